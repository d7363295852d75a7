# Dimensionless collision frequency against the voidage. Reads collision_frequency.csv (kinetic theory) and the tables of
# the candidates; values: the lists simulated (tables), simulated_title and simulated_style.
set key tmargin left Left reverse maxrows 4 font ',12'
set xrange [0.4:1]
set logscale y
set yrange [*<0.3:1000<*]
set xlabel 'voidage α_L [-]'
set ylabel 'collision frequency f* [-]'
plot 'collision_frequency.csv' skip 1 using 1:2 with lines linestyle 1 title 'kinetic theory, Simonin 1991', \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4 with points linestyle simulated_style[i] title simulated_title[i]
