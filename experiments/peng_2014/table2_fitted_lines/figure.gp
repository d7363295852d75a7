# Table 2. Reads the values that figure.cpp sets for figures/table.gp: headings, cell, column_count and the heights.
array position[9] = [62, 150, 278, 368, 462, 570, 638, 698, 748]
array left[9] = [0, 0, 0, 0, 0, 0, 0, 0, 0]
array colour[9] = ['#14181d', '#14181d', ours, ours, '#14181d', ours, '#14181d', ours, ours]
load '../../figures/table.gp'
