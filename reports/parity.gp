# Ours over the paper's, a row for each place in the work. Reads verdict (tables: row, ratio, ends of its interval, whether
# it lies outside), verdict_title, place (names of the rows) and furthest (ratio at the edge).
set logscale x
set xrange [1.0/furthest:furthest]
set yrange [place_count + 0.6:0.4]
set xtics ('1/10' 0.1, '1/5' 0.2, '1/2' 0.5, '1' 1, '2' 2, '5' 5, '10' 10)
set xlabel "ours over the paper's"
unset ytics
do for [i=1:place_count] {
  set label i place[i] at graph -0.015, first i right font ',12' textcolor rgb '#2b3138'
}
set lmargin at screen 0.15
set tmargin 3
set key at screen 0.99, screen 0.985 right top horizontal
set arrow 1 from 1, graph 0 to 1, graph 1 nohead linecolor rgb paper linewidth 1.2 back
set object 1 rectangle from 0.9, graph 0 to 1.1, graph 1 fillcolor rgb '#eef1f4' fillstyle solid noborder behind
colour(title) = title eq 'reproduced' ? second_variant : title eq 'not reproduced' ? variant : quiet
mark(title) = title eq 'reproduced' ? 7 : title eq 'not reproduced' ? 5 : 6
plot for [k=1:verdict_count] verdict[k] skip 1 using 2:1:3:4 with xerrorbars linecolor rgb colour(verdict_title[k]) \
       pointsize 0 linewidth 1 notitle, \
     for [k=1:verdict_count] verdict[k] skip 1 using ($5 == 0 ? $2 : NaN):1 with points linecolor rgb \
       colour(verdict_title[k]) pointtype mark(verdict_title[k]) pointsize 0.55 title verdict_title[k], \
     for [k=1:verdict_count] verdict[k] skip 1 using ($5 > 0 ? furthest/1.15 : $5 < 0 ? 1.15/furthest : NaN):1:\
       ($5 > 0 ? furthest*0.13 : -0.13/furthest):(0) with vectors filled linecolor rgb colour(verdict_title[k]) \
       linewidth 1.5 notitle
