# Figure 13. Reads fig13_plane_U.csv and the values that figure.cpp sets: panel_width over that of the picture, and for
# each panel velocity, plane (its table, empty without one), cell_x and cell_z (size of its cells [m]), simulated and
# printed (mean voidage in words).
set multiplot
set xrange [-0.025:0.025]
set yrange [0:0.4]
set cbrange [0.4:1]
unset grid
unset key
set border 15
unset xtics
set ytics 0, 0.1
set tmargin at screen 1 - 34.0/height
set bmargin at screen base + 62.0/height
set colorbox user origin 0.89, base + 62.0/height size 0.022, 1 - base - 96.0/height
set cbtics 0.4, 0.1 out scale 0.5
set ylabel 'height z [m]' offset 1,0
set label 3 'ours' at screen 0.015, screen base + 40.0/height font ',12' textcolor rgb ours
set label 4 'paper' at screen 0.015, screen base + 18.0/height font ',12'
set label 5 'U_L [m/s]' at screen 0.015, screen 1 - 16.0/height font ',12'
set label 7 'α_L [-]' at screen 0.985, screen 1 - 16.0/height right font ',12'

do for [k=1:velocity_count] {
  left = 0.135 + 0.124*(k - 1)
  set lmargin at screen left
  set rmargin at screen left + panel_width
  set title velocity[k] font ',13' offset 0,-0.6
  set label 1 simulated[k] at graph 0.5, screen base + 40.0/height center font ',12' textcolor rgb ours
  set label 2 printed[k] at graph 0.5, screen base + 18.0/height center font ',12' textcolor rgb paper
  if (plane[k] ne '') {
    # Half a cell each way, a little widened so that no seam of background shows between neighbours.
    plot plane[k] skip 1 using 1:2:(0.52*cell_x[k]):(0.52*cell_z[k]):3 \
      with boxxyerror fillstyle solid noborder linecolor palette
    unset colorbox
  } else {
    set label 6 'not yet simulated' at graph 0.5, 0.5 center rotate by 90 textcolor rgb quiet
    plot NaN
    unset label 6
  }
  # What stands once, beside the first panel.
  if (k == 1) {
    eval footer_drawn
    unset ylabel
    set format y ''
    unset for [tag=3:7] label tag
  }
}
unset multiplot
