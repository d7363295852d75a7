# Table 1. Reads the values that figure.cpp sets for figures/table.gp: headings, cell, column_count and the heights.
array position[5] = [20, 250, 410, 500, 672]
array left[5] = [1, 1, 0, 0, 0]
array colour[5] = ['#14181d', '#56606d', '#14181d', ours, law_one]
load '../../figures/table.gp'
