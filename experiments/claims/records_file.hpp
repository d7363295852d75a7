#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiments/quantities/quantity.hpp"
#include "experiments/runs/runs_of_others.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {

/// What the [[series]] of results of others refer to: the systems of a work and how it measures.
struct MeasuredSystems {
  MeasuringRules rules = general_rules();
  std::vector<std::string> names = {};
  std::function<Scene(const std::string& system)> scene_of = {};
};

/// Reads the tables [[series]] and reduces the records that they name, as measure_runs does.
/// \param folder from which names of files count \param file for messages
/// \throws std::runtime_error with file, line and key; with those of a record where that cannot be read.
Measurements measure_records(TomlTable& table, const std::filesystem::path& folder, const std::string& file,
                             const MeasuredSystems& systems);

/// How [[series]] is written and what becomes of it, as comments of a TOML file.
std::string records_help(const MeasuredSystems& systems);

}  // namespace slfb
