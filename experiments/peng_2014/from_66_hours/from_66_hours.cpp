#include "experiments/peng_2014/from_66_hours/from_66_hours.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "experiments/numerics/frontier/study.hpp"
#include "reports/gnuplot.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {
namespace {

/// A setting of a study.
struct Place {
  std::string study, series;
  double axis;
};

struct Step {
  std::string what;
  double hours;               ///< of wall-clock time for 23 s of the paper's run
  std::string measured;       ///< where the time comes from
  std::vector<Place> prices;  ///< whose errors belong to the step
};

constexpr double simulated_seconds = 23.0;  ///< of the paper's run

Place place_of(TomlTable& table) {
  Place place{table.text("study"), table.text("series"), table.number("axis")};
  table.reject_others();
  return place;
}

struct SolvedPlace {
  frontier::Study study;
  frontier::ReducedStudy reduced;
  const frontier::ReducedPoint* point;  ///< in `reduced`; null when not computed

  SolvedPlace(const Place& place, const std::filesystem::path& results)
      : study(frontier::load_study(
            source_folder() / "experiments" / "numerics" / "frontier" / "studies" / (place.study + ".toml"),
            studies::Set::full)),
        reduced(frontier::load_reduced(study, results)),
        point(nullptr) {
    for (const auto& one : reduced.points)
      if (one.series == place.series && std::abs(one.axis - place.axis) <= 1e-9 * std::abs(place.axis)) point = &one;
  }
};

/// The steps of from_66_hours.toml: hours as printed, seconds of wall-clock time per simulated second, or the CPU time
/// of a study's setting.
std::vector<Step> load_steps(const std::filesystem::path& results) {
  const auto file = source_folder() / "experiments" / "peng_2014" / "from_66_hours" / "from_66_hours.toml";
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  std::vector<Step> steps;
  for (TomlTable& one : table.tables("step")) {
    Step step{one.text("what"), std::numeric_limits<double>::quiet_NaN(), one.text("measured"), {}};
    if (one.has("hours")) {
      step.hours = one.number("hours");
    } else if (one.has("cost")) {
      TomlTable cost = one.table("cost");
      const SolvedPlace solved(place_of(cost), results);
      if (solved.point != nullptr) step.hours = solved.point->cpu_seconds * simulated_seconds / 3600.0;
    } else {
      step.hours = one.number("wall_seconds_per_second") * simulated_seconds / 3600.0;
    }
    for (TomlTable& price : one.tables("price")) step.prices.push_back(place_of(price));
    one.reject_others();
    steps.push_back(std::move(step));
  }
  table.reject_others();
  return steps;
}

/// "V_2 3 ± 5 %, voidage 0.4 ± 0.2 %": what a study found for a setting of a step.
std::string price_of(const Place& place, const std::filesystem::path& results) {
  const SolvedPlace solved(place, results);
  if (solved.point == nullptr) return fmt::format("not yet measured: slfb frontier {}", place.study);
  std::vector<std::string> parts;
  for (const auto& quantity : solved.study.quantities) {
    const auto found = solved.point->values.find(quantity);
    if (found == solved.point->values.end() || !std::isfinite(found->second.error)) continue;
    parts.push_back(fmt::format("{} {:.1f}",
                                studies::find_quantity(studies::find_problem(solved.study.problem), quantity).title,
                                100.0 * found->second.error));
    if (std::isfinite(found->second.error_half_width))
      parts.back() += fmt::format(" ± {:.1f}", 100.0 * found->second.error_half_width);
    parts.back() += " %";
  }
  return fmt::format("{} at {:g} ({}): {}", place.series, place.axis, place.study, fmt::join(parts, ", "));
}

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{"from-66-hours", {}, "", {}};
  output.caption =
      "Wall-clock time on two cores for the 23 s that the paper simulates, from its own 66 hours to the settings of "
      "the profile quick and on to a slice in one dimension (one core), one change after the other. What a change "
      "costs in each quantity is listed below, with the "
      "study "
      "that measured it; the error is that of the setting against the study's reference.";
  const auto steps = load_steps(context.results);
  DataTable table{"from-66-hours", {"number [-]", "wall-clock time [h]", "of the step before [-]"}, {}};
  std::string tics;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    table.rows.push_back({static_cast<double>(k), steps[k].hours,
                          k == 0 ? std::numeric_limits<double>::quiet_NaN() : steps[k - 1].hours / steps[k].hours});
    tics += fmt::format("{}{} {}", k == 0 ? "" : ", ", gnuplot_text(steps[k].what), k);
    std::string note = fmt::format("{}: {:.3g} h ({}).", steps[k].what, steps[k].hours, steps[k].measured);
    for (const Place& price : steps[k].prices) note += fmt::format(" Errors of {}.", price_of(price, context.results));
    output.notes.push_back(std::move(note));
  }
  output.data.push_back(write_csv(table, context.out));
  const int height = 60 * static_cast<int>(steps.size()) + 90;
  draw_figure(
      "from-66-hours",
      fmt::format("set logscale x\nset xrange [0.002:300]\nset yrange [{}:-0.6]\nset ytics ({})\nset xlabel "
                  "'wall-clock time on two cores [h]'\nset lmargin 40\nset key off\nunset grid\nset boxwidth "
                  "0.55\nset style fill solid noborder\n"
                  "set arrow 1 from 66, graph 0 to 66, graph 1 nohead linestyle 20\n"
                  "plot 'from-66-hours.csv' skip 1 using (0.5*$2):1:(0.002):2:($1-0.27):($1+0.27) with boxxyerror "
                  "linecolor rgb '#0072b2', '' skip 1 using 2:1:($2 < 1 ? sprintf('%.2g min', 60*$2) : sprintf('%.0f "
                  "h', $2)) with labels left offset 0.6, 0\n",
                  static_cast<double>(steps.size()) - 0.4, tics),
      {820, height}, context.out);
  return output;
}

}  // namespace

Figure from_66_hours() {
  return {"from-66-hours", "From 66 hours to minutes: what each step saves and costs",
          [](const Profile&) { return std::vector<std::string>{}; }, draw, "numerics/frontier"};
}

}  // namespace slfb
