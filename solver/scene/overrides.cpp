#include "solver/scene/overrides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>
#include <utility>

namespace slfb::description {
namespace {

std::string trimmed(std::string text) {
  const auto blank = [](unsigned char c) { return std::isspace(c) != 0; };
  text.erase(std::find_if_not(text.rbegin(), text.rend(), blank).base(), text.end());
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), blank));
  return text;
}

Override split_override(const std::string& text) {
  const auto fail = [&](std::string_view what) {
    return SceneError(
        fmt::format("--set {}: {}; allowed is key=value with the dotted path of the scene file, for "
                    "example \"contact.stiffness=1e3 N/m\" or \"stage[2].repetitions=5\"",
                    text, what));
  };
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw fail("no \"=\"");
  Override result{text, trimmed(text.substr(0, equals)), {}, trimmed(text.substr(equals + 1))};
  std::istringstream path(result.path);
  for (std::string part; std::getline(path, part, '.');) {
    Override::PathSegment segment{part, std::nullopt};
    if (const auto bracket = part.find('['); bracket != std::string::npos) {
      const auto digits = part.substr(bracket + 1, part.size() - bracket - 2);
      if (part.back() != ']' || digits.empty() || digits.size() > 6 ||
          !std::ranges::all_of(digits, [](unsigned char c) { return std::isdigit(c) != 0; })) {
        throw fail("the index in the key is not [0], [1], …");
      }
      segment = {part.substr(0, bracket), std::stoul(digits)};
    }
    if (segment.key.empty()) throw fail("the key has an empty part");
    result.segments.push_back(segment);
  }
  if (result.segments.empty() || result.path.back() == '.') throw fail("the key has an empty part");
  if (result.segments.back().index) throw fail("the key names a whole table");
  return result;
}

/// The value as TOML where it is TOML (numbers, booleans, arrays, quoted strings), else the bare text.
void insert_value(toml::table& table, const std::string& key, const std::string& value) {
  if (value.find('\n') == std::string::npos) {
    try {
      auto parsed = toml::parse("value = " + value);
      table.insert_or_assign(key, std::move(*parsed.get("value")));
      return;
    } catch (const toml::parse_error&) {
      // "1e3 N/m" or a word: the text is the value
    }
  }
  table.insert_or_assign(key, value);
}

void apply_override(toml::table& root, const Override& change) {
  const auto fail = [&](std::string_view what) {
    return SceneError(fmt::format("{}: {} = {}: {}", change.place(), change.path, change.value, what));
  };
  toml::table* table = &root;
  for (std::size_t i = 0; i + 1 < change.segments.size(); ++i) {
    const auto& [key, index] = change.segments[i];
    if (!table->contains(key) && !index) table->insert(key, toml::table{});
    toml::node* node = table->get(key);
    if (index) {
      const toml::array* array = node != nullptr ? node->as_array() : nullptr;
      const std::size_t size = array != nullptr ? array->size() : 0;
      if (*index >= size) throw fail(fmt::format("the scene has {} [[{}]], counted from 0", size, key));
      node = node->as_array()->get(*index);
    }
    table = node->as_table();
    if (table == nullptr)
      throw fail(fmt::format("\"{}\" is not a table; allowed is a path such as stage[2].duration", key));
  }
  const std::string& key = change.segments.back().key;
  // Either of the two keys replaces the other.
  if (key == "count") table->erase("total_mass");
  if (key == "total_mass") table->erase("count");
  insert_value(*table, key, change.value);
}

/// The newest override of a key of [contact], without its quotes.
std::optional<std::string> word_for(const std::vector<Override>& changes, const std::string& path) {
  const auto change =
      std::find_if(changes.rbegin(), changes.rend(), [&](const Override& candidate) { return candidate.path == path; });
  if (change == changes.rend()) return std::nullopt;
  const bool quoted = change->value.starts_with('"') && change->value.ends_with('"');
  return quoted ? change->value.substr(1, change->value.size() - 2) : change->value;
}

/// Removes the key of [contact] that the tangential model of an override does not take.
void forget_other_tangential_model(toml::table& root, const std::vector<Override>& changes) {
  toml::table* contact = root["contact"].as_table();
  const auto model = word_for(changes, "contact.tangential_model");
  if (contact == nullptr || !model) return;
  if (*model == "dashpot") contact->erase("tangential_stiffness_ratio");
  if (*model == "spring") contact->erase("tangential_damping_ratio");
}

/// Removes the keys of [contact] and [wall] that the law of an override does not take.
void forget_other_contact_law(toml::table& root, const std::vector<Override>& changes, const SceneLaws& laws) {
  const auto law = word_for(changes, "contact.law");
  if (!law) return;
  for (const char* section : {"contact", "wall"}) {
    toml::table* table = root[section].as_table();
    if (table == nullptr) continue;
    std::vector<std::string> others;
    for (const auto& [key, value] : *table)
      if (laws.contact_key(*law, key.str()).rule == Presence::Rule::meaningless) others.emplace_back(key.str());
    for (const std::string& key : others) table->erase(key);
  }
}

}  // namespace

std::vector<Override> split_overrides(const std::vector<std::string>& texts) {
  std::vector<Override> changes;
  for (const std::string& text : texts) changes.push_back(split_override(text));
  return changes;
}

void apply_overrides(toml::table& root, const std::vector<Override>& changes, const SceneLaws& laws) {
  forget_other_contact_law(root, changes, laws);
  forget_other_tangential_model(root, changes);
  for (const Override& change : changes) apply_override(root, change);
}

}  // namespace slfb::description
