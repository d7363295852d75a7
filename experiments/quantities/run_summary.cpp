#include "experiments/quantities/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
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

std::map<std::string, double> numbers_of_drop(const DropSeries& drop, const RunView& run) {
  const Species& sphere = species_named(run.scene, drop.species);
  const DropStatistics statistics =
      analyse_drop(drop, {.bed_top = run.bed_top(),
                          .bed_diameter = run.bed_species().diameter,
                          .sphere_diameter = sphere.diameter,
                          .sphere_density = sphere.density,
                          .classification = classification_of(drop, run.scene, run.rules, run.release_clock)});
  const bool from_release_height = !drop.z.empty() && drop.z.front() > 0.98 * run.rules.release_height;
  const DropView view{run, drop, statistics, from_release_height};
  std::map<std::string, double> numbers;
  for (const Quantity& quantity : run.rules.quantities)
    if (const auto* computed = std::get_if<OfDrop>(&quantity.computed))
      if (const auto value = (*computed)(view)) numbers[quantity.id] = *value;
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
  for (const DropSeries& drop : result.drops) summary.drops.push_back(numbers_of_drop(drop, view));
  summary.run["wall_seconds"] = result.wall_seconds;
  summary.run["simulated_seconds"] = result.simulated_seconds;
  summary.run["particles_removed"] = static_cast<double>(result.particles_removed);
  return summary;
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
