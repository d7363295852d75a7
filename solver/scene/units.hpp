#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

/// Quantities with units, at the edge of the suite; everything behind it is SI.
namespace slfb::units {

/// What a value of a scene file measures.
struct Dimension {
  std::string_view name;     ///< "length"
  std::string_view unit;     ///< the SI unit (degree for an angle), in UDUNITS-2 notation; "1" for a ratio
  std::string_view example;  ///< a value as a user would write it
};

inline constexpr Dimension length{"a length", "m", "50 mm"};
inline constexpr Dimension mass{"a mass", "kg", "0.5255 kg"};
inline constexpr Dimension time{"a time", "s", "1 ms"};
inline constexpr Dimension density{"a density", "kg/m3", "998.2 kg/m3"};
inline constexpr Dimension viscosity{"a dynamic viscosity", "Pa s", "1.0 mPa s"};
inline constexpr Dimension velocity{"a velocity", "m/s", "6 cm/s"};
inline constexpr Dimension stiffness{"a stiffness", "N/m", "1e4 N/m"};
inline constexpr Dimension pressure{"a pressure", "Pa", "5e7 Pa"};
/// In degrees: a bare number that was meant so and taken for radians would be another angle, unseen.
inline constexpr Dimension angle{"an angle", "degree", "10 degree"};
inline constexpr Dimension ratio{"a number without a unit", "1", "0.9"};

/// A text that is not a quantity of the dimension asked for; what() says what is needed, with an example.
struct UnitError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// "50 mm" as a length → 0.05. The number is rounded to fifteen significant digits after the conversion, so that
/// "7.14 mm" and 0.00714 are the same number. Calls from several threads are serialised (UDUNITS-2 keeps one state).
double parse_quantity(std::string_view text, const Dimension& dimension);

/// What one `unit` is in `target` units, "mm" in "m" → 0.001; empty where it is unknown or measures something else.
std::optional<double> unit_factor(std::string_view unit, std::string_view target);

/// Shortest decimal that reads back as the same number.
std::string shortest(double value);
/// The same with the SI unit behind it: "0.05 m".
std::string with_unit(double value, const Dimension& dimension);
/// Four digits, enough to act on: for messages.
std::string rounded(double value);

}  // namespace slfb::units
