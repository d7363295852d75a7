#include "experiments/compare/drag_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "correlations/drag/drag_laws.hpp"
#include "experiments/compare/bed_figures.hpp"
#include "experiments/figures/figure_support.hpp"
#include "reports/gnuplot.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb::compare {
namespace {

namespace fs = std::filesystem;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
const std::vector<std::string> formats{"svg", "png"};

std::vector<std::string> names_of(const std::vector<ComparedDragLaw>& laws) {
  std::vector<std::string> names;
  for (const auto& compared : laws) names.push_back(compared.name());
  return names;
}

std::vector<drag::DragLawKernels> literature() {
  std::vector<drag::DragLawKernels> laws;
  for_each_law<drag::DragLaws>([&](const auto& law) { laws.push_back(find_drag_law(std::string(law.info.name))); });
  return laws;
}

bool in_range(const LawInfo& info, double voidage, double reynolds) {
  return info.voidage.contains(voidage) && info.reynolds.contains(reynolds);
}

/// A table with one row per point of the grid; `value(i, voidage, reynolds)` fills column i.
template <class Value>
DataTable map_table(const std::string& id, const std::vector<std::string>& columns, Value value) {
  DataTable table{id, {"voidage [-]", "Reynolds number [-]"}, {}};
  table.columns.insert(table.columns.end(), columns.begin(), columns.end());
  const DragGrid grid = drag_grid();
  for (const double voidage : grid.voidage)
    for (const double reynolds : grid.reynolds) {
      std::vector<double> row{voidage, reynolds};
      for (std::size_t i = 0; i < columns.size(); ++i) row.push_back(value(i, voidage, reynolds));
      table.rows.push_back(std::move(row));
    }
  return table;
}

/// Draws a map per column of a table, `across` of them in a row.
void draw_maps(const DataTable& table, const std::vector<std::string>& titles, int across, bool ratios,
               const fs::path& folder) {
  constexpr int map_width = 190, map_height = 170, above = 28, below = 34, left = 70, bar = 110, foot = 24;  // [pixel]
  const int rows = (static_cast<int>(titles.size()) + across - 1) / across;
  const Canvas canvas{left + across * map_width + bar, rows * (above + map_height + below) + foot};
  PlotValues values;
  values.markup("table", table.name);
  values.number("ratio", ratios ? 1 : 0);
  values.number("across", across);
  values.texts("map", titles);
  for (const auto& [name, size] : std::initializer_list<std::pair<const char*, int>>{{"width", canvas.width},
                                                                                     {"height", canvas.height},
                                                                                     {"map_width", map_width},
                                                                                     {"map_height", map_height},
                                                                                     {"above", above},
                                                                                     {"below", below},
                                                                                     {"left", left},
                                                                                     {"bar", bar},
                                                                                     {"foot", foot}})
    values.number(name, size);
  write_csv(table, folder);
  draw_plot(table.name, plot_file("drag_maps"), values, canvas, folder, "", formats);
}

Picture draw_surfaces(const std::vector<ComparedDragLaw>& laws, const fs::path& folder) {
  const std::string id = "drag_maps";
  std::vector<std::string> columns;
  for (const auto& compared : laws) columns.push_back(compared.name() + " F [-]");
  const DataTable table = map_table(id, columns, [&](std::size_t i, double voidage, double reynolds) {
    const auto& law = laws[i].law;
    return in_range(law.info, voidage, reynolds) ? law({voidage, reynolds}) : nothing;
  });
  draw_maps(table, names_of(laws), std::min<int>(4, static_cast<int>(laws.size())), false, folder);
  return {id, "The laws over voidage and Reynolds number",
          "Drag over Stokes drag F of each law inside its own range; blank outside."};
}

Picture draw_ratios(const ComparedDragLaw& compared, const fs::path& folder) {
  std::string id = "ratio_" + compared.name();
  std::ranges::replace(id, ':', '_');
  std::vector<drag::DragLawKernels> others;
  std::vector<std::string> names, columns;
  for (const auto& law : literature()) {
    if (law.info.name == compared.law.info.name) continue;
    others.push_back(law);
    names.emplace_back(law.info.name);
    columns.push_back(fmt::format("over {} [-]", law.info.name));
  }
  const DataTable table = map_table(id, columns, [&](std::size_t i, double voidage, double reynolds) {
    const bool both = in_range(compared.law.info, voidage, reynolds) && in_range(others[i].info, voidage, reynolds);
    return both ? compared.law({voidage, reynolds}) / others[i]({voidage, reynolds}) : nothing;
  });
  draw_maps(table, names, 5, true, folder);
  return {
      id, compared.name() + " over each law of the literature",
      "Ratio of the drag where the ranges of both laws meet: red, this law gives more; blue, less; the darkest ends "
      "are a factor of two and beyond."};
}

Picture draw_lines(const std::vector<ComparedDragLaw>& laws, const fs::path& folder) {
  const std::string id = "drag_lines";
  const auto behind = literature();
  constexpr std::array voidages{0.45, 0.7, 0.95};
  DataTable table{id, {"Reynolds number [-]"}, {}};
  for (const double reynolds : drag_grid().reynolds) table.rows.push_back({reynolds});
  for (const double voidage : voidages) {
    const auto add = [&](const drag::DragLawKernels& law) {
      table.columns.push_back(fmt::format("{} at voidage {} [-]", law.info.name, voidage));
      for (auto& row : table.rows)
        row.push_back(in_range(law.info, voidage, row[0]) ? law({voidage, row[0]}) : nothing);
    };
    for (const auto& law : behind) add(law);
    for (const auto& compared : laws) add(compared.law);
  }
  write_csv(table, folder);
  PlotValues values;
  values.number("literature_count", static_cast<double>(behind.size()));
  values.texts("law", names_of(laws));
  values.numbers("voidage", {voidages.begin(), voidages.end()});
  draw_plot(id, plot_file(id), values, {900, 380}, folder, "", formats);
  return {id, "The laws among the literature", "Each law inside its own range, at three voidages."};
}

/// A value of a homogeneous bed, and whether the law is meant for that bed.
struct BedValue {
  double value;
  bool in_range;
};

/// A line per law against the first column of the table, filled from `value(law, x)`, and the lists that a plot draws
/// them from: the columns of the literature, and those of the compared laws inside and outside the ranges that they
/// state, with titles and styles. A line without a value is left out.
template <class Value>
void add_bed_lines(DataTable& table, const std::string& quantity, const std::vector<ComparedDragLaw>& laws, Value value,
                   PlotValues& values) {
  /// Columns of the table, and how each is drawn.
  struct Lines {
    std::vector<double> columns, styles;
    std::vector<std::string> titles;
  } grey, inside, outside;
  const auto add = [&](Lines& lines, const std::string& heading, const std::string& title, std::size_t style, auto at) {
    table.columns.push_back(heading + " " + quantity);
    bool any = false;
    for (auto& row : table.rows) {
      row.push_back(at(row[0]));
      any = any || std::isfinite(row.back());
    }
    if (!any) return false;
    lines.columns.push_back(static_cast<double>(table.columns.size()));
    lines.styles.push_back(line_style(style));
    lines.titles.push_back(title);
    return true;
  };
  for (const drag::DragLawKernels& law : literature())
    add(grey, std::string(law.info.name), "", 0, [&](double x) { return value(law, x).value; });
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const std::string name = laws[i].name();
    const auto part = [&](bool wanted) {
      return [&, wanted](double x) {
        const BedValue found = value(laws[i].law, x);
        return found.in_range == wanted ? found.value : nothing;
      };
    };
    const bool titled = add(inside, name + " in its range", name, i, part(true));
    add(outside, name + " outside its range", titled ? "" : name, i, part(false));
  }
  values.numbers("literature", grey.columns);
  values.numbers("inside", inside.columns);
  values.texts("inside_title", inside.titles);
  values.numbers("inside_style", inside.styles);
  values.numbers("outside", outside.columns);
  values.texts("outside_title", outside.titles);
  values.numbers("outside_style", outside.styles);
}

