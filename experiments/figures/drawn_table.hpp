#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/figures/figure.hpp"
#include "reports/gnuplot.hpp"

/// Tables of the paper as pictures, so that they can be put beside the figures.
namespace slfb {

struct TableColumn {
  std::string heading;  ///< of one or two lines, with gnuplot's markup: "V_2"
  int position;         ///< of its left or right edge in the picture [pixel]
  bool left = false;    ///< aligned left; numbers are aligned right
  std::string colour = "'#14181d'";
};

/// Height of the picture of a table [pixel].
int table_height(std::size_t rows);

/// gnuplot commands for a table that fills a picture of `width` pixels and table_height(); the rows are shown as
/// written.
std::string table_commands(const std::vector<TableColumn>& columns, const std::vector<std::vector<std::string>>& rows,
                           int width);

/// A figure that is such a table: draws it as `id` into `folder`, with `data`, the numbers behind it, beside it.
FigureOutput draw_table(const std::string& id, std::string caption, const std::vector<TableColumn>& columns,
                        const std::vector<std::vector<std::string>>& rows, const DataTable& data,
                        std::vector<std::string> notes, int width, const std::filesystem::path& folder);

/// Gives a plot the rows of a table that it draws as a picture with experiments/figures/table.gp, so that a table of a
/// paper can be put beside the figures. The texts are shown as written; each row has one text per column.
///
/// Sets the list `cell` (row after row), `column_count` and the heights `head_height`, `row_height` and `table_height`
/// [pixel]. Columns (positions, headings, colours) stand in figure.gp. Returns the height of the picture [pixel].
int add_table(const std::vector<std::vector<std::string>>& rows, PlotValues& values);

}  // namespace slfb
