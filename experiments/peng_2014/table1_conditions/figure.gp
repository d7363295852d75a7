# Table 1. Reads the values that figure.cpp sets for figures/table.gp: cell, column_count and the heights.
array position[5] = [20, 250, 410, 500, 672]
array left[5] = [1, 1, 0, 0, 0]
array heading_1[5] = ['condition', 'unit', 'paper,', 'here,', 'other numbers of']
array heading_2[5] = ['', '', 'Table 1', '6in5W', 'the paper give']
array colour[5] = ['#14181d', '#56606d', '#14181d', ours, law_one]
load '../../figures/table.gp'
