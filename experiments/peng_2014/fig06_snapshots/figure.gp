# Figure 6. Reads fig06_spheres_U.csv and the values that figure.cpp sets: upper_height of the panels [m], panel_width
# over that of the picture, and for each panel velocity, spheres_table (empty without one), simulated and printed
# (what happens, in words), missing (why nothing is drawn).
set multiplot
unset grid
unset key
set border 15 linecolor rgb '#9aa3ad'
unset xtics
set ytics 0, 0.1
set xrange [-0.025:0.025]
set yrange [0:upper_height]
scale = panel_width*width/0.05
set tmargin at screen 1 - 34.0/height
set bmargin at screen base + 56.0/height
set ylabel 'height z [m]' offset 1.5,0
set label 3 'ours' at screen 0.012, screen base + 38.0/height font ',12' textcolor rgb ours
set label 4 'paper' at screen 0.012, screen base + 16.0/height font ',12'
set label 5 'U_L [m/s]' at screen 0.012, screen 1 - 17.0/height font ',12'

do for [k=1:velocity_count] {
  left = 0.13 + 0.17*(k - 1)
  set lmargin at screen left
  set rmargin at screen left + panel_width
  set title velocity[k] font ',13' offset 0,-0.6
  set label 1 simulated[k] at graph 0.5, screen base + 38.0/height center font ',11' textcolor rgb ours
  set label 2 printed[k] at graph 0.5, screen base + 16.0/height center font ',11'
  set label 6 missing[k] at graph 0.5, 0.5 center rotate by 90 font ',12' textcolor rgb quiet
  if (spheres_table[k] ne '') {
    plot spheres_table[k] skip 1 @spheres
  } else {
    plot NaN
  }
  # What stands once, beside the first panel.
  if (k == 1) {
    eval footer_drawn
    set format y ''
    unset ylabel
    unset for [tag=3:5] label tag
  }
}
unset multiplot
