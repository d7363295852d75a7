# Figure 14. Reads fig14_plane_U.csv and the values that figure.cpp sets: panel_width and window_width over that of the
# picture; vorticity_lowest and _highest [1/s] and speed_axis [m/s], ends of the colour scales; window_bottom and
# window_top [m]; for each panel velocity, plane (its table, empty without one), cell_x and cell_z (size of its cells
# [m]).
set multiplot
unset grid
unset key
set border 15
unset xtics
set style fill solid noborder
set xrange [-0.025:0.025]

# Vorticity, one panel per velocity.
left = 0.095
pitch = 0.091
right = left + (velocity_count - 1)*pitch + panel_width
set yrange [0:0.4]
set ytics 0, 0.1
set tmargin at screen 1 - 36.0/height
set bmargin at screen base + 84.0/height
set ylabel 'height z [m]' offset 1.6,0
set cbrange [vorticity_lowest:vorticity_highest]
set palette defined (-80 '#2166ac', -40 '#92c5de', 0 '#f7f7f7', 45 '#f4a582', 90 '#b2182b')
set colorbox horizontal user origin left, base + 40.0/height size right - left, 10.0/height
set cbtics 40 out scale 0.5 offset 0,0.4 font ',12'
set label 6 'U_L [m/s]' at screen 0.012, screen 1 - 18.0/height font ',12'
set label 7 'vorticity [1/s]' at screen 0.5*(left + right), screen base + 60.0/height center font ',12'
do for [k=1:velocity_count] {
  set lmargin at screen left + (k - 1)*pitch
  set rmargin at screen left + (k - 1)*pitch + panel_width
  set title velocity[k] font ',12' offset 0,-0.6
  if (plane[k] ne '') {
    # Grey: no difference across the edge. Half a cell each way, a little widened against seams of background.
    set object 1 rectangle from graph 0, 0 to graph 1, 1 behind fillcolor rgb '#dfe3e8' fillstyle solid noborder
    plot plane[k] skip 1 using ($3 == $3 ? $1 : NaN):2:(0.52*cell_x[k]):(0.52*cell_z[k]):3 \
      with boxxyerror linecolor palette
    unset object 1
  } else {
    set label 8 'not yet simulated' at graph 0.5, 0.5 center rotate by 90 font ',12' textcolor rgb quiet
    plot NaN
    unset label 8
  }
  # What stands once, beside the first panel.
  if (k == 1) {
    eval footer_drawn
    set format y ''
    unset ylabel
    unset label 6
    unset label 7
  }
  unset colorbox
}

# Speed and direction in the window, at the lowest and the highest velocity.
left = 0.75
window_height = 2.0*window_width*width  # in pixels; the window is twice as tall as wide
set lmargin at screen left
set rmargin at screen left + window_width
set yrange [window_bottom:window_top]
set ytics 0.05
set format y '%g'
set cbrange [0:speed_axis]
set palette defined (0 '#440154', 1 '#3e4989', 2 '#26828e', 3 '#35b779', 4 '#b5de2b', 5 '#fde725')
set colorbox horizontal user origin 0.695, base + 40.0/height size 0.265, 10.0/height
set cbtics 0.1
set label 7 'speed of the liquid [m/s]' at screen 0.8275, screen base + 60.0/height center font ',12'
do for [place=0:1] {
  k = place == 0 ? 1 : velocity_count
  upper = 36.0 + place*(window_height + 30.0)
  set tmargin at screen 1 - upper/height
  set bmargin at screen 1 - (upper + window_height)/height
  set title velocity[k].' m/s' font ',12' noenhanced
  if (plane[k] ne '') {
    # A vector of 0.25 m/s is as long as a cell. Black on yellow and white on violet would vanish, so both are drawn.
    scale = cell_x[k]/0.25
    plot plane[k] skip 1 using 1:2:(0.52*cell_x[k]):(0.52*cell_z[k]):4 with boxxyerror linecolor palette, \
         for [line=1:2] plane[k] skip 1 \
           using ($1 - 0.5*scale*$5):($2 - 0.5*scale*$6):(scale*$5):(scale*$6) with vectors head filled \
           size 0.0012,20 linecolor rgb (line == 1 ? '#ffffff' : '#14181d') linewidth (line == 1 ? 2.6 : 1.1)
  } else {
    set label 8 'not yet simulated' at graph 0.5, 0.5 center font ',12' textcolor rgb quiet
    plot NaN
    unset label 8
  }
  unset label 7
  unset colorbox
}
unset multiplot
