# Defaults beside what is cheaper and what is better. Reads the values that figure.cpp sets for figures/table.gp: cell,
# column_count and the heights.
array position[6] = [14, 170, 400, 700, 940, 1170]
array left[6] = [1, 1, 1, 0, 0, 0]
array heading_1[6] = ['', '', '', '', 'best of what', 'cheapest of what']
array heading_2[6] = ['study', 'default, at', 'quantity', 'error', 'is cheaper', 'is better']
array colour[6] = ['#14181d', '#14181d', '#14181d', ours, '#14181d', '#14181d']
load '../../../figures/table.gp'
