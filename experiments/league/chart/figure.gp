# Reads the list law (names from the bottom up) and, one file each, fluidised, fluidised_wall, creeping, slow and packed:
# bias less 1, place, spread, all in %.
set multiplot
# A mark beyond the panel stands on its edge.
lowest = -45.0
highest = 65.0
inside(x) = x < lowest ? lowest : x > highest ? highest : x
set yrange [0.3:law_count + 0.7]
set xrange [lowest:highest]
set xtics 20
set grid noxtics noytics
set tmargin at screen 1 - 62.0/height
set bmargin at screen 64.0/height
set xlabel 'bias [%]'
set arrow 1 from 0, graph 0 to 0, graph 1 nohead linecolor rgb paper linewidth 1
do for [k=1:law_count] { set arrow 1 + k from graph 0, first k to graph 1, first k nohead back linecolor rgb '#e9ecef' }
set ytics scale 0
do for [k=1:law_count] { set ytics add (law[k] k) }
set ytics font ',11'
set key at graph 0.5, screen 1 - 6.0/height center top maxrows 2 Left reverse font ',11'

set lmargin at screen 0.205
set rmargin at screen 0.455
plot fluidised[1] skip 1 using 1:2:3:(0) with xyerrorbars linestyle 2 @bars, \
  fluidised[1] skip 1 using (inside($1)):2 with points linestyle 2 title 'fluidised', \
  fluidised_wall[1] skip 1 using 1:($2 + 0.25):3:(0) with xyerrorbars linestyle 3 @bars, \
  fluidised_wall[1] skip 1 using (inside($1)):($2 + 0.25) with points linestyle 3 title 'with the wall'
unset ytics
set lmargin at screen 0.475
set rmargin at screen 0.725
plot creeping[1] skip 1 using 1:2:3:(0) with xyerrorbars linestyle 4 @bars, \
  creeping[1] skip 1 using (inside($1)):2 with points linestyle 4 title 'settling, Re_t < 1', \
  slow[1] skip 1 using 1:($2 + 0.25):3:(0) with xyerrorbars linestyle 5 @bars, \
  slow[1] skip 1 using (inside($1)):($2 + 0.25) with points linestyle 5 title 'settling, Re_t > 1'
set lmargin at screen 0.745
set rmargin at screen 0.985
plot packed[1] skip 1 using 1:2:3:(0) with xyerrorbars linestyle 2 @bars, \
  packed[1] skip 1 using (inside($1)):2 with points linestyle 2 title 'packed'
unset multiplot
