#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace slfb {

/// A scene that cannot be run; what() reads "file:line: key = value: what is wrong; what is allowed", a line for each
/// problem.
struct SceneError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace slfb

namespace slfb::description {

/// Where a value was written, and how.
struct Origin {
  std::string place;  ///< "file:line" or "--set key=value"
  std::string text;   ///< the value as written
};

/// Collects what is wrong with a scene, so that one run of the reader reports all of it.
class Problems {
 public:
  /// `file` stands for values that were never written (defaults, missing keys).
  explicit Problems(std::string file) : file_(std::move(file)) {}

  /// `path` of a value ("contact.stiffness") or of its table ("contact", "stage[2]").
  void set_origin(const std::string& path, Origin origin) { origins_[path] = std::move(origin); }

  /// "place: path = value: message"; `value` is printed, at the line of the table, when the file lacks the key.
  void add(const std::string& path, std::string_view value, std::string_view message);

  /// "place: message", for what has no value.
  void add_at(const std::string& place, std::string_view message);

  /// Throws SceneError with one line per problem, if there is any.
  void raise() const;

 private:
  std::string file_;
  std::map<std::string, Origin> origins_;
  std::vector<std::string> lines_;
};

}  // namespace slfb::description
