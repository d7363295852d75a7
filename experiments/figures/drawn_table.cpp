#include "experiments/figures/drawn_table.hpp"

#include <utility>

namespace slfb {

int add_table(const std::vector<std::vector<std::string>>& rows, PlotValues& values) {
  constexpr int head_height = 52, row_height = 24, foot_height = 10;
  const int height = head_height + row_height * static_cast<int>(rows.size()) + foot_height;
  std::vector<std::string> cells;
  for (const auto& row : rows) cells.insert(cells.end(), row.begin(), row.end());
  values.texts("cell", cells);
  values.number("column_count", rows.empty() ? 0.0 : static_cast<double>(rows.front().size()));
  values.number("head_height", head_height);
  values.number("row_height", row_height);
  values.number("table_height", height);
  return height;
}

FigureOutput draw_table(const std::string& id, const FigureFolder& folder,
                        const std::vector<std::vector<std::string>>& rows, const DataTable& data,
                        std::vector<std::string> notes, int width, const std::filesystem::path& out) {
  PlotValues values;
  const int height = add_table(rows, values);
  draw_plot(id, folder.plot(), values, {width, height}, out);
  return {id, {write_csv(data, out)}, folder.caption(), std::move(notes)};
}

}  // namespace slfb
