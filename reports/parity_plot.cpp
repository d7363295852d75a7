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

/// Where a verdict stands in the tables of the plot.
constexpr std::array plotted_verdicts{Verdict::reproduced, Verdict::not_reproduced, Verdict::not_decidable};

}  // namespace

bool draw_parity(const std::vector<ClaimRow>& claims, const std::filesystem::path& folder) {
  std::array<DataTable, plotted_verdicts.size()> tables;
  for (std::size_t v = 0; v < plotted_verdicts.size(); ++v)
    tables[v] = {"parity_" + verdict_class(plotted_verdicts[v]),
                 {"row of the place [-]", "ours over the paper's [-]", "lower end of its 95 % interval [-]",
                  "upper end of its 95 % interval [-]", "outside the plot: -1 left, 1 right [-]"},
                 {}};
  std::vector<std::string> places;
  for (const auto& [place, group] : claims_by_place(claims)) {
    double row = 0.0, step = 0.0;
    std::vector<const ClaimRow*> measured;
    for (const ClaimRow* claim : group)
      if (claim->paper_number && claim->ours && *claim->paper_number != 0.0 &&
          *claim->ours / *claim->paper_number > 0.0)
        measured.push_back(claim);
    if (measured.empty()) continue;
    places.push_back(place_name(place));
    // The claims of a place share its row, side by side.
    row = static_cast<double>(places.size()) - 0.3;
    step = measured.size() > 1 ? 0.6 / static_cast<double>(measured.size() - 1) : 0.0;
    if (measured.size() == 1) row += 0.3;
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
      tables[v].rows.push_back({row, inside(ratio), inside(lower), inside(upper),
                                ratio > furthest         ? 1.0
                                : ratio < 1.0 / furthest ? -1.0
                                                         : 0.0});
      row += step;
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
  values.number("furthest", furthest);
  draw_plot("parity", source_folder() / "reports" / "parity.gp", values,
            {640, 110 + 26 * static_cast<int>(places.size())}, folder);
  return true;
}

}  // namespace slfb::reports
