# Classification velocity as printed and as simulated. Reads simulated_classification.csv and the tables of the
# candidates; values: printed_title, the lists simulated (tables), simulated_title and simulated_style.
set key tmargin left Left reverse maxrows 4 font ',12'
set yrange [0:0.3<*]
set xlabel 'superficial velocity U_L [m/s]'
set ylabel 'classification velocity V_2 [m/s]'
# Only as far as something was simulated.
slowest = 1e9
fastest = -1e9
do for [i=1:simulated_count] {
  stats simulated[i] skip 1 using 2 nooutput
  slowest = STATS_min < slowest ? STATS_min : slowest
  fastest = STATS_max > fastest ? STATS_max : fastest
}
if (simulated_count > 0) { set xrange [slowest - 0.02:fastest + 0.02] }
plot 'simulated_classification.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title printed_title, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4 with points linestyle simulated_style[i] title simulated_title[i]
