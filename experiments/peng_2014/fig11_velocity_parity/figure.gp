# Figure 11. Reads fig11_laws.csv and the list simulated that figure.cpp sets, by drag law.
set key tmargin left vertical maxrows 6 Left reverse font ',11'
set xrange [0.05:0.45]
set yrange [0:0.8]
set xtics 0.1
set ytics 0.1
set xlabel 'V_2 simulated by the paper [m/s]'
set ylabel 'V_2 predicted [m/s]'
plot 'fig11_laws.csv' skip 1 using 2:8:2:2:8:9 \
       with xyerrorbars linecolor rgb '#c3c9d0' linewidth 2.5 pointsize 0 title 'Grbavčić, f from 0 to 1', \
     x with lines linecolor rgb paper linewidth 1.2 title 'equality', \
     0.9*x with lines linestyle 1 linewidth 1 title '10 %', \
     1.1*x with lines linestyle 1 linewidth 1 notitle, \
     0.8*x with lines linestyle 20 linecolor rgb paper title '20 %', \
     1.2*x with lines linestyle 20 linecolor rgb paper notitle, \
     'fig11_laws.csv' skip 1 using 2:3 \
       with points linecolor rgb law_four pointtype 8 pointsize 0.65 title 'Kunii, Levenspiel', \
     'fig11_laws.csv' skip 1 using 2:4 \
       with points linecolor rgb law_two pointtype 12 pointsize 0.65 title 'Di Felice', \
     'fig11_laws.csv' skip 1 using 2:5 \
       with points linecolor rgb law_three pointtype 10 pointsize 0.65 title 'Kennedy, Bretton', \
     'fig11_laws.csv' skip 1 using 2:6 \
       with points linecolor rgb law_one pointtype 4 pointsize 0.65 title 'Joshi (reconstructed)', \
     'fig11_laws.csv' skip 1 using 2:7 \
       with points linecolor rgb quiet pointtype 14 pointsize 0.65 title 'van der Wielen', \
     for [i=1:simulated_count] simulated[i] skip 1 using 2:3:(0):(half_width(4)) \
       with xyerrorbars linestyle simulated_style[i] @bars, \
     for [i=1:simulated_count] simulated[i] skip 1 using 2:3 \
       with points linestyle simulated_style[i] title simulated_title[i]
