#include "experiments/runs/sphere_frames.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "experiments/runs/series_file.hpp"

namespace slfb {
namespace {

constexpr std::string_view first_item = "ITEM: TIMESTEP";

/// Where a number of a line goes, and by what it is multiplied.
struct DumpColumn {
  std::string_view name;
  std::vector<double> SphereFrame::*scalar = nullptr;
  dem::VectorField SphereFrame::*vector = nullptr;
  std::vector<double> dem::VectorField::*component = nullptr;
  std::vector<std::int64_t> SphereFrame::*whole = nullptr;
  double DumpUnits::*unit = nullptr;
  double factor = 1.0;

  [[nodiscard]] std::vector<double>& numbers(SphereFrame& frame) const {
    return vector == nullptr ? frame.*scalar : (frame.*vector).*component;
  }
};

using Field = dem::VectorField;
constexpr std::array<DumpColumn, 13> dump_columns{{
    {.name = "id", .whole = &SphereFrame::id},
    {.name = "type", .whole = &SphereFrame::type},
    {.name = "x", .vector = &SphereFrame::position, .component = &Field::x, .unit = &DumpUnits::length},
    {.name = "y", .vector = &SphereFrame::position, .component = &Field::y, .unit = &DumpUnits::length},
    {.name = "z", .vector = &SphereFrame::position, .component = &Field::z, .unit = &DumpUnits::length},
    {.name = "xu", .vector = &SphereFrame::position, .component = &Field::x, .unit = &DumpUnits::length},
    {.name = "yu", .vector = &SphereFrame::position, .component = &Field::y, .unit = &DumpUnits::length},
    {.name = "zu", .vector = &SphereFrame::position, .component = &Field::z, .unit = &DumpUnits::length},
    {.name = "radius", .scalar = &SphereFrame::radius, .unit = &DumpUnits::length},
    {.name = "diameter", .scalar = &SphereFrame::radius, .unit = &DumpUnits::length, .factor = 0.5},
    {.name = "vx", .vector = &SphereFrame::velocity, .component = &Field::x, .unit = &DumpUnits::velocity},
    {.name = "vy", .vector = &SphereFrame::velocity, .component = &Field::y, .unit = &DumpUnits::velocity},
    {.name = "vz", .vector = &SphereFrame::velocity, .component = &Field::z, .unit = &DumpUnits::velocity},
}};

void clear(SphereFrame& frame) {
  frame.id.clear();
  frame.type.clear();
  frame.radius.clear();
  frame.position.resize(0);
  frame.velocity.resize(0);
}

/// All three components or none.
bool whole_vector(const Field& field) { return field.x.size() == field.y.size() && field.y.size() == field.z.size(); }

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || rest != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Words between blanks.
std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
  return words;
}

class DumpReader {
 public:
  DumpReader(const std::filesystem::path& file, const DumpUnits& units)
      : file_(file.string()), stream_(file), units_(units) {}

  /// False at the end of the file.
  bool next(SphereFrame& frame) {
    clear(frame);
    std::optional<std::int64_t> step;
    std::optional<std::size_t> count;
    while (next_line()) {
      if (line_.starts_with(first_item)) {
        step = whole_number("the time step");
      } else if (line_.starts_with("ITEM: NUMBER OF ATOMS")) {
        const std::int64_t number = whole_number("the number of atoms");
        if (number < 0) throw problem("the number of atoms is below zero");
        count = static_cast<std::size_t>(number);
      } else if (line_.starts_with("ITEM: ATOMS")) {
        if (!step || !count) throw problem("ITEM: ATOMS stands before ITEM: TIMESTEP and ITEM: NUMBER OF ATOMS");
        frame.time = static_cast<double>(*step) * units_.time_step;
        read_spheres(frame, *count);
        return true;
      }
      // Bounds of the box, units and times are not needed.
    }
    if (step) throw problem("the file ends before ITEM: ATOMS");
    return false;
  }

  [[nodiscard]] std::runtime_error problem(const std::string& message) const {
    return std::runtime_error(fmt::format("{}:{}: {}", file_, number_, message));
  }

 private:
  bool next_line() {
    if (!std::getline(stream_, line_)) return false;
    ++number_;
    return true;
  }

  std::int64_t whole_number(std::string_view what) {
    const auto words = next_line() ? words_of(line_) : std::vector<std::string_view>{};
    const auto value = words.size() == 1 ? number_in<std::int64_t>(words[0]) : std::nullopt;
    if (!value) throw problem(fmt::format("{} has to be a whole number", what));
    return *value;
  }

