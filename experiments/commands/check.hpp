#pragma once

#include <CLI/CLI.hpp>

namespace slfb {

/// Adds `slfb check [ID…] [--json [FILE]] [--junit FILE] [--profile NAME] [--out DIR]`. The exit status is 0 only
/// when every gate holds.
void add_check_command(CLI::App& app);

}  // namespace slfb
