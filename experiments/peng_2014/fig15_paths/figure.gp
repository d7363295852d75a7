# Figure 15. Reads fig15_spheres_*.csv and fig15_path_*.csv. Values that figure.cpp sets: scale [pixel/m] and
# panel_height [m] of the panels; one item per panel of the lists voidage (the paper's), run_voidage (ours, as text),
# heading, bottom [m], picture and path (tables; '' when there is none).
set multiplot
unset grid
unset key
unset xtics
set border 15 linecolor rgb '#9aa3ad'
set ytics 0.05
set xrange [-0.025:0.025]
set tmargin at screen 1 - 34.0/height
set bmargin at screen base + 56.0/height
set ylabel 'height z [m]' offset 1.6,0
set label 3 'α_L ours' at screen 0.012, screen base + 38.0/height font ',12' textcolor rgb ours
set label 4 'α_L paper' at screen 0.012, screen base + 16.0/height font ',12'

do for [i=1:voidage_count] {
  left_edge = 0.15 + 0.29*(i - 1)
  set lmargin at screen left_edge
  set rmargin at screen left_edge + 0.205
  set yrange [bottom[i]:bottom[i] + panel_height]
  heading_colour = picture[i] eq '' ? quiet : '#14181d'
  set title heading[i] font ',13' offset 0,-0.6 textcolor rgb heading_colour
  set label 1 run_voidage[i] at graph 0.5, screen base + 38.0/height center font ',12' textcolor rgb ours
  set label 2 sprintf('%.2f', voidage[i]) at graph 0.5, screen base + 16.0/height center font ',12'
  if (picture[i] eq '') {
    plot NaN
  } else { if (path[i] eq '') {
    plot picture[i] skip 1 @spheres
  } else {
    plot picture[i] skip 1 @spheres, \
      path[i] skip 1 using 1:3 with lines linecolor rgb '#ffffff' linewidth 3.4, \
      path[i] skip 1 using 1:3 with lines linecolor rgb '#c0271c' linewidth 1.8
  } }
  if (i == 1) {
    eval footer_drawn
    unset label 3
    unset label 4
    unset ylabel
  }
}
unset multiplot