  void read_spheres(SphereFrame& frame, std::size_t count) {
    std::vector<std::string> headings;
    for (const std::string_view word : words_of(std::string_view(line_).substr(11))) headings.emplace_back(word);
    std::vector<const DumpColumn*> columns;
    for (const std::string& heading : headings) {
      const auto found = std::ranges::find(dump_columns, heading, &DumpColumn::name);
      columns.push_back(found == dump_columns.end() ? nullptr : &*found);
    }
    const auto reads = [&](std::vector<double> Field::*component) {
      return std::ranges::any_of(columns, [&](const DumpColumn* column) {
        return column != nullptr && column->vector == &SphereFrame::position && column->component == component;
      });
    };
    if (!reads(&Field::x) || !reads(&Field::y) || !reads(&Field::z))
      throw problem(
          fmt::format("ITEM: ATOMS has the columns {}; needed are x y z or xu yu zu (scaled xs ys zs are not "
                      "read), and read are also id, type, radius or diameter, vx vy vz",
                      fmt::join(headings, " ")));
    for (std::size_t n = 0; n < count; ++n) {
      if (!next_line()) throw problem(fmt::format("the file ends after {} of {} atoms", n, count));
      const auto words = words_of(line_);
      if (words.size() != columns.size())
        throw problem(fmt::format("{} numbers for {} columns", words.size(), columns.size()));
      for (std::size_t k = 0; k < columns.size(); ++k)
        if (columns[k] != nullptr) read_cell(frame, *columns[k], words[k]);
    }
  }

  void read_cell(SphereFrame& frame, const DumpColumn& column, std::string_view word) const {
    if (column.whole != nullptr) {
      const auto value = number_in<std::int64_t>(word);
      if (!value) throw problem(fmt::format("column {}: \"{}\" is no whole number", column.name, word));
      (frame.*column.whole).push_back(*value);
      return;
    }
    const auto value = number_in<double>(word);
    if (!value || !std::isfinite(*value))
      throw problem(fmt::format("column {}: \"{}\" is no finite number", column.name, word));
    column.numbers(frame).push_back(column.factor * units_.*column.unit * *value);
  }

  std::string file_;
  std::ifstream stream_;
  const DumpUnits& units_;
  std::string line_;
  std::size_t number_ = 0;
};

void read_dump(const std::filesystem::path& file, const DumpUnits& units,
               const std::function<void(const SphereFrame&)>& visit) {
  DumpReader reader(file, units);
  SphereFrame frame;
  double last = -std::numeric_limits<double>::infinity();
  while (reader.next(frame)) {
    if (!whole_vector(frame.position) || !whole_vector(frame.velocity) ||
        (!frame.radius.empty() && frame.radius.size() != frame.size()))
      throw reader.problem("ITEM: ATOMS names a column twice, or not all of vx vy vz");
    if (frame.time <= last) throw reader.problem("ITEM: TIMESTEP does not rise");
    last = frame.time;
    visit(frame);
  }
}

void read_positions(const std::filesystem::path& file, const std::function<void(const SphereFrame&)>& visit) {
  const std::array<SeriesColumn, 10> known{{{"time", units::time},
                                            {"id", units::ratio},
                                            {"type", units::ratio},
                                            {"x", units::length},
                                            {"y", units::length},
                                            {"z", units::length},
                                            {"diameter", units::length},
                                            {"vx", units::velocity},
                                            {"vy", units::velocity},
                                            {"vz", units::velocity}}};
  const std::array<std::string_view, 4> needed{"time", "x", "y", "z"};
  const SeriesTable table = read_series(file, known, needed);
  const auto problem = [&](std::size_t row, std::string_view message) {
    return std::runtime_error(fmt::format("{}:{}: {}", table.file, table.lines[row], message));
  };
  const bool moving = table.has("vx") && table.has("vy") && table.has("vz");
  if (!moving && (table.has("vx") || table.has("vy") || table.has("vz")))
    throw problem(0, "not all of the columns vx, vy, vz are there");
  const std::vector<double>& time = table.at("time");
  SphereFrame frame;
  for (std::size_t row = 0; row < time.size(); ++row) {
    if (row > 0 && time[row] < time[row - 1]) throw problem(row, "column time: goes back");
    if (row > 0 && time[row] > time[row - 1]) {
      visit(frame);
      clear(frame);
    }
    frame.time = time[row];
    for (const DumpColumn& column : dump_columns) {
      if (!table.has(column.name) || (column.vector == &SphereFrame::velocity && !moving)) continue;
      const double value = table.at(column.name)[row];
      if (column.whole == nullptr) {
        column.numbers(frame).push_back(column.factor * value);
      } else if (std::abs(value) > 1e15 || value != std::floor(value)) {
        throw problem(row, fmt::format("column {}: {} is no whole number", column.name, value));
      } else {
        (frame.*column.whole).push_back(static_cast<std::int64_t>(value));
      }
    }
  }
  visit(frame);
}

}  // namespace

void for_each_frame(const std::filesystem::path& file, const DumpUnits& units,
                    const std::function<void(const SphereFrame&)>& visit) {
  std::ifstream stream(file);
  if (!std::filesystem::is_regular_file(file) || !stream)
    throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  std::string line;
  std::getline(stream, line);
  if (line.starts_with(first_item)) {
    read_dump(file, units, visit);
  } else {
    read_positions(file, visit);
  }
}

}  // namespace slfb
