#include "solver/support/toml_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace slfb {

std::runtime_error TomlTable::problem(const std::string& key, const std::string& message) const {
  const toml::node* node = table_.get(key);
  const auto line = (node != nullptr ? node->source() : table_.source()).begin.line;
  return std::runtime_error(fmt::format("{}:{}: {}: {}", file_, line, key, message));
}

const toml::node* TomlTable::find(const std::string& key) {
  asked_.insert(key);
  return table_.get(key);
}

const toml::node& TomlTable::required(const std::string& key) {
  const toml::node* node = find(key);
  if (node == nullptr) throw problem(key, "is missing");
  return *node;
}

std::string TomlTable::text(const std::string& key) {
  const auto value = required(key).value<std::string>();
  if (!value) throw problem(key, "must be a text");
  return *value;
}

std::string TomlTable::text(const std::string& key, const std::string& otherwise) {
  return find(key) == nullptr ? otherwise : text(key);
}

double TomlTable::number(const std::string& key) {
  const auto value = required(key).value<double>();
  if (!value) throw problem(key, "must be a number");
  return *value;
}

double TomlTable::number(const std::string& key, double otherwise) {
  return find(key) == nullptr ? otherwise : number(key);
}

bool TomlTable::flag(const std::string& key) {
  if (find(key) == nullptr) return false;
  const auto value = required(key).value<bool>();
  if (!value) throw problem(key, "must be true or false");
  return *value;
}

std::vector<std::string> TomlTable::texts(const std::string& key) {
  std::vector<std::string> values;
  const toml::node* node = find(key);
  if (node == nullptr) return values;
  if (!node->is_array()) throw problem(key, "must be an array of texts");
  for (const toml::node& item : *node->as_array()) {
    const auto value = item.value<std::string>();
    if (!value) throw problem(key, "must be an array of texts");
    values.push_back(*value);
  }
  return values;
}

std::vector<std::string> TomlTable::text_or_texts(const std::string& key) {
  const toml::node* node = find(key);
  return node != nullptr && node->is_string() ? std::vector{text(key)} : texts(key);
}

std::vector<double> TomlTable::numbers(const std::string& key) {
  std::vector<double> values;
  const toml::node* node = find(key);
  if (node == nullptr) return values;
  if (!node->is_array()) throw problem(key, "must be an array of numbers");
  for (const toml::node& item : *node->as_array()) {
    const auto value = item.value<double>();
    if (!value) throw problem(key, "must be an array of numbers");
    values.push_back(*value);
  }
  return values;
}

std::map<std::string, double> TomlTable::numbers_by_name(const std::string& key) {
  std::map<std::string, double> values;
  const toml::node* node = find(key);
  if (node == nullptr) return values;
  if (!node->is_table()) throw problem(key, "must be a table of numbers");
  for (const auto& [name, item] : *node->as_table()) {
    const auto value = item.value<double>();
    if (!value) throw problem(key, "must be a table of numbers");
    values[std::string(name.str())] = *value;
  }
  return values;
}

TomlTable TomlTable::table(const std::string& key) {
  const toml::table* inner = required(key).as_table();
  if (inner == nullptr) throw problem(key, "must be a table");
  return {*inner, file_};
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) {
  std::vector<TomlTable> inner;
  const toml::node* node = find(key);
  if (node == nullptr) return inner;
  if (!node->is_array_of_tables()) throw problem(key, "must be an array of tables");
  for (const toml::node& item : *node->as_array()) inner.emplace_back(*item.as_table(), file_);
  return inner;
}

void TomlTable::reject_others() const {
  for (const auto& [key, node] : table_)
    if (!asked_.contains(std::string(key.str())))
      throw problem(std::string(key.str()),
                    fmt::format("is not a key that is read here; known: {}", fmt::join(asked_, ", ")));
}

toml::table parse_toml_file(const std::filesystem::path& file) {
  try {
    return toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
}

std::vector<std::filesystem::path> toml_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace slfb
