#include "experiments/reference/reference_numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
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

double Record::number(std::size_t column) const {
  const std::string& cell = cells_[column];
  double value = 0.0;
  const auto [rest, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc{} || rest != cell.data() + cell.size() || !std::isfinite(value))
    throw problem(fmt::format("\"{}\" is not a number", cell));
  return value;
}

double Record::positive(std::size_t column) const {
  const double value = number(column);
  if (!(value > 0.0)) throw problem(fmt::format("\"{}\" is not above zero", cells_[column]));
  return value;
}

std::runtime_error Record::problem(const std::string& message) const {
  return std::runtime_error(place_ + ": " + message);
}

std::vector<Record> read_records(const std::filesystem::path& file, const std::vector<std::string>& headings) {
  std::istringstream in(read_file(file));
  std::vector<Record> records;
  std::vector<std::string> cells;
  bool header = true;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    cells.clear();
    std::istringstream parts(line);
    for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
    if (line.back() == ',') cells.emplace_back();
    const std::string place = fmt::format("{}:{}", file.string(), number);
    if (std::exchange(header, false)) {
      if (cells != headings) fail(place, fmt::format("the headings have to be {}", fmt::join(headings, ",")));
      continue;
    }
    if (cells.size() != headings.size())
      fail(place, fmt::format("{} columns instead of {}", cells.size(), headings.size()));
    records.emplace_back(place, cells);
  }
  return records;
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
