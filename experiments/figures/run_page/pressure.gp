# Pressure drop over time: pressure.csv (time, pressure drop) and weight, that of the bed in the liquid over the
# cross-section [Pa].
set xlabel 'time since fluidisation began [s]'
set ylabel 'pressure drop [Pa]'
set key outside top center horizontal
plot 'pressure.csv' skip 1 using 1:2 with lines linestyle 2 title 'pressure drop', \
     weight with lines linestyle 1 title 'weight of the bed in the liquid'
