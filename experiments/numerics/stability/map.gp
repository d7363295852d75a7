# Stability map. map_chart.cpp says what is drawn:
#   series_title and series (tables) of the methods, with and without a boundary in the range
#   bracketed[1 … bracketed_end], open[1 … open_end]: numbers of the methods, from 1, with boundaries, and with points
#     that have none in the range
#   theory, theory_column, theory_series (number of the method whose colour it has; 0: grey), theory_dash (7 or 8),
#     theory_title: limits of theory
#   here: table of this machine's quick set, or none; mark_x, mark_y, mark_text, mark_right: settings in use
#   x_log, x_low, x_high, y_low, y_high, x_label, y_label, x_format, y_format, middle (of the range of y), fails_high,
#     key_rows
array colour[6] = ['#0072b2', '#d55e00', '#009e73', '#aa4499', '#8a6d00', '#56b4e9']
array point[6] = [7, 5, 9, 13, 11, 15]
do for [s=1:series_count] {
  i = (s - 1) % 6 + 1
  set style line 100 + s linecolor rgb colour[i] linewidth 2 pointtype point[i] pointsize 0.8
  set style line 200 + s linecolor rgb colour[i] linewidth 1.4 pointtype 0
}
set dashtype 7 (8, 5)
set dashtype 8 (2, 4)
theory_colour(k) = theory_series[k] > 0 ? colour[(theory_series[k] - 1) % 6 + 1] : '#5b6470'
set logscale y
if (x_log) { set logscale x }
if (x_format ne '') { set format x x_format }
if (y_format ne '') { set format y y_format }
set xrange [x_low:x_high]
set yrange [y_low:y_high]
set xlabel x_label
set ylabel y_label
do for [k=1:mark_x_count] {
  if (mark_right[k]) {
    set label 200 + k mark_text[k] at mark_x[k], mark_y[k] right offset -1, 0 font ',11' front
  } else {
    set label 200 + k mark_text[k] at mark_x[k], mark_y[k] offset 1, 0 font ',11' front
  }
}
set label 300 'fails' at graph 0.985, graph (fails_high ? 0.96 : 0.04) right font ',12' textcolor rgb '#b0303c'
set label 301 'holds' at graph 0.985, graph (fails_high ? 0.04 : 0.96) right font ',12' textcolor rgb '#3f7f5f'
set bmargin 5 + key_rows
# gnuplot takes the titles to be longer than they are drawn, and leaves out a column that would not fit then.
longest = 0
do for [s=1:series_count] { longest = strlen(series_title[s]) > longest ? strlen(series_title[s]) : longest }
do for [k=1:theory_count] { longest = strlen(theory_title[k]) > longest ? strlen(theory_title[k]) : longest }
set key at screen 0.5, character key_rows + 1.3 center top vertical maxrows key_rows Left reverse font ',11' \
  samplen 1.5 width (format eq 'svg' ? -0.35 : -0.12)*longest

# gnuplot opens the first file even where a loop has nothing to do: that is $empty_list.
# Bars first: they would take the points' middle away. Methods without a boundary keep their place in the key; an arrow
# leads out of the range in which was looked.
plot \
  for [k=1:bracketed_end] (k <= bracketed_end ? series[bracketed[k]] : '$empty_list') skip 1 using 1:2:3:4 \
    with yerrorbars linestyle 200 + bracketed[k] notitle, \
  for [k=1:bracketed_end] (k <= bracketed_end ? series[bracketed[k]] : '$empty_list') skip 1 using 1:2 \
    with linespoints linestyle 100 + bracketed[k] notitle, \
  for [k=1:open_end] (k <= open_end ? series[open[k]] : '$empty_list') skip 1 using 1:5:(0):($5 > middle ? 0.45*$5 : -0.35*$5) \
    with vectors head filled linestyle 100 + open[k] notitle, \
  for [s=1:series_count] keyentry with linespoints linestyle 100 + s title series_title[s], \
  for [k=1:here_count] here[k] skip 1 using 1:2 \
    with points pointtype 6 pointsize 1.4 linecolor rgb '#000000' title 'quick set, this machine', \
  for [k=1:theory_count] theory[k] skip 1 using 1:theory_column[k] \
    with lines linecolor rgb theory_colour(k) linewidth 1.4 dashtype theory_dash[k] title theory_title[k], \
  for [k=1:mark_x_count] '+' every ::0::0 using (mark_x[k]):(mark_y[k]) \
    with points pointtype 3 pointsize 1.4 linewidth 2 linecolor rgb '#000000' notitle
