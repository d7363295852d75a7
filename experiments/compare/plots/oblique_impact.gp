# Oblique impact on a wall over the angle. Reads oblique_impact.csv: angle [degrees], tangential restitution and spin of
# a rigid sphere that slides, then both for each law; value: the list law (names).
set multiplot layout 1,2
set tmargin 4
set xrange [0:90]
set xtics 15
set xlabel 'angle to the normal [°]'
law_style(i) = 2 + (i - 1) % 4
# The first lines are the widest, so that those that lie on them leave an edge to be seen.
width(i) = 2.0 + 1.5*(law_count - i)
rigid = "with lines linecolor rgb '#c3c8ce' linewidth 12 notitle"

set ylabel "tangential restitution v_t'/v_t [-]"
set key at screen 0.5,0.99 center top vertical maxrows 1 Left reverse font ',12'
plot 'oblique_impact.csv' skip 1 using 1:2 @rigid, \
  for [i=1:law_count] 'oblique_impact.csv' skip 1 using 1:2*i+2 with lines linestyle law_style(i) linewidth width(i) title law[i]

set ylabel "spin rω'/v_n [-]"
unset key
plot 'oblique_impact.csv' skip 1 using 1:3 @rigid, \
  for [i=1:law_count] 'oblique_impact.csv' skip 1 using 1:2*i+3 with lines linestyle law_style(i) linewidth width(i) notitle
unset multiplot
