#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a source leaves open, or says twice: the choices that whoever repeats it has to make. Read from the file
/// readings.toml of a work (README.md says what stands in it).
namespace slfb::readings {

/// One way to make a choice.
struct Level {
  std::string name;                    ///< "random-dry"; no other level of the work has it
  std::string title;                   ///< a few words
  std::vector<std::string> overrides;  ///< what it sets in a scene, in full: it does not lean on the scene's defaults
  std::string departs;                 ///< what printed statement it departs from; empty: from none
  std::optional<double> value;         ///< of a choice that is a number, in the unit of the factor
};

/// One choice. Its first level is the one that names leave out.
struct Factor {
  std::string name;
  std::string title;
  std::string source;  ///< what the source says of it
  std::string unit;    ///< of the values of its levels; "-" for a ratio
  std::vector<Level> levels;
};

/// One level for each factor: its place in Factor::levels.
using Reading = std::vector<std::size_t>;

/// All factors of a work, and which readings each design asks for.
struct Choices {
  std::vector<Factor> factors;
  std::map<std::string, std::vector<Reading>> designs;

  /// Names of the levels that are not the first of their factor, joined by "_" in the order of the factors; "base" for
  /// none. Stays the same when factors and levels are added behind the others.
  [[nodiscard]] std::string name_of(const Reading& reading) const;
  /// The reading with this name. Throws std::invalid_argument for a name that is none.
  [[nodiscard]] Reading reading_named(std::string_view name) const;
  /// Titles of the levels that are not the first of their factor, joined by commas.
  [[nodiscard]] std::string title_of(const Reading& reading) const;
  [[nodiscard]] std::vector<std::string> overrides_of(const Reading& reading) const;
  /// The levels of a reading that depart from what is printed.
  [[nodiscard]] std::vector<const Level*> departures_of(const Reading& reading) const;
  /// Throws std::invalid_argument that lists the known designs.
  [[nodiscard]] const std::vector<Reading>& design(const std::string& name) const;
};

/// The name of the reading that has the first level of every factor.
inline constexpr std::string_view base_name = "base";

/// Throws std::runtime_error with file, line and key.
Choices load_choices(const std::filesystem::path& file);

}  // namespace slfb::readings
