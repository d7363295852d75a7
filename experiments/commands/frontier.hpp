#pragma once

#include <CLI/CLI.hpp>

namespace slfb {

/// `slfb frontier`: error against cost of methods.
void add_frontier_command(CLI::App& app);

}  // namespace slfb
