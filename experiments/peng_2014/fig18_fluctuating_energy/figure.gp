# Figure 18. Reads fig18_paper_axis.csv and the lists whole_bed and boxes: fluctuating energy against the solid fraction,
# velocities about the mean of the whole bed and about the means of boxes.
set key tmargin left vertical maxrows 6 Left reverse font ',12'
set xrange [0.1:0.6]
set logscale y
set yrange [2e-5:3e-2]
set format y '10^{%L}'
set xlabel 'solid fraction α_S [-]'
set ylabel 'fluctuating kinetic energy q_p^2 [m²/s²]'
set style fill solid 0.1 noborder
plot 'fig18_paper_axis.csv' skip 1 using 1:2:3 with filledcurves linecolor rgb paper title 'axis of the paper', \
  '' skip 1 using 1:2 with lines linestyle 1 linewidth 0.8 notitle, \
  '' skip 1 using 1:3 with lines linestyle 1 linewidth 0.8 notitle, \
  for [i=1:whole_bed_count] whole_bed[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
    with xyerrorbars linestyle whole_bed_style[i] @bars, \
  for [i=1:whole_bed_count] whole_bed[i] skip 1 using 2:4 \
    with points linestyle whole_bed_style[i] title whole_bed_title[i], \
  for [i=1:boxes_count] boxes[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
    with xyerrorbars linestyle boxes_style[i] @bars, \
  for [i=1:boxes_count] boxes[i] skip 1 using 2:4 \
    with points linestyle boxes_style[i] pointtype 8 pointsize 0.8 title boxes_title[i]
