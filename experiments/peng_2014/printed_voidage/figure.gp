# Whose voidage do the paper's figures stand on? Reads printed_voidage_equation_36.csv, printed_voidage_paper.csv,
# printed_voidage_equations.csv, the list simulated (one item per system) and the list main_bed (the table of the bed of
# the paper's Fig. 13, if it is simulated).
set multiplot
set tmargin at screen 1 - 16.0/height
set bmargin at screen base + 74.0/height

# Voidage against the superficial velocity.
set lmargin at screen 0.085
set rmargin at screen 0.27
set xrange [0.04:0.24]
set xtics 0.04
set xlabel 'U_L [m/s]'
set yrange [0.4:0.9]
set ylabel 'voidage [-]'
set key at graph 0.98, graph 0.04 right bottom Left reverse font ',11'
plot 'printed_voidage_equation_36.csv' skip 1 using 1:2 with lines linecolor rgb paper title 'Eq. 36', \
  'printed_voidage_paper.csv' skip 1 using 1:2 with points linecolor rgb paper pointtype 2 title 'printed', \
  for [i=1:main_bed_count] main_bed[i] skip 1 using 1:2 with points linestyle main_bed_style title 'our bed'
eval footer_drawn

# Force at the voidage of our bed.
set lmargin at screen 0.355
set rmargin at screen 0.54
set xrange [0.42:0.92]
set xtics 0.1
set xlabel 'voidage of our bed [-]'
set yrange [0.2:1.1]
set ylabel '|F_c|/mg [-]'
set key at screen 0.83, screen 1 - 16.0/height left top Left reverse font ',11'
plot 'printed_voidage_equations.csv' skip 1 using 1:2 with lines linecolor rgb paper title 'Eq. 40', \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4:(0):(half_width(5)) \
    with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 2:4 \
    with points linestyle simulated_style[i] title simulated_title[i]

# Force at the voidage by Eq. 36.
set lmargin at screen 0.625
set rmargin at screen 0.81
set xlabel 'voidage by Eq. 36 [-]'
unset key
plot 'printed_voidage_equations.csv' skip 1 using 1:2 with lines linecolor rgb paper notitle, \
  for [i=1:simulated_count] simulated[i] skip 1 using 6:4:(0):(half_width(5)) \
    with xyerrorbars linestyle simulated_style[i] @bars, \
  for [i=1:simulated_count] simulated[i] skip 1 using 6:4 with points linestyle simulated_style[i]
unset multiplot
