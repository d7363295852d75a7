#include "solver/scene/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <optional>

namespace slfb::units {
namespace {

struct SystemDeleter {
  void operator()(ut_system* system) const { ut_free_system(system); }
};
struct UnitDeleter {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct ConverterDeleter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using System = std::unique_ptr<ut_system, SystemDeleter>;
using Unit = std::unique_ptr<ut_unit, UnitDeleter>;
using Converter = std::unique_ptr<cv_converter, ConverterDeleter>;

ut_system* unit_system() {
  static const System system = [] {
    ut_set_error_message_handler(ut_ignore);  // our own messages name the value and what is allowed
    System made(ut_read_xml(nullptr));
    // Viscosities are sold in centipoise; UDUNITS spells the poise out and has no symbol for it.
    if (const Unit centipoise(ut_parse(made.get(), "0.001 Pa s", UT_ASCII)); made && centipoise)
      ut_map_symbol_to_unit("cP", UT_ASCII, centipoise.get());
    if (const Unit degree(ut_parse(made.get(), "degree", UT_ASCII)); made && degree)
      ut_map_symbol_to_unit("deg", UT_ASCII, degree.get());
    return made;
  }();
  if (!system) throw std::runtime_error("the unit database of UDUNITS-2 (package libudunits2-data) cannot be read");
  return system.get();
}

std::string_view trim(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  return text;
}

double round_to_fifteen_digits(double value) { return std::strtod(fmt::format("{:.14e}", value).c_str(), nullptr); }

/// Value in `target` units; nothing when `unit` does not measure the same dimension.
std::optional<double> convert(double value, const std::string& unit_text, const std::string& target_text) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  ut_system* system = unit_system();
  const Unit unit(ut_parse(system, unit_text.c_str(), UT_UTF8));
  const Unit target(ut_parse(system, target_text.c_str(), UT_UTF8));
  if (!unit || !target) return std::nullopt;
  // ut_are_convertible accepts reciprocals too (20 Hz as a time), so the ratio of the two units is asked instead.
  const Unit quotient(ut_divide(unit.get(), target.get()));
  if (!quotient || !ut_is_dimensionless(quotient.get())) return std::nullopt;
  const Converter converter(ut_get_converter(unit.get(), target.get()));
  if (!converter) return std::nullopt;
  // Dates, temperatures and logarithmic units have an offset; no quantity of a scene does.
  if (cv_convert_double(converter.get(), 0.0) != 0.0) return std::nullopt;
  return cv_convert_double(converter.get(), value);
}

}  // namespace

double parse_quantity(std::string_view text, const Dimension& dimension) {
  const auto fail = [&](std::string_view problem) -> UnitError {
    return UnitError(fmt::format("{}; needed is {}, for example \"{}\"{}", problem, dimension.name, dimension.example,
                                 dimension.unit == "1" ? "" : fmt::format(", or a bare number in {}", dimension.unit)));
  };
  text = trim(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) throw fail("does not begin with a finite number");
  const auto unit = std::string(trim({rest, static_cast<std::size_t>(text.data() + text.size() - rest)}));
  if (unit.empty()) {
    if (dimension.unit == "1") return value;
    throw fail("has no unit");
  }
  if (std::isdigit(static_cast<unsigned char>(unit.front()))) throw fail("holds more than one number");
  if (unit.front() == ',') throw fail("holds a comma; numbers are written with a point");
  const auto converted = convert(value, unit, std::string(dimension.unit));
  if (!converted) throw fail(fmt::format("the unit \"{}\" is unknown or measures something else", unit));
  return round_to_fifteen_digits(*converted);
}

std::optional<double> unit_factor(std::string_view unit, std::string_view target) {
  const auto factor = convert(1.0, std::string(trim(unit)), std::string(target));
  return factor ? std::optional(round_to_fifteen_digits(*factor)) : std::nullopt;
}

std::string shortest(double value) { return fmt::format("{}", value); }

std::string with_unit(double value, const Dimension& dimension) {
  return dimension.unit == "1" ? shortest(value) : fmt::format("{} {}", shortest(value), dimension.unit);
}

std::string rounded(double value) { return fmt::format("{:.4g}", value); }

}  // namespace slfb::units
