# Figure 5. Reads fig05_*.csv and the values that figure.cpp sets: weight, crossing and plateau of the paper, the lists
# packed (Ergun's lines) and simulated.
set multiplot
set lmargin at screen 0.155
set rmargin at screen 0.965
set ylabel 'pressure drop Δp [Pa]' offset 1.6,0
set xlabel 'superficial liquid velocity U_L [m/s]' offset 0,0.2
split = base + 0.42*(1 - base)

# The same curves in both panels.
curves = "for [i=1:packed_count] packed[i] skip 1 using 1:2 with lines linestyle packed_style[i] title packed_title[i], ".\
  "weight with lines linestyle 11 title sprintf('weight of the bed, %.0f Pa', weight), ".\
  "'fig05_paper.csv' skip 1 using 1:2 with lines linestyle 1 title 'paper, fitted lines', ".\
  "'fig05_minimum_fluidisation.csv' skip 1 using 2:3 with points pointtype 11 pointsize 0.9 linecolor rgb law_one title 'U_{mf} by Eq. 36 at these voidages', ".\
  "for [i=1:simulated_count] simulated[i] skip 1 using 1:2:(0):3 with xyerrorbars linestyle simulated_style[i] pointsize 0 linewidth 1.4 notitle, ".\
  "for [i=1:simulated_count] simulated[i] skip 1 using 1:2 with points linestyle simulated_style[i] title simulated_title[i]"

# All velocities.
set tmargin at screen 1 - 12.0/height
set bmargin at screen split + 40.0/height
set xrange [0:0.25]
set yrange [0:1800]
set xtics 0.05
set ytics 400
set key at graph 0.99, graph 0.03 bottom right reverse Left font ',11' spacing 1.05
plot @curves
eval footer_drawn

# Around the crossing, enlarged.
set tmargin at screen split - 24.0/height
set bmargin at screen base + 74.0/height
set xrange [0.034:0.066]
set yrange [1000:1600]
set xtics 0.04, 0.01
set ytics 200
unset key
set arrow 1 from crossing, graph 0 to crossing, plateau nohead linestyle 1 linewidth 0.8
set label 1 sprintf('paper: U_{mf} = %.4f m/s', crossing) at crossing, graph 0.1 offset 0.6,0 font ',11'
plot @curves
unset multiplot
