# Work-precision chart of a study. frontier_chart.cpp says what is drawn:
#   page_rows, page_columns, page_left, page_bottom, page_top, page_gap: the layout; key_rows: of the key
#   series, series_title: the methods' tables and names
#   foot, foot_position: lines of text below the panels and their heights
# and for each panel p: panel_title, panel_x_label, panel_first (1: leftmost of its row), panel_cost (column of the cost),
#   panel_error (column of the error; the ends of its interval follow), panel_band (interval of the reference, 0: none),
#   panel_left and panel_right (range of the cost), panel_low and panel_high (range of the error),
#   panel_top (where failures stand), panel_drawn_end (methods that have points: drawn[previous end + 1 … end]),
#   panel_front (table of the Pareto front) and panel_has_front, panel_has_here and panel_here (column in `here`, this
#   machine's quick set)
# and `failed`, the tables of the methods that failed somewhere.
set logscale xy
set format '10^{%L}'
set tics font ',11'
do for [k=1:foot_count] {
  set label 900 + k foot[k] at screen 0.012, foot_position[k] font ',10' textcolor rgb '#6b7580' front
}
array colour[8] = ['#0072b2', '#d55e00', '#009e73', '#aa4499', '#8a6d00', '#56b4e9', '#5a4fa2', '#b0303c']
array point[8] = [7, 5, 9, 13, 11, 15, 6, 4]
do for [s=1:series_count] {
  i = (s - 1) % 8 + 1
  set style line 100 + s linecolor rgb colour[i] linewidth 1.6 pointtype point[i] pointsize 0.75
  set style line 200 + s linecolor rgb colour[i] linewidth 1.2 pointtype 0
}
reason = 5  # column of the number of the reason of failure
set multiplot layout page_rows, page_columns margins page_left, 0.97, page_bottom, page_top spacing 0.075, page_gap
set key at screen 0.5, 0.985 center top vertical maxrows key_rows font ',12' width (page_columns == 1 || format eq 'svg' ? -2 : 2)
begin = 1
do for [p=1:panel_title_count] {
  cost = panel_cost[p]
  error = panel_error[p]
  set title panel_title[p] font ',13' offset 0,-0.8
  set xlabel panel_x_label[p] font ',13'
  if (panel_first[p]) { set ylabel 'relative error' font ',13' offset 2,0 } else { unset ylabel }
  if (panel_band[p] > 0) {
    set object 1 rectangle from graph 0, graph 0 to graph 1, first panel_band[p] fillcolor rgb '#dfe3e8' \
      fillstyle solid noborder behind
  }
  set xrange [panel_left[p]:panel_right[p]]
  set yrange [panel_low[p]:panel_high[p]]
  # gnuplot opens the first file even where a loop has nothing to do.
  file(k, end) = k <= end ? series[drawn[k]] : '$empty_list'
  # Bars first: they would take the points' middle away. Methods without a point keep their place in the key. A failure
  # has a cost but no error: it is a numbered cross at the top.
  plot \
    for [k=begin:panel_drawn_end[p]] file(k, panel_drawn_end[p]) skip 1 using cost:error:error+1:error+2 \
      with yerrorbars linestyle 200 + drawn[k] notitle, \
    for [k=begin:panel_drawn_end[p]] file(k, panel_drawn_end[p]) skip 1 using cost:error \
      with linespoints linestyle 100 + drawn[k] notitle, \
    for [k=1:failed_count] failed[k] skip 1 using (column(reason) > 0 ? column(cost) : NaN):(panel_top[p]) \
      with points pointtype 2 pointsize 1.1 linewidth 2 linecolor rgb '#b0303c' notitle, \
    for [k=1:failed_count] failed[k] skip 1 \
      using (column(reason) > 0 ? column(cost) : NaN):(panel_top[p]):(sprintf('%d', column(reason))) \
      with labels offset 0.9, 0 font ',10' textcolor rgb '#b0303c' notitle, \
    for [s=1:series_count] keyentry with linespoints linestyle 100 + s title series_title[s], \
    for [k=1:panel_has_front[p]] (panel_has_front[p] ? panel_front[p] : '$empty_list') skip 1 using 1:2 \
      with fsteps linecolor rgb '#000000' linewidth 1 dashtype (6, 4) title 'Pareto front', \
    for [k=1:panel_has_here[p]] (panel_has_here[p] ? here[1] : '$empty_list') skip 1 using cost:panel_here[p] \
      with points pointtype 6 pointsize 1.4 linecolor rgb '#000000' title 'quick set, this machine'
  begin = panel_drawn_end[p] + 1
  # Key and text belong to the page, not to each of its panels.
  unset object 1
  set key off
  do for [k=1:foot_count] { unset label 900 + k }
}
unset multiplot
