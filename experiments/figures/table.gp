# A table as a picture, so that it can be put beside the figures. Reads cell (its rows one after the other, each of
# column_count texts), heading_1 and heading_2 (the two lines of each heading), the heights head_height and row_height of
# its head and rows and table_height of all [pixel], and from the figure for each column its place [pixel] in position,
# left (1: position is its left edge, 0: its right one) and colour.
unset grid
unset key
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set xrange [0:width]
set yrange [table_height:0]
set arrow 1 from 8, head_height - 4 to width - 8, head_height - 4 nohead linecolor rgb '#5b6470' linewidth 1
row_count = cell_count/column_count
tag = 0
do for [c=1:column_count] {
  do for [r=-1:row_count] {
    entry = r == -1 ? heading_1[c] : r == 0 ? heading_2[c] : cell[(r - 1)*column_count + c]
    y = r == -1 ? 14 : r == 0 ? 33 : head_height + (r - 0.5)*row_height
    tag = tag + 1
    if (left[c]) {
      set label tag entry at position[c], y left font ',12' textcolor rgb colour[c] front
    } else {
      set label tag entry at position[c], y right font ',12' textcolor rgb colour[c] front
    }
  }
}
# Every other row is shaded.
do for [r=2:row_count:2] {
  set object r rectangle from 8, head_height + (r - 1)*row_height to width - 8, head_height + r*row_height \
    fillcolor rgb '#f1f4f7' fillstyle solid noborder behind
}
plot NaN
