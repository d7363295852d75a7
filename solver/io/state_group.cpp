#include "solver/io/state_group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace slfb::io {

void StateGroup::fail(const std::string& name, const std::string& what) const {
  const Hdf5File& file = reading() ? *source_ : *target_;
  throw std::runtime_error(
      fmt::format("{}: \"{}\" {}", file.file().string(), name.empty() ? path_ : path_of(name), what));
}

std::string StateGroup::path_of(const std::string& name) const {
  return path_.empty() ? name : fmt::format("{}/{}", path_, name);
}

std::string StateGroup::item(const std::string& name) {
  std::string path = path_of(name);
  names_.insert(name);
  if (reading() && !source_->exists(path)) fail(name, "is missing");
  return path;
}

void StateGroup::check_length(const std::string& name, std::size_t length, std::optional<std::size_t> expected) const {
  if (expected && length != *expected) fail(name, fmt::format("has {} values instead of {}", length, *expected));
}

void StateGroup::check_finite(const std::string& name, const std::vector<double>& values) const {
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
    fail(name, "holds a value that is no finite number");
}

void StateGroup::check_names() const {
  const std::string group = path_.empty() ? "/" : path_;
  if (!reading() || !source_->exists(group)) return;
  for (const std::string& name : source_->children(group))
    if (!names_.contains(name)) fail(name, "is not a name of this state");
}

void StateGroup::values(const std::string& name, std::vector<double>& values, const std::string& unit,
                        std::optional<std::size_t> length) {
  const std::string path = item(name);
  if (!reading()) return target_->write(path, values, unit);
  values = source_->read_doubles(path);
  check_length(name, values.size(), length);
  check_finite(name, values);
}

void StateGroup::values(const std::string& name, std::vector<std::int64_t>& values, std::optional<std::size_t> length) {
  const std::string path = item(name);
  if (!reading()) return target_->write(path, values);
  values = source_->read_integers(path);
  check_length(name, values.size(), length);
}

void StateGroup::write_fields(const NamedFields& fields) {
  for (const auto& [name, values] : fields) target_->write(path_of(name), values);
}

NamedFields StateGroup::read_fields() {
  NamedFields fields;
  if (!source_->exists(path_)) return fields;
  for (const std::string& name : source_->children(path_)) {
    names_.insert(name);
    if (source_->is_group(path_of(name)))
      add_part(fields, name, StateGroup(nullptr, source_, path_of(name)).read_fields());
    else
      check_finite(name, fields[name] = source_->read_doubles(path_of(name)));
  }
  return fields;
}

void StateGroup::value(const std::string& name, double& value, const std::string& unit) {
  std::vector<double> one{value};
  values(name, one, unit, 1);
  value = one.front();
}

void StateGroup::value(const std::string& name, std::int64_t& value, std::int64_t least, std::int64_t most) {
  this->value(name, value);
  if (reading() && (value < least || value > most))
    fail(name, fmt::format("is {}, not from {} to {}", value, least, most));
}

void StateGroup::value(const std::string& name, std::int64_t& value) {
  std::vector<std::int64_t> one{value};
  values(name, one, 1);
  value = one.front();
}

void StateGroup::value(const std::string& name, bool& value) {
  std::int64_t number = value ? 1 : 0;
  this->value(name, number, 0, 1);
  value = number != 0;
}

void StateGroup::part(const std::string& name, const Exchange& exchange) {
  names_.insert(name);
  StateGroup group(target_, source_, path_of(name));
  exchange(group);
  group.check_names();
}

void write_state(Hdf5File& file, const StateGroup::Exchange& exchange) {
  StateGroup state(&file, nullptr, "");
  exchange(state);
}

void read_state(const Hdf5File& file, const StateGroup::Exchange& exchange) {
  StateGroup state(nullptr, &file, "");
  exchange(state);
  state.check_names();
}

}  // namespace slfb::io
