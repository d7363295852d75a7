#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

namespace slfb {

/// Calls `visit(law)` with a default-constructed object of each type of the list `Laws` (a std::tuple).
template <class Laws, class Visit>
void for_each_law(Visit&& visit) {
  std::apply([&](const auto&... law) { (visit(law), ...); }, Laws{});
}

/// The names of the laws of a list, separated by commas, for messages.
template <class Laws>
std::string law_names() {
  std::string names;
  for_each_law<Laws>([&](const auto& law) {
    if (!names.empty()) names += ", ";
    names += law.info.name;
  });
  return names;
}

/// Calls `use(law)` with the law of that name and returns its result, so that the code inside `use` is compiled once
/// per law and the formula is inlined there.
/// \param what the kind of law, for the message ("drag law")
/// \throws std::invalid_argument naming the unknown law and listing the known ones
template <class Laws, std::size_t Index = 0, class Use>
decltype(auto) with_law(std::string_view what, std::string_view name, Use&& use) {
  using Law = std::tuple_element_t<Index, Laws>;
  if constexpr (Index + 1 < std::tuple_size_v<Laws>) {
    if (name != Law::info.name) return with_law<Laws, Index + 1>(what, name, std::forward<Use>(use));
  } else {
    if (name != Law::info.name) {
      throw std::invalid_argument("unknown " + std::string(what) + " \"" + std::string(name) +
                                  "\"; known: " + law_names<Laws>());
    }
  }
  return std::forward<Use>(use)(Law{});
}

}  // namespace slfb
