#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Numbers of the literature, read from reference-data/ (its README describes the format).
namespace slfb {

/// One printed number.
struct ReferenceValue {
  std::string id;
  std::string quantity;
  double value = 0.0;
  std::string unit;
  double uncertainty = 0.0;  ///< half the last printed digit unless the source states more, in `unit`
  std::string source;        ///< table, figure, section and page
};

/// A printed table: a CSV file whose first column is the number by which its rows are named. A cell is the value
/// "ID/0.06", 0.06 being that number with two decimals.
struct ReferenceTable {
  struct Column {
    std::string id;        ///< "table2/classification_velocity"
    std::string quantity;  ///< in words; "{}" stands for the number of the row
    std::string unit;
    double uncertainty = 0.0;
  };
  std::string file;  ///< in the folder of the work: "table2.csv"
  std::string source;
  std::vector<Column> columns;  ///< those behind the first one, in their order
};

/// The numbers that a work prints, by id.
class ReferenceNumbers {
 public:
  /// `work` is named where an id is unknown.
  explicit ReferenceNumbers(std::string work) : work_(std::move(work)) {}

  /// Each throws std::runtime_error naming file and line on anything unexpected, an id that occurs twice included.
  void read_values(const std::filesystem::path& file);  ///< the [[value]] of a TOML file
  /// Returns the rows of the table.
  std::vector<std::vector<double>> read_table(const std::filesystem::path& folder, const ReferenceTable& table);
  /// \param origin named in the error
  void add(ReferenceValue value, const std::string& origin);

  /// Throws std::out_of_range with the id when there is none.
  [[nodiscard]] const ReferenceValue& at(std::string_view id) const;
  [[nodiscard]] double value(std::string_view id) const { return at(id).value; }
  [[nodiscard]] const std::map<std::string, ReferenceValue, std::less<>>& values() const { return values_; }

 private:
  std::string work_;
  std::map<std::string, ReferenceValue, std::less<>> values_;
};

/// Rows of numbers with `columns` columns; lines that start with # are comments and the first other line names the
/// columns. Throws std::runtime_error naming file and line.
std::vector<std::vector<double>> read_columns(const std::filesystem::path& file, std::size_t columns);

/// One line of a table of numbers and words.
class Record {
 public:
  Record(std::string place, std::vector<std::string> cells) : place_(std::move(place)), cells_(std::move(cells)) {}
  [[nodiscard]] const std::string& text(std::size_t column) const { return cells_[column]; }
  /// Each throws std::runtime_error with file and line where the cell is none.
  [[nodiscard]] double number(std::size_t column) const;
  [[nodiscard]] double positive(std::size_t column) const;
  /// An error that names file and line.
  [[nodiscard]] std::runtime_error problem(const std::string& message) const;

 private:
  std::string place_;  ///< "FILE:LINE"
  std::vector<std::string> cells_;
};

/// The lines of a CSV file whose first line, comments aside, has these headings; the last cell of a line may be empty.
/// A cell holds no comma. Throws std::runtime_error naming file and line.
std::vector<Record> read_records(const std::filesystem::path& file, const std::vector<std::string>& headings);

/// The folder reference-data/ of the source tree.
std::filesystem::path reference_data_folder();

}  // namespace slfb
