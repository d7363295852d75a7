# Figure 9. Reads fig09_drops_U.csv and the values that figure.cpp sets: columns and rows of panels; for each panel
# velocity, samples (its table, empty without drops), first_drop and drops (place of its first drop in the list slope,
# and their number), longest (time that a straight line takes through the window [s]), paper_slope [m/s], NaN for none;
# slope of each drop [m/s].
set multiplot
left = 0.1
right = 0.985
bottom = base + 60.0/height
top = 1 - 62.0/height
gap_x = 0.03
gap_y = 52.0/height
panel_width = (right - left - (columns - 1)*gap_x)/columns
panel_height = (top - bottom - (rows - 1)*gap_y)/rows
set yrange [0.09:0.21]
set ytics 0.1, 0.05
unset key
time_step(longest) = longest > 2.0 ? 1.0 : longest > 0.8 ? 0.5 : 0.2

do for [k=1:velocity_count] {
  row = (k - 1)/columns
  column = (k - 1) % columns
  set lmargin at screen left + column*(panel_width + gap_x)
  set rmargin at screen left + column*(panel_width + gap_x) + panel_width
  set tmargin at screen top - row*(panel_height + gap_y)
  set bmargin at screen top - row*(panel_height + gap_y) - panel_height
  set title 'U_L = '.velocity[k].' m/s' font ',13' offset 0,-0.7
  set label 1 (drops[k] > 0 ? '' : 'not yet simulated') at graph 0.97, 0.92 right font ',11' textcolor rgb quiet
  if (column == 0) {
    set format y '%.2f'
    set ylabel 'height z [m]' offset 0.8,0
  } else {
    set format y ''
    unset ylabel
  }
  set xrange [-0.08*longest[k]:1.15*longest[k]]
  set xtics time_step(longest[k])
  if (k + columns > velocity_count) {
    set xlabel 'time since z = 0.2 m [s]' offset 0,0.4
  }
  if (drops[k] > 0) {
    plot for [d=1:drops[k]] samples[k] skip 1 using ($1 == d ? $2 : NaN):3 \
           with lines linecolor rgb pale_2 linewidth 2.2, \
         for [d=1:drops[k]] 0.2 - slope[first_drop[k] + d - 1]*x with lines linecolor rgb '#003f63' linewidth 0.9, \
         0.2 - paper_slope[k]*x with lines linestyle 1
  } else {
    plot 0.2 - paper_slope[k]*x with lines linestyle 1
  }
  if (k == 1) {
    eval footer_drawn
  }
}

# The key has the width of the picture, so it is a plot of its own; gnuplot's would wrap differently in each format.
set lmargin at screen left
set rmargin at screen right
set tmargin at screen 1 - 6.0/height
set bmargin at screen 1 - 30.0/height
unset title
unset label 1
unset border
unset tics
unset xlabel
unset ylabel
set arrow 1 from 0.00, 0.5 to 0.08, 0.5 nohead linecolor rgb pale_2 linewidth 2.2
set label 11 'drops' at 0.10, 0.5
set arrow 2 from 0.28, 0.5 to 0.36, 0.5 nohead linecolor rgb '#003f63' linewidth 0.9
set label 12 'straight lines' at 0.38, 0.5
set arrow 3 from 0.70, 0.5 to 0.78, 0.5 nohead linestyle 1
set label 13 'paper' at 0.80, 0.5
plot [0:1] [0:1] NaN notitle
unset multiplot
