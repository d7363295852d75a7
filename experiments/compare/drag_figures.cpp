#include "experiments/compare/drag_figures.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "correlations/drag/drag_laws.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/runs/measure.hpp"
#include "reports/gnuplot.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb::compare {
namespace {

namespace fs = std::filesystem;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
const std::vector<std::string> formats{"svg", "png"};
const char* const grey = "with lines linecolor rgb '#c3c8ce' linewidth 1";

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

/// Sizes of a figure of maps [pixels].
constexpr int map_width = 190, map_height = 170, above = 28, below = 34, left = 70, bar = 110, foot = 24;

Canvas map_canvas(std::size_t maps, int across) {
  const int rows = (static_cast<int>(maps) + across - 1) / across;
  return {left + across * map_width + bar, rows * (above + map_height + below) + foot};
}

/// A map per column of a table, side by side with one colour bar.
std::string map_commands(const DataTable& table, const std::vector<std::string>& titles, int across,
                         const std::string& palette, const std::string& scale) {
  const Canvas canvas = map_canvas(titles.size(), across);
  // An image of an SVG would be a second file; a PNG would show the seams between single rectangles.
  std::string commands = palette +
                         "drawn = format eq 'png' ? '' : 'pixels'\nset multiplot\nunset key\nset xrange [-2:4]\nset "
                         "yrange [0.36:1]\nset xtics -2,2,2 format '10^{%g}'\nset ytics 0.2\n";
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const int column = static_cast<int>(i) % across, row = static_cast<int>(i) / across;
    const double width = canvas.width, height = canvas.height;
    const int from_left = left + column * map_width, from_top = row * (above + map_height + below) + above;
    commands += fmt::format(
        "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\nset bmargin at screen {}\n",
        from_left / width, (from_left + map_width - 18) / width, 1.0 - from_top / height,
        1.0 - (from_top + map_height) / height);
    const bool lowest = i + static_cast<std::size_t>(across) >= titles.size();
    commands += fmt::format("set title {} offset 0,-0.8 font ',11'\nset xlabel '{}' offset 0,0.6\nset ylabel '{}'\n",
                            gnuplot_text(titles[i]), lowest ? "Re [-]" : "", column == 0 ? "voidage [-]" : "");
    commands += fmt::format("set format y '{}'\n", column == 0 ? "%g" : "");
    commands += i == 0 ? fmt::format("set colorbox user origin {},{} size {},{}\n", 1.0 - (bar - 10) / width,
                                     (below + foot) / height, 16 / width, 1.0 - (above + below + foot) / height)
                       : "unset colorbox\n";
    commands +=
        fmt::format("plot '{}.csv' skip 1 using (log10($2)):1:({}(${})) with image @drawn\n", table.name, scale, i + 3);
  }
  return commands + "unset multiplot\n";
}

Picture draw_surfaces(const std::vector<ComparedDragLaw>& laws, const fs::path& folder) {
  const std::string id = "drag_maps";
  std::vector<std::string> names, columns;
  for (const auto& compared : laws) {
    names.push_back(compared.name());
    columns.push_back(compared.name() + " F [-]");
  }
  const DataTable table = map_table(id, columns, [&](std::size_t i, double voidage, double reynolds) {
    const auto& law = laws[i].law;
    return in_range(law.info, voidage, reynolds) ? law({voidage, reynolds}) : nothing;
  });
  write_csv(table, folder);
  const int across = std::min<int>(4, static_cast<int>(laws.size()));
  draw_figure(id, map_commands(table, names, across, "set cbrange [0:5]\nset cbtics format '10^{%g}'\n", "log10"),
              map_canvas(laws.size(), across), folder, formats);
  return {id, "The laws over voidage and Reynolds number",
          "Drag over Stokes drag F of each law inside its own range; blank outside."};
}

Picture draw_ratios(const ComparedDragLaw& compared, const fs::path& folder) {
  const std::string id = "ratio_" + compared.name();
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
  write_csv(table, folder);
  const std::string palette =
      "set palette defined (-1 '#2166ac', -0.5 '#92c5de', 0 '#f7f7f7', 0.5 '#f4a582', 1 '#b2182b')\n"
      "set cbrange [-1:1]\nset cbtics ('1/2' -1, '0.71' -0.5, '1' 0, '1.41' 0.5, '2' 1)\n"
      "within(x) = x > 1 ? 1 : x < -1 ? -1 : x\nratio(x) = within(log(x) / log(2))\n";
  draw_figure(id, map_commands(table, names, 5, palette, "ratio"), map_canvas(names.size(), 5), folder, formats);
  return {
      id, compared.name() + " over each law of the literature",
      "Ratio of the drag where the ranges of both laws meet: red, this law gives more; blue, less; the darkest ends "
      "are a factor of two and beyond."};
}

