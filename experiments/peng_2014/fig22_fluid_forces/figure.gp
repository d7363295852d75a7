# Figure 22. Reads fig22_mean_field_drag.csv, fig22_pressure_gradient.csv, fig22_paper.csv and the lists drag and pressure:
# simulated forces over weight against the voidage.
set multiplot
set lmargin at screen 0.14
set rmargin at screen 0.97
set xrange [0.42:0.9]
set xtics 0.1
middle = base + 0.5*(1 - base)

# Drag.
set tmargin at screen 1 - 12.0/height
set bmargin at screen middle + 22.0/height
set format x ''
set yrange [0:1.2]
set ytics 0.2
set ylabel 'drag over weight, |F_d|/mg [-]' offset 1.6,0
set key top left Left reverse font ',11' spacing 1.05
plot 'fig22_mean_field_drag.csv' skip 1 using 1:2 with lines linestyle 11 title 'Gidaspow at V_2 of Table 2', \
  '' skip 1 using 1:3 with lines linestyle 12 title 'Wen and Yu at V_2 of Table 2', \
  'fig22_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'paper, printed', \
  for [i=1:drag_count] drag[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
    with xyerrorbars linestyle drag_style[i] @bars, \
  for [i=1:drag_count] drag[i] skip 1 using 2:4 with points linestyle drag_style[i] title drag_title[i]
eval footer_drawn

# Pressure-gradient force.
set tmargin at screen middle - 2.0/height
set bmargin at screen base + 60.0/height
set format x '%g'
set xlabel 'voidage α_L [-]'
set yrange [0:0.3]
set ytics 0.1
set ylabel 'pressure gradient over weight [-]' offset 1.6,0
set key bottom left Left reverse
plot 'fig22_pressure_gradient.csv' skip 1 using 1:3 \
    with lines linestyle 13 title 'homogeneous bed, ρ_M/ρ_{P2}', \
  '' skip 1 using 1:2 with lines linestyle 14 title 'clear liquid, ρ_L/ρ_{P2}', \
  'fig22_paper.csv' skip 1 using 1:3 with points linestyle 1 dashtype 1 notitle, \
  for [i=1:pressure_count] pressure[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
    with xyerrorbars linestyle pressure_style[i] @bars, \
  for [i=1:pressure_count] pressure[i] skip 1 using 2:4 \
    with points linestyle pressure_style[i] title pressure_title[i]
unset multiplot
