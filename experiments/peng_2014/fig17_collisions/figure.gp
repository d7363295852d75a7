# Figure 17. Reads fig17_expansion_in_sodium_iodide.csv and, if simulated is 1, fig17_history.csv. Values that figure.cpp
# sets: begin and end of the time axis [s], description of the run, and the velocities caption_velocity and terminal [m/s].
if (simulated) {
  stats 'fig17_history.csv' skip 1 using 2 name 'contacts' nooutput
  # The key stands below the lowest velocity.
  lowest = 0
  do for [k=3:5] {
    stats 'fig17_history.csv' skip 1 using k name 'velocity' nooutput
    if (velocity_min < lowest) { lowest = velocity_min }
  }
}
set multiplot
set lmargin at screen 0.14
set rmargin at screen 0.97
split = base + 0.44*(1 - base)
upper = 1 - 14.0/height
middle = split + 0.62*(1 - split)

# Contacts since the release. Some room above the curve keeps it clear of the label.
set tmargin at screen upper
set bmargin at screen middle
set xrange [begin:end]
set xtics 0.02
set format x ''
set ylabel 'contacts [-]' offset 0.5,0
if (simulated) {
  set label 1 description at graph 0.02, 0.88 font ',12' textcolor rgb ours
  set yrange [contacts_min - 1:contacts_max + 1 + 0.3*(contacts_max - contacts_min)]
  plot 'fig17_history.csv' skip 1 using 1:2 with steps linestyle 2 linewidth 1.6 notitle
} else {
  set label 1 description at graph 0.02, 0.88 font ',12' textcolor rgb quiet
  set yrange [430:510]
  set ytics 20
  plot NaN notitle
}
eval footer_drawn
unset label 1
set ytics autofreq

# Velocity.
set tmargin at screen middle - 12.0/height
set bmargin at screen split + 52.0/height
set format x '%g'
set xlabel 'time since release [s]' offset 0,0.3
set ylabel 'velocity [m/s]' offset 1.4,0
set key bottom right horizontal font ',12'
if (simulated) {
  set yrange [lowest - 0.25:*]
  plot 'fig17_history.csv' skip 1 using 1:3 with lines linestyle 4 linewidth 1.4 title 'v_x', \
    '' skip 1 using 1:4 with lines linestyle 3 linewidth 1.4 title 'v_y', \
    '' skip 1 using 1:5 with lines linestyle 2 linewidth 1.8 title 'v_z'
} else {
  set yrange [-0.5:0.5]
  plot NaN notitle
}

# Voidage of the bed in the liquid of the caption.
set tmargin at screen split - 22.0/height
set bmargin at screen base + 58.0/height
set xrange [0:0.23]
set xtics 0.05
set yrange [0.35:1.05]
set ytics 0.2
set xlabel 'superficial velocity U_L of NaI solution [m/s]' offset 0,0.7
set ylabel 'voidage α_L [-]'
set key top left vertical Left reverse font ',12'
set arrow 1 from caption_velocity, graph 0 to caption_velocity, graph 1 nohead linestyle 1
set arrow 2 from terminal, graph 0 to terminal, graph 1 nohead linestyle 20
set label 2 'caption' at caption_velocity, graph 0.70 rotate by 90 offset 0.9,0 font ',11'
set label 3 'terminal' at terminal, graph 0.70 rotate by 90 offset -0.8,0 font ',11' textcolor rgb quiet
plot 'fig17_expansion_in_sodium_iodide.csv' skip 1 using 1:2 with lines linestyle 13 title 'Eq. 36', \
  '' skip 1 using 1:3 with lines linestyle 12 title 'Wen and Yu', \
  '' skip 1 using 1:4 with lines linestyle 14 title 'Di Felice'
unset multiplot
