# Settings of the paper beside their limits. Reads the values that figure.cpp sets for figures/table.gp: cell,
# column_count and the heights.
array position[6] = [14, 330, 640, 790, 950, 970]
array left[6] = [1, 1, 0, 0, 0, 1]
array heading_1[6] = ['', '', '', 'limit, or', 'of the limit,', '']
array heading_2[6] = ['setting of the paper', 'measured by', 'the paper', 'resolved', 'or change', '']
array colour[6] = ['#14181d', '#14181d', '#14181d', '#14181d', ours, '#14181d']
load '../../figures/table.gp'