/// A plot element per law, the literature grey behind the compared laws: columns of one CSV file from `first_column`
/// on. Under "set datafile missing" its lines break where there is no value.
std::string lines_of(const std::string& id, std::size_t first_column, std::size_t behind,
                     const std::vector<ComparedDragLaw>& laws, bool titles) {
  std::string commands;
  for (std::size_t i = 0; i < behind; ++i)
    commands += fmt::format("'{}.csv' skip 1 using 1:{} {} {}, ", id, first_column + i, grey,
                            titles && i == 0 ? "title 'literature'" : "notitle");
  for (std::size_t i = 0; i < laws.size(); ++i)
    commands += fmt::format("'{}.csv' skip 1 using 1:{} with lines linestyle {} {}{}", id, first_column + behind + i,
                            2 + i % 4, titles ? "title " + gnuplot_text(laws[i].name()) : std::string("notitle"),
                            i + 1 < laws.size() ? ", " : "");
  return commands;
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
  std::string commands =
      "set datafile missing\nset multiplot layout 1,3\nset logscale xy\nset format x '10^{%T}'\nset xtics 100\nset "
      "format y '10^{%T}'\nset xlabel 'Re [-]'\nset xrange [0.01:10000]\nset yrange [*<0.9:*]\nset lmargin 7\nset "
      "tmargin 5\n";
  for (std::size_t k = 0; k < voidages.size(); ++k) {
    commands += fmt::format(
        "set ylabel '{}'\nset label 1 'voidage {}' at graph 0.05,0.93\n{}", k == 0 ? "F [-]" : "", voidages[k],
        k == 0 ? "set key at screen 0.5,0.99 center top horizontal maxrows 2 font ',12'\n" : "unset key\n");
    commands += "plot " + lines_of(id, 2 + k * (behind.size() + laws.size()), behind.size(), laws, k == 0) + "\n";
  }
  draw_figure(id, commands + "unset multiplot\n", {900, 380}, folder, formats);
  return {id, "The laws among the literature", "Each law inside its own range, at three voidages."};
}

/// A value of a homogeneous bed, and whether the law is meant for that bed.
struct BedValue {
  double value;
  bool in_range;
};

/// A line per law against the first column of the table, filled from `value(law, x)`, and its plot elements, each
/// followed by a comma: the literature grey, the compared laws dotted outside the ranges that they state.
template <class Value>
std::string bed_lines(DataTable& table, const std::string& quantity, const std::vector<ComparedDragLaw>& laws,
                      Value value) {
  std::string plot;
  const auto add = [&](const std::string& heading, const std::string& style, auto line) {
    table.columns.push_back(heading + " " + quantity);
    bool any = false;
    for (auto& row : table.rows) {
      row.push_back(line(row[0]));
      any = any || std::isfinite(row.back());
    }
    if (any) plot += fmt::format("'{}.csv' skip 1 using 1:{} {}, ", table.name, table.columns.size(), style);
    return any;
  };
  bool titled = false;
  for (const drag::DragLawKernels& law : literature())
    titled = add(std::string(law.info.name), grey + std::string(titled ? " notitle" : " title 'literature'"),
                 [&](double x) { return value(law, x).value; }) ||
             titled;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const std::string style = fmt::format("with lines linestyle {} ", 2 + i % 4);
    const std::string title = "title " + gnuplot_text(laws[i].name());
    const auto part = [&](bool inside) {
      return [&, inside](double x) {
        const BedValue found = value(laws[i].law, x);
        return found.in_range == inside ? found.value : nothing;
      };
    };
    const bool inside = add(laws[i].name() + " in its range", style + title, part(true));
    add(laws[i].name() + " outside its range", style + "dashtype (2, 3) " + (inside ? "notitle" : title), part(false));
  }
  return plot;
}

