#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/quantities/analysis.hpp"
#include "solver/io/run_result.hpp"
#include "solver/scene/scene.hpp"

namespace slfb {

/// What is measured in one run, from all that it recorded: the numbers that measure_runs pools, by the name of their
/// quantity. Committed beside the thinned series of a published run, so that nothing is lost by thinning them.
struct RunSummary {
  std::map<std::string, SeriesEstimate> bed;         ///< means over the undisturbed bed
  std::map<std::string, double> run;                 ///< one value per run
  std::vector<std::map<std::string, double>> drops;  ///< of each drop, those that it has
};

/// Measures one run. `system` tells the clock of the intercepts: release at 20 s, in sodium iodide ("…N") at 30 s.
RunSummary summarise(const std::string& system, const Scene& scene, const RunResult& result);

/// Unit of a quantity of a summary.
std::string unit_of(const std::string& quantity);

/// As JSON. Reading throws std::runtime_error that names the file.
void save_summary(const RunSummary& summary, const std::filesystem::path& file);
RunSummary load_summary(const std::filesystem::path& file);

}  // namespace slfb
