# Stands for a chart whose results do not exist.
set label 1 'not yet computed' at graph 0.5, 0.5 center
set xrange [0:1]
set yrange [0:1]
unset tics
plot NaN notitle
