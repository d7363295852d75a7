#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/quantities/quantity.hpp"

namespace slfb {

/// What is measured in one run, from all that it recorded: numbers by the id of their quantity. Committed beside the
/// thinned series of a published run, so that nothing is lost by thinning them.
struct RunSummary {
  std::map<std::string, SeriesEstimate> bed;  ///< means over the undisturbed bed
  /// One value per run; also wall_seconds and simulated_seconds [s] and particles_removed, facts about this very run.
  std::map<std::string, double> run;
  /// Of each drop, those that it has; a bound of what it has not under the id and "_at_least" or "_at_most".
  std::vector<std::map<std::string, double>> drops;
};

/// Measures one run: walks the list of quantities of the rules, those of the bed first.
RunSummary summarise(const std::string& system, const Scene& scene, const RunResult& result,
                     const MeasuringRules& rules = general_rules());

/// What a drop says of a quantity; empty where nothing.
std::optional<BoundedSample> sample_of(const std::map<std::string, double>& drop, const std::string& quantity);

/// Adds what a summary that was written by an earlier version lacks and its thinned result still gives:
/// Quantity::from_thinned and Quantity::bound.
void complete(RunSummary& summary, const std::string& system, const Scene& scene, const RunResult& thinned,
              const MeasuringRules& rules);

/// As JSON, with the units that the rules have. Reading throws std::runtime_error that names the file.
void save_summary(const RunSummary& summary, const std::filesystem::path& file,
                  const MeasuringRules& rules = general_rules());
RunSummary load_summary(const std::filesystem::path& file);

}  // namespace slfb
