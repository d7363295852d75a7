# The cheapest rung for each figure. Reads the values that figure.cpp sets for figures/table.gp: headings, cell, column_count and
# the heights.
array position[8] = [14, 130, 250, 490, 570, 650, 730, 755]
array left[8] = [1, 1, 1, 0, 0, 0, 0, 1]
array colour[8] = ['#14181d', '#14181d', '#14181d', '#14181d', ours, '#14181d', '#14181d', '#14181d']
load '../../figures/table.gp'
