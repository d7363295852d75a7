# Restitution of a bounce in the liquid over the dry one, against the Stokes number. Reads wet_restitution.csv (impact
# speed, Stokes number, two laws of the literature, then each contact law) and wet_restitution_measured.csv; values:
# no_rebound_below and dry_above (Stokes numbers of Joseph et al. 2001) and the list law (names).
set key tmargin left Left reverse maxrows 4 font ',12'
set logscale x
set xrange [3:1500]
set yrange [0:1.05]
set xlabel 'Stokes number ρ_P U d/9μ [-]'
set ylabel 'restitution over the dry one [-]'
set object 1 rectangle from 3,0 to no_rebound_below,1.05 fillcolor rgb '#f0f1f3' fillstyle solid noborder behind
set object 2 rectangle from dry_above,0 to 1500,1.05 fillcolor rgb '#f0f1f3' fillstyle solid noborder behind
set label 1 'no rebound' at sqrt(3*no_rebound_below),0.5 center rotate by 90 font ',11' textcolor rgb '#5b6470'
set label 2 'dry value' at sqrt(1500*dry_above),0.5 center rotate by 90 font ',11' textcolor rgb '#5b6470'
law_style(i) = 2 + (i - 1) % 4
# The first lines are the widest, so that those that lie on them leave an edge to be seen.
width(i) = 2.0 + 1.5*(law_count - i)
plot 'wet_restitution.csv' skip 1 using 2:3 with lines linestyle 11 title 'Legendre 2005', \
  '' skip 1 using 2:4 with lines linestyle 12 title 'Barnocky, Davis 1988', \
  'wet_restitution_measured.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'Gondret 2002, measured', \
  for [i=1:law_count] 'wet_restitution.csv' skip 1 using 2:i+4 with lines linestyle law_style(i) linewidth width(i) title law[i]
