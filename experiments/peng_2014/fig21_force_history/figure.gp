# Figure 21. Reads fig21_force_*.csv. Values that figure.cpp sets: lowest and highest peak of the paper; end of
# the time axis [s]; top_of_axis; one item per panel of the lists heading, remark and force (table; '' when there is none).
set multiplot
left = 0.12
right = 0.985
top = 1 - 40.0/height
bottom = base + 58.0/height
gap_x = 0.03
gap_y = 62.0/height
panel_width = (right - left - gap_x)/2
panel_height = (top - bottom - 2*gap_y)/3
tic_step(end) = end > 5 ? 5 : end > 2 ? 1 : end > 1 ? 0.5 : 0.2
unset key
set yrange [0:top_of_axis]
set ytics 20
set label 2 'paper: peaks between these lines' at graph 0.98, graph 0.93 right font ',10'

do for [i=1:heading_count] {
  column_of_panel = (i - 1) % 2
  row_of_panel = (i - 1)/2
  panel_left = left + column_of_panel*(panel_width + gap_x)
  panel_top = top - row_of_panel*(panel_height + gap_y)
  set lmargin at screen panel_left
  set rmargin at screen panel_left + panel_width
  set tmargin at screen panel_top
  set bmargin at screen panel_top - panel_height
  set title heading[i] font ',11' offset 0,0.1
  set label 1 remark[i] at graph 0.5, graph 1.03 center font ',8' textcolor rgb quiet
  set xrange [0:end]
  set xtics tic_step(end)
  if (column_of_panel == 0) {
    set format y '%g'
    set ylabel '|F_c|/mg [-]' offset -0.2,0
  } else {
    set format y ''
    unset ylabel
  }
  if (row_of_panel == 2) { set xlabel 'time since entering the bed [s]' offset 0,0.8 }
  if (force[i] eq '') {
    plot lowest with lines linestyle 1 linewidth 0.8, highest with lines linestyle 1 linewidth 0.8
  } else {
    plot lowest with lines linestyle 1 linewidth 0.8, highest with lines linestyle 1 linewidth 0.8, \
      force[i] skip 1 using 1:2 with impulses linecolor rgb ours linewidth 0.8
  }
  if (i == 1) {
    eval footer_drawn
    unset label 2
  }
}
unset multiplot
