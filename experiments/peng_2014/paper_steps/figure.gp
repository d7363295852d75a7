# Settings of the paper beside their limits. Reads the values that figure.cpp sets for figures/table.gp: headings,
# cell, column_count and the heights.
array position[6] = [14, 330, 640, 790, 950, 970]
array left[6] = [1, 1, 0, 0, 0, 1]
array colour[6] = ['#14181d', '#14181d', '#14181d', '#14181d', ours, '#14181d']
load '../../figures/table.gp'
