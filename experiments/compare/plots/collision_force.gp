# Collision force over the weight of the foreign sphere against the voidage. Reads collision_force.csv (laws),
# collision_force_van_der_wielen.csv and the tables of the candidates; values: the lists simulated
# (tables), simulated_title and simulated_style.
set key tmargin left Left reverse vertical maxrows 6 font ',12'
set xrange [0.4:1]
set yrange [0:*]
set style fill transparent solid 0.18 noborder
set xlabel 'voidage α_L [-]'
set ylabel 'collision force over weight, |F_c|/mg [-]'
plot 'collision_force.csv' skip 1 using 1:3 with filledcurves y=0 linecolor rgb law_four title 'Grbavčić, foreign sphere', \
  '' skip 1 using 1:3 with lines linestyle 14 notitle, \
  '' skip 1 using 1:4 with filledcurves y=0 linecolor rgb law_three title 'Grbavčić, bed spheres', \
  '' skip 1 using 1:4 with lines linestyle 13 notitle, \
  'collision_force_van_der_wielen.csv' skip 1 using 2:4 with linespoints linestyle 12 pointtype 12 pointsize 0.5 title 'van der Wielen with the printed V_2', \
  'collision_force.csv' skip 1 using 1:2 with lines linestyle 1 title 'Peng et al. 2014, Eq. 40', \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4 with points linestyle simulated_style[i] title simulated_title[i]
