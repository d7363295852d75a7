# What stands before the plot of a figure of runs: the text below the picture, if there is any. Reads footer (its lines) and footer_height
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

