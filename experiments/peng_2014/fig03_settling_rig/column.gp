# What Figures 3 and 4 share: the column in its square jacket, the calming section, the distributor and the water in
# blue. Positions are millimetres of the picture. `plot @column_spheres` draws the spheres: those of the bed and of the
# calming section on staggered lattices, and the foreign sphere.
unset grid
unset key
unset border
unset tics
set lmargin at screen 0
set rmargin at screen 1
set tmargin at screen 1
set bmargin at screen 0
water = '#cfe5f5'
glass = '#8fb6d6'
metal = '#5b6470'
set style line 41 linecolor rgb '#2b3138' linewidth 1.5
set style line 42 linecolor rgb ours linewidth 2.2

set object 1 rectangle from 150,110 to 210,470 fillcolor rgb '#e9f3fa' fillstyle solid \
  border linecolor rgb glass linewidth 1.2 behind
set object 2 rectangle from 165,110 to 195,480 fillcolor rgb water fillstyle solid \
  border linecolor rgb '#2b3138' linewidth 1.4
set object 3 rectangle from 165,60 to 195,108 fillcolor rgb '#efe6d2' fillstyle solid \
  border linecolor rgb '#2b3138' linewidth 1.4
set object 4 rectangle from 160,107 to 200,112 fillcolor rgb metal fillstyle solid noborder front

bed_x(i) = 167.5 + 3.3*((i % 8) + 0.5*((i/8) % 2))
bed_y(i) = 115.5 + 3.6*(i/8)
calming_x(i) = 168.2 + 5.2*((i % 5) + 0.5*((i/5) % 2))
calming_y(i) = 64 + 4.9*(i/5)
bed_spheres = 272
calming_spheres = 45
set samples 300
column_spheres = "'+' using (bed_x(int($0))):(bed_y(int($0))):(int($0) < bed_spheres ? 1.45 : NaN) with circles fillstyle solid noborder linecolor rgb ours, ".\
  "'+' using (calming_x(int($0))):(calming_y(int($0))):(int($0) < calming_spheres ? 2.2 : NaN) with circles fillstyle solid noborder linecolor rgb law_three, ".\
  "'+' using (int($0) == 0 ? 180 : NaN):(318):(2.4) with circles fillstyle solid noborder linecolor rgb '#c0392b'"
