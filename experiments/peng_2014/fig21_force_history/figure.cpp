#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/quantities/analysis.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb::fig21_force_history {
namespace {

const FigureFolder folder{"peng_2014/fig21_force_history"};
constexpr const char* system_name = "6in5W";

struct Panel {
  double superficial_velocity;  ///< whose bed has this voidage by Eq. 36, as the printed pairs have [m/s]
  double voidage;               ///< of the panel in the paper [-]
};
constexpr std::array<Panel, 6> panels{
    {{0.06, 0.46}, {0.08, 0.51}, {0.12, 0.60}, {0.16, 0.67}, {0.18, 0.71}, {0.24, 0.79}}};

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.system == system_name && spec.variant.empty() &&
           std::any_of(panels.begin(), panels.end(), [&](const Panel& panel) {
             return std::fabs(panel.superficial_velocity - spec.superficial_velocity) < 1e-6;
           });
  });
}

/// Collision force over weight of the first drop from entering the bed, the largest value of each group of samples, so
/// that no peak is lost and the picture stays small.
DataTable force_history(const FinishedRun& run, double bed_top, const std::string& name) {
  DataTable table{name, {"time since entering the bed [s]", "largest collision force over weight [-]"}, {}};
  const DropSeries& drop = run.result.drops.front();
  const auto passage = bed_passage(drop, bed_top);
  if (!passage) return table;
  constexpr std::size_t most_rows = 800;
  const double weight = paper::steel(0.006).weight();
  const std::size_t group = (passage->end - passage->begin + most_rows - 1) / most_rows;
  for (std::size_t first = passage->begin; first < passage->end; first += group) {
    const std::size_t last = std::min(first + group, passage->end);
    const auto largest = std::max_element(drop.contact_force.begin() + static_cast<std::ptrdiff_t>(first),
                                          drop.contact_force.begin() + static_cast<std::ptrdiff_t>(last));
    table.rows.push_back({drop.time[first] - drop.time[passage->begin], *largest / weight});
  }
  return table;
}

/// "1e4", not "10000".
std::string stiffness_text(double stiffness) {
  const int power = static_cast<int>(std::floor(std::log10(stiffness) + 1e-9));
  return fmt::format("{:.2g}e{}", stiffness / std::pow(10.0, power), power);
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  const double lowest = printed.value("peak_force_lowest"), highest = printed.value("peak_force_highest");
  FigureOutput output{
      "fig21",
      {},
      folder.caption({{"lowest", fmt::format("{:g}", lowest)}, {"highest", fmt::format("{:g}", highest)}}),
      run_notes(context, keys)};
  const auto own_springs = runs_with_own_springs(context.results);
  output.notes.push_back(springs_note(own_springs));
  std::vector<std::string> headings, remarks, forces;
  double common_end = std::numeric_limits<double>::infinity(), highest_drawn = highest;
  for (const Panel& panel : panels) {
    const std::string tag = velocity_text(panel.superficial_velocity);
    const auto voidage =
        context.measurements.find(measure_key("voidage_centre_of_mass", system_name, panel.superficial_velocity));
    headings.push_back(
        fmt::format("U_L = {} m/s, α_L {:.2f} (paper), {} (ours)", tag, panel.voidage,
                    voidage == context.measurements.end() ? "–" : fmt::format("{:.2f}", voidage->second.value)));
    DataTable force;
    const FinishedRun* run = find_contact_run(context, own_springs, run_key(system_name, panel.superficial_velocity));
    if (run != nullptr && !run->result.drops.empty()) {
      const auto top = context.measurements.find(measure_key("bed_top", system_name, panel.superficial_velocity));
      force = force_history(*run, top == context.measurements.end() ? run->result.packed_height : top->second.value,
                            "fig21_force_" + tag);
    }
    const bool simulated = !force.rows.empty();
    if (simulated) output.data.push_back(write_csv(force, context.out));
    forces.push_back(simulated ? force.name : "");
    if (!simulated) {
      remarks.emplace_back("not yet simulated");
      continue;
    }
    const auto peak = std::ranges::max_element(force.rows, {}, [](const std::vector<double>& row) { return row[1]; });
    common_end = std::min(common_end, force.rows.back()[0]);
    highest_drawn = std::max(highest_drawn, (*peak)[1]);
    remarks.push_back(fmt::format("{} N/m, every {:.2g} ms; passage {:.1f} s; highest {:.0f} at {:.1f} s",
                                  stiffness_text(run->scene.contact.stiffness),
                                  1e3 * sample_interval(run->result.drops.front()), force.rows.back()[0], (*peak)[1],
                                  (*peak)[0]));
  }
  PlotValues values;
  values.number("lowest", lowest);
  values.number("highest", highest);
  values.markups("heading", headings);
  values.texts("remark", remarks);
  // One length for all: the panels are compared by how dense their peaks are in time.
  values.number("end", std::isfinite(common_end) ? common_end : 1.0);
  values.number("top_of_axis", 10.0 * std::ceil(1.05 * highest_drawn / 10.0));
  values.files("force", forces);
  draw_plot_of_runs("fig21", folder.plot(), values, {700, 660}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig21", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig21_force_history
