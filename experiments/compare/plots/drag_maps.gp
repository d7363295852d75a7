# Maps over Reynolds number and voidage side by side with one colour bar: the drag of each law, or its ratio to other
# laws. Reads TABLE.csv: voidage, Reynolds number, then a column per map; values: table, ratio (1: ratios, 0: drag),
# across (maps in a row), the list map (titles) and sizes in pixels: width and height of the picture, map_width,
# map_height, left, bar (for the colour bar), above and below (each map), foot.
if (ratio) {
  set palette defined (-1 '#2166ac', -0.5 '#92c5de', 0 '#f7f7f7', 0.5 '#f4a582', 1 '#b2182b')
  set cbrange [-1:1]
  set cbtics ('1/2' -1, '0.71' -0.5, '1' 0, '1.41' 0.5, '2' 1)
} else {
  set cbrange [0:5]
  set cbtics format '10^{%g}'
}
within(x) = x > 1 ? 1 : x < -1 ? -1 : x
shade(x) = ratio ? within(log(x)/log(2)) : log10(x)
# An image of an SVG would be a second file; a PNG would show the seams between single rectangles.
drawn = format eq 'png' ? '' : 'pixels'
set multiplot
unset key
set xrange [-2:4]
set yrange [0.36:1]
set xtics -2,2,2 format '10^{%g}'
set ytics 0.2
do for [i=1:map_count] {
  column_of_map = (i - 1) % across
  from_left = left + column_of_map*map_width
  from_top = ((i - 1)/across)*(above + map_height + below) + above
  set lmargin at screen 1.0*from_left/width
  set rmargin at screen 1.0*(from_left + map_width - 18)/width
  set tmargin at screen 1 - 1.0*from_top/height
  set bmargin at screen 1 - 1.0*(from_top + map_height)/height
  set title map[i] offset 0,-0.8 font ',11'
  set xlabel (i + across > map_count ? 'Re [-]' : '') offset 0,0.6
  set ylabel (column_of_map == 0 ? 'voidage [-]' : '')
  set format y (column_of_map == 0 ? '%g' : '')
  if (i == 1) {
    set colorbox user origin 1 - 1.0*(bar - 10)/width,1.0*(below + foot)/height size 16.0/width,1 - 1.0*(above + below + foot)/height
  } else {
    unset colorbox
  }
  plot table.'.csv' skip 1 using (log10($2)):1:(shade(column(i + 2))) with image @drawn notitle
}
unset multiplot
