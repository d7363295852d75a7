# Figure 26. Reads the list simulated: force over weight against Eq. 40 at the simulated voidage, one item per system.
set key tmargin left vertical maxrows 6 Left reverse font ',11'
set xrange [0.3:1.1]
set yrange [0.3:1.1]
set xtics 0.2
set ytics 0.2
set size ratio -1
set xlabel '|F_c|/mg by Eq. 40 [-]'
set ylabel 'simulated |F_c|/mg [-]'
plot x with lines linecolor rgb paper linewidth 1.2 title 'equality', \
  0.9*x with lines linestyle 1 linewidth 1 title '10 %', \
  1.1*x with lines linestyle 1 linewidth 1 notitle, \
  0.8*x with lines linestyle 20 linecolor rgb paper title '20 %', \
  1.2*x with lines linestyle 20 linecolor rgb paper notitle, \
  for [i=1:simulated_count] simulated[i] skip 1 using 3:5:(half_width(4)):(half_width(6)) \
    with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 3:5 \
    with points linestyle simulated_style[i] title simulated_title[i]
