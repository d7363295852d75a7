# Collision frequency of an elastic gas: kinetic-theory_laws.csv has the laws, kinetic-theory_counted.csv the counts.
laws = 'kinetic-theory_laws.csv'
counted = 'kinetic-theory_counted.csv'
set multiplot layout 1,2 margins 0.09,0.985,0.17,0.95 spacing 0.11,0
set xrange [0:0.6]
set xlabel 'solids fraction α_S [-]'

set logscale y
set yrange [0.4:400]
set ylabel 'collision frequency f* [-]'
set key top left reverse Left font ',12'
plot laws skip 1 using 1:2 with lines linestyle 11 title 'kinetic theory, Carnahan–Starling', \
  laws skip 1 using 1:3 with lines linestyle 1 title 'kinetic theory, Lun–Savage', \
  counted skip 1 using 1:2:3 with yerrorbars linestyle 2 title 'counted'

unset logscale y
set yrange [-10:150]
set ylabel 'difference [%]'
plot 0 with lines linestyle 20 notitle, \
  laws skip 1 using 1:4 with lines linestyle 1 title 'Lun–Savage over Carnahan–Starling', \
  counted skip 1 using 1:6 with points linestyle 3 title 'Lun–Savage over the count', \
  counted skip 1 using 1:4:5 with yerrorbars linestyle 2 title 'count over Carnahan–Starling'
unset multiplot
