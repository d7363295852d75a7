#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/quantities/analysis.hpp"
#include "experiments/reference/reference_data.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

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

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const Peng2014& printed = peng_2014();
  FigureOutput output{"fig21", {}, "", run_notes(context, keys)};
  output.caption = fmt::format(
      "Magnitude of the collision force on the 6 mm steel sphere over its weight, from entering the bed of 5 mm glass "
      "to "
      "the bottom, for the first drop at six superficial velocities. Above each panel: the "
      "voidage of the paper's panel and of our bed. Dashed: the range {:g} to {:g} in which the paper sees the peaks. "
      "Its "
      "curves are not available as numbers.",
      printed.value("peak_force_lowest"), printed.value("peak_force_highest"));
  std::string script =
      "set multiplot\nleft = 0.12\nright = 0.985\nwide = (right - left - 0.03)/2\ntop = 1 - 30.0/height\n"
      "bottom = base + 58.0/height\ngap_y = 50.0/height\nhigh = (top - bottom - 2*gap_y)/3\nset yrange [0:60]\nset "
      "ytics "
      "20\nunset key\n"
      "set label 2 'paper: peaks in this range' at graph 0.98, graph 0.89 right font ',10'\n";
  const auto own_springs = runs_with_own_springs(context.results);
  output.notes.push_back(springs_note(own_springs));
  for (std::size_t place = 0; place < panels.size(); ++place) {
    const Panel& panel = panels[place];
    const std::string tag = velocity_text(panel.superficial_velocity);
    const FinishedRun* run = find_contact_run(context, own_springs, run_key(system_name, panel.superficial_velocity));
    std::string plot, ours = "–", sampling;
    if (const auto voidage =
            context.measurements.find(measure_key("voidage_centre_of_mass", system_name, panel.superficial_velocity));
        voidage != context.measurements.end())
      ours = fmt::format("{:.2f}", voidage->second.value);
    double end = 1.0;
    if (run != nullptr && !run->result.drops.empty()) {
      const auto top = context.measurements.find(measure_key("bed_top", system_name, panel.superficial_velocity));
      const DataTable table =
          force_history(*run, top == context.measurements.end() ? run->result.packed_height : top->second.value,
                        "fig21_force_" + tag);
      if (!table.rows.empty()) {
        output.data.push_back(write_csv(table, context.out));
        end = table.rows.back()[0];
        sampling = fmt::format("sampled every {:.2g} ms", 1e3 * sample_interval(run->result.drops.front()));
        plot = fmt::format(", '{}.csv' skip 1 using 1:2 with impulses linecolor rgb ours linewidth 0.8", table.name);
      }
    }
    const std::size_t row = place / 2, column = place % 2;
    script += fmt::format(
        "set lmargin at screen left + {0}*(wide + 0.03)\nset rmargin at screen left + {0}*(wide + 0.03) + wide\n"
        "set tmargin at screen top - {1}*(high + gap_y)\nset bmargin at screen top - {1}*(high + gap_y) - high\n"
        "set title 'U_L = {2} m/s, α_L {3:.2f} (paper), {4} (ours)' font ',11' offset 0,-0.7\n"
        "set label 1 '{5}' at graph 0.5, graph 0.6 center font ',11' textcolor rgb quiet\nset xrange [0:{6:.3f}]\nset "
        "xtics "
        "{9:g}\n{7}\n{8}\n",
        column, row, tag, panel.voidage, ours, plot.empty() ? "not yet simulated" : sampling, end,
        column == 0 ? "set format y '%g'\nset ylabel '|F_c|/mg [-]' offset -0.2,0" : "set format y ''\nunset ylabel",
        row == 2 ? "set xlabel 'time since entering the bed [s]' offset 0,0.4" : "unset xlabel",
        end > 5.0   ? 5.0
        : end > 2.0 ? 1.0
        : end > 1.0 ? 0.5
                    : 0.2);
    script +=
        fmt::format("plot {:g} with lines linestyle 1 linewidth 0.8, {:g} with lines linestyle 1 linewidth 0.8{}\n",
                    printed.value("peak_force_lowest"), printed.value("peak_force_highest"), plot);
    if (place == 0) script += "eval footer_drawn\nunset label 2\n";
  }
  draw_figure_of_runs("fig21", script + "unset multiplot\n", {640, 620}, context, keys, own_springs);
  return output;
}

}  // namespace

Figure fig21() { return {"fig21", "Collision force in time", needs, draw, "peng_2014/fig21_force_history"}; }

}  // namespace slfb
