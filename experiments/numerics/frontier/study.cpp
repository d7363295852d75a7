#include "experiments/numerics/frontier/study.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <nlohmann/json.hpp>

#include "experiments/quantities/analysis.hpp"
#include "experiments/quantities/json_file.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb::frontier {
namespace {

using nlohmann::ordered_json;
using studies::Set;
using studies::Trial;
using studies::TrialResult;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

std::filesystem::path folder() { return source_folder() / "experiments" / "numerics" / "frontier"; }

std::vector<Trial> replicates(const std::string& problem, const std::vector<std::string>& settings, int number) {
  std::vector<Trial> trials;
  for (int k = 0; k < number; ++k) trials.push_back({problem, settings, k});
  return trials;
}

std::vector<double> numbers_for(TomlTable& table, const std::string& key, Set set) {
  const auto full = table.numbers(key);
  const auto quick = table.numbers("quick_" + key);
  return set == Set::quick && !quick.empty() ? quick : full;
}

ordered_json json_of(const PointValue& value) {
  return {{"value", number_or_null(value.value)},
          {"half_width", number_or_null(value.half_width)},
          {"error", number_or_null(value.error)},
          {"error_half_width", number_or_null(value.error_half_width)}};
}

PointValue point_value(const ordered_json& value) {
  return {number_or_nan(value.at("value")), number_or_nan(value.at("half_width")), number_or_nan(value.at("error")),
          number_or_nan(value.at("error_half_width"))};
}

/// Mean and interval of one quantity over the replicates that have it; NaN where none has.
PointValue mean_of(const std::vector<TrialResult>& results, const std::string& quantity) {
  std::vector<double> values;
  double error = 0.0, exact = nothing;
  for (const TrialResult& result : results) {
    const auto found = result.values.find(quantity);
    if (found == result.values.end() || !std::isfinite(found->second.value)) continue;
    values.push_back(found->second.value);
    error += found->second.error;
    exact = found->second.exact;
  }
  if (values.empty()) return {nothing, nothing, nothing, nothing};
  const ReplicateEstimate estimate = estimate_replicates(values);
  return {estimate.mean, estimate.half_width, error / static_cast<double>(values.size()) / std::abs(exact), nothing};
}

/// What save_reduced wrote; no points where there is no file.
ReducedStudy load_file(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  return read_json(file, "a reduced study", [](const ordered_json& json) {
    ReducedStudy reduced;
    reduced.set = json.at("set");
    reduced.machine = json.at("machine");
    reduced.date = json.at("date");
    reduced.numerics = static_cast<int>(whole_number(json.at("numerics")));
    for (const auto& [quantity, value] : json.at("reference").items()) reduced.reference[quantity] = point_value(value);
    for (const auto& one : json.at("points")) {
      ReducedPoint point;
      point.series = one.at("series");
      point.axis = one.at("axis");
      point.cpu_seconds = one.at("cpu_seconds");
      point.counts = one.at("counts").get<std::map<std::string, double>>();
      point.replicates = static_cast<int>(whole_number(one.at("replicates")));
      point.failure = one.at("failure");
      for (const auto& [quantity, value] : one.at("values").items()) point.values[quantity] = point_value(value);
      reduced.points.push_back(std::move(point));
    }
    return reduced;
  });
}

}  // namespace

std::vector<studies::Trial> trials_of(const Study& study) {
  std::vector<studies::Trial> trials = study.reference;
  for (const StudyPoint& point : study.points) trials.insert(trials.end(), point.trials.begin(), point.trials.end());
  return trials;
}

std::vector<std::filesystem::path> study_files() { return toml_files(folder() / "studies"); }

std::filesystem::path study_file(const std::string& id) { return folder() / "studies" / (id + ".toml"); }

