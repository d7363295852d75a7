#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/quantities/measurement.hpp"

/// Results of others, an experiment or another code, held against the claims of the paper.
///
/// A TOML file of [[measured]] tables: `measure`, a key of the claims (reference-data/README.md); `value`, nan where
/// nothing was measured; `unit`, that of the claim; `half_width` of the 95 % interval, left out for a single sample and
/// 0 for an exact number.
namespace slfb {

/// \throws std::runtime_error with file, line and key: a measure that no claim uses (close ones are named), a unit that
/// is not the claim's, a half width below zero, a measure that stands there twice.
Measurements load_measured(const std::filesystem::path& file, const std::vector<Claim>& claims);

/// Evaluates the claims that use any of `measured`; what the paper allows is their gate.
std::vector<Evaluation> evaluate_measured(const std::vector<Claim>& claims, const Measurements& measured);

/// A file to start from: every measure of the claims that a simulation or an experiment answers.
std::string measured_template(const std::vector<Claim>& claims);

}  // namespace slfb
