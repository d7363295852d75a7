#include "reports/law_plot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "reports/gnuplot.hpp"

namespace slfb {
namespace {

constexpr int points = 121;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double abscissa(const Sweep& sweep, int point) {
  const double part = static_cast<double>(point) / (points - 1);
  return sweep.x.logarithmic ? sweep.lower * std::pow(sweep.upper / sweep.lower, part)
                             : sweep.lower + part * (sweep.upper - sweep.lower);
}

std::vector<const CatalogueEntry*> family(LawKind kind) {
  std::vector<const CatalogueEntry*> laws;
  for (const CatalogueEntry& entry : catalogue()) {
    if (entry.info.kind == kind) laws.push_back(&entry);
  }
  return laws;
}

std::string axes(const Sweep& sweep) {
  // Room for the title of the y axis left of "10000"; lines break where there is no value.
  std::string commands = "set lmargin 12\nset datafile missing\n";
  commands += fmt::format("set xlabel {} offset 0,0.6\n", gnuplot_text(std::string(sweep.x.title)));
  commands += fmt::format("set ylabel {}\n", gnuplot_text(std::string(sweep.y.title)));
  commands += fmt::format("set xrange [{}:{}]\n", sweep.lower, sweep.upper);
  if (std::isfinite(sweep.y.frame.upper))
    commands += fmt::format("set yrange [{}:{}]\n", sweep.y.frame.lower, sweep.y.frame.upper);
  if (sweep.x.logarithmic) commands += "set logscale x\nset format x '10^{%T}'\n";
  if (sweep.y.logarithmic) commands += "set logscale y\n";
  return commands;
}

/// A column of values of a law beside the x of the sweep; `inside` and `outside` say which points are wanted.
void add_column(DataTable& table, const CatalogueEntry& entry, const LawArguments& arguments,
                const std::string& heading, bool inside, bool outside) {
  table.columns.push_back(heading);
  const std::vector<SweepPoint> line = sweep(entry, arguments);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool wanted = line[i].in_range ? inside : outside;
    table.rows[i].push_back(wanted ? line[i].value : nothing);
  }
}

DataTable empty_table(const std::string& id, const Sweep& sweep) {
  DataTable table{id, {std::string(sweep.x.title)}, {}};
  for (int point = 0; point < points; ++point) table.rows.push_back({abscissa(sweep, point)});
  return table;
}

}  // namespace

std::vector<SweepPoint> sweep(const CatalogueEntry& entry, const LawArguments& arguments) {
  const Sweep& way = sweep_of(entry.info.kind);
  std::vector<SweepPoint> line;
  for (int point = 0; point < points; ++point) {
    const double x = abscissa(way, point);
    try {
      const LawArguments here = way.at(arguments, x);
      const LawAnswer answer = entry.evaluate(here);
      const double value = answer.at(way.quantity).value;
      line.push_back({x, std::isfinite(value) ? value : nothing, in_range(entry.info, here, answer)});
    } catch (const std::domain_error&) {  // no solution there
      line.push_back({x, nothing, false});
    }
  }
  return line;
}

void draw_law(const CatalogueEntry& entry, const LawArguments& arguments, const std::string& id,
              const std::filesystem::path& folder, const std::vector<std::string>& formats) {
  const Sweep& way = sweep_of(entry.info.kind);
  const std::string_view original = entry.info.variant_of.empty() ? entry.info.name : entry.info.variant_of;
  DataTable table = empty_table(id, way);
  std::string grey, coloured;
  const char* grey_title = "title 'other laws of this kind'";
  int style = 11;
  for (const CatalogueEntry* other : family(entry.info.kind)) {
    if (other == &entry) continue;
    add_column(table, *other, arguments, std::string(other->info.name), true, true);
    const std::string line = fmt::format("'{}.csv' skip 1 using 1:{} with lines ", id, table.columns.size());
    if (other->info.name == original || other->info.variant_of == original) {
      coloured += fmt::format("{}linestyle {} title {}, ", line, style++, gnuplot_text(std::string(other->info.name)));
    } else {
      grey += fmt::format("{}linecolor rgb '#c3c8ce' linewidth 1 {}, ", line, grey_title);
      grey_title = "notitle";
    }
  }
  const std::string name(entry.info.name);
  add_column(table, entry, arguments, name + " inside its range", true, false);
  add_column(table, entry, arguments, name + " outside its range", false, true);
  write_csv(table, folder);
  const std::string bold = fmt::format(
      "'{0}.csv' skip 1 using 1:{1} with lines linestyle 2 linewidth 3 title {3}, "
      "'' skip 1 using 1:{2} with lines linestyle 2 linewidth 2.5 dashtype (2, 3) title 'the same outside its range'\n",
      id, table.columns.size() - 1, table.columns.size(), gnuplot_text(name));
  draw_figure(id, axes(way) + "set key tmargin left Left reverse font ',12'\nplot " + grey + coloured + bold,
              {620, 460}, folder, formats);
}

void draw_family(LawKind kind, const LawArguments& arguments, const std::string& id,
                 const std::filesystem::path& folder, const std::vector<std::string>& formats) {
  const Sweep& way = sweep_of(kind);
  DataTable table = empty_table(id, way);
  // Seven colours that the colour-blind tell apart; each round of them has another dash.
  const std::vector<std::string> colours{"#0072b2", "#d55e00", "#009e73", "#aa4499", "#8a6d00", "#b0303c", "#3b4450"};
  const std::vector<std::string> dashes{"1", "(10, 4)", "(3, 3)"};
  std::string lines;
  std::size_t number = 0;
  for (const CatalogueEntry* law : family(kind)) {
    add_column(table, *law, arguments, std::string(law->info.name), true, true);
    lines +=
        fmt::format("{}'{}.csv' skip 1 using 1:{} with lines linewidth 1.6 linecolor rgb '{}' dashtype {} title {}",
                    lines.empty() ? "" : ", ", id, table.columns.size(), colours[number % colours.size()],
                    dashes[number / colours.size() % dashes.size()], gnuplot_text(std::string(law->info.name)));
    ++number;
  }
  write_csv(table, folder);
  const int height = 380 + 22 * static_cast<int>((number + 1) / 2);
  draw_figure(id, axes(way) + "set key below left maxcols 2 Left reverse font ',11'\nplot " + lines + "\n",
              {680, height}, folder, formats);
}

}  // namespace slfb
