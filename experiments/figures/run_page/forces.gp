# Vertical forces on bed and liquid: forces.csv (time, then one column for each force).
set xlabel 'time since fluidisation began [s]'
set ylabel 'force [N]'
set key outside right top vertical
array force[8] = ['pressure', 'weight less buoyancy', 'bottom', 'walls', 'shear', 'flow', 'inertia of spheres', 'inertia of liquid']
plot for [i=1:8] 'forces.csv' skip 1 using 1:(column(i + 1)) with lines linewidth 1.6 title force[i]
