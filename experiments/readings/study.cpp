#include "experiments/readings/study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

namespace slfb::readings {
namespace {

/// Readings that lie no more than this below the best are told as nearly as good: one in ten by the odds.
constexpr double nearly_as_good = 1.0;
constexpr std::size_t told_readings = 10;
constexpr double below_all = -std::numeric_limits<double>::infinity();

std::size_t factor_named(const Choices& choices, const std::string& name) {
  const auto found = std::ranges::find(choices.factors, name, &Factor::name);
  if (found == choices.factors.end()) throw std::invalid_argument("study: there is no factor \"" + name + "\"");
  return static_cast<std::size_t>(found - choices.factors.begin());
}

/// By number: run for at least half of the readings that the most answered number of its part has.
std::vector<bool> widely_run(const std::vector<PrintedNumber>& numbers, const std::vector<ReadingRuns>& runs) {
  std::vector<std::size_t> count(numbers.size(), 0);
  std::map<Part, std::size_t> most;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (const ReadingRuns& one : runs) count[i] += one.samples[i].empty() ? 0 : 1;
    most[numbers[i].part] = std::max(most[numbers[i].part], count[i]);
  }
  std::vector<bool> widely(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) widely[i] = count[i] > 0 && 2 * count[i] >= most[numbers[i].part];
  return widely;
}

std::optional<Posterior> told(const Study& study, const std::vector<PrintedNumber>& numbers,
                              const std::vector<ReadingRuns>& runs, const std::vector<Part>& parts, bool penalised) {
  try {
    return posterior(study.choices, numbers, runs, study.widths, study.counted, parts, penalised);
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // too few readings were run
  }
}

void rank(std::vector<StudiedReading>& readings) {
  double best = -std::numeric_limits<double>::infinity(), best_without = best;
  for (StudiedReading& one : readings) {
    const Assessment& assessment = one.assessment;
    if (!assessment.calibration || !assessment.test) continue;
    one.without_penalty = *assessment.calibration + *assessment.test;
    one.log10_evidence = *one.without_penalty - penalty_per_departure * static_cast<double>(one.departures);
    best = std::max(best, *one.log10_evidence);
    best_without = std::max(best_without, *one.without_penalty);
  }
  for (StudiedReading& one : readings) {
    if (one.log10_evidence) *one.log10_evidence -= best;
    if (one.without_penalty) *one.without_penalty -= best_without;
  }
  std::ranges::stable_sort(readings, std::greater{}, [](const StudiedReading& one) {
    return std::pair{one.log10_evidence.value_or(below_all), one.assessment.calibration.value_or(below_all)};
  });
}

std::string number_text(std::optional<double> value) {
  // Adding zero takes the sign from a value that rounds to zero.
  return value ? fmt::format("{:.1f}", std::round(10.0 * *value) / 10.0 + 0.0) : "–";
}

/// Bars end cells of a Markdown table.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.replace(at, 1, "\\|");
  return text;
}

std::string percent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

nlohmann::json number_or_null(double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); }
nlohmann::json number_or_null(const std::optional<double>& value) {
  return value ? number_or_null(*value) : nlohmann::json();
}

nlohmann::ordered_json posterior_json(const Choices& choices, const std::optional<Posterior>& posterior) {
  nlohmann::ordered_json json;
  if (!posterior) return json;
  for (std::size_t f = 0; f < choices.factors.size(); ++f)
    for (std::size_t k = 0; k < choices.factors[f].levels.size(); ++k)
      json["levels"][choices.factors[f].name][choices.factors[f].levels[k].name] = posterior->levels[f][k];
  for (const RankedReading& one : posterior->best)
    json["best"].push_back({{"reading", choices.name_of(one.reading)}, {"log10_evidence", one.log10_evidence}});
  return json;
}

