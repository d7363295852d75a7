#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scene/units.hpp"

namespace slfb {

/// A column that a file of series may have.
struct SeriesColumn {
  std::string_view name;
  units::Dimension dimension;
};

/// Columns of a CSV file in SI units, all of one length, with the place of each line for errors.
struct SeriesTable {
  std::string file;
  std::map<std::string, std::vector<double>, std::less<>> columns;
  std::vector<std::size_t> lines;  ///< of the file, of each row

  [[nodiscard]] bool has(std::string_view column) const { return columns.contains(column); }
  [[nodiscard]] const std::vector<double>& at(std::string_view column) const { return columns.find(column)->second; }
};

/// Reads a CSV file whose first line names each column with its unit, "time [ms],z [cm]", in any unit that scenes take;
/// a column without dimension has none. Empty lines and those that begin with # are left out.
/// \param known the columns that are allowed \param needed those that have to be there
/// \throws std::runtime_error with file, line and column: a column that is not known or missing, one that stands there
/// twice, a unit that does not fit, a cell that is no finite number, fewer or more cells than columns, no line at all.
SeriesTable read_series(const std::filesystem::path& file, std::span<const SeriesColumn> known,
                        std::span<const std::string_view> needed);

/// \throws std::runtime_error with file and line where the column `rising` does not rise from line to line.
void require_rising(const SeriesTable& table, std::string_view rising);

}  // namespace slfb
