#include "experiments/reference/reference_numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/toml_table.hpp"

namespace slfb {
namespace {

[[noreturn]] void fail(const std::string& place, const std::string& problem) {
  throw std::runtime_error(place + ": " + problem);
}

}  // namespace

void ReferenceNumbers::read_values(const std::filesystem::path& file) {
  const toml::table document = parse_toml_file(file);
  TomlTable root(document, file.string());
  auto entries = root.tables("value");
  if (entries.empty()) fail(file.string(), "no [[value]] in it");
  for (TomlTable& entry : entries) {
    ReferenceValue value{entry.text("id"),   entry.text("quantity"),      entry.number("value"),
                         entry.text("unit"), entry.number("uncertainty"), entry.text("source")};
    entry.reject_others();
    if (values_.contains(value.id)) throw entry.problem("id", fmt::format("\"{}\" occurs twice", value.id));
    add(std::move(value), file.string());
  }
  root.reject_others();
}

std::vector<std::vector<double>> ReferenceNumbers::read_table(const std::filesystem::path& folder,
                                                              const ReferenceTable& table) {
  const auto file = folder / table.file;
  auto rows = read_columns(file, table.columns.size() + 1);
  for (const auto& row : rows) {
    const std::string at = fmt::format("{:.2f}", row.front());
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
      const auto& column = table.columns[k];
      add({column.id + "/" + at, fmt::format(fmt::runtime(column.quantity), at), row[k + 1], column.unit,
           column.uncertainty, table.source},
          file.string());
    }
  }
  return rows;
}

void ReferenceNumbers::add(ReferenceValue value, const std::string& origin) {
  std::string id = value.id;
  if (!values_.emplace(id, std::move(value)).second) fail(origin, fmt::format("\"{}\" occurs twice", id));
}

const ReferenceValue& ReferenceNumbers::at(std::string_view id) const {
  const auto found = values_.find(id);
  if (found == values_.end()) throw std::out_of_range(fmt::format("{} has no value \"{}\"", work_, id));
  return found->second;
}

std::vector<std::vector<double>> read_columns(const std::filesystem::path& file, std::size_t columns) {
  std::istringstream in(read_file(file));
  std::vector<std::vector<double>> rows;
  bool header = true;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    if (std::exchange(header, false)) continue;
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      double value = 0.0;
      const auto [rest, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
      if (error != std::errc{} || rest != cell.data() + cell.size()) {
        fail(fmt::format("{}:{}", file.string(), number), fmt::format("\"{}\" is not a number", cell));
      }
      row.push_back(value);
    }
    if (row.size() != columns) {
      fail(fmt::format("{}:{}", file.string(), number), fmt::format("{} columns instead of {}", row.size(), columns));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::filesystem::path reference_data_folder() { return source_folder() / "reference-data"; }

}  // namespace slfb
