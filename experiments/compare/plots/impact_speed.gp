# Restitution, contact time and peak force over the impact speed. Reads impact_speed.csv, six columns per law:
# restitution, contact time [ms], peak force [N], then restitution at the step of the scene, mean, lowest and highest;
# value: the list law (names).
set multiplot layout 1,3
set tmargin 4
set lmargin 10
set logscale x
set xrange [0.008:1.25]
set format x '10^{%T}'
set xtics 10
set xlabel 'impact speed [m/s]'
law_style(i) = 2 + (i - 1) % 4
# The first lines are the widest, so that those that lie on them leave an edge to be seen.
width(i) = 2.0 + 1.5*(law_count - i)
# The bars of all laws are alike: they stand side by side.
aside(i) = 1.1**(i - 0.5*(law_count + 1))

set ylabel 'restitution e [-]'
set yrange [*:*]
set key at screen 0.5,0.99 center top vertical maxrows 1 Left reverse font ',12'
plot for [i=1:law_count] 'impact_speed.csv' skip 1 using 1:6*i-4 with lines linestyle law_style(i) linewidth width(i) title law[i], \
  for [i=1:law_count] 'impact_speed.csv' skip 1 using ($1*aside(i)):6*i-1:6*i:6*i+1 with yerrorbars linestyle law_style(i) pointsize 0.6 linewidth 1 notitle

unset key
set yrange [0:*]
set ylabel 'contact time [ms]'
plot for [i=1:law_count] 'impact_speed.csv' skip 1 using 1:6*i-3 with lines linestyle law_style(i) linewidth width(i) notitle

set logscale y
set yrange [*:*]
set format y '10^{%T}'
set ylabel 'peak force [N]'
plot for [i=1:law_count] 'impact_speed.csv' skip 1 using 1:6*i-2 with lines linestyle law_style(i) linewidth width(i) notitle
unset multiplot
