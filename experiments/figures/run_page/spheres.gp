# Spheres in the column: discs[1] (x, z, radius, colour), half_width and upper_height of what is shown [m], scale [pixel/m],
# moment (the time as a text).
unset grid
unset key
set border 15 linecolor rgb '#9aa3ad'
unset xtics
set xrange [-half_width:half_width]
set yrange [0:upper_height]
set lmargin at screen 60.0/width
set rmargin at screen (60.0 + 2*half_width*scale)/width
set bmargin at screen 20.0/height
set tmargin at screen (20.0 + upper_height*scale)/height
set ylabel 'height z [m]'
set title moment
plot discs[1] skip 1 @spheres