Study load_study(const std::filesystem::path& file, Set set) {
  const toml::table parsed = parse_toml_file(file);
  TomlTable table(parsed, file.string());
  Study study;
  study.id = file.stem().string();
  study.title = table.text("title");
  study.caption = table.text("caption");
  study.problem = table.text("problem");
  study.quantities = table.texts("quantities");
  study.count = table.text("count");
  const studies::Problem& problem = studies::find_problem(study.problem);
  for (const std::string& quantity : study.quantities) studies::find_quantity(problem, quantity);
  auto common = table.texts("settings");
  const auto quick_settings = table.texts("quick_settings");
  if (set == Set::quick) common.insert(common.end(), quick_settings.begin(), quick_settings.end());
  const auto full_repetitions = table.number("repetitions", 1.0),
             quick_repetitions = table.number("quick_repetitions", full_repetitions);
  const int repetitions = static_cast<int>(set == Set::quick ? quick_repetitions : full_repetitions);

  TomlTable axis = table.table("axis");
  study.axis_label = axis.text("label");
  const auto axis_settings = axis.texts("set");
  const auto axis_values = numbers_for(axis, "values", set);
  axis.reject_others();

  TomlTable reference = table.table("reference");
  study.reference_text = reference.text("text");
  if (reference.has("settings")) {
    auto settings = common;
    auto own = reference.texts("settings");
    const auto quick = reference.texts("quick_settings");
    if (set == Set::quick && !quick.empty()) own = quick;
    settings.insert(settings.end(), own.begin(), own.end());
    study.reference = replicates(reference.text("problem", study.problem), settings, repetitions);
  }
  reference.reject_others();

  for (TomlTable& series : table.tables("series")) {
    const std::string name = series.text("name");
    study.series.push_back(name);
    const bool full_only = series.flag("full_only");
    const std::string own_problem = series.text("problem", study.problem);
    auto settings = common;
    const auto own = series.texts("settings");
    settings.insert(settings.end(), own.begin(), own.end());
    const auto own_values = numbers_for(series, "values", set);
    const bool once = series.flag("once");  // a method that the axis does not change
    series.reject_others();
    if (full_only && set == Set::quick) continue;
    auto values = own_values.empty() ? axis_values : own_values;
    if (once) values.resize(1);
    for (const double value : values) {
      auto with_axis = settings;
      if (!once)
        for (const std::string& setting : axis_settings) with_axis.push_back(studies::fill_in(setting, value));
      study.points.push_back({name, value, replicates(own_problem, with_axis, repetitions)});
    }
  }
  if (table.has("default")) {
    TomlTable standard = table.table("default");
    study.default_series = standard.text("series");
    study.default_axis = standard.number("axis");
    study.default_text = standard.text("text");
    standard.reject_others();
  }
  table.reject_others();
  // Everything is read and checked before anything is solved.
  const auto check = [&](const Trial& trial) {
    try {
      trial.check();
    } catch (const std::exception& error) {
      throw std::runtime_error(fmt::format("{}: {}", file.string(), error.what()));
    }
  };
  for (const StudyPoint& point : study.points) check(point.trials.front());
  if (!study.reference.empty()) check(study.reference.front());
  return study;
}

ReducedStudy reduce(const Study& study, Set set, const studies::TrialStore& store) {
  ReducedStudy reduced;
  reduced.id = study.id;
  reduced.set = studies::name_of(set);
  reduced.numerics = numerics_version;
  reduced.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
  const auto found = [&](const std::vector<Trial>& trials) {
    std::vector<TrialResult> results;
    for (const Trial& trial : trials)
      if (const auto result = store.find(trial)) results.push_back(*result);
    return results;
  };
  const auto reference = found(study.reference);
  for (const std::string& quantity : study.quantities) {
    PointValue value = mean_of(reference, quantity);
    value.error_half_width = value.half_width / std::abs(value.value);
    value.error = 0.0;
    if (std::isfinite(value.value)) reduced.reference[quantity] = value;
  }
  for (const StudyPoint& point : study.points) {
    const auto results = found(point.trials);
    if (results.empty()) continue;
    ReducedPoint one;
    one.series = point.series;
    one.axis = point.axis;
    one.replicates = static_cast<int>(results.size());
    for (const TrialResult& result : results) {
      reduced.machine = result.machine;
      one.cpu_seconds += result.cpu_seconds / static_cast<double>(results.size());
      for (const auto& [name, count] : result.counts) one.counts[name] += count / static_cast<double>(results.size());
      if (!result.failure.empty()) one.failure = result.failure;
    }
    for (const std::string& quantity : study.quantities) {
      PointValue value = mean_of(results, quantity);
      if (!std::isfinite(value.value)) continue;
      if (const auto truth = reduced.reference.find(quantity); truth != reduced.reference.end()) {
        value.error = std::abs(value.value / truth->second.value - 1.0);
        value.error_half_width = value.half_width / std::abs(truth->second.value);
      }
      one.values[quantity] = value;
    }
    reduced.points.push_back(std::move(one));
  }
  return reduced;
}

