# What one change does. Reads causes.csv: a row per change, those of the default scene above first_of_lattice; for each
# velocity and each quantity a ratio to the unchanged bed and the half width of its interval. Lists that figure.cpp sets:
# change, quantity (their titles), end (of each panel's axis) and velocity [m/s].
ratio_column(v, q) = 2 + 2*((v - 1)*quantity_count + q - 1)
# What is not simulated yet stands outside the axes, so that it keeps its place in the key.
known(k) = valid(k) ? column(k) : -1
array colour[2] = [ours, variant]
array point_type[2] = [7, 5]
array shift[2] = [-0.15, 0.15]

set multiplot
set tmargin at screen 1 - 34.0/height
set bmargin at screen base + 40.0/height
set yrange [change_count - 0.3:-0.7]
set mxtics 2
set grid x y
set key at screen 0.01, screen 1 - 6.0/height left top Left reverse font ',11'
set arrow 2 from graph 0, first first_of_lattice - 0.5 to graph 1, first first_of_lattice - 0.5 nohead linecolor rgb paper
set arrow 1 from 1, graph 0 to 1, graph 1 nohead linecolor rgb paper
left_edge = 0.2
panel_width = (0.99 - left_edge)/quantity_count

do for [q=1:quantity_count] {
  set lmargin at screen left_edge + (q - 1)*panel_width
  set rmargin at screen left_edge + q*panel_width - 0.012
  set title quantity[q] font ',13' offset 0,-0.4
  set xrange [0:end[q]]
  set xtics (end[q] > 20 ? 10 : end[q] > 10 ? 5 : end[q] > 5 ? 2 : 1)
  # The names of the changes stand at the first panel.
  set ytics ('' 0)
  do for [k=1:change_count] { set ytics add ((q == 1 ? change[k] : '') k - 1) }
  plot for [v=1:velocity_count] 'causes.csv' skip 1 \
      using (known(ratio_column(v, q))):($1+shift[v]):(half_width(ratio_column(v, q)+1)) \
      with xerrorbars linecolor rgb colour[v] pointtype point_type[v] pointsize 0.01 notitle, \
    for [v=1:velocity_count] 'causes.csv' skip 1 using (known(ratio_column(v, q))):($1+shift[v]) \
      with points linecolor rgb colour[v] pointtype point_type[v] pointsize 0.7 title sprintf('%.2f m/s', velocity[v])
  if (q == 1) {
    eval footer_drawn
    unset key
  }
}
unset multiplot
