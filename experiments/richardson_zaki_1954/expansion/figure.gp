# Reads the lists name (titles of the beds), measured, laws (tables by bed), and simulated_1, simulated_3 (tables, empty
# where nothing is simulated).
set multiplot
columns = 4
rows = (name_count + columns - 1)/columns
panel_width = (width - 20.0)/columns
panel_height = (height*(1 - base) - 30.0)/rows
set logscale xy
set xtics (0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1) font ',10'
set ytics (0.5, 0.6, 0.7, 0.8, 0.9, 1) font ',10'
set yrange [0.42:1]
unset key
do for [k=1:name_count] {
  column_k = (k - 1) % columns
  row_k = (k - 1)/columns
  set lmargin at screen (62.0 + column_k*panel_width)/width
  set rmargin at screen (20.0 + (column_k + 1)*panel_width)/width - 8.0/width
  set tmargin at screen 1 - (30.0 + row_k*panel_height)/height
  set bmargin at screen 1 - ((row_k + 1)*panel_height - 24.0)/height
  set title name[k] font ',12' offset 0,-0.7
  set xlabel (row_k == rows - 1 || k + columns > name_count) ? 'U [m/s]' : '' font ',12'
  set ylabel column_k == 0 ? 'voidage [-]' : '' font ',12' offset 2.2,0
  set xrange [low[k]:high[k]]
  plot laws[k] skip 1 using 2:1 with lines linestyle 11, \
    laws[k] skip 1 using 3:1 with lines linestyle 12, \
    measured[k] skip 1 using 2:1 with lines linecolor rgb paper linewidth 1.6 dashtype 3, \
    measured[k] skip 1 using ($1 > 0.499 && $1 < 0.901 ? $2 : NaN):1 with lines linecolor rgb paper linewidth 1.8, \
    simulated_1[k] skip 1 using 1:2:(half_width(3)) with yerrorbars linestyle 2 @bars, \
    simulated_1[k] skip 1 using 1:2 with points linestyle 2, \
    simulated_3[k] skip 1 using 1:2:(half_width(3)) with yerrorbars linestyle 3 @bars, \
    simulated_3[k] skip 1 using 1:2 with points linestyle 3 pointtype 4
  if (k == 1) {
    eval footer_drawn
  }
}
# The free panel is the key.
unset title
unset border
unset tics
unset grid
unset logscale
set xlabel ''
set ylabel ''
set lmargin at screen (20.0 + (name_count % columns)*panel_width)/width
set rmargin at screen 1 - 8.0/width
set tmargin at screen 1 - (30.0 + (rows - 1)*panel_height)/height
set bmargin at screen 1 - (rows*panel_height - 24.0)/height
set xrange [0:1]
set yrange [0:1]
set key center left Left reverse font ',12'
plot NaN with lines linecolor rgb paper linewidth 1.8 title 'measured', \
  NaN with points linestyle 2 title 'simulated, 1-D slice', \
  NaN with points linestyle 3 pointtype 4 title 'simulated, 3-D', \
  NaN with lines linestyle 11 title law_title, \
  NaN with lines linestyle 12 title formula_title
unset multiplot
