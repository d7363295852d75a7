# Figure 23. Reads fig23_laws.csv, fig23_paper.csv, the list simulated (ratio against the voidage) and the number largest
# that figure.cpp sets.
set key tmargin left vertical maxrows 7 Left reverse font ',12'
set xrange [0.42:0.9]
set yrange [0:12]
set ytics 2
set xlabel 'voidage α_L [-]'
set ylabel 'collision force over drag, |F_c|/|F_d| [-]'
plot largest with lines linestyle 1 title 'paper, largest ratio', \
  1 with lines linestyle 20 notitle, \
  'fig23_laws.csv' skip 1 using 1:2 with lines linestyle 11 title 'Eq. 40 over Gidaspow at V_2 of Table 2', \
  '' skip 1 using 1:3 with lines linestyle 12 title 'Eq. 40 over Wen and Yu at V_2 of Table 2', \
  'fig23_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 pointtype 1 \
    title 'Eq. 40 over the printed drag', \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
    with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4 \
    with points linestyle simulated_style[i] title simulated_title[i]
