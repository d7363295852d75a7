#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "solver/scene/units.hpp"

namespace slfb {

/// "30min", "2 h", "90 s" as CPU time [s]; "0" is none. Throws CLI::ValidationError of --budget.
inline double budget_seconds(const std::string& text) {
  if (text == "0") return 0.0;
  try {
    return units::parse_quantity(text, units::time);
  } catch (const units::UnitError& error) {
    throw CLI::ValidationError("--budget", error.what());
  }
}

}  // namespace slfb
