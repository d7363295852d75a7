# From 66 hours to minutes. Reads from-66-hours.csv and the list step: what is changed, one item per row.
set logscale x
set xrange [0.002:300]
set xlabel 'wall-clock time on two cores [h]'
set yrange [step_count - 0.4:-0.6]
set ytics ('' 0)
do for [k=1:step_count] { set ytics add (step[k] k - 1) }
set lmargin 40
set key off
unset grid
set style fill solid noborder
set arrow 1 from 66, graph 0 to 66, graph 1 nohead linestyle 20
time_text(hours) = hours < 1 ? sprintf('%.2g min', 60*hours) : sprintf('%.0f h', hours)
plot 'from-66-hours.csv' skip 1 using (0.5*$2):1:(0.002):2:($1-0.27):($1+0.27) with boxxyerror linecolor rgb ours, \
  '' skip 1 using 2:1:(time_text($2)) with labels left offset 0.6, 0
