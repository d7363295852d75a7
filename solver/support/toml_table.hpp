#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace slfb {

/// A table of a TOML file. Each getter throws std::runtime_error "file:line: key: what is wrong" for a key that is
/// missing or is of another type. Keys are remembered as they are asked for, so that reject_others() finds the rest.
class TomlTable {
 public:
  /// `table` must outlive the object; `file` is named in errors.
  TomlTable(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  [[nodiscard]] std::string text(const std::string& key);
  [[nodiscard]] std::string text(const std::string& key, const std::string& otherwise);
  [[nodiscard]] double number(const std::string& key);
  [[nodiscard]] double number(const std::string& key, double otherwise);
  [[nodiscard]] bool flag(const std::string& key);                       ///< false without the key
  [[nodiscard]] std::vector<std::string> texts(const std::string& key);  ///< empty without the key
  /// A text alone, or an array of texts; empty without the key.
  [[nodiscard]] std::vector<std::string> text_or_texts(const std::string& key);
  [[nodiscard]] std::vector<double> numbers(const std::string& key);  ///< empty without the key
  /// A table whose values are all numbers; empty without the key.
  [[nodiscard]] std::map<std::string, double> numbers_by_name(const std::string& key);
  [[nodiscard]] bool has(const std::string& key) const { return table_.contains(key); }
  [[nodiscard]] TomlTable table(const std::string& key);
  /// The tables [[key]]; empty without the key.
  [[nodiscard]] std::vector<TomlTable> tables(const std::string& key);
  /// Throws for a key that no getter has asked for, with a list of those that were.
  void reject_others() const;
  /// The error "file:line: key: message", for checks of the caller; the line is that of the key, or of the table.
  [[nodiscard]] std::runtime_error problem(const std::string& key, const std::string& message) const;

 private:
  const toml::node* find(const std::string& key);
  [[nodiscard]] const toml::node& required(const std::string& key);

  const toml::table& table_;
  std::string file_;
  std::set<std::string> asked_;
};

/// Parses a TOML file. Throws std::runtime_error "file:line: what is wrong".
toml::table parse_toml_file(const std::filesystem::path& file);

/// The files NAME.toml of a folder, by name.
std::vector<std::filesystem::path> toml_files(const std::filesystem::path& folder);

}  // namespace slfb
