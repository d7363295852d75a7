#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/claims/claims.hpp"

/// Claims as the pages of the report show them.
namespace slfb {

/// Evaluations of one place in the paper: figures, tables, then the text.
using ClaimGroups = std::vector<std::pair<std::string, std::vector<const Evaluation*>>>;
ClaimGroups claims_by_place(const std::vector<Evaluation>& evaluations);

/// "fig05" → "Figure 5", "table2" → "Table 2", "text" → "Text".
std::string place_in_paper(const std::string& name);

/// A verdict as a class of the style sheet.
std::string verdict_class(Verdict verdict);

/// One character per verdict, so that colour is never the only sign.
const char* verdict_sign(Verdict verdict);

/// "1 claim", "3 claims".
std::string plural(std::size_t count, const std::string& noun);

/// `text` with its unit, unless that is "-".
std::string with_unit(const std::string& text, const std::string& unit);

/// The table of claims; `body_id` names its body for scripts and may be empty.
std::string claim_table(const std::vector<const Evaluation*>& evaluations, const std::string& body_id);

}  // namespace slfb
