#include "reports/law_plot.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "reports/gnuplot.hpp"
#include "solver/support/folders.hpp"

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

std::filesystem::path plot_file() { return source_folder() / "reports" / "laws.gp"; }

/// Columns of a table, the first of which is 1, with what the key says of each.
struct Columns {
  std::vector<double> places;
  std::vector<std::string> titles;

  void add(const DataTable& table, const std::string& title) {
    places.push_back(static_cast<double>(table.columns.size()));
    titles.push_back(title);
  }
  void give(const std::string& name, PlotValues& values) const {
    values.numbers(name, places);
    values.texts(name + "_title", titles);
  }
};

PlotValues axes(const std::string& table, const Sweep& sweep) {
  const bool bounded = std::isfinite(sweep.y.frame.upper);
  PlotValues values;
  values.markup("table", table);
  values.text("x_title", std::string(sweep.x.title));
  values.text("y_title", std::string(sweep.y.title));
  values.number("from", sweep.lower);
  values.number("to", sweep.upper);
  values.number("y_bounded", bounded ? 1 : 0);
  values.number("lower", bounded ? sweep.y.frame.lower : 0.0);
  values.number("upper", bounded ? sweep.y.frame.upper : 0.0);
  values.number("x_logarithmic", sweep.x.logarithmic ? 1 : 0);
  values.number("y_logarithmic", sweep.y.logarithmic ? 1 : 0);
  return values;
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
  Columns others, variants;
  for (const CatalogueEntry* other : family(entry.info.kind)) {
    if (other == &entry) continue;
    const std::string name(other->info.name);
    add_column(table, *other, arguments, name, true, true);
    const bool variant = other->info.name == original || other->info.variant_of == original;
    (variant ? variants : others).add(table, name);
  }
  const std::string name(entry.info.name);
  add_column(table, entry, arguments, name + " inside its range", true, false);
  add_column(table, entry, arguments, name + " outside its range", false, true);
  write_csv(table, folder);
  PlotValues values = axes(id, way);
  values.text("law", name);
  values.number("inside", static_cast<double>(table.columns.size() - 1));
  values.number("outside", static_cast<double>(table.columns.size()));
  others.give("other", values);
  variants.give("variant", values);
  Columns{}.give("member", values);
  draw_plot(id, plot_file(), values, {620, 460}, folder, "", formats);
}

void draw_family(LawKind kind, const LawArguments& arguments, const std::string& id,
                 const std::filesystem::path& folder, const std::vector<std::string>& formats) {
  const Sweep& way = sweep_of(kind);
  DataTable table = empty_table(id, way);
  Columns members;
  for (const CatalogueEntry* law : family(kind)) {
    const std::string name(law->info.name);
    add_column(table, *law, arguments, name, true, true);
    members.add(table, name);
  }
  write_csv(table, folder);
  PlotValues values = axes(id, way);
  members.give("member", values);
  const int height = 380 + 22 * static_cast<int>((members.places.size() + 1) / 2);
  draw_plot(id, plot_file(), values, {680, height}, folder, "", formats);
}

}  // namespace slfb
