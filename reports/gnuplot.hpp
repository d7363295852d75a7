#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// A thin layer over gnuplot: a figure is CSV files, a script that stands on its own, and the pictures it draws.
namespace slfb {

/// Numbers that a figure draws, written as NAME.csv: one heading per column, its unit in square brackets.
struct DataTable {
  std::string name;
  std::vector<std::string> columns;  ///< for instance "superficial velocity [m/s]"
  std::vector<std::vector<double>> rows;
};

/// Writes `table` into `folder` and returns the file. Throws std::runtime_error when a row and the headings differ in
/// length or the file cannot be written. A value that is not a number is written as NaN, which gnuplot leaves out.
std::filesystem::path write_csv(const DataTable& table, const std::filesystem::path& folder);

/// Size of a figure in pixels of the SVG; the PNG has twice as many each way, the PDF the same proportions.
struct Canvas {
  int width = 520;
  int height = 400;
};

/// What a plot reads besides its tables: gnuplot variables, set above it in ID.gp.
///
/// A list becomes an array NAME[1…] and its length NAME_count, 0 for an empty list, so that a plot can say
/// `plot for [i=1:series_count] series[i] skip 1 using 1:2 with points title series_title[i]`.
class PlotValues {
 public:
  void number(const std::string& name, double value);
  /// Shown as written: gnuplot's markup is escaped.
  void text(const std::string& name, const std::string& value);
  /// With gnuplot's markup: "U_{mf}".
  void markup(const std::string& name, const std::string& value);
  void numbers(const std::string& name, const std::vector<double>& values);
  void texts(const std::string& name, const std::vector<std::string>& values);
  void markups(const std::string& name, const std::vector<std::string>& values);
  /// The files of these tables, for instance 'fig05_simulated.csv'; '' for a table without a name.
  void files(const std::string& name, const std::vector<std::string>& tables);

  /// The gnuplot commands that set them.
  [[nodiscard]] const std::string& commands() const { return commands_; }

 private:
  void list(const std::string& name, const std::vector<std::string>& items, const std::string& when_empty);
  std::string commands_;
};

/// Draws `plot`, a gnuplot file of the source tree (figure.gp of a figure's folder), with these values.
///
/// Writes ID.gp into `folder`: terminal, shared style (reports/style.gp), `width` and `height` of the picture [pixel],
/// the values, then the text of `plot`. A line "load 'FILE'" of it becomes that file, named from the folder of `plot`:
/// what several plots share. Runs ID.gp in `folder`, which leaves ID.svg, ID.png and ID.pdf, or those of `formats`.
/// ID.gp names its data without a folder, so that `gnuplot ID.gp` beside the CSV files redraws the figure anywhere.
/// The formats are drawn at the same time. ID.drawn notes what the pictures were drawn from: where script and tables
/// are still the same, nothing is drawn. Throws std::runtime_error with gnuplot's own message when gnuplot is missing,
/// fails, or leaves a picture out. `frame`: a gnuplot file that comes between the values and the plot, for what frames
/// of figures have in common.
void draw_plot(const std::string& id, const std::filesystem::path& plot, const PlotValues& values, const Canvas& canvas,
               const std::filesystem::path& folder, const std::filesystem::path& frame = {},
               const std::vector<std::string>& formats = {"svg", "png", "pdf"});

}  // namespace slfb
