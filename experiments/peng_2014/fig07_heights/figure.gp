# Figure 7. Reads fig07_*.csv and the values that figure.cpp sets: followed_time [s] and packed_height [m] of the paper,
# its arrival [s] at 0.06 m/s; velocity (of each colour, as in the key), and for each drop its table drop, its number in
# that table and the place of its velocity, drop_velocity.
array colour[5] = ['#440154', '#3b528b', '#21918c', '#5ec962', '#d55e00']
set key top right Left reverse font ',12' title 'U_L' left
set xrange [0:followed_time]
set yrange [0:1]
set xlabel 'time since release [s]'
set ylabel 'height z of the sphere [m]'
set label 1 'paper: rests here at 0.03, 0.04' at graph 0.98, first packed_height right offset 0,-0.7 font ',11'
set label 2 'paper: arrives' at first arrival, first 0.003 offset 0.6,0.9 font ',11'
drops = drop_count == 0 ? '' : \
  "for [i=1:drop_count] drop[i] skip 1 using ($1 == drop_number[i] ? $2 : NaN):3 ".\
  "with lines linecolor rgb colour[drop_velocity[i]] linewidth (drop_number[i] == 1 ? 2.0 : 1.2) notitle, "
plot packed_height with lines linestyle 1 notitle, \
     for [k=1:velocity_count] keyentry with lines linecolor rgb colour[k] linewidth 2 title velocity[k], \
     @drops \
     'fig07_paper.csv' skip 1 using 2:3 with points linestyle 1 dashtype 1 notitle
