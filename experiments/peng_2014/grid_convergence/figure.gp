# Values over the finest against the size: cells above, steps below; one panel for each quantity. Reads grid-convergence_N.csv
# (size, then ratio and half width of each quantity). Lists that figure.cpp sets: sequence (files), sequence_title, quantity,
# panel (which sequences have a number there, those above first).
array colour[9] = [ours, variant, second_variant, third_variant, law_one, law_two, law_three, law_four, '#5b6470']
array point_type[9] = [7, 5, 9, 13, 11, 15, 6, 4, 8]
number(i) = (i - 1)%9 + 1
# Side by side, so that intervals do not hide each other.
place(i) = column(1)*(1 + 0.012*(number(i) - 5))
half_width(q) = valid(2*q + 1) ? column(2*q + 1) : 0
array low[4] = [0.5, 0.96, 0.97, 0.7]
array high[4] = [2.5, 1.06, 1.03, 1.3]
key_width = 0.24
left_edge = 0.06
panel_width = (0.99 - key_width - left_edge)/quantity_count

set multiplot
set logscale x
set bars 0.4
set grid x y
unset key
do for [row=1:2] {
  set tmargin at screen (row == 1 ? 0.94 : 0.45)
  set bmargin at screen (row == 1 ? 0.58 : 0.09)
  set xlabel (row == 1 ? 'cell width [mm]' : 'step [ms]') offset 0, 0.5
  if (row == 1) {
    set xrange [2.5:15]
    set xtics (3, 5, 7, 10)
  } else {
    set xrange [0.007:7]
    set xtics ('0.01' 0.01, '0.1' 0.1, '1' 1)
  }
  do for [q=1:quantity_count] {
    set lmargin at screen left_edge + (q - 1)*panel_width
    set rmargin at screen left_edge + (q - 0.25)*panel_width
    set title (row == 1 ? quantity[q] : '')
    set ylabel (q == 1 ? 'over that of the finest' : '') offset 1.5
    set yrange [low[q]:high[q]]
    drawn = panel[(row - 1)*quantity_count + q]
    if (q == 2) {  # all sequences have a voidage
      set key at screen 0.985, screen (row == 1 ? 0.94 : 0.45) right top Left reverse font ',10' samplen 0.5
    }
    plot 1 with lines linecolor rgb quiet notitle, \
      for [i in drawn] sequence[int(i)] skip 1 using (place(int(i))):(column(2*q)) \
        with lines linecolor rgb colour[number(int(i))] linewidth 1 notitle, \
      for [i in drawn] sequence[int(i)] skip 1 using (place(int(i))):(column(2*q)):(half_width(q)) \
        with yerrorbars linecolor rgb colour[number(int(i))] pointtype point_type[number(int(i))] pointsize 0.01 notitle, \
      for [i in drawn] sequence[int(i)] skip 1 using (place(int(i))):(column(2*q)) \
        with points linecolor rgb colour[number(int(i))] pointtype point_type[number(int(i))] pointsize 0.6 \
        title sequence_title[int(i)]
    unset key
  }
}
unset multiplot
