# The laws among the literature over the Reynolds number, a panel per voidage. Reads drag_lines.csv: Reynolds number,
# then for each voidage a column per law of the literature and a column per compared law; values: literature_count, the
# lists law (names) and voidage.
set datafile missing
set multiplot layout 1,voidage_count
set logscale xy
set format x '10^{%T}'
set xtics 100
set format y '10^{%T}'
set xlabel 'Re [-]'
set xrange [0.01:10000]
set yrange [*<0.9:*]
set lmargin 7
set tmargin 5
law_style(i) = 2 + (i - 1) % 4
set key at screen 0.5,0.99 center top horizontal maxrows 2 font ',12'
set ylabel 'F [-]'
do for [k=1:voidage_count] {
  set label 1 sprintf('voidage %g', voidage[k]) at graph 0.05,0.93
  before = 1 + (k - 1)*(literature_count + law_count)
  plot for [j=1:literature_count] 'drag_lines.csv' skip 1 using 1:before+j with lines linecolor rgb '#c3c8ce' linewidth 1 title (j == 1 ? 'literature' : ''), \
    for [i=1:law_count] 'drag_lines.csv' skip 1 using 1:before+literature_count+i with lines linestyle law_style(i) title law[i]
  unset key
  set ylabel ''
}
unset multiplot
