# Figure 16. Reads fig16_paper.csv and the lists mean and most: contacts against the voidage of the bed.
set multiplot
set lmargin at screen 0.13
set rmargin at screen 0.97
set xrange [0.42:0.86]
set xtics 0.1
middle = base + 0.5*(1 - base)

# Mean over time.
set tmargin at screen 1 - 12.0/height
set bmargin at screen middle + 22.0/height
set format x ''
set logscale y
set yrange [0.02:10]
set ylabel 'mean contacts [-]' offset 1.9,0
set key top right Left reverse font ',12'
plot 'fig16_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'paper, printed', \
  for [i=1:mean_count] mean[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
    with xyerrorbars linestyle mean_style[i] @bars, \
  for [i=1:mean_count] mean[i] skip 1 using 2:4 with points linestyle mean_style[i] title mean_title[i]
eval footer_drawn

# Most at once.
set tmargin at screen middle - 2.0/height
set bmargin at screen base + 60.0/height
set format x '%g'
set xlabel 'voidage α_L [-]'
unset logscale y
set yrange [0:16]
set ytics 4
set ylabel 'most contacts [-]' offset 1,0
unset key
plot 'fig16_paper.csv' skip 1 using 1:3 with points linestyle 1 dashtype 1, \
  for [i=1:most_count] most[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
    with xyerrorbars linestyle most_style[i] @bars, \
  for [i=1:most_count] most[i] skip 1 using 2:4 with points linestyle most_style[i]
unset multiplot
