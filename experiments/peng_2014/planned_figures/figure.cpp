#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "experiments/figures/drawn_table.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/planned_figures/figure_plans.hpp"

namespace slfb::planned_figures {
namespace {

const std::vector<std::pair<std::string, std::string>> headings{{"", "figure"},
                                                                {"", "cheapest rung"},
                                                                {"springs, step of", "solids/liquid"},
                                                                {"error", "of band"},
                                                                {"planned", "[s/s]"},
                                                                {"the paper", "[s/s]"},
                                                                {"profile", "[s/s]"},
                                                                {"", "the profile beside the plan"}};

const FigureFolder folder{"peng_2014/planned_figures"};

FigureOutput draw(const FigureContext& context) {
  DataTable data{"planned-figures",
                 {"row [-]", "estimated error over band [-]", "CPU time planned [s/s]",
                  "CPU time of the paper's rung [s/s]", "CPU time of the profile [s/s]"},
                 {}};
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes;
  for (const plan::FigurePlan& plan : figure_plans()) {
    rows.push_back({plan.figure, plan.tier, plan.steps, fmt::format("{:.0f} %", 100.0 * plan.error_over_band),
                    plan.by_formula ? "ms" : fmt::format("{:.3g}", plan.core_seconds),
                    fmt::format("{:.3g}", plan.published_core_seconds),
                    fmt::format("{:.3g}", plan.profile_core_seconds),
                    fmt::format("{}: {}", plan.profile, plan.agreement)});
    data.rows.push_back({static_cast<double>(rows.size()), plan.error_over_band, plan.core_seconds,
                         plan.published_core_seconds, plan.profile_core_seconds});
    notes.push_back(
        fmt::format("{} asks for {}; nearest to its band: {}.", plan.figure, fmt::join(plan.asked, ", "), plan.worst));
  }
  return draw_table("planned-figures", folder, {headings, std::move(rows)}, data, std::move(notes), 1040, context.out);
}

}  // namespace

Figure figure() { return {"planned-figures", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb::planned_figures
