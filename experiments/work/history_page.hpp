#pragma once

#include <string>
#include <vector>

#include "experiments/claims/history.hpp"

namespace slfb {

/// A claim or a time of the last entry beside those before.
struct HistoryRow {
  std::string name;  ///< id of a claim, or what was timed
  PastClaim now;
  std::optional<PastClaim> before, first;  ///< of the entry that has it last before this one, and of the first one
  std::optional<PastChange> since_before, since_first;
  bool significant = false;  ///< one of the two differences is no chance, all claims taken together
};

/// Each claim of the last entry: those with another verdict or gate first, then by how significantly they changed.
std::vector<HistoryRow> history_rows(const std::vector<HistoryEntry>& entries);

/// The entries, what changed with the last one, and how many did not: for the terminal.
std::string history_text(const std::vector<HistoryEntry>& entries);

/// A whole page: the same with every claim drawn over the entries, its interval and the paper's band, and each time of
/// a benchmark over that of the first entry of the same machine.
std::string history_html(const std::vector<HistoryEntry>& entries);

}  // namespace slfb
