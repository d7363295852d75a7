#include "experiments/readings/choices.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiments/readings/hadamard.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb::readings {
namespace {

constexpr std::array design_kinds{"one-at-a-time", "full", "two-level", "list"};
/// A full design multiplies: more readings than this are a slip.
constexpr std::size_t most_readings = 1000;

/// Where a level stands: factor and place in it.
using Place = std::pair<std::size_t, std::size_t>;

std::optional<Place> find_level(const std::vector<Factor>& factors, std::string_view name) {
  for (std::size_t f = 0; f < factors.size(); ++f)
    for (std::size_t k = 0; k < factors[f].levels.size(); ++k)
      if (factors[f].levels[k].name == name) return Place{f, k};
  return std::nullopt;
}

/// Letters, digits, points and hyphens: "_" joins names, and names become file names.
bool is_word(std::string_view name) {
  return !name.empty() && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
  });
}

std::vector<Factor> read_factors(TomlTable& root) {
  std::vector<Factor> factors;
  std::set<std::string> names;
  for (TomlTable& table : root.tables("factor")) {
    Factor factor{table.text("name"), table.text("title"), table.text("source"), table.text("unit", "-"), {}};
    for (TomlTable& entry : table.tables("level")) {
      Level level{entry.text("name"), entry.text("title"), entry.texts("overrides"), entry.text("departs", ""), {}};
      if (entry.has("value")) level.value = entry.number("value");
      if (!is_word(level.name) || level.name == base_name)
        throw entry.problem("name", fmt::format("\"{}\" is no name of a level; allowed are small letters, digits, "
                                                "\"-\" and \".\", and not \"{}\"",
                                                level.name, base_name));
      if (!names.insert(level.name).second)
        throw entry.problem("name", fmt::format("\"{}\" is the name of another level too", level.name));
      entry.reject_others();
      factor.levels.push_back(std::move(level));
    }
    if (factor.levels.size() < 2) throw table.problem("level", "a choice needs two levels or more");
    table.reject_others();
    factors.push_back(std::move(factor));
  }
  return factors;
}

/// One design, as its table asks for it.
class DesignReader {
 public:
  DesignReader(const std::vector<Factor>& factors, TomlTable table) : factors_(factors), table_(std::move(table)) {
    base_ = completed(Reading(factors.size(), 0), table_.texts("base"), "base");
  }

  std::vector<Reading> read() {
    const std::string kind = table_.text("kind");
    std::vector<Reading> readings;
    if (kind == "one-at-a-time") {
      readings = one_at_a_time();
    } else if (kind == "full") {
      readings = full();
    } else if (kind == "two-level") {
      readings = two_level();
    } else if (kind == "list") {
      readings = list();
    } else {
      throw table_.problem(
          "kind", fmt::format("\"{}\" is no kind of design; allowed is {}", kind, fmt::join(design_kinds, ", ")));
    }
    table_.reject_others();
    return readings;
  }

 private:
  [[nodiscard]] Place place_of(const std::string& name, const std::string& key) const {
    if (const auto found = find_level(factors_, name)) return *found;
    std::vector<std::string> known;
    for (const Factor& factor : factors_)
      for (const Level& level : factor.levels) known.push_back(level.name);
    throw table_.problem(key, fmt::format("there is no level \"{}\"; known: {}", name, fmt::join(known, ", ")));
  }

  [[nodiscard]] Reading completed(Reading reading, const std::vector<std::string>& names,
                                  const std::string& key) const {
    std::set<std::size_t> set;
    for (const std::string& name : names) {
      const auto [factor, level] = place_of(name, key);
      if (!set.insert(factor).second)
        throw table_.problem(key, fmt::format("\"{}\" is a second level of \"{}\"", name, factors_[factor].name));
      reading[factor] = level;
    }
    return reading;
  }

  /// The levels beside the base: those that the table lists, or all others.
  std::vector<Place> levels_beside_base() {
    std::vector<Place> places;
    if (table_.has("levels")) {
      for (const std::string& name : table_.texts("levels")) {
        const Place place = place_of(name, "levels");
        if (base_[place.first] == place.second)
          throw table_.problem("levels", fmt::format("\"{}\" is a level of the base", name));
        places.push_back(place);
      }
    } else {
      for (std::size_t f = 0; f < factors_.size(); ++f)
        for (std::size_t k = 0; k < factors_[f].levels.size(); ++k)
          if (k != base_[f]) places.emplace_back(f, k);
    }
    return places;
  }

  std::vector<Reading> one_at_a_time() {
    std::vector<Reading> readings{base_};
    for (const auto& [factor, level] : levels_beside_base()) {
      readings.push_back(base_);
      readings.back()[factor] = level;
    }
    return readings;
  }

