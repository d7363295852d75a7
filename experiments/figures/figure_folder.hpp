#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace slfb {

/// The source folder of a figure: figure.cpp makes its tables and values, figure.gp plots them, README.md gives title,
/// caption and definitions.
///
/// README.md begins with the title as a first-level heading; the caption is the text under "## Caption". A word in
/// braces there, "{weight}", stands for a text that figure.cpp puts in.
class FigureFolder {
 public:
  /// `folder` is relative to experiments/, for example "peng_2014/fig05_pressure_drop".
  explicit FigureFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Throws std::runtime_error naming the file when README.md cannot be read or has no title.
  [[nodiscard]] std::string title() const;
  /// The caption in one line. Throws std::runtime_error when README.md has none, when a word in braces is not among
  /// `words`, or when one of `words` is not used.
  [[nodiscard]] std::string caption(const std::map<std::string, std::string>& words = {}) const;
  /// The gnuplot file.
  [[nodiscard]] std::filesystem::path plot(const std::string& name = "figure.gp") const;
  /// Relative to experiments/.
  [[nodiscard]] const std::filesystem::path& path() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// What a figure's README.md has under "## Definitions", and after it but for the caption, as Markdown: how the figure
/// is measured. Empty without that heading: the text is then for those who work on the suite.
std::string figure_definitions(const std::string& readme);

}  // namespace slfb
