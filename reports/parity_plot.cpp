#include "reports/parity_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "reports/claim_table.hpp"
#include "reports/gnuplot.hpp"
#include "solver/support/folders.hpp"

namespace slfb::reports {
namespace {

constexpr double furthest = 10.0;  ///< ratio at the edge of the plot
// Heights in the plot [px]: of a claim, of the name of a place, and of the space between places.
constexpr double claim_height = 6.0, name_height = 16.0, space = 8.0;

/// Where a verdict stands in the tables of the plot.
constexpr std::array plotted_verdicts{Verdict::reproduced, Verdict::not_reproduced, Verdict::not_decidable};

}  // namespace

bool draw_parity(const std::vector<ClaimRow>& claims, const std::filesystem::path& folder) {
  std::array<DataTable, plotted_verdicts.size()> tables;
  for (std::size_t v = 0; v < plotted_verdicts.size(); ++v)
    tables[v] = {"parity_" + verdict_class(plotted_verdicts[v]),
                 {"from the top [px]", "ours over the paper's [-]", "lower end of its 95 % interval [-]",
                  "upper end of its 95 % interval [-]", "outside the plot: -1 left, 1 right [-]"},
                 {}};
  std::vector<std::string> places;
  std::vector<double> middles, ends;
  double top = 0.0;
  for (const auto& [place, group] : claims_by_place(claims)) {
    std::vector<const ClaimRow*> measured;
    for (const ClaimRow* claim : group)
      if (claim->paper_number && claim->ours && *claim->paper_number != 0.0 &&
          *claim->ours / *claim->paper_number > 0.0)
        measured.push_back(claim);
    if (measured.empty()) continue;
    places.push_back(place_name(place));
    // Each claim has a line of its own.
    const double lines = claim_height * static_cast<double>(measured.size());
    const double height = std::max(name_height, lines) + space;
    double line = top + 0.5 * (height - lines + claim_height);
    middles.push_back(top + 0.5 * height);
    top += height;
    ends.push_back(top);
    for (const ClaimRow* claim : measured) {
      const double ratio = *claim->ours / *claim->paper_number;
      double lower = ratio, upper = ratio;
      if (claim->interval) {
        lower = claim->interval->first / *claim->paper_number;
        upper = claim->interval->second / *claim->paper_number;
        if (lower > upper) std::swap(lower, upper);
      }
      const auto inside = [](double value) { return std::clamp(value, 1.0 / furthest, furthest); };
      const auto v =
          static_cast<std::size_t>(std::ranges::find(plotted_verdicts, claim->verdict) - plotted_verdicts.begin());
      tables[v].rows.push_back({line, inside(ratio), inside(lower), inside(upper),
                                ratio > furthest         ? 1.0
                                : ratio < 1.0 / furthest ? -1.0
                                                         : 0.0});
      line += claim_height;
    }
  }
  if (places.empty()) return false;
  PlotValues values;
  std::vector<std::string> names, titles;
  for (std::size_t v = 0; v < plotted_verdicts.size(); ++v) {
    if (tables[v].rows.empty()) continue;
    write_csv(tables[v], folder);
    names.push_back(tables[v].name);
    titles.push_back(verdict_words(plotted_verdicts[v]));
  }
  values.files("verdict", names);
  values.texts("verdict_title", titles);
  values.texts("place", places);
  values.numbers("middle", middles);
  values.numbers("end", ends);
  values.number("furthest", furthest);
  draw_plot("parity", source_folder() / "reports" / "parity.gp", values, {640, 120 + static_cast<int>(top)}, folder);
  return true;
}

}  // namespace slfb::reports
