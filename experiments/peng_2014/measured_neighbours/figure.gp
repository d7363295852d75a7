# Reads measured_neighbours_curves.csv (U, Eq. 36, Gidaspow, formula, its lower and upper end, then a column per measured
# line), measured_neighbours_printed.csv, the list simulated, measured_neighbours_laws.csv (place, less printed, less
# measured), and the lists line (titles of the measured lines) and law (names from the bottom up).
set multiplot
set tmargin at screen 1 - 20.0/height
set bmargin at screen base + 60.0/height
set lmargin at screen 0.075
set rmargin at screen 0.5
set xrange [0.045:0.24]
set yrange [0.3:0.95]
set xlabel 'U_L [m/s]'
set ylabel 'voidage [-]'
set key at graph 0.99, graph 0.02 right bottom Left reverse font ',12' width (format eq 'svg' ? -10 : -3)
curves = 'measured_neighbours_curves.csv'
plot curves skip 1 using 1:5:6 with filledcurves fillcolor rgb '#dfe9f2' notitle, \
  curves skip 1 using 1:4 with lines linestyle 2 dashtype 2 title 'formula of the measured beds', \
  curves skip 1 using 1:2 with lines linecolor rgb paper title 'Eq. 36', \
  curves skip 1 using 1:3 with lines linestyle 11 title 'Gidaspow-1994', \
  for [i=1:line_count] curves skip 1 using 1:(column(6 + i)) with lines linestyle 2 + i title line[i], \
  'measured_neighbours_printed.csv' skip 1 using 1:2 with points linecolor rgb paper pointtype 6 title 'printed', \
  for [i=1:simulated_count] simulated[i] skip 1 using 1:2 with points linestyle 2 title 'our bed'
eval footer_drawn
set lmargin at screen 0.73
set rmargin at screen 0.985
set xrange [-0.16:0.2]
set xtics 0.1
set yrange [0.3:law_count + 0.7]
set xlabel 'voidage of the law, less the other [-]'
set ylabel ''
unset ytics
set ytics scale 0 font ',11'
do for [k=1:law_count] { set ytics add (law[k] k) }
set grid noytics
set arrow 1 from 0, graph 0 to 0, graph 1 nohead linecolor rgb paper linewidth 1
set key at graph 0.98, graph 0.02 right bottom font ',12' width 0
plot 'measured_neighbours_laws.csv' skip 1 using 2:1 with points linecolor rgb paper pointtype 6 title 'printed', \
  'measured_neighbours_laws.csv' skip 1 using 3:1 with points linestyle 3 title 'measured'
unset multiplot