Picture draw_expansion(const std::vector<ComparedDragLaw>& laws, const ComparisonBed& bed, const fs::path& folder) {
  const std::string id = "bed_expansion";
  DataTable table{id, {"voidage [-]"}, {}};
  for (int i = 0; i <= 60; ++i)
    table.rows.push_back({bed.packed_voidage + 0.01 * i * (1.0 - bed.packed_voidage) / 0.6});
  PlotValues values;
  add_bed_lines(
      table, "U [m/s]", laws,
      [&](const drag::DragLawKernels& law, double voidage) {
        const double velocity = bed_velocity(law, bed, voidage);
        return BedValue{velocity, bed_in_range(law, bed, voidage, velocity)};
      },
      values);
  write_csv(table, folder);
  DataTable printed{id + "_paper", {"voidage [-]", "superficial velocity [m/s]"}, {}};
  for (const PrintedPoint& point : bed.expansion.points)
    printed.rows.push_back({point.value, point.superficial_velocity});
  write_csv(printed, folder);
  values.number("packed_voidage", bed.packed_voidage);
  values.text("printed_title", bed.expansion.title);
  draw_plot(id, plot_file(id), values, {560, 480}, folder, "", formats);
  return {id, "Expansion of the homogeneous bed",
          fmt::format("Superficial velocity that carries {} in {} at each voidage. At the left end it is the minimum "
                      "fluidisation velocity; a straight line in these axes is Richardson and Zaki's law. Dotted: "
                      "outside the range that the law states.",
                      bed.bed.words(), bed.liquid_name)};
}

