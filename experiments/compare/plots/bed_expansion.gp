# Expansion of the homogeneous bed. Reads bed_expansion.csv (voidage, then superficial velocities [m/s]) and
# bed_expansion_paper.csv; values: packed_voidage, printed_title, and lists of columns: literature, inside (laws inside
# their ranges) and outside, the latter two with inside_title, inside_style, outside_title, outside_style.
set datafile missing
set key tmargin left Left reverse maxrows 3 font ',12'
set logscale xy
set xrange [packed_voidage - 0.02:1]
set yrange [*<0.02:1<*]
set xtics (0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1)
set xlabel 'voidage [-]'
set ylabel 'superficial velocity [m/s]'
plot for [i=1:literature_count] 'bed_expansion.csv' skip 1 using 1:literature[i] with lines linecolor rgb '#c3c8ce' linewidth 1 title (i == 1 ? 'literature' : ''), \
  for [i=1:inside_count] 'bed_expansion.csv' skip 1 using 1:inside[i] with lines linestyle inside_style[i] title inside_title[i], \
  for [i=1:outside_count] 'bed_expansion.csv' skip 1 using 1:outside[i] with lines linestyle outside_style[i] dashtype (2, 3) title outside_title[i], \
  'bed_expansion_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title printed_title
