# Ours over the paper's, a line for each claim, grouped by place in the work. Reads verdict (tables: pixels from the top,
# ratio, ends of its interval, whether it lies outside), verdict_title, place (names), middle and end (of each place, pixels
# from the top) and furthest (ratio at the edge).
set logscale x
set xrange [1.0/furthest:furthest]
set yrange [end[place_count]:0]
set tmargin at screen 1 - 46.0/height
set bmargin at screen 62.0/height
set xtics ('1/10' 0.1, '1/5' 0.2, '1/2' 0.5, '1' 1, '2' 2, '5' 5, '10' 10)
set xlabel "ours over the paper's"
unset ytics
do for [i=1:place_count] {
  set label i place[i] at graph -0.015, first middle[i] right font ',12' textcolor rgb '#2b3138'
  set arrow 100 + i from graph 0, first end[i] to graph 1, first end[i] nohead linewidth 0.6 linecolor rgb '#dfe3e8' back
}
set lmargin at screen 0.15
set key at screen 0.99, screen 1 - 6.0/height right top horizontal maxrows 1 font ',12' width (format eq 'svg' ? -4 : 0)
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
