# Figure 25. Reads fig25.csv (laws), fig25_van_der_wielen.csv and the list simulated: force over weight against the
# voidage.
set key tmargin left vertical maxrows 9 Left reverse font ',12'
set xrange [0.4:1]
set yrange [0:1.25]
set ytics 0.25
set xlabel 'voidage α_L [-]'
set ylabel 'collision force over weight, |F_c|/mg [-]'
set style fill transparent solid 0.18 noborder
plot 'fig25.csv' skip 1 using 1:3 with filledcurves y=0 linecolor rgb law_four title 'Grbavčić, foreign sphere', \
  '' skip 1 using 1:3 with lines linestyle 14 notitle, \
  '' skip 1 using 1:4 with filledcurves y=0 linecolor rgb law_three title 'Grbavčić, bed spheres', \
  '' skip 1 using 1:4 with lines linestyle 13 notitle, \
  'fig25_van_der_wielen.csv' skip 1 using 2:4 \
    with linespoints linestyle 12 pointtype 12 pointsize 0.5 title 'van der Wielen with V_2 of Table 2', \
  'fig25.csv' skip 1 using 1:2 with lines linestyle 1 title 'paper, Eq. 40', \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
    with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4 \
    with points linestyle simulated_style[i] title simulated_title[i]