std::filesystem::path committed_file(const std::string& id) { return folder() / "results" / (id + ".json"); }

std::filesystem::path reduced_file(const std::filesystem::path& out, const std::string& id) {
  return out / "frontier" / (id + ".json");
}

bool keep_if_whole(const Study& study, studies::Set set, const studies::TrialStore& store,
                   const std::filesystem::path& out) {
  if (!std::ranges::all_of(trials_of(study),
                           [&](const studies::Trial& trial) { return store.find(trial).has_value(); }))
    return false;
  save_reduced(reduce(study, set, store), reduced_file(out, study.id));
  return true;
}

void save_reduced(const ReducedStudy& reduced, const std::filesystem::path& file) {
  std::filesystem::create_directories(file.parent_path());
  ordered_json json{{"study", reduced.id},
                    {"set", reduced.set},
                    {"machine", reduced.machine},
                    {"date", reduced.date},
                    {"numerics", reduced.numerics},
                    {"reference", ordered_json::object()},
                    {"points", ordered_json::array()}};
  for (const auto& [quantity, value] : reduced.reference) json["reference"][quantity] = json_of(value);
  for (const ReducedPoint& point : reduced.points) {
    ordered_json one{{"series", point.series},           {"axis", point.axis},
                     {"cpu_seconds", point.cpu_seconds}, {"counts", point.counts},
                     {"replicates", point.replicates},   {"failure", point.failure},
                     {"values", ordered_json::object()}};
    for (const auto& [quantity, value] : point.values) one["values"][quantity] = json_of(value);
    json["points"].push_back(std::move(one));
  }
  write_file(file, json.dump(1) + "\n");
}

ReducedStudy load_committed(const std::string& id) {
  ReducedStudy committed = load_file(committed_file(id));
  committed.id = id;
  return committed;
}

ReducedStudy load_reduced(const Study& study, const std::filesystem::path& out) {
  ReducedStudy own = load_file(reduced_file(out, study.id)), committed = load_committed(study.id);
  ReducedStudy drawn = committed_is_better(own, committed) ? std::move(committed) : std::move(own);
  drawn.id = study.id;
  return drawn;
}

ReducedStudy load_beside(const Study& study, const std::filesystem::path& out) {
  ReducedStudy own = load_file(reduced_file(out, study.id));
  return committed_is_better(own, load_committed(study.id)) ? own : ReducedStudy{};
}

std::vector<const ReducedPoint*> pareto_front(const ReducedStudy& reduced, const std::string& quantity,
                                              const std::string& count) {
  std::vector<const ReducedPoint*> candidates, front;
  for (const ReducedPoint& point : reduced.points)
    if (point.failure.empty() && point.values.contains(quantity) && std::isfinite(point.values.at(quantity).error) &&
        (count.empty() || point.counts.contains(count)))
      candidates.push_back(&point);
  const auto rank = [&](const ReducedPoint* point) {
    return std::pair(count.empty() ? point->cpu_seconds : point->counts.at(count), point->values.at(quantity).error);
  };
  std::sort(candidates.begin(), candidates.end(), [&](const auto* a, const auto* b) { return rank(a) < rank(b); });
  double best = std::numeric_limits<double>::infinity();
  for (const ReducedPoint* point : candidates) {
    if (!(point->values.at(quantity).error < best)) continue;
    best = point->values.at(quantity).error;
    front.push_back(point);
  }
  return front;
}

}  // namespace slfb::frontier
