# Cheap answers beside their bands. Reads the values that figure.cpp sets for figures/table.gp: headings, cell, column_count and
# the heights.
array position[6] = [14, 250, 720, 790, 890, 910]
array left[6] = [1, 1, 0, 0, 0, 1]
array colour[6] = ['#14181d', '#14181d', ours, '#14181d', '#14181d', '#14181d']
load '../../../figures/table.gp'
