#pragma once

#include <string>
#include <vector>

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

}  // namespace slfb
