#include "experiments/frontier/from_66_hours.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "experiments/frontier/study.hpp"
#include "experiments/studies/table_reader.hpp"
#include "reports/gnuplot.hpp"

namespace slfb {
namespace {

struct Step {
  std::string what;
  double hours;               ///< of wall-clock time for 23 s of the paper's run, on two cores
  std::string measured;       ///< where the time comes from
  std::string study, series;  ///< of the study whose errors belong to the step; empty: none
  double axis;
};

/// The steps of from_66_hours.toml.
std::vector<Step> load_steps() {
  const auto file = std::filesystem::path(SLFB_SOURCE_DIR) / "experiments" / "frontier" / "from_66_hours.toml";
  const toml::table parsed = studies::parse_table(file);
  studies::TableReader table(parsed, file.string());
  std::vector<Step> steps;
  for (studies::TableReader& one : table.tables("step")) {
    steps.push_back({one.text("what"), one.number("hours"), one.text("measured"), one.text("study", ""),
                     one.text("series", ""), one.number("axis", 0.0)});
    one.reject_others();
  }
  table.reject_others();
  return steps;
}

/// "V_2 3 ± 5 %, voidage 0.4 ± 0.2 %": what a study found for the setting of a step.
std::string price_of(const Step& step, const std::filesystem::path& results) {
  if (step.study.empty()) return "";
  const auto folder = std::filesystem::path(SLFB_SOURCE_DIR) / "experiments" / "frontier" / "studies";
  const auto study = frontier::load_study(folder / (step.study + ".toml"), frontier::Set::full);
  const auto reduced = frontier::load_reduced(study, results);
  std::string text;
  for (const auto& point : reduced.points) {
    if (point.series != step.series || std::abs(point.axis - step.axis) > 1e-9 * std::abs(step.axis)) continue;
    for (const auto& quantity : study.quantities) {
      const auto found = point.values.find(quantity);
      if (found == point.values.end() || !std::isfinite(found->second.error)) continue;
      text += fmt::format("{}{} {:.1f}", text.empty() ? "" : ", ",
                          studies::find_quantity(studies::find_problem(study.problem), quantity).title,
                          100.0 * found->second.error);
      if (std::isfinite(found->second.error_half_width))
        text += fmt::format(" ± {:.1f}", 100.0 * found->second.error_half_width);
      text += " %";
    }
  }
  return text.empty() ? fmt::format("not yet measured: slfb frontier {}", step.study) : text;
}

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{"from-66-hours", {}, "", {}};
  output.caption =
      "Wall-clock time on two cores for the 23 s that the paper simulates, from its own 66 hours to the settings of "
      "the profile quick, one change after the other. What a change costs in each quantity is listed below, with the "
      "study "
      "that measured it; the error is that of the setting against the study's reference.";
  const auto steps = load_steps();
  DataTable table{"from-66-hours", {"number [-]", "wall-clock time [h]", "of the step before [-]"}, {}};
  std::string tics;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    table.rows.push_back({static_cast<double>(k), steps[k].hours,
                          k == 0 ? std::numeric_limits<double>::quiet_NaN() : steps[k - 1].hours / steps[k].hours});
    tics += fmt::format("{}{} {}", k == 0 ? "" : ", ", gnuplot_text(steps[k].what), k);
    const std::string price = price_of(steps[k], context.results);
    output.notes.push_back(fmt::format("{}: {:.3g} h ({}){}{}", steps[k].what, steps[k].hours, steps[k].measured,
                                       price.empty() ? "." : "; errors: ", price));
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
          [](const Profile&) { return std::vector<std::string>{}; }, draw, "frontier"};
}

}  // namespace slfb
