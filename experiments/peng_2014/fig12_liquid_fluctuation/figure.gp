# Figure 12. Reads fig12_*.csv and the lists that figure.cpp sets: vector (mean length of the fluctuation) and vertical
# (of its vertical component alone), each by system. Columns 2 and 3: voidage and its half width, 4 and 5: fluctuation.
band = "'fig12_paper_axis.csv' skip 1 using 1:2:3 with filledcurves linecolor rgb paper fillstyle solid 0.08 noborder"
set multiplot
set lmargin at screen 0.165
set rmargin at screen 0.97
set xrange [0.4:0.9]
set xtics 0.1
set yrange [0:0.18]
set ytics 0.04
middle = base + 0.5*(1 - base - 80.0/height)

# The vector.
set tmargin at screen 1 - 92.0/height
set bmargin at screen middle + 22.0/height
set format x ''
set ylabel "u'_L, vector [m/s]" offset 1.4,0
set key at screen 0.165, screen 1 - 8.0/height left top Left reverse font ',12'
if (vector_count > 0) {
  plot @band title 'sharp rise in the paper', \
       for [i=1:vector_count] vector[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
         with xyerrorbars linestyle vector_style[i] @bars, \
       for [i=1:vector_count] vector[i] skip 1 using 2:4 \
         with points linestyle vector_style[i] title vector_title[i]
} else {
  set label 1 'no run with this record yet' at graph 0.55, 0.5 font ',12' textcolor rgb quiet
  plot @band title 'sharp rise in the paper'
}
eval footer_drawn

# The vertical component.
set tmargin at screen middle - 2.0/height
set bmargin at screen base + 60.0/height
set format x '%g'
set xlabel 'voidage α_L [-]'
set ylabel "u'_L, vertical [m/s]" offset 1.4,0
unset key
if (vertical_count > 0) {
  plot @band, \
       for [i=1:vertical_count] vertical[i] skip 1 using 2:4:(half_width(3)):(half_width(5)) \
         with xyerrorbars linestyle vertical_style[i] @bars, \
       for [i=1:vertical_count] vertical[i] skip 1 using 2:4 with points linestyle vertical_style[i]
} else {
  plot @band
}
unset multiplot
