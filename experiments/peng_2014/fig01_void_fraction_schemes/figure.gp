# Figure 1. Reads fig01_*.csv and the values that figure.cpp sets: method (names; column m + 1 of the tables), cost and
# error of each, paper_cell (size of the cells in diameters).
lower = 2e-4  # of the axis of errors; exact overlap, whose error is zero here, stands on it
above(error) = error > lower ? error : lower

# One look for each method: meshing in ever darker orange, with diffusion dashed.
set style line 101 linecolor rgb second_variant linewidth 2 pointtype 9 pointsize 0.8
set style line 102 linecolor rgb '#f3c39b' linewidth 2 pointtype 5 pointsize 0.6
set style line 103 linecolor rgb '#eb9f5e' linewidth 2 pointtype 5 pointsize 0.6
set style line 104 linecolor rgb '#e07b26' linewidth 2 pointtype 5 pointsize 0.6
set style line 105 linecolor rgb variant linewidth 2.6 pointtype 5 pointsize 0.8
set style line 106 linecolor rgb '#8a3c00' linewidth 2 pointtype 5 pointsize 0.6
set style line 107 linecolor rgb ours linewidth 2.2 pointtype 7 pointsize 1
set style line 108 linecolor rgb second_variant linewidth 1.6 pointtype 8 pointsize 0.9 dashtype (6, 4)
set style line 109 linecolor rgb ours linewidth 1.6 pointtype 6 pointsize 0.8 dashtype (6, 4)
meshing_first = 2
meshing_last = 6

set multiplot layout 2,3 margins 0.055,0.988,0.085,0.945 spacing 0.066,0.155

# The template, cut open.
set title 'template of 1214 pieces of equal volume'
unset border
unset tics
unset key
unset grid
set size ratio -1
set xrange [-1.1:1.1]
set yrange [-1.1:1.1]
set style fill solid 1 border rgb '#1b2a38'
plot 'fig01_template.csv' skip 1 using 1:2:3:4 with circles linecolor rgb variable linewidth 0.4

# Error against the size of the cells.
set size noratio
set border 3
set grid back
set logscale xy
set mxtics 1
set mytics 1
set xrange [0.45:11]
set xtics nomirror out scale 0.6 (0.5, 1, 2, 5, 10)
set yrange [1e-5:10]
set ytics nomirror out scale 0.6
set format y '10^{%L}'
set xlabel 'cell size / sphere diameter'
set ylabel 'error of solids fraction / mean [-]' offset 0.4,0
set title 'root mean square error'
set key bottom left reverse Left samplen 1.6 spacing 1 font ',11'
plot for [m in "1 8 9"] 'fig01_root_mean_square.csv' skip 1 using 1:(column(m+1)) \
       with linespoints linestyle 100+m notitle, \
     for [m=meshing_first:meshing_last] 'fig01_root_mean_square.csv' skip 1 using 1:m+1 \
       with linespoints linestyle 100+m title method[m]
set title 'largest error'
set label 50 '50 %' at 10.5,0.5 right offset 0,0.6 font ',11' textcolor rgb quiet
plot 0.5 with lines linestyle 20 notitle, \
     for [m in "1 8 9"] 'fig01_largest.csv' skip 1 using 1:(column(m+1)) \
       with linespoints linestyle 100+m title method[m+0], \
     for [m=meshing_first:meshing_last] 'fig01_largest.csv' skip 1 using 1:m+1 \
       with linespoints linestyle 100+m notitle
unset label 50

# Error against cost. Names stand right of their points but where they would meet.
set title sprintf('error against cost, cells of %.2f d', paper_cell)
unset key
set xrange [10:1e6]
set xtics autofreq
set format x '10^{%L}'
set xlabel 'CPU time per sphere [ns]'
set yrange [lower:3]
set ylabel 'root mean square error [-]' offset 1.8,0
do for [m=1:method_count] {
  set label m method[m] at cost[m], above(error[m]) left offset 0.9,0.4 font ',11'
}
set label 2 right offset -0.9,-0.3
set label 3 right offset -0.9,-0.3
set label 7 offset 0.9,0.6
set label 9 offset 0.9,-0.1
plot 'fig01_pareto.csv' skip 1 using 1:(above($2)) with steps linestyle 20, \
     for [m=1:method_count] 'fig01_cost.csv' skip 1 every ::m-1::m-1 using 1:(above($2)) with points linestyle 100+m
unset for [m=1:method_count] label m

# One sphere on its way through the face of a cell.
unset logscale
set format '%g'
set xrange [-0.75:0.75]
set xtics 0.25
set xlabel 'distance of the centre beyond the face / d'
set title 'a sphere enters a cell'
set ylabel 'part of the sphere in the cell [-]' offset 0,0
set yrange [-0.02:1.04]
set key top left reverse Left samplen 1.6 spacing 1 font ',10'
plot for [m in "1 2 3 5 8 9 7"] 'fig01_crossing.csv' skip 1 using 1:(column(m+1)) \
  with lines linestyle 100+m title method[m+0]
set title 'its rate of change'
set ylabel 'rate of change per diameter [-]'
set yrange [-0.15:5]
unset key
set label 51 'centroid: 100' at 0.03,4.7 font ',11' textcolor rgb second_variant
plot for [m in "1 3 5 8 9 7"] 'fig01_rate.csv' skip 1 using 1:(column(m+1)) with lines linestyle 100+m
unset multiplot
