# Fall of a dropped sphere: track.csv (time, height, velocity), has_line (1 or 0), velocity [m/s] and intercept [m] of
# its straight line.
set xlabel 'time since release [s]'
set ylabel 'height [m]'
set yrange [0:*]
set key outside top center horizontal
if (has_line) {
  plot 'track.csv' skip 1 using 1:2 with lines linestyle 2 title 'height', \
       intercept - velocity*x with lines linestyle 1 title sprintf('V_2 = %.4g m/s', velocity)
} else {
  plot 'track.csv' skip 1 using 1:2 with lines linestyle 2 title 'height'
}