std::string ranking_text(const Study& study) {
  std::vector<std::string> first_levels;
  for (const Factor& factor : study.choices.factors) first_levels.push_back(factor.levels.front().title);
  std::string text =
      "### Ranking\n\nEvidence is the logarithm (base 10) of the likelihood of the counted numbers, over that of the "
      "best reading; each departure from a printed statement costs one unit. A reading is ruled out by one number of "
      "the packed bed, or by two others, that lie more than three widths off. What a row does not "
      "name is as first listed: " +
      fmt::format("{}", fmt::join(first_levels, ", ")) +
      ".\n\n"
      "| reading | evidence | without penalty | packed bed | drops | with disputed numbers | departures | drops' "
      "numbers inside "
      "95 % | ruled out by |\n|---|---|---|---|---|---|---|---|---|\n";
  std::size_t shown = 0;
  for (const StudiedReading& one : study.readings) {
    if (!one.log10_evidence || shown++ == told_readings) break;
    std::vector<std::string> departures;
    for (const Level* level : study.choices.departures_of(one.runs.reading))
      departures.push_back(fmt::format("{} ({})", level->title, level->departs));
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} of {} | {} |\n",
                        study.choices.title_of(one.runs.reading), number_text(one.log10_evidence),
                        number_text(one.without_penalty), number_text(one.assessment.calibration),
                        number_text(one.assessment.test), number_text(one.with_disputed),
                        departures.empty() ? "none" : fmt::format("{}", fmt::join(departures, "; ")), one.inside,
                        one.tested, one.assessment.ruled_out ? cell(one.assessment.reason) : "not");
  }
  if (shown == 0) return "No reading has been run for all counted numbers yet.\n\n";
  return text + "\n";
}

std::string choices_text(const Study& study) {
  const auto probabilities = [&](const std::optional<Posterior>& posterior, std::size_t f) {
    if (!posterior) return std::string("–");
    std::vector<std::pair<double, std::string>> levels;
    for (std::size_t k = 0; k < study.choices.factors[f].levels.size(); ++k)
      if (posterior->levels[f][k] >= 0.005)
        levels.emplace_back(posterior->levels[f][k], study.choices.factors[f].levels[k].title);
    std::ranges::sort(levels, std::greater{});
    std::vector<std::string> texts;
    for (const auto& [probability, title] : levels) texts.push_back(fmt::format("{} {}", title, percent(probability)));
    return fmt::format("{}", fmt::join(texts, ", "));
  };
  std::string text =
      "### Each choice\n\nProbability of each level over all combinations of the levels that were tried, predicted "
      "from "
      "the runs by a sum of terms (an emulator), with the penalty; and whether a choice can be told at all: one run "
      "after another took the paper's place, and the others had to find its levels.\n\n"
      "| choice | by the packed bed alone | by all counted numbers | found in the twins | by chance | can be told | "
      "moves "
      "most |\n|---|---|---|---|---|---|---|\n";
  for (std::size_t f = 0; f < study.choices.factors.size(); ++f) {
    const Identification& one = study.identification[f];
    if (one.trials == 0) continue;
    std::vector<std::string> moved;
    for (const Sensitivity& number : study.sensitivities[f]) {
      if (moved.size() == 3) break;
      moved.push_back(fmt::format("{} ({:.1f} widths)", study.evidence[number.number].printed.title, number.effect));
    }
    text += fmt::format("| {} | {} | {} | {} of {} | {} | {} | {} |\n", study.choices.factors[f].title,
                        probabilities(study.calibrated, f), probabilities(study.penalised, f), one.hits, one.trials,
                        percent(one.chance), one.identified ? "yes" : "no",
                        moved.empty() ? "no number by two widths" : cell(fmt::format("{}", fmt::join(moved, ", "))));
  }
  return text + "\n";
}

std::string unreached_text(const Study& study) {
  std::string text;
  for (std::size_t i = 0; i < study.evidence.size(); ++i) {
    if (study.reached[i]) continue;
    double nearest = std::numeric_limits<double>::infinity(), ours = 0.0;
    std::string by;
    for (const StudiedReading& one : study.readings) {
      const Comparison& comparison = one.assessment.comparisons[i];
      if (!(comparison.implausibility < nearest)) continue;
      nearest = comparison.implausibility;
      ours = comparison.ours;
      by = study.choices.title_of(one.runs.reading);
    }
    if (!std::isfinite(nearest)) continue;  // not run at all
    text += fmt::format("- {}: printed {:.4g}, nearest {:.4g} ({:.1f} widths off; {})\n",
                        study.evidence[i].printed.title, study.evidence[i].printed.value, ours, nearest, by);
  }
  if (text.empty()) return "";
  return "### What no reading satisfies\n\nMore than three widths off in every reading; these numbers count in no "
         "ranking.\n\n" +
         text + "\n";
}

std::string disputed_text(const Study& study) {
  std::map<std::string, std::vector<std::string>> titles;
  for (const Evidence& one : study.evidence)
    if (!one.disputed.empty()) titles[one.disputed].push_back(one.printed.title);
  if (titles.empty()) return "";
  std::string text = "### Numbers that are disputed\n\nCompared, and counted only in the column that says so.\n\n";
  for (const auto& [reason, list] : titles) text += fmt::format("- {}: {}\n", fmt::join(list, ", "), reason);
  return text + "\n";
}

