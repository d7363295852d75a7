#pragma once

#include <CLI/CLI.hpp>

namespace slfb {

/// Adds `slfb list`: figures, claims, the runs of each profile, scenes.
void add_list_command(CLI::App& app);

}  // namespace slfb
