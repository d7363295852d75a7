#pragma once

#include <fmt/core.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace slfb {

/// A state by name, as a checkpoint stores it: each field is a list of numbers in SI units under a name such as
/// "velocity_x". A name with a slash, "interval/steps", belongs to a part of its owner.
using NamedFields = std::map<std::string, std::vector<double>>;

/// The field of that name. \throws std::runtime_error if there is none
inline const std::vector<double>& field_of(const NamedFields& fields, const std::string& name) {
  const auto found = fields.find(name);
  if (found == fields.end()) throw std::runtime_error(fmt::format("the state has no field \"{}\"", name));
  return found->second;
}

/// The same, which must have that many values. \throws std::runtime_error if it has not
inline const std::vector<double>& field_of(const NamedFields& fields, const std::string& name, std::size_t length) {
  const std::vector<double>& field = field_of(fields, name);
  if (field.size() == length) return field;
  throw std::runtime_error(
      fmt::format("the field \"{}\" of the state has {} values instead of {}", name, field.size(), length));
}

/// The same, which must have that many values or none.
/// \throws std::runtime_error if it has another number
inline const std::vector<double>& field_or_none(const NamedFields& fields, const std::string& name,
                                                std::size_t length) {
  const std::vector<double>& field = field_of(fields, name);
  return field.empty() ? field : field_of(fields, name, length);
}

/// A whole number from 0 to `most` that is stored as the field's value `place`.
/// \throws std::runtime_error if it is none
inline std::size_t index_of(const NamedFields& fields, const std::string& name, std::size_t place, std::size_t most) {
  const std::vector<double>& field = field_of(fields, name);
  const double value = place < field.size() ? field[place] : -1.0;
  if (value >= 0.0 && value <= static_cast<double>(most) && value == std::floor(value))
    return static_cast<std::size_t>(value);
  throw std::runtime_error(
      fmt::format("the field \"{}\" of the state holds {} instead of a whole number from 0 to {}", name, value, most));
}

/// Adds the fields of a part as "part/name".
inline void add_part(NamedFields& fields, std::string_view part, const NamedFields& of_part) {
  for (const auto& [name, values] : of_part) fields[fmt::format("{}/{}", part, name)] = values;
}

/// The fields of a part by their own names; empty if it has none.
inline NamedFields part_of(const NamedFields& fields, std::string_view part) {
  const std::string start = fmt::format("{}/", part);
  NamedFields result;
  for (const auto& [name, values] : fields)
    if (name.starts_with(start)) result[name.substr(start.size())] = values;
  return result;
}

}  // namespace slfb
