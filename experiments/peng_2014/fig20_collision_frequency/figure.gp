# Figure 20. Reads fig20_straight_flight.csv, fig20_paper.csv and the list simulated: collision frequency against the
# solid fraction, one item per system.
set key tmargin left vertical maxrows 5 Left reverse font ',11'
set xrange [0.14:0.6]
set logscale y
set yrange [20:10000]
set xlabel 'solid fraction α_S [-]'
set ylabel 'collision frequency f_{coll} [1/s]' offset 1.8,0
plot 'fig20_straight_flight.csv' skip 1 using 1:2 \
    with lines linestyle 14 title 'Eq. 5 at V_2 of Table 2, 6 in 5 mm', \
  'fig20_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'paper, printed', \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
    with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4 \
    with points linestyle simulated_style[i] title simulated_title[i]
