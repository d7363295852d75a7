#include "reports/gnuplot.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "solver/support/run_program.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

/// `text` between single quotes, its markup kept.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char character : text) {
    if (character == '\'') result += '\'';
    result += character;
  }
  return result + "'";
}

/// `text` between single quotes as gnuplot reads it, and without its markup (_ ^ { } @ & ~ are shown as written).
std::string gnuplot_text(const std::string& text) {
  std::string result = "'";
  for (const char character : text) {
    if (character == '\'') result += '\'';
    if (std::string_view("_^{}@&~\\").find(character) != std::string_view::npos) result += '\\';
    result += character;
  }
  return result + "'";
}

/// A value as gnuplot reads it.
std::string number_text(double value) { return std::isnan(value) ? "NaN" : fmt::format("{:.9g}", value); }

/// The text of a gnuplot file with each line "load 'FILE'" replaced by that file, which is named from the folder of the
/// file that loads it: the script then stands alone.
std::string with_loaded_files(const fs::path& plot) {
  constexpr std::string_view load = "load '";
  std::istringstream lines(read_file(plot));
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(load))
      text += with_loaded_files(plot.parent_path() / line.substr(load.size(), line.rfind('\'') - load.size()));
    else
      text += line + "\n";
  }
  return text;
}

/// Of a script and the tables that it reads: what its pictures depend on.
std::string fingerprint(const std::string& script, const fs::path& folder) {
  static const std::regex table("'([^'/]+\\.csv)'");
  std::string text = script;
  for (std::sregex_iterator found(script.begin(), script.end(), table), end; found != end; ++found)
    if (const fs::path file = folder / (*found)[1].str(); fs::exists(file)) text += read_file(file);
  return fmt::format("{:016x}\n", XXH3_64bits(text.data(), text.size()));
}

/// Whether the pictures were drawn from this very script and these tables.
bool is_drawn(const std::string& id, const fs::path& folder, const std::string& drawn_from,
              const std::vector<std::string>& formats) {
  const fs::path note = folder / (id + ".drawn");
  return fs::exists(note) && read_file(note) == drawn_from && std::ranges::all_of(formats, [&](const auto& format) {
           std::error_code missing;
           return fs::file_size(folder / (id + "." + format), missing) > 0 && !missing;
         });
}

/// The script draws itself once per format: loaded without `format` it loads itself for each, then leaves.
constexpr const char* prologue = R"(# {id}: redraw it with `gnuplot {id}.gp` in the folder of its CSV files.
if (!exists("format")) {{ do for [format in "{formats}"] {{ load '{id}.gp' }}; exit }}
reset
if (format eq 'svg') {{ set terminal svg size {width},{height} dynamic enhanced font 'sans-serif,15' background '#ffffff' }}
if (format eq 'png') {{ set terminal pngcairo size {png_width},{png_height} enhanced font 'DejaVu Sans,15' fontscale 1.5 linewidth 2 pointscale 3 background '#ffffff' }}
if (format eq 'pdf') {{ set terminal pdfcairo size {pdf_width:.3f},{pdf_height:.3f} enhanced font 'DejaVu Sans,11' background '#ffffff' }}
set output '{id}.'.format
)";

}  // namespace

fs::path write_csv(const DataTable& table, const fs::path& folder) {
  std::ostringstream text;
  for (std::size_t column = 0; column < table.columns.size(); ++column)
    text << (column == 0 ? "" : ",") << table.columns[column];
  text << '\n';
  for (const auto& row : table.rows) {
    if (row.size() != table.columns.size())
      throw std::runtime_error(
          fmt::format("table {}: a row of {} values under {} headings", table.name, row.size(), table.columns.size()));
    for (std::size_t column = 0; column < row.size(); ++column)
      text << (column == 0 ? "" : ",") << (std::isnan(row[column]) ? "NaN" : fmt::format("{:.9g}", row[column]));
    text << '\n';
  }
  fs::path file = folder / (table.name + ".csv");
  write_file(file, text.str());
  return file;
}

void PlotValues::number(const std::string& name, double value) {
  commands_ += fmt::format("{} = {}\n", name, number_text(value));
}

