#pragma once

#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/work/work.hpp"
#include "reports/report_contents.hpp"

namespace slfb {

/// What was found in a work, as its findings.toml says it: sentences, each with a figure and the claims that carry it.
/// "{ours:ID}" and "{paper:ID}" in a sentence stand for the number of a claim with its unit ("0.0561 ± 0.0005 m/s"), a
/// dash where there is none, so that no number is typed.
///
/// \param evaluations of all claims. None where the work has no such file. Throws std::runtime_error with file, line
/// and key on a claim, figure or verdict that does not exist.
std::vector<reports::FindingRow> findings(const Work& work, const std::vector<Evaluation>& evaluations);

}  // namespace slfb
