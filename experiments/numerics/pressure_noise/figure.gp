# Noise of the pressure drop. Reads the tables `series` (titles series_title, line styles series_style) and `weight`, the
# buoyant weight of the bed [Pa].
set multiplot layout 1,2 margins 0.115,0.985,0.17,0.95 spacing 0.115,0
set logscale xy
set xrange [0.08:1.25]
set xtics (0.1, 0.2, 0.5, 1)
set xlabel 'time step of the liquid [ms]'

set ylabel 'r.m.s. of the pressure drop [Pa]'
set yrange [10:2e4]
unset key
plot weight with lines linestyle 20 notitle, \
  for [i=1:series_count] series[i] skip 1 \
    using (1000*$1):2:(1000*$1):(1000*$1):($3 > 10 ? $3 : 10):4 with xyerrorbars linestyle series_style[i] notitle, \
  for [i=1:series_count] series[i] skip 1 using (1000*$1):2 with lines linestyle series_style[i] notitle

set ylabel 'over exact overlap at 1 ms [-]'
set yrange [0.8:2000]
set key top right Right font ',12'
plot 1 with lines linestyle 20 notitle, \
  for [i=1:series_count] series[i] skip 1 using (1000*$1):6 with linespoints linestyle series_style[i] \
    title series_title[i]
unset multiplot
