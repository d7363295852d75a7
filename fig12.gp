format='png'
set terminal pngcairo size 800,1000 enhanced
set output 'fig12.png'
# The look that all figures share. Colours are told apart by the colour-blind (Okabe and Ito's set, darkened a little
# for thin lines); the paper is always black and open, our simulations are filled and coloured, laws are thin lines.
set encoding utf8
set datafile separator comma
set datafile missing NaN
set border 3 linewidth 1 linecolor rgb '#5b6470'
set tics nomirror out scale 0.6 font ',13' textcolor rgb '#2b3138'
set grid back linetype 1 linewidth 0.6 linecolor rgb '#e3e6ea'
set key textcolor rgb '#2b3138' samplen 1.8 spacing 1.15
set title font ',15' textcolor rgb '#14181d'
set xlabel textcolor rgb '#14181d'
set ylabel textcolor rgb '#14181d'
set bars 0.6
set pointintervalbox 0
set lmargin 9

paper = '#000000'
ours = '#0072b2'
variant = '#d55e00'
second_variant = '#009e73'
third_variant = '#aa4499'
law_one = '#b0303c'
law_two = '#3f7f5f'
law_three = '#8a6d00'
law_four = '#5a4fa2'
quiet = '#8b939c'

set style line 1 linecolor rgb paper linewidth 1.6 pointtype 6 pointsize 0.75 dashtype (9, 5)
set style line 2 linecolor rgb ours linewidth 2 pointtype 7 pointsize 0.7
set style line 3 linecolor rgb variant linewidth 2 pointtype 5 pointsize 0.7
set style line 4 linecolor rgb second_variant linewidth 2 pointtype 9 pointsize 0.8
set style line 5 linecolor rgb third_variant linewidth 2 pointtype 13 pointsize 0.8
set style line 11 linecolor rgb law_one linewidth 1.5
set style line 12 linecolor rgb law_two linewidth 1.5
set style line 13 linecolor rgb law_three linewidth 1.5
set style line 14 linecolor rgb law_four linewidth 1.5
set style line 20 linecolor rgb quiet linewidth 1.2 dashtype (2, 4)

# Viridis (public domain): even steps of the value are even steps to the eye, in colour and in grey.
set palette defined (0 '#440154', 1 '#482878', 2 '#3e4989', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', 6 '#35b779', \
                     7 '#6ece58', 8 '#b5de2b', 9 '#fde725')

# Single replicates behind the means of style lines 2 to 5.
pale_2 = '#8fbfe0'
pale_3 = '#edb48a'
pale_4 = '#8fd0b8'
pale_5 = '#d6a5cf'

# The eight systems of foreign sphere and bed: water filled, sodium iodide open; one colour per pair of sizes.
set style line 31 linecolor rgb '#d55e00' linewidth 1.6 pointtype 5 pointsize 0.65
set style line 32 linecolor rgb '#009e73' linewidth 1.6 pointtype 9 pointsize 0.8
set style line 33 linecolor rgb '#0072b2' linewidth 1.6 pointtype 7 pointsize 0.7
set style line 34 linecolor rgb '#aa4499' linewidth 1.6 pointtype 13 pointsize 0.8
set style line 35 linecolor rgb '#8a6d00' linewidth 1.6 pointtype 11 pointsize 0.8
set style line 36 linecolor rgb '#5b6470' linewidth 1.6 pointtype 15 pointsize 0.7
set style line 37 linecolor rgb '#d55e00' linewidth 1.6 pointtype 4 pointsize 0.65
set style line 38 linecolor rgb '#0072b2' linewidth 1.6 pointtype 6 pointsize 0.7

# Radius of a filled round point (type 7) of size 1 in pixels of the SVG, in each format as its terminal is set up:
# pictures of thousands of discs are points of a given radius, an eighth of the size that circles would have.
point_radius = format eq 'svg' ? 5.625 : format eq 'png' ? 4.5 : 4.0

