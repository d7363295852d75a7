# Collision force over the weight of the foreign sphere against the voidage. Reads collision_force.csv (voidage, then a
# column per law), collision_force_points.csv (superficial velocity, voidage, printed velocity, then a column per law that
# needs it) and the tables of the candidates; values: the lists curve_title, point_title, simulated (tables),
# simulated_title and simulated_style.
set key tmargin left Left reverse vertical maxrows 6 font ',12'
set xrange [0.4:1]
set yrange [0:*]
set xlabel 'voidage α_L [-]'
set ylabel 'collision force over weight, |F_c|/mg [-]'
plot for [i=1:curve_title_count] 'collision_force.csv' skip 1 using 1:i+1 with lines linestyle 10 + i title curve_title[i], \
  for [i=1:point_title_count] 'collision_force_points.csv' skip 1 using 2:i+3 with linespoints linestyle 14 pointtype 12 pointsize 0.5 title point_title[i], \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4 with points linestyle simulated_style[i] title simulated_title[i]
