# Reads the list series (tables: measured voidage, ours, half width), its titles and styles, and band.
set key tmargin left vertical maxrows 3 Left reverse font ',11'
set xrange [0.45:0.95]
set yrange [0.35:1.02]
set xtics 0.1
set ytics 0.1
set xlabel 'measured voidage [-]'
set ylabel 'our voidage [-]'
plot x with lines linecolor rgb paper linewidth 1.2 title 'equality', \
  x + band with lines linestyle 1 linewidth 1 title 'two columns', \
  x - band with lines linestyle 1 linewidth 1 notitle, \
  for [i=1:series_count] series[i] skip 1 using 1:2:(half_width(3)) with yerrorbars linestyle series_style[i] @bars, \
  for [i=1:series_count] series[i] skip 1 using 1:2 with points linestyle series_style[i] title series_title[i]
