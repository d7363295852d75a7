#pragma once

#include <CLI/CLI.hpp>

namespace slfb {

/// Adds `slfb figures [ID…] [--profile NAME] [--jobs N] [--threads N] [--out DIR] [--no-run]`: simulates what the named
/// figures still need, draws every figure with what exists, and writes the report.
void add_figures_command(CLI::App& app);

}  // namespace slfb