std::string choosing_text(const Study& study) {
  std::map<std::string, std::vector<std::string>> titles;
  for (const Evidence& one : study.evidence)
    if (!one.chose.empty()) titles[one.chose].push_back(one.printed.title);
  if (titles.empty()) return "";
  std::string text =
      "### Numbers that made a choice\n\nEvidence as the others; no tests, so not among those inside 95 %.\n\n";
  for (const auto& [choice, list] : titles) text += fmt::format("- {}: {}\n", fmt::join(list, ", "), choice);
  return text + "\n";
}

/// Numbers on which the leading readings differ most: to know them would decide between them.
std::string deciding_text(const Study& study) {
  std::vector<const StudiedReading*> leading;
  for (const StudiedReading& one : study.readings)
    if (one.log10_evidence && *one.log10_evidence > -nearly_as_good) leading.push_back(&one);
  if (leading.size() < 2) return "";
  struct Difference {
    double widths;
    std::size_t number;
    double lowest, highest;
  };
  std::vector<Difference> differences;
  for (std::size_t i = 0; i < study.evidence.size(); ++i) {
    const auto a = static_cast<Eigen::Index>(i);
    const double width = std::sqrt(study.widths.chance(a, a) + study.widths.grid[a]);
    Difference difference{0.0, i, std::numeric_limits<double>::infinity(), 0.0};
    for (const StudiedReading* one : leading) {
      const double ours = one->assessment.comparisons[i].ours;
      if (!std::isfinite(ours)) continue;
      difference.lowest = std::min(difference.lowest, ours);
      difference.highest = std::max(difference.highest, ours);
    }
    if (!(difference.highest > difference.lowest) || !(width > 0.0)) continue;
    difference.widths = std::log(difference.highest / difference.lowest) / width;
    differences.push_back(difference);
  }
  std::ranges::sort(differences, std::greater{}, &Difference::widths);
  std::string text = fmt::format(
      "### What could be measured to decide\n\n{} readings lie within one unit of the best. They differ most in these "
      "numbers, over the scatter of one sample; several drops, or the original data, of the first ones would tell them "
      "apart.\n\n",
      leading.size());
  for (std::size_t k = 0; k < std::min<std::size_t>(5, differences.size()); ++k)
    text += fmt::format("- {}: {:.4g} to {:.4g} ({:.1f} widths)\n", study.evidence[differences[k].number].printed.title,
                        differences[k].lowest, differences[k].highest, differences[k].widths);
  return text + "\n";
}

std::string prediction_text(const Study& study) {
  if (!study.penalised) return "";
  std::string text =
      "### Combinations that were not run\n\nThe emulator's best combinations of the tried levels, run or not, over "
      "its "
      "best one. They are predictions: the ranking above is of runs.\n\n";
  for (std::size_t k = 0; k < std::min<std::size_t>(5, study.penalised->best.size()); ++k) {
    const RankedReading& one = study.penalised->best[k];
    const std::string name = study.choices.name_of(one.reading);
    const bool run = std::ranges::find(study.readings, name, &StudiedReading::name) != study.readings.end();
    text += fmt::format("- {} ({:.1f}{})\n", study.choices.title_of(one.reading), one.log10_evidence,
                        run ? ", run" : ", not run");
  }
  return text + "\n";
}

}  // namespace

