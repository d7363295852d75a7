# Classification velocity by balance of forces, and as simulated. Reads classification.csv (superficial velocity, then
# classification velocities [m/s]), classification_paper.csv and the tables of the candidates; values: slowest and
# fastest (superficial velocities), printed_title, lists of columns as in bed_expansion.gp, and the lists simulated
# (tables), simulated_title and simulated_style.
set datafile missing
set key tmargin left Left reverse maxrows 4 font ',12'
set xrange [slowest - 0.005:fastest + 0.005]
set yrange [0:0.6<*]
set xlabel 'superficial velocity U_L [m/s]'
set ylabel 'classification velocity V_2 [m/s]'
plot for [i=1:literature_count] 'classification.csv' skip 1 using 1:literature[i] with lines linecolor rgb '#c3c8ce' linewidth 1 title (i == 1 ? 'literature' : ''), \
  for [i=1:inside_count] 'classification.csv' skip 1 using 1:inside[i] with lines linestyle inside_style[i] title inside_title[i], \
  for [i=1:outside_count] 'classification.csv' skip 1 using 1:outside[i] with lines linestyle outside_style[i] dashtype (2, 3) title outside_title[i], \
  'classification_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title printed_title, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4:(0):(half_width(5)) with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4 with points linestyle simulated_style[i] title (i > simulated_count ? '' : 'simulated, '.simulated_title[i])
