# One head-on collision under each law: force over time, force over overlap. Reads one_collision.csv, three columns per
# law: time [ms], overlap over effective radius [%], normal force [N]; value: the list law (names).
set multiplot layout 1,2
set tmargin 4
set lmargin 11
set ylabel 'normal force F_n [N]'
law_style(i) = 2 + (i - 1) % 4
# The first lines are the widest, so that those that lie on them leave an edge to be seen.
width(i) = 2.0 + 1.5*(law_count - i)

set xlabel 'time [ms]'
set key at screen 0.5,0.99 center top vertical maxrows 1 Left reverse font ',12'
plot 0 with lines linestyle 20 notitle, \
  for [i=1:law_count] 'one_collision.csv' skip 1 using 3*i-2:3*i with lines linestyle law_style(i) linewidth width(i) title law[i]

set xlabel 'overlap over effective radius, δ/R* [%]'
unset key
plot 0 with lines linestyle 20 notitle, \
  for [i=1:law_count] 'one_collision.csv' skip 1 using 3*i-1:3*i with lines linestyle law_style(i) linewidth width(i) notitle
unset multiplot
