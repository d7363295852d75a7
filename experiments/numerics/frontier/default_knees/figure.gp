# Defaults beside what is cheaper and what is better. Reads the values that figure.cpp sets for figures/table.gp: headings,
# cell, column_count and the heights.
array position[6] = [14, 170, 400, 700, 940, 1170]
array left[6] = [1, 1, 1, 0, 0, 0]
array colour[6] = ['#14181d', '#14181d', '#14181d', ours, '#14181d', '#14181d']
load '../../../figures/table.gp'
