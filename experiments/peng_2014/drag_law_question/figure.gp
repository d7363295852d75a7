# The drag-law question. Reads drag_law_homogeneous.csv, drag_law_paper.csv, drag_law_equation_40.csv and the tables of the
# list simulated: one item per combination of law[i] and friction[i], whose points stand aside by shift[i] [m/s].
colour(i) = law[i] eq 'Gidaspow' ? ours : variant
point_type(i) = friction[i] == 0.3 ? 5 : friction[i] == 0.1 ? 9 : 6
# What was not measured stands below the axes.
known(k) = valid(k) ? column(k) : -1

set multiplot
set tmargin at screen 1 - 16.0/height
set bmargin at screen base + 74.0/height

# Voidage.
set lmargin at screen 0.085
set rmargin at screen 0.27
set xrange [0.04:0.22]
set xtics 0.04
set xlabel 'U_L [m/s]'
set yrange [0.4:0.9]
set ylabel 'voidage [-]'
set key at screen 0.83, screen 1 - 16.0/height left top Left reverse font ',11'
plot 'drag_law_homogeneous.csv' skip 1 using 1:2 with lines linecolor rgb ours title 'homogeneous, Gidaspow', \
  '' skip 1 using 1:3 with lines linecolor rgb variant title 'homogeneous, Wen-Yu', \
  'drag_law_paper.csv' skip 1 using 1:2 with points linecolor rgb paper pointtype 2 pointsize 0.9 title 'paper', \
  for [i=1:simulated_count] simulated[i] skip 1 using ($1+shift[i]):2:(half_width(3)) \
    with yerrorbars linecolor rgb colour(i) pointtype point_type(i) pointsize 0.8 notitle, \
  for [i=1:simulated_count] simulated[i] skip 1 using ($1+shift[i]):2 \
    with points linecolor rgb colour(i) pointtype point_type(i) pointsize 0.8 \
    title sprintf('%s, friction %g', law[i], friction[i])
eval footer_drawn
unset key

# Classification velocity.
set lmargin at screen 0.355
set rmargin at screen 0.54
set yrange [0:0.5]
set ylabel 'V_2 [m/s]'
plot 'drag_law_paper.csv' skip 1 using 1:3 with points linecolor rgb paper pointtype 2 pointsize 0.9 notitle, \
  for [i=1:simulated_count] simulated[i] skip 1 using ($1+shift[i]):(known(4)):(half_width(5)) \
    with yerrorbars linecolor rgb colour(i) pointtype point_type(i) pointsize 0.8 notitle

# Collision force against the voidage.
set lmargin at screen 0.625
set rmargin at screen 0.81
set xrange [0.44:0.9]
set xtics 0.1
set xlabel 'voidage [-]'
set yrange [0:1.2]
set ylabel '|F_c|/mg [-]'
plot 'drag_law_equation_40.csv' skip 1 using 1:2 with lines linecolor rgb paper notitle, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:(known(6)):(half_width(7)) \
    with yerrorbars linecolor rgb colour(i) pointtype point_type(i) pointsize 0.8 notitle
unset multiplot