Study study(Choices choices, std::vector<Evidence> evidence, const std::vector<FinishedRun>& runs,
            const MeasuringRules& rules, const std::string& grid) {
  Study study{std::move(choices), std::move(evidence), {}, {}, {}, {}, {}, {}, {}, {}, {}};
  const std::vector<PrintedNumber> numbers = printed_numbers(study.evidence);
  const std::vector<NamedRuns> named = collect(study.choices, study.evidence, runs, rules);
  std::vector<ReadingRuns> plain;
  for (const NamedRuns& one : named) plain.push_back(one.runs);
  study.widths =
      measure_widths(numbers, plain, grid.empty() ? std::nullopt : std::optional(factor_named(study.choices, grid)));
  study.reached = reached_by_any(numbers, plain, study.widths);
  const std::vector<bool> widely = widely_run(numbers, plain);
  std::vector<bool> with_disputed(numbers.size());
  study.counted.resize(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    with_disputed[i] = study.reached[i] && widely[i];
    study.counted[i] = with_disputed[i] && study.evidence[i].disputed.empty();
  }
  const auto assessed = assess(numbers, plain, study.widths, study.counted);
  const auto all_assessed = assess(numbers, plain, study.widths, with_disputed);
  for (std::size_t r = 0; r < named.size(); ++r) {
    StudiedReading reading{named[r].name,
                           named[r].runs,
                           assessed[r],
                           all_assessed[r].test,
                           study.choices.departures_of(named[r].runs.reading).size(),
                           {},
                           {},
                           0,
                           0};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const double implausibility = assessed[r].comparisons[i].implausibility;
      const Evidence& one = study.evidence[i];
      if (numbers[i].part != Part::test || !one.disputed.empty() || !one.chose.empty() || std::isnan(implausibility))
        continue;
      ++reading.tested;
      reading.inside += implausibility <= inside_95_percent ? 1 : 0;
    }
    study.readings.push_back(std::move(reading));
  }
  rank(study.readings);
  study.penalised = told(study, numbers, plain, {Part::calibration, Part::test}, true);
  study.unpenalised = told(study, numbers, plain, {Part::calibration, Part::test}, false);
  study.calibrated = told(study, numbers, plain, {Part::calibration}, true);
  study.sensitivities = sensitivities(study.choices, numbers, plain, study.widths);
  study.identification = identify(study.choices, numbers, plain, study.widths);
  return study;
}

nlohmann::ordered_json study_json(const Study& study) {
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < study.evidence.size(); ++i) {
    const auto a = static_cast<Eigen::Index>(i);
    const PrintedNumber& printed = study.evidence[i].printed;
    json["numbers"].push_back({{"title", printed.title},
                               {"quantity", printed.quantity},
                               {"block", printed.block},
                               {"part", printed.part == Part::calibration ? "calibration" : "test"},
                               {"printed", printed.value},
                               {"half_width", printed.half_width},
                               {"scatter_of_one_sample", std::sqrt(study.widths.chance(a, a))},
                               {"degrees_of_freedom", study.widths.freedom[i]},
                               {"scatter_of_grid", std::sqrt(study.widths.grid[a])},
                               {"reached", static_cast<bool>(study.reached[i])},
                               {"counted", static_cast<bool>(study.counted[i])},
                               {"disputed", study.evidence[i].disputed},
                               {"chose", study.evidence[i].chose}});
  }
  for (const StudiedReading& one : study.readings) {
    nlohmann::ordered_json reading{{"name", one.name},
                                   {"title", study.choices.title_of(one.runs.reading)},
                                   {"log10_evidence", number_or_null(one.log10_evidence)},
                                   {"without_penalty", number_or_null(one.without_penalty)},
                                   {"calibration", number_or_null(one.assessment.calibration)},
                                   {"test", number_or_null(one.assessment.test)},
                                   {"test_with_disputed", number_or_null(one.with_disputed)},
                                   {"departures", one.departures},
                                   {"inside_95_percent", one.inside},
                                   {"tested", one.tested},
                                   {"ruled_out_by", one.assessment.reason}};
    for (const Comparison& comparison : one.assessment.comparisons)
      reading["comparisons"].push_back({{"ours", number_or_null(comparison.ours)},
                                        {"samples", comparison.samples},
                                        {"lost", comparison.lost},
                                        {"relative_error", number_or_null(comparison.relative_error)},
                                        {"implausibility", number_or_null(comparison.implausibility)}});
    json["readings"].push_back(std::move(reading));
  }
  json["posterior"] = posterior_json(study.choices, study.penalised);
  json["posterior_without_penalty"] = posterior_json(study.choices, study.unpenalised);
  json["posterior_of_calibration"] = posterior_json(study.choices, study.calibrated);
  for (std::size_t f = 0; f < study.choices.factors.size(); ++f) {
    const Identification& one = study.identification[f];
    nlohmann::ordered_json choice{{"trials", one.trials},
                                  {"hits", one.hits},
                                  {"mean_probability", one.mean_probability},
                                  {"chance", one.chance},
                                  {"identified", one.identified}};
    for (const Sensitivity& number : study.sensitivities[f])
      choice["moves"].push_back({{"number", study.evidence[number.number].printed.title}, {"widths", number.effect}});
    json["choices"][study.choices.factors[f].name] = std::move(choice);
  }
  return json;
}

std::string study_text(const Study& study) {
  if (study.readings.empty()) return "No reading has been run yet.\n";
  return "All of this is inference from printed numbers, not knowledge of what was run.\n\n" + ranking_text(study) +
         choices_text(study) + unreached_text(study) + disputed_text(study) + choosing_text(study) +
         deciding_text(study) + prediction_text(study);
}

}  // namespace slfb::readings
