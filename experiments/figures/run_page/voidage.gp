# Voidage in the plane y = 0: plane.csv (x, z, voidage), `columns` cells across.
set xlabel 'x [m]'
set ylabel 'z [m]'
set size ratio -1
set xtics 0.02
set cbrange [0.3:1]
set cblabel 'voidage [-]'
unset grid
plot 'plane.csv' skip 1 using 1:2:3 with image notitle
