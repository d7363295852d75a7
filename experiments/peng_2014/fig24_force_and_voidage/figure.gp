# Figure 24. Reads fig24_equation_40.csv and the lists mean_of_magnitude and magnitude_of_mean: force over weight against
# the voidage.
set key tmargin left vertical maxrows 6 Left reverse font ',12'
set xrange [0.4:1]
set yrange [0:1.25]
set ytics 0.25
set xlabel 'voidage α_L [-]'
set ylabel 'collision force over weight, |F_c|/mg [-]'
set style fill transparent solid 0.09 noborder
plot 'fig24_equation_40.csv' skip 1 using 1:5:6 with filledcurves linecolor rgb paper notitle, \
  '' skip 1 using 1:3:4 with filledcurves linecolor rgb paper notitle, \
  '' skip 1 using 1:2 with lines linestyle 1 title 'paper, Eq. 40, with 10 and 20 %', \
  for [i=1:mean_of_magnitude_count] mean_of_magnitude[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
    with xyerrorbars linestyle mean_of_magnitude_style[i] @bars, \
  for [i=1:mean_of_magnitude_count] mean_of_magnitude[i] skip 1 using 2:4 \
    with points linestyle mean_of_magnitude_style[i] title mean_of_magnitude_title[i], \
  for [i=1:magnitude_of_mean_count] magnitude_of_mean[i] skip 1 using 2:4:(0):(half_width(5)) \
    with xyerrorbars linestyle magnitude_of_mean_style[i] @bars, \
  for [i=1:magnitude_of_mean_count] magnitude_of_mean[i] skip 1 using 2:4 \
    with points linestyle magnitude_of_mean_style[i] pointtype 12 pointsize 0.9 title magnitude_of_mean_title[i]
