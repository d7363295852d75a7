#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/claims/records_file.hpp"
#include "experiments/quantities/measurement.hpp"

/// Results of others, an experiment or another code, held against the claims of the paper.
///
/// A TOML file of [[measured]] tables: `measure`, a key of the claims (reference-data/README.md); `value`, nan where
/// nothing was measured; `unit`, any that measures what the claim's does; `half_width` of the 95 % interval, left out
/// for a single sample and 0 for an exact number, or `interval` with its two ends. And of [[series]] tables, which name
/// raw records (records_file.hpp).
namespace slfb {

/// In the units of the claims.
/// \throws std::runtime_error with file, line and key: a measure that no claim uses (close ones are named), a unit that
/// measures something else, a half width below zero, a measure that stands there twice; what measure_records throws.
Measurements load_measured(const std::filesystem::path& file, const std::vector<Claim>& claims,
                           const MeasuredSystems& systems = {});

/// The values as a file of [[measured]] tables, which load_measured reads back.
std::string measured_text(const Measurements& measured);

/// Evaluates the claims that use any of `measured`; what the paper allows is their gate.
std::vector<Evaluation> evaluate_measured(const std::vector<Claim>& claims, const Measurements& measured);

/// A file to start from: every measure of the claims that a simulation or an experiment answers, with its definition
/// and the records from which it can be reduced.
std::string measured_template(const std::vector<Claim>& claims, const MeasuredSystems& systems = {});

}  // namespace slfb
