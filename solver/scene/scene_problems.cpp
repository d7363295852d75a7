#include "solver/scene/scene_problems.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace slfb::description {

void Problems::add(const std::string& path, std::string_view value, std::string_view message) {
  if (const auto origin = origins_.find(path); origin != origins_.end()) {
    add_at(origin->second.place, fmt::format("{} = {}: {}", path, origin->second.text, message));
    return;
  }
  // A value that was never written belongs to its table.
  const auto table = origins_.find(path.substr(0, path.rfind('.')));
  add_at(table != origins_.end() ? table->second.place : file_, fmt::format("{} = {}: {}", path, value, message));
}

void Problems::add_at(const std::string& place, std::string_view message) {
  lines_.push_back(fmt::format("{}: {}", place, message));
}

void Problems::raise() const {
  if (!lines_.empty()) throw SceneError(fmt::format("{}", fmt::join(lines_, "\n")));
}

}  // namespace slfb::description
