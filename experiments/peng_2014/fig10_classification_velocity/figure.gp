# Figure 10. Reads fig10_*.csv and the lists that figure.cpp sets: mean (of the drops at each velocity, by drag law) and
# drops (single ones).
set key tmargin left vertical maxrows 9 Left reverse font ',12'
set xrange [0.04:0.25]
set yrange [0:0.6]
set xlabel 'superficial liquid velocity U_L [m/s]'
set ylabel 'classification velocity V_2 [m/s]'
plot for [i=1:drops_count] drops[i] skip 1 using 1:2 \
       with points linestyle drops_style[i] pointtype 7 pointsize 0.35 linecolor rgb value('pale_'.drops_style[i]) \
       notitle, \
     'fig10_without_collisions.csv' skip 1 using 1:2 with lines linestyle 12 title 'without collisions, Eq. 36', \
     'fig10_without_collisions.csv' skip 1 using 1:3 with lines linestyle 11 title 'without collisions, Gidaspow', \
     'fig10_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'paper, Table 2', \
     for [i=1:mean_count] mean[i] skip 1 using 1:2:(0):(half_width(3)) \
       with xyerrorbars linestyle mean_style[i] @bars, \
     for [i=1:mean_count] mean[i] skip 1 using 1:2 with points linestyle mean_style[i] title mean_title[i]