# Pictures of spheres (sphere_picture: x, z, radius, colour) in a panel of `scale` pixels per metre:
# `plot 'spheres.csv' skip 1 @spheres`.
spheres = "using 1:2:(scale/point_radius*$3):4 with points pointtype 7 pointsize variable linewidth 0.1 ".\
  "linecolor rgb variable notitle"

# Error bars: `using 1:2:(0):(half_width(3)) with xyerrorbars linestyle 2 @bars`. They have both directions, one of them
# of no length: gnuplot leaves a gap for the point in bars of one direction, in which short bars vanish. A single sample
# has no interval.
half_width(k) = valid(k) ? column(k) : 0
bars = 'pointsize 0 linewidth 1.4 notitle'

width=800.0
height=1000.0
footer_count=1
array footer[1]=['text']
footer_height=21
vector_count = 0
array vector[1] = ['fig12_paper_axis']
vector_title_count = 0
array vector_title[1] = ['']
vector_style_count = 0
array vector_style[1] = ['']
vertical_count = 0
array vertical[1] = ['fig12_paper_axis']
vertical_title_count = 0
array vertical_title[1] = ['']
vertical_style_count = 0
array vertical_style[1] = ['']
# What stands before the plot of a figure of runs: the text below the picture. Reads footer (its lines) and footer_height
# [pixel]; sets base, the part of the height that the text takes, and keeps the plot above it. A figure of several plots
# says `eval footer_drawn` after its first, so that the text is drawn once.
base = footer_height/height
set origin 0, base
set size 1, 1 - base
do for [i=1:footer_count] {
  set label 900+i footer[i] at screen 0.012, (footer_height - 4.0 - 13.0*(i - 0.5))/height \
    font ',9' textcolor rgb '#6b7580' front
}
footer_drawn = 'unset for [tag=901:'.(900 + footer_count).'] label tag'

# Figure 12. Reads fig12_*.csv and the lists that figure.cpp sets: vector (mean length of the fluctuation) and vertical
# (of its vertical component alone), each by system. Columns 2 and 3: voidage and its half width, 4 and 5: fluctuation.
band = "'fig12_paper_axis.csv' skip 1 using 1:2:3 with filledcurves linecolor rgb paper fillstyle solid 0.08 noborder"
set multiplot
set lmargin at screen 0.165
set rmargin at screen 0.97
set xrange [0.4:0.9]
set xtics 0.1
set yrange [0:0.18]
set ytics 0.04
middle = base + 0.5*(1 - base - 80.0/height)

# The vector.
set tmargin at screen 1 - 92.0/height
set bmargin at screen middle + 22.0/height
set format x ''
set ylabel "u'_L, vector [m/s]" offset 0.5,0
set key at screen 0.165, screen 1 - 8.0/height left top Left reverse font ',12'
if (vector_count > 0) {
  plot @band title 'sharp rise in the paper', \
       for [i=1:vector_count] vector[i].'.csv' skip 1 using 2:4:(half_width(3)):(half_width(5)) \
         with xyerrorbars linestyle vector_style[i] @bars, \
       for [i=1:vector_count] vector[i].'.csv' skip 1 using 2:4 \
         with points linestyle vector_style[i] title vector_title[i]
} else {
  set label 1 'no run with this record yet' at graph 0.55, 0.5 font ',12' textcolor rgb quiet
  plot @band title 'sharp rise in the paper'
}
eval footer_drawn

# The vertical component.
set tmargin at screen middle - 2.0/height
set bmargin at screen base + 60.0/height
set format x '%g'
set xlabel 'voidage α_L [-]'
set ylabel "u'_L, vertical [m/s]" offset 0.5,0
unset key
if (vertical_count > 0) {
  plot @band, \
       for [i=1:vertical_count] vertical[i].'.csv' skip 1 using 2:4:(half_width(3)):(half_width(5)) \
         with xyerrorbars linestyle vertical_style[i] @bars, \
       for [i=1:vertical_count] vertical[i].'.csv' skip 1 using 2:4 with points linestyle vertical_style[i]
} else {
  plot @band
}
unset multiplot
