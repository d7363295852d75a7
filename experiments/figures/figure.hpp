#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "experiments/quantities/measurement.hpp"
#include "experiments/runs/campaign.hpp"

namespace slfb {

/// Everything a figure may use.
struct FigureContext {
  const Profile& profile;
  const std::vector<FinishedRun>& runs;
  const Measurements& measurements;
  std::filesystem::path out;      ///< folder of the figure's files
  std::filesystem::path results;  ///< folder of runs/, for figures that draw runs of another profile
};

/// A table of texts, as a picture and on a page. Texts are shown as written; each row has one per column.
struct TextTable {
  /// Two lines for each column: {"V_2 [m/s]", "paper"}. The first may be empty.
  std::vector<std::pair<std::string, std::string>> headings;
  std::vector<std::vector<std::string>> rows;
};

/// What a figure left behind: ID.svg, ID.png, ID.pdf, one or more CSV, ID.gp (the gnuplot script that redraws it).
struct FigureOutput {
  std::string id;
  std::vector<std::filesystem::path> data;
  std::string caption;  ///< what is shown, and what is not known
  /// Profile differences, missing runs. Of a sentence "HERE, not THERE." the page makes a row of two columns, ours and
  /// the source's.
  std::vector<std::string> notes;
  TextTable table = {};       ///< shown on the page instead of the picture; empty: the picture is
  std::string findings = {};  ///< Markdown: what the numbers say, where that is computed with them
};

/// One figure: a folder in experiments/ with figure.cpp, figure.gp and README.md (FigureFolder).
struct Figure {
  std::string id;  ///< "fig05"
  std::string title;
  std::function<std::vector<std::string>(const Profile&)> needs;  ///< "system/U_L[/variant]" of the runs it draws
  std::function<FigureOutput(const FigureContext&)> draw;
  std::string folder = "";  ///< in experiments/
};

/// For Figure::needs of a figure that draws no run.
inline std::vector<std::string> no_runs(const Profile&) { return {}; }

}  // namespace slfb
