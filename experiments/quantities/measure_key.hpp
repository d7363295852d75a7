#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace slfb {

/// A superficial velocity [m/s] or a voidage [-] as keys and names of runs have it: two decimals, or as many as it
/// needs: "0.10", "0.105".
std::string velocity_text(double value);

/// The subject of a number that is of all systems together.
inline constexpr std::string_view all_systems = "all";

/// Names one measured number: which quantity, of what.
///
/// The text form "quantity/subject[/at][/detail]" is for files and messages only: "pressure_drop/SYSTEM/0.06",
/// "pressure_drop/SYSTEM/0.06/VARIANT", "pressure_plateau/SYSTEM", "collision_force/LAW/packed". In a claim "*" in the
/// place of `at` stands for every value of it: a pattern.
struct MeasureKey {
  std::string quantity;           ///< id of a Quantity
  std::string subject;            ///< a system of runs, "all" of them, a law, or what else the number is of
  std::optional<double> at = {};  ///< superficial velocity [m/s], or voidage [-] of a quantity "…_at_voidage"
  std::string detail = {};        ///< variant of a run, or a state ("packed"); never a number
  bool for_all_at = false;        ///< a pattern: every value of `at`

  /// By quantity, subject, `at` and detail, in this order: what stands side by side is one curve.
  friend auto operator<=>(const MeasureKey&, const MeasureKey&) = default;
  friend bool operator==(const MeasureKey&, const MeasureKey&) = default;
};

/// A key with a number, which is rounded to what its text says: 0.1 and 0.1 + 1e-12 are one key.
MeasureKey measure_key(std::string_view quantity, std::string_view subject, double at, std::string_view detail = "");

std::string to_string(const MeasureKey& key);

/// Reads the text form. \throws std::invalid_argument where it has fewer than two parts, more than four, or an empty
/// one.
MeasureKey parse_measure_key(std::string_view text);

/// Whether `pattern` names `key`, or stands for it.
bool stands_for(const MeasureKey& pattern, const MeasureKey& key);

}  // namespace slfb
