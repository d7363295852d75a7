#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/report_contents.hpp"

/// Claims as the pages of the report show them. All texts returned are HTML unless it is said otherwise.
namespace slfb::reports {

/// Claims of one place in the work: figures, tables, then the text.
using ClaimGroups = std::vector<std::pair<std::string, std::vector<const ClaimRow*>>>;
ClaimGroups claims_by_place(const std::vector<ClaimRow>& claims);

/// "fig05" → "Figure 5", "table2" → "Table 2", "text" → "Text".
std::string place_name(const std::string& place);

/// "reproduced", "not reproduced", "not decidable".
std::string verdict_words(Verdict verdict);

/// The verdict as a class of the style sheet: "not-reproduced".
std::string verdict_class(Verdict verdict);

/// One character per verdict, so that colour is never the only sign.
const char* verdict_sign(Verdict verdict);

/// "1 claim", "3 claims".
std::string plural(std::size_t count, const std::string& noun);

/// `text` with its unit, unless that is "-" or empty.
std::string with_unit(const std::string& text, const std::string& unit);

/// The table of claims. `claims_page`: page with all of them, to which each id leads; empty on that page itself.
std::string claim_table(const std::vector<const ClaimRow*>& claims, const std::string& claims_page = "");

/// How many of the claims have which verdict, as badges.
std::string verdict_badges(const std::vector<const ClaimRow*>& claims);

}  // namespace slfb::reports