void PlotValues::text(const std::string& name, const std::string& value) {
  commands_ += fmt::format("{} = {}\n", name, gnuplot_text(value));
}

void PlotValues::markup(const std::string& name, const std::string& value) {
  commands_ += fmt::format("{} = {}\n", name, quoted(value));
}

void PlotValues::numbers(const std::string& name, const std::vector<double>& values) {
  std::vector<std::string> items;
  for (const double value : values) items.push_back(number_text(value));
  list(name, items, "0");
}

void PlotValues::texts(const std::string& name, const std::vector<std::string>& values) {
  std::vector<std::string> items;
  for (const std::string& value : values) items.push_back(gnuplot_text(value));
  list(name, items, "''");
}

void PlotValues::markups(const std::string& name, const std::vector<std::string>& values) {
  std::vector<std::string> items;
  for (const std::string& value : values) items.push_back(quoted(value));
  list(name, items, "''");
}

void PlotValues::files(const std::string& name, const std::vector<std::string>& tables) {
  std::vector<std::string> items;
  for (const std::string& table : tables) items.push_back(quoted(table.empty() ? "" : table + ".csv"));
  list(name, items, "'$empty_list'");
}

void PlotValues::list(const std::string& name, const std::vector<std::string>& items, const std::string& when_empty) {
  // gnuplot has no empty arrays, and reads the first item even where a loop has nothing to do.
  commands_ += fmt::format("{0}_count = {1}\narray {0}[{2}] = [{3}]\n", name, items.size(),
                           std::max<std::size_t>(1, items.size()),
                           items.empty() ? when_empty : fmt::format("{}", fmt::join(items, ", ")));
}

void draw_plot(const std::string& id, const fs::path& plot, const PlotValues& values, const Canvas& canvas,
               const fs::path& folder, const fs::path& frame, const std::vector<std::string>& formats) {
  const std::string head =
      fmt::format(prologue, fmt::arg("id", id), fmt::arg("formats", fmt::join(formats, " ")),
                  fmt::arg("width", canvas.width), fmt::arg("height", canvas.height),
                  fmt::arg("png_width", 2 * canvas.width), fmt::arg("png_height", 2 * canvas.height),
                  fmt::arg("pdf_width", canvas.width / 96.0), fmt::arg("pdf_height", canvas.height / 96.0));
  const std::string style = read_file(source_folder() / "reports" / "style.gp");
  const std::string script = id + ".gp";
  const std::string size = fmt::format("width = {}.0\nheight = {}.0\n", canvas.width, canvas.height);
  const std::string text = head + "\n" + style + "\n" + size + values.commands() + "\n" +
                           (frame.empty() ? "" : with_loaded_files(frame)) + with_loaded_files(plot) + "unset output\n";
  write_file(folder / script, text);
  const std::string drawn_from = fingerprint(text, folder);
  if (is_drawn(id, folder, drawn_from, formats)) return;
  fs::remove(folder / (id + ".drawn"));
  std::vector<std::future<ProgramOutcome>> drawings;
  for (const std::string& format : formats) {
    fs::remove(folder / (id + "." + format));
    drawings.push_back(std::async(std::launch::async, [&folder, &script, format] {
      return run_program({"gnuplot", "-e", fmt::format("format = '{}'", format), script}, folder,
                         "apt-get install gnuplot-nox");
    }));
  }
  std::vector<ProgramOutcome> outcomes;
  for (auto& drawing : drawings) drawing.wait();
  for (auto& drawing : drawings) outcomes.push_back(drawing.get());
  for (std::size_t i = 0; i < formats.size(); ++i) {
    const auto& [message, status] = outcomes[i];
    if (status != 0)
      throw std::runtime_error(
          fmt::format("gnuplot failed on {} (exit status {}):\n{}", (folder / script).string(), status, message));
    const fs::path picture = folder / (id + "." + formats[i]);
    std::error_code missing;
    if (fs::file_size(picture, missing) == 0 || missing)
      throw std::runtime_error(fmt::format("gnuplot left no {}:\n{}", picture.string(), message));
  }
  write_file(folder / (id + ".drawn"), drawn_from);
}

}  // namespace slfb
