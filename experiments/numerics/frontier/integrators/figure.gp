# Error against cost of the integrators. Reads frontier-integrators_CASE_METHOD.csv: the cases are `cases` with the titles
# case_title, the methods 0, 1, … have the titles `methods`.
table(c, m) = sprintf('frontier-integrators_%s_%d.csv', cases[c], m - 1)
set multiplot layout 2,4 margins 0.06,0.985,0.11,0.93 spacing 0.045,0.15
set logscale xy
set format '10^{%L}'
set yrange [1e-9:1]
set ytics 1e2
set key bottom left reverse Left samplen 1 font ',11'

# Above, the cost that no machine changes. Grey lines: first and second order.
set xlabel 'force evaluations per contact'
set xrange [4:5000]
set arrow 1 from 5.4, graph 0 to 5.4, graph 1 nohead linestyle 20
set ylabel 'relative error [-]'
do for [c=1:cases_count] {
  set title case_title[c]
  plot for [m=1:methods_count] table(c, m) skip 1 using 1:2 with linespoints linestyle m + 1 pointsize 1.4 - 0.25*m \
      title methods[m], \
    0.5/x with lines linestyle 20 notitle, 0.5/x**2 with lines linestyle 20 notitle
  unset key
  unset ylabel
}

# Below, the time of this machine.
unset title
unset arrow 1
set xlabel 'CPU time per sphere and contact [ns]'
set xrange [*:*]
set ylabel 'relative error [-]'
do for [c=1:cases_count] {
  plot for [m=1:methods_count] table(c, m) skip 1 using 4:2 with linespoints linestyle m + 1 pointsize 1.4 - 0.25*m \
    notitle
  unset ylabel
}
unset multiplot
