#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/compare/candidates.hpp"
#include "experiments/compare/comparison_page.hpp"
#include "reports/gnuplot.hpp"

/// Pictures of what the runs of the candidates have measured in the bed. Each is a table, values, and a gnuplot file of
/// experiments/compare/plots/.
namespace slfb::compare {

/// Classification velocity, collision force and collision frequency of the foreign sphere beside the work and the
/// correlations, drawn into `folder`. None without a run. \throws std::runtime_error where a file cannot be written or
/// gnuplot fails
std::vector<Picture> draw_bed_pictures(const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                                       const std::filesystem::path& folder);

/// Writes a table for each candidate with runs into `folder`, ID_simulated_1.csv and so on, and gives a plot their
/// lists: simulated[i] (the name of the table), simulated_title[i], simulated_style[i] and simulated_count. Columns:
/// superficial velocity, x, half width of its 95 % interval, y, half width of its interval. `x` and `y` are quantities
/// of the measurements; `x` empty: the superficial velocity itself, those of one velocity side by side.
void add_simulated(const std::string& id, const std::vector<Candidate>& candidates, const ComparisonBed& bed,
                   const std::string& x, const std::string& y, const std::string& y_unit, PlotValues& values,
                   const std::filesystem::path& folder);

/// The gnuplot file of a picture, in experiments/compare/plots/.
std::filesystem::path plot_file(const std::string& name);

}  // namespace slfb::compare