Picture draw_expansion(const std::vector<ComparedDragLaw>& laws, const fs::path& folder) {
  const std::string id = "bed_expansion";
  DataTable table{id, {"voidage [-]"}, {}};
  for (int i = 0; i <= 60; ++i)
    table.rows.push_back({paper::packed_voidage() + 0.01 * i * (1.0 - paper::packed_voidage()) / 0.6});
  const std::string lines = bed_lines(table, "U [m/s]", laws, [](const drag::DragLawKernels& law, double voidage) {
    const double velocity = bed_velocity(law, voidage);
    return BedValue{velocity, bed_in_range(law, voidage, velocity)};
  });
  write_csv(table, folder);
  DataTable paper{id + "_paper", {"voidage [-]", "superficial velocity [m/s]"}, {}};
  for (const VoidagePoint& point : peng_2014().figure13())
    paper.rows.push_back({point.voidage, point.superficial_velocity});
  write_csv(paper, folder);
  draw_figure(
      id,
      "set datafile missing\nset key tmargin left Left reverse maxrows 3 font ',12'\nset logscale xy\nset xrange "
      "[0.38:1]\nset yrange [*<0.02:1<*]\nset xtics (0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1)\nset xlabel 'voidage [-]'\nset "
      "ylabel 'superficial "
      "velocity [m/s]'\nplot " +
          lines +
          fmt::format("'{}_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'paper, Fig. "
                      "13'\n",
                      id),
      {560, 480}, folder, formats);
  return {
      id, "Expansion of the homogeneous bed",
      "Superficial velocity that carries 5 mm glass in water at each voidage. At the left end it is the minimum "
      "fluidisation velocity; a straight line in these axes is Richardson and Zaki's law. Dotted: outside the range "
      "that the law states."};
}

Picture draw_classification(const std::vector<ComparedDragLaw>& laws, const std::vector<Candidate>& candidates,
                            const fs::path& folder) {
  const std::string id = "classification";
  DataTable table{id, {"superficial velocity [m/s]"}, {}};
  for (int i = 0; i <= 100; ++i) table.rows.push_back({0.045 + 0.002 * i});
  const std::string lines = bed_lines(table, "V_2 [m/s]", laws, [](const drag::DragLawKernels& law, double velocity) {
    const HomogeneousBed bed = homogeneous_bed(law, velocity);
    return BedValue{bed.classification_velocity, bed.in_range};
  });
  write_csv(table, folder);
  DataTable paper{id + "_paper", {"superficial velocity [m/s]", "V_2 [m/s]"}, {}};
  for (const Table2Row& row : peng_2014().table2())
    paper.rows.push_back({row.superficial_velocity, row.classification_velocity});
  write_csv(paper, folder);
  std::string simulated;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates[i].runs == 0) continue;
    DataTable points{fmt::format("{}_{}", id, candidates[i].name),
                     {"superficial velocity [m/s]", "V_2 [m/s]", "half width of its 95 % interval [m/s]"},
                     {}};
    for (const Table2Row& row : peng_2014().table2()) {
      const auto found =
          candidates[i].measurements.find(measure_key("classification_velocity", "6in5W", row.superficial_velocity));
      if (found != candidates[i].measurements.end() && found->second.origin != "law")
        points.rows.push_back({row.superficial_velocity, found->second.value, found->second.half_width});
    }
    if (points.rows.empty()) continue;
    write_csv(points, folder);
    simulated += fmt::format(
        ", '{0}.csv' skip 1 using 1:2:3 with yerrorbars linestyle {1} notitle, '{0}.csv' skip 1 using 1:2 with points "
        "linestyle {1} title {2}",
        points.name, 2 + i % 4, gnuplot_text("simulated, " + candidates[i].name));
  }
  draw_figure(
      id,
      "set datafile missing\nset key tmargin left Left reverse maxrows 4 font ',12'\nset xrange [0.04:0.25]\nset "
      "yrange [0:0.6<*]\nset xlabel 'superficial velocity U_L [m/s]'\nset ylabel 'classification velocity V_2 "
      "[m/s]'\nplot " +
          lines +
          fmt::format("'{}_paper.csv' skip 1 using 1:2 with points linestyle 1 dashtype 1 title 'paper, Table "
                      "2'{}\n",
                      id, simulated),
      {560, 520}, folder, formats);
  return {id, "Classification velocity",
          "The 6 mm steel sphere in the bed. Lines: weight, pressure gradient of the homogeneous bed and drag balance "
          "(no collisions), which is the upper limit of what a law can give; a line ends where the law has no steady "
          "bed and is dotted outside the range that the law states. Filled symbols: simulated with collisions, means "
          "of the drops with 95 % intervals."};
}

}  // namespace

std::vector<Picture> draw_drag_pictures(const std::vector<ComparedDragLaw>& laws,
                                        const std::vector<Candidate>& candidates, const fs::path& folder) {
  fs::create_directories(folder);
  std::vector<Picture> pictures{draw_lines(laws, folder), draw_surfaces(laws, folder)};
  // The first law is what the others are compared with.
  for (std::size_t i = 1; i < laws.size(); ++i) pictures.push_back(draw_ratios(laws[i], folder));
  pictures.push_back(draw_expansion(laws, folder));
  pictures.push_back(draw_classification(laws, candidates, folder));
  return pictures;
}

}  // namespace slfb::compare
