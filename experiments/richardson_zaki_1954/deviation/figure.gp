# Reads the list series (tables: terminal Re, mean error, smallest, largest), its titles and styles, and band.
# Series a little apart, so that bars of one bed do not hide one another.
apart(i, reynolds) = reynolds*1.06**(i - 1)
set logscale x
set xrange [8:1.6e4]
set yrange [-0.16:0.16]
set xlabel 'terminal Reynolds number [-]'
set ylabel 'error of the voidage [-]'
set key tmargin left vertical maxrows 3 Left reverse font ',11'
set object 1 rectangle from graph 0, first -band to graph 1, first band fillcolor rgb '#eceff2' fillstyle solid noborder behind
plot 0 with lines linecolor rgb paper linewidth 1.2 notitle, \
  for [i=1:series_count] series[i] skip 1 using (apart(i, $1)):2:3:4 with yerrorbars linestyle series_style[i] @bars, \
  for [i=1:series_count] series[i] skip 1 using (apart(i, $1)):2 with points linestyle series_style[i] title series_title[i]
