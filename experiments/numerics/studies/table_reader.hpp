#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace slfb::studies {

/// A table of a data file; every getter throws std::runtime_error with file and line of what is missing or wrong.
class TableReader {
 public:
  TableReader(const toml::table& table, std::string file) : table_(table), file_(std::move(file)) {}

  [[nodiscard]] std::string text(const std::string& key);
  [[nodiscard]] std::string text(const std::string& key, const std::string& otherwise);
  [[nodiscard]] double number(const std::string& key);
  [[nodiscard]] double number(const std::string& key, double otherwise);
  [[nodiscard]] bool flag(const std::string& key);  ///< false without the key
  [[nodiscard]] std::vector<std::string> texts(const std::string& key);
  [[nodiscard]] std::vector<double> numbers(const std::string& key);
  /// A table whose values are all numbers; empty without the key.
  [[nodiscard]] std::map<std::string, double> numbers_by_name(const std::string& key);
  [[nodiscard]] bool has(const std::string& key) const { return table_.contains(key); }
  [[nodiscard]] TableReader table(const std::string& key);
  /// None without the key.
  [[nodiscard]] std::vector<TableReader> tables(const std::string& key);
  /// Complains about keys that nothing has asked for.
  void reject_others() const;
  /// "file:line: message"
  [[nodiscard]] std::runtime_error problem(const std::string& key, const std::string& message) const;

 private:
  const toml::node* find(const std::string& key);
  [[nodiscard]] const toml::node& required(const std::string& key);

  const toml::table& table_;
  std::string file_;
  std::set<std::string> asked_;
};

/// Parses a file; `table` must outlive the readers made of it.
toml::table parse_table(const std::filesystem::path& file);

/// Files NAME.toml of a folder by name.
std::vector<std::filesystem::path> data_files(const std::filesystem::path& folder);

/// `text` with every {} replaced by a number.
std::string fill_in(std::string text, double value);

}  // namespace slfb::studies
