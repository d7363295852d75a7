#include "experiments/figures/drawn_table.hpp"

#include <fmt/format.h>

namespace slfb {
namespace {

constexpr int head_height = 52, row_height = 24, foot_height = 10;

std::string quoted(const std::string& markup) { return fmt::format("'{}'", markup); }

}  // namespace

int table_height(std::size_t rows) { return head_height + row_height * static_cast<int>(rows) + foot_height; }

std::string table_commands(const std::vector<TableColumn>& columns, const std::vector<std::vector<std::string>>& rows,
                           int width) {
  const int height = table_height(rows.size());
  std::string commands = fmt::format(
      "unset grid\nunset key\nunset border\nunset tics\nset lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
      "set xrange [0:{0}]\nset yrange [{1}:0]\nset arrow 1 from 8, {2} to {3}, {2} nohead linecolor rgb '#5b6470' "
      "linewidth "
      "1\n",
      width, height, head_height - 4, width - 8);
  int tag = 0;
  const auto label = [&](const std::string& text, const TableColumn& column, int y) {
    commands += fmt::format("set label {} {} at {}, {} {} font ',12' textcolor rgb {} front\n", ++tag, text,
                            column.position, y, column.left ? "left" : "right", column.colour);
  };
  for (const TableColumn& column : columns) {
    const auto line_break = column.heading.find('\n');
    label(quoted(column.heading.substr(0, line_break)), column, 14);
    if (line_break != std::string::npos) label(quoted(column.heading.substr(line_break + 1)), column, 33);
  }
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const int top = head_height + row_height * static_cast<int>(row);
    if (row % 2 == 1)
      commands += fmt::format(
          "set object {} rectangle from 8, {} to {}, {} fillcolor rgb '#f1f4f7' fillstyle solid "
          "noborder behind\n",
          row, top, width - 8, top + row_height);
    for (std::size_t column = 0; column < columns.size(); ++column)
      label(gnuplot_text(rows[row][column]), columns[column], top + row_height / 2);
  }
  return commands + "plot NaN\n";
}

FigureOutput draw_table(const std::string& id, std::string caption, const std::vector<TableColumn>& columns,
                        const std::vector<std::vector<std::string>>& rows, const DataTable& data,
                        std::vector<std::string> notes, int width, const std::filesystem::path& folder) {
  draw_figure(id, table_commands(columns, rows, width), {width, table_height(rows.size())}, folder);
  return {id, {write_csv(data, folder)}, std::move(caption), std::move(notes)};
}

int add_table(const std::vector<std::vector<std::string>>& rows, PlotValues& values) {
  const int height = table_height(rows.size());
  std::vector<std::string> cells;
  for (const auto& row : rows) cells.insert(cells.end(), row.begin(), row.end());
  values.texts("cell", cells);
  values.number("column_count", rows.empty() ? 0.0 : static_cast<double>(rows.front().size()));
  values.number("head_height", head_height);
  values.number("row_height", row_height);
  values.number("table_height", height);
  return height;
}

}  // namespace slfb