Picture draw_classification(const std::vector<ComparedDragLaw>& laws, const std::vector<Candidate>& candidates,
                            const ComparisonBed& bed, const fs::path& folder) {
  const std::string id = "classification";
  DataTable table{id, {"superficial velocity [m/s]"}, {}};
  constexpr int steps = 100;
  for (int i = 0; i <= steps; ++i) table.rows.push_back({bed.slowest + (bed.fastest - bed.slowest) * i / steps});
  PlotValues values;
  add_bed_lines(
      table, "V_2 [m/s]", laws,
      [&](const drag::DragLawKernels& law, double velocity) {
        const HomogeneousBed found = homogeneous_bed(law, bed, velocity);
        return BedValue{found.classification_velocity, found.in_range};
      },
      values);
  write_csv(table, folder);
  DataTable printed{id + "_paper", {"superficial velocity [m/s]", "V_2 [m/s]"}, {}};
  for (const PrintedPoint& point : bed.classification.points)
    printed.rows.push_back({point.superficial_velocity, point.value});
  write_csv(printed, folder);
  values.number("slowest", bed.slowest);
  values.number("fastest", bed.fastest);
  values.text("printed_title", bed.classification.title);
  add_simulated(id, candidates, bed, "", "classification_velocity", "m/s", values, folder);
  draw_plot(id, plot_file(id), values, {560, 520}, folder, "", formats);
  return {id, "Classification velocity",
          fmt::format("The {} sphere in the bed. Lines: weight, pressure gradient of the homogeneous bed and drag "
                      "balance (no collisions), which is the upper limit of what a law can give; a line ends where the "
                      "law has no steady bed and is dotted outside the range that the law states. Filled symbols: "
                      "simulated with collisions, means of the drops with 95 % intervals.",
                      bed.foreign.words())};
}

}  // namespace

std::vector<Picture> draw_drag_pictures(const std::vector<ComparedDragLaw>& laws,
                                        const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                                        const fs::path& folder) {
  fs::create_directories(folder);
  std::vector<Picture> pictures{draw_lines(laws, folder), draw_surfaces(laws, folder)};
  // The first law is what the others are compared with.
  for (std::size_t i = 1; i < laws.size(); ++i) pictures.push_back(draw_ratios(laws[i], folder));
  pictures.push_back(draw_expansion(laws, bed, folder));
  pictures.push_back(draw_classification(laws, candidates, bed, folder));
  return pictures;
}

}  // namespace slfb::compare
