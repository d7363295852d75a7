# Figure 2. Reads fig02_*.csv and the values that figure.cpp sets, all in millimetres: radius and column_height, part
# (height of the part that is drawn with its mesh), steel and glass (diameters of the spheres).
mm = 1000.0  # in a metre
set multiplot
unset grid
unset key
unset border
unset tics
set size ratio -1
set style fill solid 0.25 noborder
set tmargin at screen 1 - 30.0/height
set bmargin at screen 26.0/height

# The domain. Each panel has one scale for width and height: 270 pixels are 1 m here, 110 mm of the part, 58 mm of the
# section.
set lmargin at screen 0.01
set rmargin at screen 0.15
set title 'domain' font ',13' offset 0,-0.4
set xrange [-80:80]
set yrange [-70:column_height+20]
set object 1 rectangle from -radius, 0 to radius, column_height \
  fillstyle empty border linecolor rgb '#2b3138' linewidth 1.2
set object 2 rectangle from -radius, 0 to radius, part fillcolor rgb ours fillstyle solid 0.2 noborder
set arrow 1 from 52, 0 to 52, column_height heads size 12,20 linecolor rgb quiet
set label 1 sprintf('%g mm', column_height) at 88, 0.5*column_height rotate by 90 center font ',11'
do for [i=-1:1] {
  set arrow 5+i from i*16, -40 to i*16, -4 head size 14,20 linecolor rgb ours
}
plot NaN
unset object 1
unset object 2
unset arrow
unset label 1

# The cells that the plane y = 0 cuts.
set lmargin at screen 0.17
set rmargin at screen 0.42
set title sprintf('plane y = 0, lowest %g mm', part)
set xrange [-30:30]
set yrange [-4:part+4]
plot 'fig02_side.csv' skip 1 using (mm*$1):(mm*$2):(mm*$3):(mm*$4) \
  with vectors nohead linecolor rgb '#5b6470' linewidth 0.8

# The section, with the two largest spheres.
set lmargin at screen 0.44
set rmargin at screen 0.99
set title 'section'
set xrange [-31:45]
set yrange [-34:28]
set trange [0:2*pi]
set parametric
set object 3 circle at -9, 0 size 0.5*steel fillcolor rgb '#c0392b' fillstyle solid 0.75 noborder front
set object 4 circle at 9, 0 size 0.5*glass fillcolor rgb ours fillstyle solid 0.45 noborder front
set label 3 sprintf('%g mm', steel) at -9, -5 center font ',11' textcolor rgb '#c0392b' front
set label 4 sprintf('%g mm', glass) at 9, -5 center font ',11' textcolor rgb ours front
set arrow 2 from -radius, -29 to radius, -29 heads size 1.2,20 linecolor rgb quiet
set label 2 sprintf('%g mm', 2*radius) at 0, -32 center font ',11'
set label 5 'shaded: joined to' at 28, 25 font ',11' textcolor rgb law_three
set label 6 'the next square' at 28, 22 font ',11' textcolor rgb law_three
plot 'fig02_joined.csv' skip 1 using (mm*$1):(mm*$2):(mm*$3):(mm*$4) with boxxyerror linecolor rgb law_three, \
     'fig02_section.csv' skip 1 using (mm*$1):(mm*$2):(mm*$3):(mm*$4) \
       with vectors nohead linecolor rgb '#5b6470' linewidth 0.9, \
     radius*cos(t), radius*sin(t) with lines linecolor rgb '#14181d' linewidth 1.8
unset multiplot
