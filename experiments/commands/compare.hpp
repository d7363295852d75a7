#pragma once

#include <CLI/CLI.hpp>

namespace slfb {

/// Adds `slfb compare`: laws, those of the suite and a user's own, side by side.
void add_compare_command(CLI::App& app);

}  // namespace slfb
