#include "solver/support/close_names.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace slfb {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t substitution = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = std::exchange(row[j + 1], std::min({row[j] + 1, row[j + 1] + 1, substitution}));
    }
  }
  return row.back();
}

std::vector<std::string> close_names(std::string_view word, std::vector<std::string> known) {
  const auto rank = [&](const std::string& name) {
    return std::pair(name.find(word) != std::string::npos ? std::size_t{0} : edit_distance(word, name), name);
  };
  std::ranges::sort(known, {}, rank);
  known.erase(std::unique(known.begin(), known.end()), known.end());  // clang 14 does not take that of std::ranges
  known.resize(std::min<std::size_t>(3, known.size()));
  return known;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  if (word.empty() || known.empty()) return "";
  const std::string nearest = close_names(word, known).front();
  // A letter or two, or a third of a long word, or a part of the name.
  const std::size_t most = std::max<std::size_t>(2, word.size() / 3);
  if (nearest.find(word) == std::string::npos && edit_distance(word, nearest) > most) return "";
  return "; did you mean " + nearest + "?";
}

}  // namespace slfb
