# What was most likely simulated. Reads most_likely_ranking.csv and most_likely_implausibility.csv (a row per reading),
# most_likely_paper_line.csv, most_likely_paper_velocity.csv and the tables of the lists packed_curve and velocity_curve,
# one item for each of the first readings. Lists that figure.cpp sets: reading and rest_of_reading (the first and, where
# it is long, the second line of its title), number (their titles).
title_of(k) = sprintf("%d: ", k).reading[k].(rest_of_reading[k] eq "" ? "" : "\n".rest_of_reading[k])
lowest = -12
inside(x) = x < lowest ? lowest : x
# What a reading was not run for stands outside the axes.
known(k) = valid(k) ? inside(column(k)) : 9
size = number_count > 17 ? 2.2*17/number_count : 2.2
tic_font = number_count > 28 ? ',9' : ',12'
aside = -99  # outside every axis
array curve_colour[3] = [ours, variant, second_variant]
array curve_point[3] = [7, 5, 9]

# Pixels from the top: the rows of readings lie above the names of the numbers, and these above the two curves.
rows_end = 90.0 + 38*reading_count
set multiplot
set tmargin at screen 1 - 80.0/height
set bmargin at screen 1 - rows_end/height

# Evidence.
set lmargin at screen 0.27
set rmargin at screen 0.41
set title 'evidence' font ',14'
set xrange [lowest:0.4]
set xtics 4
set yrange [reading_count - 0.4:-0.6]
set ytics ('' 0)
do for [k=1:reading_count] { set ytics add (title_of(k) k - 1) font ',12' }
set grid x y
set key at screen 0.005, screen 1 - 6.0/height left top Left reverse vertical maxrows 2 font ',12' samplen 0.6 \
  width (format eq 'svg' ? -3 : 0)
plot 'most_likely_ranking.csv' skip 1 using (known(2)):1 with points linecolor rgb ours pointtype 7 pointsize 1.1 \
    title 'all counted numbers', \
  '' skip 1 using (known(3)):1 with points linecolor rgb variant pointtype 5 pointsize 0.7 title 'packed bed', \
  '' skip 1 using (known(4)):1 with points linecolor rgb second_variant pointtype 9 pointsize 0.8 title 'drops', \
  '' skip 1 using (known(5)):1 with points linecolor rgb quiet pointtype 2 pointsize 0.6 title 'penalty'
eval footer_drawn

# Implausibility.
unset key
set lmargin at screen 0.425
set rmargin at screen 0.93
set title 'implausibility' font ',14'
set ytics ('' 0)
do for [k=1:reading_count] { set ytics add ('' k - 1) }
set xrange [-0.7:number_count - 0.3]
set xtics ('' 0) rotate by 70 right font tic_font
do for [k=1:number_count] { set xtics add (number[k] k - 1) }
set cbrange [0:6]
set colorbox user origin screen 0.945, screen (1 - (rows_end - 40)/height) size screen 0.012, screen (rows_end - 160)/height
set cbtics 3 font ',12'
plot 'most_likely_implausibility.csv' skip 1 using 2:1:(valid(3) ? ($3 > 6 ? 6 : $3) : NaN) \
    with points palette pointtype 5 pointsize size notitle, \
  '' skip 1 using ($4 > 0 ? aside : $2):1 with points linecolor rgb '#ffffff' pointtype 1 pointsize 0.7 notitle, \
  '' skip 1 using (!valid(3) && $5 > 0 ? $2 : aside):1 with points linecolor rgb quiet pointtype 2 pointsize 0.7 notitle
unset colorbox

# The line of the packed bed.
set lmargin at screen 0.075
set rmargin at screen 0.46
set tmargin at screen base + 350.0/height
set bmargin at screen base + 62.0/height
set title 'packed bed' font ',14'
set xtics norotate autofreq font ',12'
set ytics autofreq font ',12'
set xtics 0.01
set xrange [0.02:0.055]
set yrange [0:1800]
set ytics 500
set xlabel 'U_L [m/s]' font ',13'
set ylabel 'pressure drop [Pa]' font ',13' offset 1.5
plot 'most_likely_paper_line.csv' skip 1 using 1:2 with lines linestyle 1 notitle, \
  for [k=1:packed_curve_count] (packed_curve[k] eq '' ? '$empty_list' : packed_curve[k]) skip 1 using 1:2:(half_width(3)) \
    with yerrorbars linecolor rgb curve_colour[k] pointtype curve_point[k] pointsize 0.8 notitle

# V_2.
set lmargin at screen 0.6
set rmargin at screen 0.985
set title 'settling' font ',14'
set xrange [0.04:0.26]
set xtics 0.05
set yrange [0:0.5]
set ytics 0.1
set ylabel 'V_2 [m/s]' font ',13' offset 1.5
set key at graph 0.98, graph 0.04 right bottom Left reverse vertical maxrows 4 font ',12' samplen 1 width 0
plot 'most_likely_paper_velocity.csv' skip 1 using 1:2 with points linecolor rgb paper pointtype 6 pointsize 0.8 \
    title 'paper', \
  for [k=1:velocity_curve_count] (velocity_curve[k] eq '' ? '$empty_list' : velocity_curve[k]) skip 1 \
    using 1:2:(half_width(3)) with yerrorbars linecolor rgb curve_colour[k] pointtype curve_point[k] pointsize 0.8 \
    title sprintf('reading %d', k)
unset multiplot
