#pragma once

#include <CLI/App.hpp>
#include <string>

#include "experiments/work/work.hpp"

namespace slfb {

/// The works of the suite; adding one is one line in works.cpp.
const Works& works();

/// Adds --work ID, which sets `id`; find_work(works, id) gives the work.
void add_work_option(CLI::App& command, const Works& works, std::string& id);

}  // namespace slfb
