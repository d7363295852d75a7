#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Names that a mistyped one may have meant, for messages.
namespace slfb {

/// Insertions, deletions and replacements that lead from one word to the other (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The three names nearest to `word`, those that contain it before the others.
std::vector<std::string> close_names(std::string_view word, std::vector<std::string> known);

/// "; did you mean NAME?" for the nearest name where it is near enough to have been meant, else nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

}  // namespace slfb
