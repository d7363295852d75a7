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
# gnuplot takes the letters of an SVG to be larger than browsers draw them. It puts the titles of axes further out then,
# and leaves out what would begin outside the picture.
if (format eq 'svg') {
  set xlabel offset 0,0.6
  set ylabel offset 1.2,0
}
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

# gnuplot opens the first file of a list even where a loop has nothing to do: of an empty list it is this one.
$empty_list << END
heading
1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1
END
