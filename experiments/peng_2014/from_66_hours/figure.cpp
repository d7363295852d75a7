#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/numerics/frontier/solved_study.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "reports/gnuplot.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb::from_66_hours {
namespace {

const FigureFolder folder{"peng_2014/from_66_hours"};
constexpr double simulated_seconds = 23.0;  ///< of the paper's run

/// A setting of a study.
struct Setting {
  std::string study, series;
  double axis;
};

struct Step {
  std::string what;
  double hours;                 ///< of wall-clock time for the paper's run
  std::string measured;         ///< where the time comes from
  std::vector<Setting> errors;  ///< settings whose errors belong to the step
};

Setting read_setting(TomlTable& table) {
  Setting setting{table.text("study"), table.text("series"), table.number("axis")};
  table.reject_others();
  return setting;
}

/// The steps of steps.toml: hours as printed, seconds of wall-clock time per simulated second, or the CPU time of a
/// study's setting.
std::vector<Step> load_steps(const std::filesystem::path& results) {
  const auto file = source_folder() / "experiments" / folder.path() / "steps.toml";
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  std::vector<Step> steps;
  for (TomlTable& one : table.tables("step")) {
    Step step{one.text("what"), std::numeric_limits<double>::quiet_NaN(), one.text("measured"), {}};
    if (one.has("hours")) {
      step.hours = one.number("hours");
    } else if (one.has("cost")) {
      TomlTable cost = one.table("cost");
      const Setting setting = read_setting(cost);
      const frontier::SolvedStudy solved = frontier::load_solved(setting.study, results);
      if (const auto* point = solved.at(setting.series, setting.axis))
        step.hours = point->cpu_seconds * simulated_seconds / 3600.0;
    } else {
      step.hours = one.number("wall_seconds_per_second") * simulated_seconds / 3600.0;
    }
    for (TomlTable& errors : one.tables("errors")) step.errors.push_back(read_setting(errors));
    one.reject_others();
    steps.push_back(std::move(step));
  }
  table.reject_others();
  return steps;
}

/// "V_2 3 ± 5 %, voidage 0.4 ± 0.2 %": what a study found for a setting of a step.
std::string errors_text(const Setting& setting, const std::filesystem::path& results) {
  const frontier::SolvedStudy solved = frontier::load_solved(setting.study, results);
  const frontier::ReducedPoint* point = solved.at(setting.series, setting.axis);
  if (point == nullptr) return fmt::format("not yet measured: slfb frontier {}", setting.study);
  std::vector<std::string> parts;
  for (const auto& quantity : solved.study.quantities) {
    const auto found = point->values.find(quantity);
    if (found == point->values.end() || !std::isfinite(found->second.error)) continue;
    parts.push_back(fmt::format("{} {:.1f}", solved.title(quantity), 100.0 * found->second.error));
    if (std::isfinite(found->second.error_half_width))
      parts.back() += fmt::format(" ± {:.1f}", 100.0 * found->second.error_half_width);
    parts.back() += " %";
  }
  return fmt::format("{} at {:g} ({}): {}", setting.series, setting.axis, setting.study, fmt::join(parts, ", "));
}

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{"from-66-hours", {}, folder.caption(), {}};
  const auto steps = load_steps(context.results);
  DataTable table{"from-66-hours", {"number [-]", "wall-clock time [h]", "of the step before [-]"}, {}};
  std::vector<std::string> titles;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    table.rows.push_back({static_cast<double>(k), steps[k].hours,
                          k == 0 ? std::numeric_limits<double>::quiet_NaN() : steps[k - 1].hours / steps[k].hours});
    titles.push_back(steps[k].what);
    std::string note = fmt::format("{}: {:.3g} h ({}).", steps[k].what, steps[k].hours, steps[k].measured);
    for (const Setting& setting : steps[k].errors)
      note += fmt::format(" Errors of {}.", errors_text(setting, context.results));
    output.notes.push_back(std::move(note));
  }
  output.data.push_back(write_csv(table, context.out));
  PlotValues values;
  values.texts("step", titles);
  draw_plot("from-66-hours", folder.plot(), values, {820, 60 * static_cast<int>(steps.size()) + 90}, context.out);
  return output;
}

}  // namespace

Figure figure() { return {"from-66-hours", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb::from_66_hours
