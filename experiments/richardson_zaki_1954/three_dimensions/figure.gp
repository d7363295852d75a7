# Reads the lists law (names), series (tables: place, mean error, half width of its interval), series_title, series_style,
# and band.
set xrange [0.5:law_count + 0.5]
set yrange [-0.16:0.16]
set xtics ()
do for [i=1:law_count] { set xtics add (law[i] i) }
set xtics font ',10' rotate by 20 right
set ylabel 'error of the voidage, mean over the beds [-]'
set key tmargin left vertical maxrows 2 Left reverse font ',11'
set object 1 rectangle from graph 0, first -band to graph 1, first band fillcolor rgb '#eceff2' fillstyle solid noborder behind
plot 0 with lines linecolor rgb paper linewidth 1.2 notitle, \
  for [i=1:series_count] series[i] skip 1 using 1:2:3 with yerrorbars linestyle series_style[i] @bars, \
  for [i=1:series_count] series[i] skip 1 using 1:2 with points linestyle series_style[i] title series_title[i]
