# Laws of one kind over the sweep of that kind. Reads TABLE.csv: x, then a column per law. Values: table; x_title,
# y_title; from, to (of x); y_bounded, lower, upper (of y); x_logarithmic, y_logarithmic; and as columns:
#   member, member_title    all laws of a kind, each with its name
# or, where that list is empty, one law among the others:
#   law                     its name
#   inside, outside         its columns inside and outside its range
#   variant, variant_title  its variants, in colour
#   other                   the other laws of its kind, in grey
set datafile missing
# Room for the title of the y axis left of "10000".
set lmargin 12
set xlabel x_title offset 0,0.6
set ylabel y_title
set xrange [from:to]
if (y_bounded) { set yrange [lower:upper] }
if (x_logarithmic) {
  set logscale x
  set format x '10^{%T}'
}
if (y_logarithmic) { set logscale y }

# Seven colours that the colour-blind tell apart; each round of them has another dash.
array colours[7] = ['#0072b2', '#d55e00', '#009e73', '#aa4499', '#8a6d00', '#b0303c', '#3b4450']
set dashtype 2 (10, 4)
set dashtype 3 (3, 3)
colour(i) = colours[1 + (i - 1) % 7]
dash(i) = 1 + ((i - 1)/7) % 3

file = table.'.csv'
if (member_count > 0) {
  set key below left maxcols 2 Left reverse font ',11'
  plot for [i=1:member_count] file skip 1 using 1:member[i] with lines linewidth 1.6 linecolor rgb colour(i) dashtype dash(i) title member_title[i]
} else {
  set key tmargin left Left reverse font ',12'
  plot for [i=1:other_count] file skip 1 using 1:other[i] with lines linecolor rgb '#c3c8ce' linewidth 1 title (i == 1 && i <= other_count ? 'other laws of this kind' : ''), \
    for [i=1:variant_count] file skip 1 using 1:variant[i] with lines linestyle 10 + i title variant_title[i], \
    file skip 1 using 1:inside with lines linestyle 2 linewidth 3 title law, \
    file skip 1 using 1:outside with lines linestyle 2 linewidth 2.5 dashtype (2, 3) title 'the same outside its range'
}
