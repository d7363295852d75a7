#pragma once

#include <CLI/CLI.hpp>

namespace slfb {

/// `slfb stability`: maps of where methods fail.
void add_stability_command(CLI::App& app);

}  // namespace slfb
