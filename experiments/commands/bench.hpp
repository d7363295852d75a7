#pragma once

#include <CLI/CLI.hpp>

namespace slfb {

/// `slfb bench`: how fast the parts of the solver are on this machine.
void add_bench_command(CLI::App& app);

}  // namespace slfb
