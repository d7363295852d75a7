#pragma once

#include <CLI/CLI.hpp>

namespace slfb {

/// `slfb plan`: which models, grid and steps a scene needs for what is asked of it.
void add_plan_command(CLI::App& app);

}  // namespace slfb
