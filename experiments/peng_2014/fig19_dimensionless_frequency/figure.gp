# Figure 19. Reads fig19_kinetic_theory.csv, fig19_paper.csv and the list simulated: dimensionless collision frequency
# against the solid fraction.
set key tmargin left vertical maxrows 7 Left reverse font ',12'
set xrange [0.15:0.6]
set logscale y
set yrange [1:1000]
set xlabel 'solid fraction α_S [-]'
set ylabel 'dimensionless collision frequency f* [-]'
plot 'fig19_kinetic_theory.csv' skip 1 using 1:2 with lines linestyle 1 title 'kinetic theory, Eqs. 6 and 7', \
  '' skip 1 using 1:3 with lines linestyle 12 title 'kinetic theory, Carnahan-Starling', \
  'fig19_paper.csv' skip 1 using 1:2:1:1:3:4 with xyerrorbars linecolor rgb paper linewidth 1.6 pointsize 0 \
    title 'printed frequencies, range the axes allow', \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
    with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4 \
    with points linestyle simulated_style[i] title simulated_title[i]
