#include "experiments/reference/reference_data.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <charconv>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "solver/support/folders.hpp"

namespace slfb {
namespace {

[[noreturn]] void fail(const std::string& place, const std::string& problem) {
  throw std::runtime_error(place + ": " + problem);
}

std::string place_of(const std::filesystem::path& file, const toml::node& node) {
  return fmt::format("{}:{}", file.string(), node.source().begin.line);
}

template <class T>
T required(const toml::table& table, std::string_view key, const std::filesystem::path& file) {
  const toml::node* node = table.get(key);
  if (node == nullptr) fail(place_of(file, table), fmt::format("\"{}\" is missing", key));
  const auto value = node->value<T>();
  if (!value) fail(place_of(file, *node), fmt::format("\"{}\" has the wrong type", key));
  return *value;
}

/// Rows of numbers with `columns` columns; lines that start with # are comments and the first other line names the
/// columns.
std::vector<std::vector<double>> read_columns(const std::filesystem::path& file, std::size_t columns) {
  std::ifstream in(file);
  if (!in) fail(file.string(), "cannot be read");
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

}  // namespace

Peng2014::Peng2014(const std::filesystem::path& folder) {
  for (const std::string_view name : {"table1.toml", "fitted_lines.toml", "statements.toml"}) {
    const auto file = folder / name;
    const toml::table document = toml::parse_file(file.string());
    const toml::array* entries = document["value"].as_array();
    if (entries == nullptr) fail(file.string(), "no [[value]] in it");
    for (const toml::node& entry : *entries) {
      const toml::table& table = *entry.as_table();
      static const std::set<std::string_view> known{"id", "quantity", "value", "unit", "uncertainty", "source"};
      for (const auto& [key, node] : table) {
        if (!known.contains(key.str())) fail(place_of(file, node), fmt::format("unknown key \"{}\"", key.str()));
      }
      add({required<std::string>(table, "id", file), required<std::string>(table, "quantity", file),
           required<double>(table, "value", file), required<std::string>(table, "unit", file),
           required<double>(table, "uncertainty", file), required<std::string>(table, "source", file)},
          place_of(file, entry));
    }
  }

  const auto table2_file = folder / "table2.csv";
  const std::string table2_source = "Table 2, p. 54";
  for (const auto& row : read_columns(table2_file, 4)) {
    table2_.push_back({row[0], row[1], row[2], row[3]});
    const std::string at = fmt::format("{:.2f}", row[0]);
    add({"table2/classification_velocity/" + at, "classification velocity at " + at + " m/s", row[1], "m/s", 0.0005,
         table2_source},
        table2_file.string());
    add({"table2/intercept/" + at, "intercept of the fitted line at " + at + " m/s", row[2], "m", 0.0005,
         table2_source},
        table2_file.string());
    add({"table2/r_squared/" + at, "R² of the fitted line at " + at + " m/s", row[3], "-", 0.00005, table2_source},
        table2_file.string());
  }

  const auto figure13_file = folder / "figure13.csv";
  for (const auto& row : read_columns(figure13_file, 2)) {
    figure13_.push_back({row[0], row[1]});
    const std::string at = fmt::format("{:.2f}", row[0]);
    add({"figure13/voidage/" + at, "mean bed voidage at " + at + " m/s", row[1], "-", 0.005,
         "captions of Figs. 13 and 14, p. 56"},
        figure13_file.string());
  }

  // Printed lines evaluated where the paper shows points of its own, and printed numbers taken together.
  for (const double velocity : {0.03, 0.04}) {
    const std::string where = fmt::format("{:.2f}", velocity);
    add({"figure5/packed_line/" + where, "pressure drop on the line through the packed bed at " + where + " m/s",
         value("packed_line_slope") * velocity + value("packed_line_intercept"), "Pa",
         at("packed_line_slope").uncertainty * velocity, "Fig. 5, line evaluated"},
        (folder / "fitted_lines.toml").string());
  }
  add({"computing_cost", "computing time per simulated time", value("computing_time") * 3600.0 / value("computed_time"),
       "s/s", 3600.0 * 0.5 / value("computed_time"), "§3.2, p. 20: 66 h for 23 s"},
      (folder / "statements.toml").string());
}

void Peng2014::add(ReferenceValue value, const std::string& origin) {
  std::string id = value.id;
  if (!values_.emplace(id, std::move(value)).second) fail(origin, fmt::format("\"{}\" occurs twice", id));
}

const ReferenceValue& Peng2014::at(std::string_view id) const {
  const auto found = values_.find(id);
  if (found == values_.end()) throw std::out_of_range(fmt::format("peng-2014 has no value \"{}\"", id));
  return found->second;
}

std::vector<WetBounce> gondret_2002() {
  std::vector<WetBounce> bounces;
  for (const auto& row : read_columns(reference_data_folder() / "gondret_2002" / "bounces.csv", 2))
    bounces.push_back({row[0], row[1]});
  return bounces;
}

StokesLimits joseph_2001() {
  const auto row = read_columns(reference_data_folder() / "joseph_2001" / "stokes_limits.csv", 2).at(0);
  return {row[0], row[1]};
}

std::filesystem::path reference_data_folder() { return source_folder() / "reference-data"; }

const Peng2014& peng_2014() {
  static const Peng2014 data(reference_data_folder() / "peng_2014");
  return data;
}

}  // namespace slfb
