#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "solver/io/hdf5_file.hpp"
#include "solver/support/named_fields.hpp"

namespace slfb::io {

/// A part of a state as a group of an HDF5 file: each value is a data set with a name of its own.
///
/// The owner of a state lists its values once, in a function that takes a StateGroup. The same list writes the group
/// and reads it back:
///
///     void Clock::exchange(io::StateGroup& group) {
///       group.value("steps", steps_);
///       group.values("sums", sums_, "N", 3);
///     }
///     write_state(file, [&](io::StateGroup& state) { state.part("clock", [&](auto& group) { clock.exchange(group); });
///     });
///
/// When a state is read, the file must hold exactly the names of the list. A std::runtime_error names file and item if
/// a name is missing, if the file has a name that the list does not have, if an array has another length, or if a real
/// number is not finite.
class StateGroup {
 public:
  /// True while the list reads: values are then assigned, else they are only read.
  [[nodiscard]] bool reading() const { return source_ != nullptr; }

  /// One number, with its unit in UDUNITS spelling.
  void value(const std::string& name, double& value, const std::string& unit = "");
  void value(const std::string& name, std::int64_t& value);
  /// The same, which must lie between two bounds when it is read.
  void value(const std::string& name, std::int64_t& value, std::int64_t least, std::int64_t most);
  void value(const std::string& name, bool& value);

  /// An array. `length`: what it must have when it is read; without it any length is accepted.
  void values(const std::string& name, std::vector<double>& values, const std::string& unit = "",
              std::optional<std::size_t> length = {});
  void values(const std::string& name, std::vector<std::int64_t>& values, std::optional<std::size_t> length = {});

  /// A whole group of arrays whose names its owner alone knows: "part/name" lies in a group within this one. What is
  /// read may have any names and lengths; its owner checks them.
  void write_fields(const NamedFields& fields);
  [[nodiscard]] NamedFields read_fields();

  using Exchange = std::function<void(StateGroup&)>;
  /// A group within this one.
  void part(const std::string& name, const Exchange& exchange);

  /// Throws std::runtime_error that names the file, an item of this group (or the group, if `name` is empty) and what
  /// is wrong with it.
  [[noreturn]] void fail(const std::string& name, const std::string& what) const;

 private:
  friend void write_state(Hdf5File& file, const Exchange& exchange);
  friend void read_state(const Hdf5File& file, const Exchange& exchange);
  StateGroup(Hdf5File* target, const Hdf5File* source, std::string path)
      : target_(target), source_(source), path_(std::move(path)) {}

  [[nodiscard]] std::string path_of(const std::string& name) const;
  /// Notes a name of the list and returns its path; when reading, it must be there.
  [[nodiscard]] std::string item(const std::string& name);
  void check_length(const std::string& name, std::size_t length, std::optional<std::size_t> expected) const;
  void check_finite(const std::string& name, const std::vector<double>& values) const;
  void check_names() const;

  Hdf5File* target_;
  const Hdf5File* source_;
  std::string path_;             ///< of the group, empty for the whole file
  std::set<std::string> names_;  ///< that the list has asked for
};

/// Writes all that `exchange` lists into a file.
void write_state(Hdf5File& file, const StateGroup::Exchange& exchange);

/// Reads all that `exchange` lists. Throws std::runtime_error as StateGroup says; what was read before stays changed.
void read_state(const Hdf5File& file, const StateGroup::Exchange& exchange);

}  // namespace slfb::io
