# Figure 8. Reads fig08_history.csv (when simulated is 1), fig08_clear_liquid.csv and the values that figure.cpp sets:
# end of the axis of time and its step [s], entry (when the sphere enters the bed [s], NaN when that is not known), and
# for each panel lower and upper end of its axis, its step and fall_column (of the sphere alone in clear liquid; 0: not
# drawn). Panel k shows column k + 1 of the history.
array heading[6] = ['height z [m]', 'vertical velocity v_z [m/s]', 'angular speed |ω| [rad/s]', \
  'voidage at the sphere α_L [-]', 'vertical liquid velocity at the sphere u_z [m/s]', 'Reynolds number Re_p [-]']

set multiplot
set lmargin at screen 0.125
set rmargin at screen 0.97
set xrange [0:end]
set xtics time_step
set format x ''
bottom = base + 58.0/height
pitch = (1 - bottom)/6
set label 5 'red: one sphere alone in clear liquid' at graph 0.99, 0.85 right font ',11' textcolor rgb law_one
if (entry == entry) {
  set arrow 1 from entry, graph 0 to entry, graph 1 nohead linestyle 20
  set label 1 '  in the bed' at entry, graph 0.12 font ',11' textcolor rgb quiet
  set label 2 'in liquid  ' at entry, graph 0.12 right font ',11' textcolor rgb quiet
}
if (!simulated) {
  set label 4 'not yet simulated' at graph 0.5, 0.5 center textcolor rgb quiet
}

do for [k=1:6] {
  set tmargin at screen 1 - (k - 1)*pitch - 26.0/height
  set bmargin at screen 1 - k*pitch
  set label 3 heading[k] at graph 0, graph 1.12 font ',12'
  set yrange [lower[k]:upper[k]]
  set ytics step[k]
  if (k == 6) {
    set format x '%g'
    set xlabel 'time since release [s]' offset 0,0.7
  }
  if (simulated) {
    plot 'fig08_history.csv' skip 1 using 1:k+1 with lines linestyle 2 linewidth 1.3 notitle, \
         for [i=1:(fall_column[k] > 0)] 'fig08_clear_liquid.csv' skip 1 using 1:int(fall_column[k]) \
           with lines linestyle 11 notitle
  } else {
    plot NaN notitle, \
         for [i=1:(fall_column[k] > 0)] 'fig08_clear_liquid.csv' skip 1 using 1:int(fall_column[k]) \
           with lines linestyle 11 notitle
  }
  if (k == 1) {
    eval footer_drawn
    unset label 1
    unset label 2
    unset label 5
  }
}
unset multiplot
