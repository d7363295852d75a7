#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/claims/claims.hpp"

/// What versions of a code said to the claims, one after the other, so that a drift is seen before a gate breaks.
///
/// A history is a file of lines, each an entry as JSON: {"version", "commit", "date", "machine", "claims": {ID:
/// {"unit", "value", "interval", "band", "verdict", "gate"}}, "bench": {NAME: time}}. Files of several machines may be
/// joined.
namespace slfb {

/// What one version said to one claim.
struct PastClaim {
  std::string unit;
  std::optional<double> value;
  std::optional<std::pair<double, double>> interval;  ///< 95 %
  std::optional<Band> band;                           ///< of the paper; an open side is ±infinity
  std::string verdict, gate;                          ///< as `slfb check --json` has them
};

struct HistoryEntry {
  std::string version, commit, date, machine;
  std::map<std::string, PastClaim> claims;  ///< by id
  std::map<std::string, double> bench;      ///< times by what was measured and their unit; less is faster
};

/// An entry from what `slfb check --json` wrote. \param label takes the place of the version of the suite, for results
/// of another code; needed where the JSON names none
/// \throws std::runtime_error where a part is missing or damaged
HistoryEntry history_entry(const nlohmann::ordered_json& checked, const std::string& label);

/// Adds the times of what `slfb bench … --json` wrote. \throws std::runtime_error where it has no result that is known
void add_bench(HistoryEntry& entry, const nlohmann::ordered_json& measured);

/// Writes the entry behind those of the file, which may not exist yet.
void append_to_history(const std::filesystem::path& file, const HistoryEntry& entry);

/// The entries by their dates. \throws std::runtime_error with file and line where one is damaged, and where there is
/// none
std::vector<HistoryEntry> load_history(const std::filesystem::path& file);

/// How a claim differs from what was said before.
struct PastChange {
  double difference = 0.0;         ///< now less before
  std::optional<double> relative;  ///< over the magnitude of the value before; empty where that is 0
  /// Of the difference over the half width of its own 95 % interval: 1 is the edge of that. Infinite for a difference
  /// of exact numbers, 0 for equal values, empty where one is a single sample.
  std::optional<double> significance;
};

/// Empty where one has no value.
std::optional<PastChange> change_since(const PastClaim& before, const PastClaim& now);

/// Significance above which a difference is no chance, at 5 % for all of `comparisons` together (Bonferroni).
double significance_of_all(std::size_t comparisons);

/// Place of the value in its band: 0 in the middle, ±1 at an edge; empty without a band of two ends.
std::optional<double> place_in_band(const PastClaim& claim);

}  // namespace slfb
