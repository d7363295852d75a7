#pragma once

#include <vector>

#include "reports/report_contents.hpp"

/// What does not add up in the paper: each row computed from its printed numbers and the laws.
namespace slfb {

/// All rows, in the order of the paper.
std::vector<reports::InconsistencyRow> inconsistencies();

}  // namespace slfb
