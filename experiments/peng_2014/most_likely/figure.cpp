#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/most_likely/evidence.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/readings/study.hpp"
#include "experiments/work/profiles.hpp"
#include "solver/support/files.hpp"

namespace slfb::most_likely {
namespace {

using readings::Comparison, readings::Study, readings::StudiedReading;

const FigureFolder folder{"peng_2014/most_likely"};
constexpr std::array profiles{"packed", "screening", "candidates", "literal"};
constexpr const char* of_the_default = "full";
constexpr std::size_t shown_readings = 14, curves = 3;
constexpr std::ptrdiff_t compared = 3;  ///< readings that have a number, for a column of its own
constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> needs(const Profile& profile) {
  if (std::ranges::find(profiles, profile.name) == profiles.end()) return {};
  return select_run_keys(profile, [](const RunSpec&) { return true; });
}

/// Points of one quantity of one reading: velocity, ours, half width of its 95 % interval, printed.
DataTable curve(const Study& study, const StudiedReading& reading, const std::string& quantity,
                const std::string& name) {
  DataTable table{name, {"superficial velocity [m/s]", quantity + " [SI]", "half width [SI]", "printed [SI]"}, {}};
  for (std::size_t i = 0; i < study.evidence.size(); ++i) {
    const readings::Evidence& evidence = study.evidence[i];
    const Comparison& comparison = reading.assessment.comparisons[i];
    if (evidence.printed.quantity != quantity || !evidence.superficial_velocity || !std::isfinite(comparison.ours))
      continue;
    table.rows.push_back({*evidence.superficial_velocity, comparison.ours,
                          1.96 * comparison.relative_error * comparison.ours, evidence.printed.value});
  }
  std::ranges::sort(table.rows);
  return table;
}

/// Place of the ", " that is nearest to the middle; npos if there is none.
std::size_t comma_in_the_middle(const std::string& text) {
  const std::size_t before = text.rfind(", ", text.size() / 2), after = text.find(", ", text.size() / 2);
  if (before == text.npos || after == text.npos) return std::min(before, after);
  return text.size() / 2 - before < after - text.size() / 2 ? before : after;
}

/// One sentence on the best reading, from the numbers.
std::string summary(const Study& study) {
  if (study.readings.empty() || !study.readings.front().log10_evidence) return "Nothing has been ranked yet.";
  const StudiedReading& best = study.readings.front();
  std::size_t left = 0;
  for (const StudiedReading& one : study.readings) left += one.log10_evidence && !one.assessment.ruled_out ? 1 : 0;
  std::string text = fmt::format(
      "Of {} readings {} are not ruled out. Best: {}; {} of {} numbers of its drops lie inside their 95 % "
      "prediction interval.",
      study.readings.size(), left, study.choices.title_of(best.runs.reading), best.inside, best.tested);
  // It has no packed line, so that it is not ranked.
  const auto literal = std::ranges::find_if(
      study.readings, [](const StudiedReading& one) { return one.name.ends_with("as-printed") && one.tested > 0; });
  if (literal != study.readings.end())
    text += fmt::format(" With the numerics as printed, one drop into each bed, {} of {} do.", literal->inside,
                        literal->tested);
  return text;
}

FigureOutput draw(const FigureContext& outer) {
  std::vector<FinishedRun> runs;
  Profile all{"readings", {}, {}};
  for (const char* name : profiles) {
    const Profile profile = load_profile(name);
    for (FinishedRun& run : finished_runs(profile, outer.results)) runs.push_back(std::move(run));
    for (const RunSpec& spec : profile.runs) all.runs.push_back(spec);
    for (const std::string& sentence : profile.differences)
      if (std::ranges::find(all.differences, sentence) == all.differences.end()) all.differences.push_back(sentence);
  }
  // The runs of the default scene are a reading too; they come last, since they are the longest.
  for (FinishedRun& run : finished_runs(load_profile(of_the_default), outer.results)) {
    if (run.spec.system != system_name || !run.spec.variant.empty()) continue;
    run.spec.variant = default_reading;
    runs.push_back(std::move(run));
  }
  const FigureContext context{all, runs, outer.measurements, outer.out, outer.results};
  const auto keys = select_run_keys(all, [](const RunSpec&) { return true; });
  const Study study =
      readings::study(load_choices(peng_2014_work()), evidence(), runs, peng_2014_work().measuring, "grid");
  write_file(outer.out / "most-likely.json", readings::study_json(study).dump(1) + "\n");

  FigureOutput output{"most-likely",
                      {},
                      folder.caption({{"summary", summary(study)}}),
                      run_notes(context, keys),
                      {},
                      readings::study_text(study)};
  // Numbers that readings can be compared by, as columns.
  std::vector<std::size_t> numbers;
  std::vector<std::string> number_titles;
  for (std::size_t i = 0; i < study.evidence.size(); ++i)
    if (std::ranges::count_if(study.readings, [&](const StudiedReading& one) {
          return one.assessment.comparisons[i].samples > 0;
        }) >= compared) {
      numbers.push_back(i);
      number_titles.push_back(study.evidence[i].printed.title);
    }
  DataTable ranking{"most_likely_ranking",
                    {"row [-]", "evidence [-]", "packed bed [-]", "drops [-]", "penalty [-]", "ruled out [-]"},
                    {}};
  DataTable implausibility{"most_likely_implausibility",
                           {"row [-]", "number [-]", "implausibility [-]", "counted [-]", "lost drops [-]"},
                           {}};
  std::vector<std::string> titles, rest_of_titles;  // a long title takes two lines
  for (const StudiedReading& one : study.readings) {
    if (titles.size() == shown_readings) break;
    const auto row = static_cast<double>(titles.size());
    const std::string title = study.choices.title_of(one.runs.reading);
    constexpr std::size_t one_line = 44;
    const std::size_t comma = title.size() > one_line ? comma_in_the_middle(title) : title.npos;
    titles.push_back(comma == title.npos ? title : title.substr(0, comma + 1));
    rest_of_titles.push_back(comma == title.npos ? "" : title.substr(comma + 2));
    ranking.rows.push_back({row, one.log10_evidence.value_or(none), one.assessment.calibration.value_or(none),
                            one.assessment.test.value_or(none), -static_cast<double>(one.departures),
                            one.assessment.ruled_out ? 1.0 : 0.0});
    for (std::size_t n = 0; n < numbers.size(); ++n) {
      const Comparison& comparison = one.assessment.comparisons[numbers[n]];
      implausibility.rows.push_back({row, static_cast<double>(n), comparison.implausibility,
                                     study.counted[numbers[n]] ? 1.0 : 0.0, static_cast<double>(comparison.lost)});
    }
  }
  output.data.push_back(write_csv(ranking, outer.out));
  output.data.push_back(write_csv(implausibility, outer.out));

  DataTable packed_print{"most_likely_paper_line", {"superficial velocity [m/s]", "pressure drop [Pa]"}, {}};
  for (const double velocity : {0.02, 0.0424})
    packed_print.rows.push_back(
        {velocity, peng_2014().value("packed_line_slope") * velocity + peng_2014().value("packed_line_intercept")});
  DataTable velocity_print{"most_likely_paper_velocity", {"superficial velocity [m/s]", "V_2 [m/s]"}, {}};
  for (const Table2Row& row : peng_2014().table2())
    velocity_print.rows.push_back({row.superficial_velocity, row.classification_velocity});
  output.data.push_back(write_csv(packed_print, outer.out));
  output.data.push_back(write_csv(velocity_print, outer.out));

  std::vector<std::string> packed_tables, velocity_tables;
  for (std::size_t k = 0; k < std::min(curves, study.readings.size()); ++k) {
    const StudiedReading& one = study.readings[k];
    const DataTable packed = curve(study, one, "pressure_drop", fmt::format("most_likely_packed_{}", k + 1)),
                    velocity =
                        curve(study, one, "classification_velocity", fmt::format("most_likely_velocity_{}", k + 1));
    for (const DataTable* table : {&packed, &velocity})
      if (!table->rows.empty()) output.data.push_back(write_csv(*table, outer.out));
    packed_tables.push_back(packed.rows.empty() ? "" : packed.name);
    velocity_tables.push_back(velocity.rows.empty() ? "" : velocity.name);
  }
  PlotValues values;
  values.texts("reading", titles);
  values.texts("rest_of_reading", rest_of_titles);
  values.texts("number", number_titles);
  values.files("packed_curve", packed_tables);
  values.files("velocity_curve", velocity_tables);
  draw_plot_of_runs("most-likely", folder.plot(), values, {1240, 1230}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"most-likely", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::most_likely
