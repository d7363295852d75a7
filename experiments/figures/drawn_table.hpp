#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/figures/figure.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "reports/gnuplot.hpp"

namespace slfb {

/// Gives a plot a table that it draws as a picture with experiments/figures/table.gp, so that a table of a paper can be
/// put beside the figures. Headings may use gnuplot's markup ("V_2").
///
/// Sets the lists `heading_1`, `heading_2` and `cell` (row after row), `column_count` and the heights `head_height`,
/// `row_height` and `table_height` [pixel]. Places and colours of the columns stand in figure.gp. Returns the height of
/// the picture [pixel].
int add_table(const TextTable& table, PlotValues& values);

/// A figure that is such a table, `width` pixels wide: draws `folder`'s figure.gp as `id` into `out`, with `data`, the
/// numbers behind it, beside it. Errors as draw_plot and FigureFolder::caption.
FigureOutput draw_table(const std::string& id, const FigureFolder& folder, TextTable table, const DataTable& data,
                        std::vector<std::string> notes, int width, const std::filesystem::path& out);

}  // namespace slfb