  std::vector<Reading> full() {
    std::map<std::size_t, std::vector<std::size_t>> others;
    for (const auto& [factor, level] : levels_beside_base()) others[factor].push_back(level);
    std::vector<Reading> readings{base_};
    for (const auto& [factor, levels] : others) {
      const std::vector<Reading> before = readings;
      for (const std::size_t level : levels)
        for (Reading reading : before) {
          reading[factor] = level;
          readings.push_back(std::move(reading));
        }
      if (readings.size() > most_readings)
        throw table_.problem("levels", fmt::format("more than {} readings; list fewer levels", most_readings));
    }
    return readings;
  }

  /// Each factor has the level of the base where its column of a Hadamard matrix has +1, the listed one where it has
  /// -1; folded, also the other way round.
  std::vector<Reading> two_level() {
    const std::vector<Place> others = levels_beside_base();
    const bool folded = table_.flag("folded");
    std::set<std::size_t> factors;
    for (const auto& [factor, level] : others)
      if (!factors.insert(factor).second)
        throw table_.problem("levels", fmt::format("a two-level design takes one level of each factor beside that of "
                                                   "the base; \"{}\" has more",
                                                   factors_[factor].name));
    std::vector<Reading> readings;
    for (const int sign : {1, -1}) {
      if (sign < 0 && !folded) break;
      for (const std::vector<int>& row : hadamard_matrix(others.size() + 1)) {
        Reading reading = base_;
        for (std::size_t c = 0; c < others.size(); ++c)
          if (sign * row[c + 1] < 0) reading[others[c].first] = others[c].second;
        readings.push_back(std::move(reading));
      }
    }
    return readings;
  }

  std::vector<Reading> list() {
    std::vector<Reading> readings;
    for (TomlTable& reading : table_.tables("readings")) {
      readings.push_back(completed(base_, reading.texts("levels"), "readings"));
      reading.reject_others();
    }
    if (readings.empty()) throw table_.problem("readings", "is empty; needed is one { levels = [...] } or more");
    return readings;
  }

  const std::vector<Factor>& factors_;
  TomlTable table_;
  Reading base_;
};

}  // namespace

std::string Choices::name_of(const Reading& reading) const {
  std::vector<std::string> names;
  for (std::size_t f = 0; f < factors.size(); ++f)
    if (reading[f] != 0) names.push_back(factors[f].levels[reading[f]].name);
  return names.empty() ? std::string(base_name) : fmt::format("{}", fmt::join(names, "_"));
}

Reading Choices::reading_named(std::string_view name) const {
  Reading reading(factors.size(), 0);
  if (name == base_name) return reading;
  for (std::string_view rest = name; !rest.empty();) {
    const auto end = rest.find('_');
    const auto place = find_level(factors, rest.substr(0, end));
    if (!place) throw std::invalid_argument(fmt::format("\"{}\" is the name of no reading", name));
    reading[place->first] = place->second;
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  }
  if (name_of(reading) != name) throw std::invalid_argument(fmt::format("\"{}\" is the name of no reading", name));
  return reading;
}

std::string Choices::title_of(const Reading& reading) const {
  std::vector<std::string> titles;
  for (std::size_t f = 0; f < factors.size(); ++f)
    if (reading[f] != 0) titles.push_back(factors[f].levels[reading[f]].title);
  return titles.empty() ? "the first level of every choice" : fmt::format("{}", fmt::join(titles, ", "));
}

std::vector<std::string> Choices::overrides_of(const Reading& reading) const {
  std::vector<std::string> overrides;
  for (std::size_t f = 0; f < factors.size(); ++f)
    for (const std::string& one : factors[f].levels[reading[f]].overrides) overrides.push_back(one);
  return overrides;
}

std::vector<const Level*> Choices::departures_of(const Reading& reading) const {
  std::vector<const Level*> departures;
  for (std::size_t f = 0; f < factors.size(); ++f)
    if (const Level& level = factors[f].levels[reading[f]]; !level.departs.empty()) departures.push_back(&level);
  return departures;
}

const std::vector<Reading>& Choices::design(const std::string& name) const {
  if (const auto found = designs.find(name); found != designs.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [design, readings] : designs) known.push_back(design);
  throw std::invalid_argument(fmt::format("there is no design \"{}\"; known: {}", name, fmt::join(known, ", ")));
}

Choices load_choices(const std::filesystem::path& file) {
  const toml::table parsed = parse_toml_file(file);
  TomlTable root(parsed, file.string());
  Choices choices{read_factors(root), {}};
  if (root.has("designs")) {
    TomlTable group = root.table("designs");
    for (const auto& [name, node] : *parsed["designs"].as_table()) {
      std::vector<Reading> readings = DesignReader(choices.factors, group.table(std::string(name.str()))).read();
      std::set<Reading> seen;
      std::erase_if(readings, [&](const Reading& reading) { return !seen.insert(reading).second; });
      choices.designs[std::string(name.str())] = std::move(readings);
    }
  }
  root.reject_others();
  return choices;
}

}  // namespace slfb::readings
