#include "experiments/runs/series_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "solver/support/files.hpp"

namespace slfb {
namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const auto begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const auto comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

/// A cell as a message shows it: a file that is no table may have all of it in one.
std::string_view shown(std::string_view cell) { return cell.substr(0, 60); }

/// A heading "NAME [UNIT]", or "NAME".
struct Heading {
  std::string_view name, unit;
};

Heading heading_of(std::string_view cell) {
  const auto open = cell.find('[');
  if (open == std::string_view::npos || cell.back() != ']') return {cell, {}};
  return {trimmed(cell.substr(0, open)), trimmed(cell.substr(open + 1, cell.size() - open - 2))};
}

std::string name_with_unit(const SeriesColumn& column) {
  return column.dimension.unit == "1" ? std::string(column.name)
                                      : fmt::format("{} [{}]", column.name, column.dimension.unit);
}

/// What the headings say of each column: its name and what one of its units is in SI.
struct ReadColumn {
  std::vector<double>* values;
  std::string_view name;
  double factor;
};

class Reader {
 public:
  Reader(SeriesTable& table, std::span<const SeriesColumn> known) : table_(table), known_(known) {}

  void read_headings(std::string_view line, std::size_t number) {
    for (const std::string_view cell : cells_of(line)) {
      if (cell.find_first_of(";\t") != std::string_view::npos)
        throw problem(number, fmt::format("\"{}\" is divided by another sign than the comma; needed are commas between "
                                          "columns and points in numbers",
                                          shown(cell)));
      const Heading heading = heading_of(cell);
      const auto found = std::ranges::find(known_, heading.name, &SeriesColumn::name);
      if (found == known_.end()) {
        std::vector<std::string> allowed;
        for (const SeriesColumn& column : known_) allowed.push_back(name_with_unit(column));
        throw problem(number, fmt::format("unknown column \"{}\"; allowed are {}, each with a unit of its own kind",
                                          shown(heading.name), fmt::join(allowed, ", ")));
      }
      if (table_.has(found->name)) throw problem(number, fmt::format("column {}: stands there twice", found->name));
      columns_.push_back({&table_.columns[std::string(found->name)], found->name, factor_of(*found, heading, number)});
    }
  }

  void read_line(std::string_view line, std::size_t number) {
    const auto cells = cells_of(line);
    if (cells.size() != columns_.size())
      throw problem(number, fmt::format("{} cells for {} columns", cells.size(), columns_.size()));
    for (std::size_t k = 0; k < cells.size(); ++k) {
      double value = 0.0;
      const auto [rest, error] = std::from_chars(cells[k].data(), cells[k].data() + cells[k].size(), value);
      if (error != std::errc{} || rest != cells[k].data() + cells[k].size() || !std::isfinite(value))
        throw problem(number, fmt::format("column {}: \"{}\" is no finite number", columns_[k].name, shown(cells[k])));
      columns_[k].values->push_back(columns_[k].factor * value);
    }
    table_.lines.push_back(number);
  }

  [[nodiscard]] std::runtime_error problem(std::size_t line, const std::string& message) const {
    return std::runtime_error(fmt::format("{}:{}: {}", table_.file, line, message));
  }
  [[nodiscard]] bool has_headings() const { return !columns_.empty(); }

 private:
  [[nodiscard]] double factor_of(const SeriesColumn& column, const Heading& heading, std::size_t number) const {
    const bool ratio = column.dimension.unit == "1";
    if (ratio && (heading.unit.empty() || heading.unit == "-")) return 1.0;
    if (heading.unit.empty())
      throw problem(number, fmt::format("column {0}: has no unit; needed is {1}, for example {0} [{2}]", column.name,
                                        column.dimension.name, column.dimension.unit));
    const auto factor = units::unit_factor(heading.unit, column.dimension.unit);
    if (!factor)
      throw problem(number, fmt::format("column {0}: the unit \"{1}\" is unknown or measures something else; needed is "
                                        "{2}, for example {0} [{3}]",
                                        column.name, heading.unit, column.dimension.name, column.dimension.unit));
    return *factor;
  }

  SeriesTable& table_;
  std::span<const SeriesColumn> known_;
  std::vector<ReadColumn> columns_;
};

}  // namespace

SeriesTable read_series(const std::filesystem::path& file, std::span<const SeriesColumn> known,
                        std::span<const std::string_view> needed) {
  SeriesTable table;
  table.file = file.string();
  Reader reader(table, known);
  const std::string whole = read_file(file);
  if (whole.find('\0') != std::string::npos)
    throw std::runtime_error(fmt::format("{}: is no text: it holds a byte of value zero", table.file));
  std::istringstream text(whole);
  std::size_t number = 0;
  for (std::string line; std::getline(text, line);) {
    ++number;
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // of spreadsheets
    if (number == 1 && line.starts_with(byte_order_mark)) line.erase(0, byte_order_mark.size());
    const std::string_view content = trimmed(line);
    if (content.empty() || content.front() == '#') continue;
    if (reader.has_headings()) {
      reader.read_line(content, number);
    } else {
      reader.read_headings(content, number);
      for (const std::string_view column : needed)
        if (!table.has(column)) throw reader.problem(number, fmt::format("has no column {}", column));
    }
  }
  if (table.lines.empty()) throw reader.problem(std::max<std::size_t>(number, 1), "has no line of numbers");
  return table;
}

void require_rising(const SeriesTable& table, std::string_view rising) {
  const std::vector<double>& values = table.at(rising);
  for (std::size_t k = 1; k < values.size(); ++k)
    if (!(values[k] > values[k - 1]))
      throw std::runtime_error(fmt::format("{}:{}: column {}: does not rise", table.file, table.lines[k], rising));
}

}  // namespace slfb
