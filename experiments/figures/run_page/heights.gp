# Heights over time: bed.csv (time, top of the bed, twice its centre of mass) and drop (tables: time, height).
set xlabel 'time since fluidisation began [s]'
set ylabel 'height [m]'
set yrange [0:*]
set key outside top center horizontal
plot 'bed.csv' skip 1 using 1:2 with lines linestyle 11 title 'top of the bed', \
     'bed.csv' skip 1 using 1:3 with lines linestyle 2 title 'twice the centre of mass', \
     for [i=1:drop_count] drop[i] skip 1 using 1:2 with lines linestyle 3 title (i == 1 ? 'dropped spheres' : '')
