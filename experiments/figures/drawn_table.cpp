#include "experiments/figures/drawn_table.hpp"

#include <utility>

namespace slfb {

int add_table(const TextTable& table, PlotValues& values) {
  constexpr int head_height = 52, row_height = 24, foot_height = 10;
  const int height = head_height + row_height * static_cast<int>(table.rows.size()) + foot_height;
  std::vector<std::string> cells, first, second;
  for (const auto& [above, below] : table.headings) {
    first.push_back(above);
    second.push_back(below);
  }
  values.markups("heading_1", first);
  values.markups("heading_2", second);
  for (const auto& row : table.rows) cells.insert(cells.end(), row.begin(), row.end());
  values.texts("cell", cells);
  values.number("column_count", static_cast<double>(table.headings.size()));
  values.number("head_height", head_height);
  values.number("row_height", row_height);
  values.number("table_height", height);
  return height;
}

FigureOutput draw_table(const std::string& id, const FigureFolder& folder, TextTable table, const DataTable& data,
                        std::vector<std::string> notes, int width, const std::filesystem::path& out) {
  PlotValues values;
  const int height = add_table(table, values);
  draw_plot(id, folder.plot(), values, {width, height}, out);
  return {id, {write_csv(data, out)}, folder.caption(), std::move(notes), std::move(table)};
}

}  // namespace slfb
