#include "experiments/quantities/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "experiments/quantities/json_file.hpp"
#include "solver/support/files.hpp"

namespace slfb {
namespace {

const Species& species_named(const Scene& scene, const std::string& name) {
  const auto found = std::ranges::find(scene.species, name, &Species::name);
  if (found == scene.species.end()) throw std::runtime_error("a run dropped the unknown species \"" + name + "\"");
  return *found;
}

/// Names of bounds in the numbers of a drop.
constexpr std::string_view at_least = "_at_least", at_most = "_at_most";

/// What is measured of the drop, or of what `wanted` says only that. \param place of the drop among those into its bed
std::map<std::string, double> numbers_of_drop(const DropSeries& drop, const RunView& run, std::size_t place,
                                              const std::function<bool(const Quantity&)>& wanted = {}) {
  const Species& sphere = species_named(run.scene, drop.species);
  const DropStatistics statistics =
      analyse_drop(drop, {.bed_top = run.bed_top(),
                          .bed_diameter = run.bed_species().diameter,
                          .sphere_diameter = sphere.diameter,
                          .sphere_density = sphere.density,
                          .classification = classification_of(drop, run.scene, run.rules, run.release_clock)});
  const bool from_release_height = !drop.z.empty() && drop.z.front() > 0.98 * run.rules.release_height;
  const DropView view{run, drop, statistics, from_release_height, place == 0};
  std::map<std::string, double> numbers;
  for (const Quantity& quantity : run.rules.quantities) {
    if (const auto* computed = std::get_if<OfDrop>(&quantity.computed); computed && (!wanted || wanted(quantity)))
      if (const auto value = (*computed)(view)) numbers[quantity.id] = *value;
    if (!quantity.bound || numbers.contains(quantity.id)) continue;
    if (const auto bound = quantity.bound(view))
      numbers[fmt::format("{}{}", quantity.id, bound->kind == BoundedSample::Kind::at_least ? at_least : at_most)] =
          bound->value;
  }
  return numbers;
}

}  // namespace

RunSummary summarise(const std::string& system, const Scene& scene, const RunResult& result,
                     const MeasuringRules& rules) {
  RunSummary summary;
  const RunView view{scene, result, rules, rules.release_clock(system), summary.bed};
  for (const Quantity& quantity : rules.quantities)
    if (const auto* computed = std::get_if<OfBed>(&quantity.computed))
      if (const auto estimate = (*computed)(view)) summary.bed[quantity.id] = *estimate;
  for (const Quantity& quantity : rules.quantities)
    if (const auto* computed = std::get_if<OfRun>(&quantity.computed))
      if (const auto value = (*computed)(view)) summary.run[quantity.id] = *value;
  for (const DropSeries& drop : result.drops)
    summary.drops.push_back(numbers_of_drop(drop, view, summary.drops.size()));
  summary.run["wall_seconds"] = result.wall_seconds;
  summary.run["simulated_seconds"] = result.simulated_seconds;
  summary.run["particles_removed"] = static_cast<double>(result.particles_removed);
  return summary;
}

std::optional<BoundedSample> sample_of(const std::map<std::string, double>& drop, const std::string& quantity) {
  using Kind = BoundedSample::Kind;
  const std::pair<std::string_view, Kind> endings[] = {
      {"", Kind::exact}, {at_least, Kind::at_least}, {at_most, Kind::at_most}};
  for (const auto& [ending, kind] : endings)
    if (const auto found = drop.find(fmt::format("{}{}", quantity, ending)); found != drop.end())
      return BoundedSample{found->second, kind};
  return std::nullopt;
}

void complete(RunSummary& summary, const std::string& system, const Scene& scene, const RunResult& thinned,
              const MeasuringRules& rules) {
  const RunView view{scene, thinned, rules, rules.release_clock(system), summary.bed};
  const auto lost_nothing = [](const Quantity& quantity) { return quantity.from_thinned; };
  for (const Quantity& quantity : rules.quantities)
    if (const auto* computed = std::get_if<OfRun>(&quantity.computed); computed && quantity.from_thinned)
      if (const auto value = (*computed)(view)) summary.run.try_emplace(quantity.id, *value);
  for (std::size_t k = 0; k < std::min(summary.drops.size(), thinned.drops.size()); ++k)
    for (const auto& [name, value] : numbers_of_drop(thinned.drops[k], view, k, lost_nothing)) {
      std::string quantity = name;
      for (const std::string_view ending : {at_least, at_most})
        if (quantity.ends_with(ending)) quantity.resize(quantity.size() - ending.size());
      if (!sample_of(summary.drops[k], quantity)) summary.drops[k][name] = value;
    }
}

void save_summary(const RunSummary& summary, const std::filesystem::path& file, const MeasuringRules& rules) {
  nlohmann::ordered_json json;
  for (const auto& [id, estimate] : summary.bed) {
    const Quantity* quantity = find_quantity(rules, id);
    json["bed"][id] = {{"unit", quantity == nullptr ? "-" : quantity->unit},
                       {"mean", number_or_null(estimate.mean)},
                       {"half_width", number_or_null(estimate.half_width)},
                       {"autocorrelation_time", number_or_null(estimate.autocorrelation_time)},
                       {"effective_samples", number_or_null(estimate.effective_samples)},
                       {"discarded", estimate.discarded}};
  }
  for (const auto& [quantity, value] : summary.run) json["run"][quantity] = number_or_null(value);
  json["drops"] = nlohmann::json::array();
  for (const auto& drop : summary.drops) json["drops"].push_back(drop);
  write_file(file, json.dump(1) + "\n");
}

RunSummary load_summary(const std::filesystem::path& file) {
  return read_json(file, "a summary of a run", [](const nlohmann::ordered_json& json) {
    RunSummary summary;
    for (const auto& [quantity, e] : json.at("bed").items())
      summary.bed[quantity] = {number_or_nan(e.at("mean")), number_or_nan(e.at("half_width")),
                               number_or_nan(e.at("autocorrelation_time")), number_or_nan(e.at("effective_samples")),
                               whole_number(e.at("discarded"))};
    for (const auto& [quantity, value] : json.at("run").items()) summary.run[quantity] = number_or_nan(value);
    for (const auto& drop : json.at("drops")) summary.drops.push_back(drop.get<std::map<std::string, double>>());
    return summary;
  });
}

}  // namespace slfb
