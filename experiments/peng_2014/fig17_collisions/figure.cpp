#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "correlations/drag/drag_laws.hpp"
#include "correlations/drag/single_sphere/brown_lawler_2003.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

/// Runs that stand for the one of the caption, which cannot exist: the nearest first.
struct Substitute {
  const char *system, *velocity, *description;
};
constexpr std::array substitutes{Substitute{"5in5W", "0.20", "5 in 5 mm, water, 0.20 m/s"},
                                 Substitute{"6in5W", "0.20", "6 in 5 mm, water, 0.20 m/s"},
                                 Substitute{"6in5W", "0.10", "6 in 5 mm, water, 0.10 m/s"}};
constexpr double window_begin = 1.0, window_end = 1.1;  ///< of the paper's time axis, from the release [s]

std::vector<std::string> needs(const Profile& profile) {
  return select_run_keys(profile, [](const RunSpec& spec) {
    return spec.variant.empty() &&
           std::any_of(substitutes.begin(), substitutes.end(), [&](const Substitute& substitute) {
             return spec.system == substitute.system && velocity_text(spec.superficial_velocity) == substitute.velocity;
           });
  });
}

/// Voidage of the bed of 5 mm glass in the NaI solution; not a number where the law keeps no bed in the column.
template <class Law>
double voidage_in_sodium_iodide(const Law& law, double superficial_velocity) {
  const auto bed = fluidisation::bed_voidage(law, paper::glass(0.005), paper::sodium_iodide(), superficial_velocity,
                                             paper::packed_voidage());
  return bed.regime == fluidisation::BedRegime::expanded ? bed.voidage : std::nan("");
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  const double caption_velocity = peng_2014().value("figure17_velocity");
  const double terminal = fluidisation::terminal_velocity(drag::single_sphere::BrownLawler2003{}, paper::glass(0.005),
                                                          paper::sodium_iodide());
  FigureOutput output{"fig17", {}, "", run_notes(context, keys)};

  DataTable expansion{"fig17_expansion_in_sodium_iodide",
                      {"superficial velocity [m/s]", "Eq. 36 [-]", "Wen and Yu 1966 [-]", "Di Felice 1994 [-]"},
                      {}};
  for (int step = 20; step <= 230; ++step) {
    const double velocity = 1e-3 * step;
    expansion.rows.push_back({velocity, voidage_in_sodium_iodide(drag::Doroodchi2012{}, velocity),
                              voidage_in_sodium_iodide(drag::WenYu1966{}, velocity),
                              voidage_in_sodium_iodide(drag::DiFelice1994{}, velocity)});
  }
  output.data.push_back(write_csv(expansion, context.out));

  const auto own_springs = runs_with_own_springs(context.results);
  output.notes.push_back(springs_note(own_springs));
  const FinishedRun* run = nullptr;
  std::string description;
  for (const Substitute& substitute : substitutes) {
    run = find_contact_run(context, own_springs, fmt::format("{}/{}", substitute.system, substitute.velocity));
    if (run != nullptr && run->result.drops.empty()) run = nullptr;
    description = substitute.description;
    if (run != nullptr) break;
  }
  DataTable history{"fig17_history",
                    {"time since release [s]", "contacts since release [-]", "velocity x [m/s]", "velocity y [m/s]",
                     "velocity z [m/s]"},
                    {}};
  if (run != nullptr) {
    const DropSeries& drop = run->result.drops.front();
    for (std::size_t i = 0; i < drop.time.size(); ++i)
      if (drop.time[i] >= window_begin - 1e-9 && drop.time[i] <= window_end + 1e-9)
        history.rows.push_back(
            {drop.time[i], drop.cumulative_contacts[i], drop.velocity_x[i], drop.velocity_y[i], drop.velocity_z[i]});
    if (history.rows.empty()) run = nullptr;
  }
  if (run != nullptr) {
    output.data.push_back(write_csv(history, context.out));
    description += fmt::format(", sampled every {:.2g} ms", 1e3 * sample_interval(run->result.drops.front()));
  }

  output.caption = fmt::format(
      "Above: contacts since the release and velocity of a foreign sphere from {:.2f} to {:.2f} s after its release{}. "
      "Below: why the case of the paper's caption (5 in 5 mm, NaI solution, {:.2f} m/s) cannot exist: voidage of the "
      "homogeneous bed of 5 mm glass in the NaI solution by three laws. It reaches 1 at the terminal velocity of one "
      "sphere, {:.3f} m/s by Brown and Lawler's drag (dotted); at the caption's velocity (dashed) every sphere is "
      "carried "
      "out. The paper's curves are not available as numbers.",
      window_begin, window_end,
      run == nullptr ? "" : fmt::format(", {}: the nearest case that exists here", description), caption_velocity,
      terminal);
  if (run != nullptr) {
    output.caption += fmt::format(" In this tenth of a second the sphere makes {:g} new contacts.",
                                  history.rows.back()[1] - history.rows.front()[1]);
  }

  std::string script = fmt::format(
      "set multiplot\nset lmargin at screen 0.14\nset rmargin at screen 0.97\nsplit = base + 0.44*(1 - base)\n"
      "upper = 1 - 14.0/height\nmiddle = split + 0.62*(1 - split)\n"
      "set xrange [{0:g}:{1:g}]\nset xtics 0.02\nset format x ''\nset tmargin at screen upper\nset bmargin at screen "
      "middle\nset ylabel 'contacts [-]' offset 0.5,0\nset label 1 '{2}' at graph 0.02, 0.88 font ',12' textcolor rgb "
      "{3}\n",
      window_begin, window_end, run == nullptr ? "not yet simulated" : description, run == nullptr ? "quiet" : "ours");
  if (run != nullptr) {
    // Some room above the curve keeps it clear of the label.
    script += fmt::format("set yrange [{:g}:{:g}]\nset ytics autofreq\n", history.rows.front()[1] - 1,
                          history.rows.back()[1] + 1 + 0.3 * (history.rows.back()[1] - history.rows.front()[1]));
    script += "plot 'fig17_history.csv' skip 1 using 1:2 with steps linestyle 2 linewidth 1.6 notitle\n";
  } else {
    script += "set yrange [430:510]\nset ytics 20\nplot NaN notitle\n";
  }
  script +=
      "eval footer_drawn\nunset label 1\nset autoscale y\nset ytics autofreq\nset tmargin at screen middle - "
      "12.0/height\n"
      "set bmargin at screen split + 52.0/height\nset format x '%g'\nset xlabel 'time since release [s]' offset 0,0.3\n"
      "set ylabel 'velocity [m/s]' offset 0.5,0\nset key bottom right horizontal font ',12'\n";
  double lowest = 0.0;  // velocity; the key stands below it [m/s]
  for (const auto& row : history.rows) lowest = std::min({lowest, row[2], row[3], row[4]});
  script += run == nullptr
                ? "set yrange [-0.5:0.5]\nplot NaN notitle\n"
                : fmt::format("set yrange [{:.3f} : *]\n", lowest - 0.25) +
                      "plot 'fig17_history.csv' skip 1 using 1:3 with lines linestyle 4 linewidth 1.4 title 'v_x', "
                      "'' skip 1 using 1:4 with lines linestyle 3 linewidth 1.4 title 'v_y', "
                      "'' skip 1 using 1:5 with lines linestyle 2 linewidth 1.8 title 'v_z'\n";
  script += fmt::format(
      "set tmargin at screen split - 22.0/height\nset bmargin at screen base + 58.0/height\nset xrange [0:0.23]\n"
      "set xtics 0.05\nset yrange [0.35:1.05]\nset ytics 0.2\nset xlabel 'superficial velocity U_L of NaI solution "
      "[m/s]'\n"
      "set ylabel 'voidage α_L [-]'\nset key top left vertical Left reverse font ',12'\n"
      "set arrow 1 from {0:g}, graph 0 to {0:g}, graph 1 nohead linestyle 1\n"
      "set arrow 2 from {1:g}, graph 0 to {1:g}, graph 1 nohead linestyle 20\n"
      "set label 2 'caption' at {0:g}, graph 0.70 rotate by 90 offset 0.9,0 font ',11'\n"
      "set label 3 'terminal' at {1:g}, graph 0.70 rotate by 90 offset -0.8,0 font ',11' textcolor rgb quiet\n"
      "plot 'fig17_expansion_in_sodium_iodide.csv' skip 1 using 1:2 with lines linestyle 13 title 'Eq. 36', "
      "'' skip 1 using 1:3 with lines linestyle 12 title 'Wen and Yu', '' skip 1 using 1:4 with lines linestyle 14 "
      "title "
      "'Di Felice'\nunset multiplot\n",
      caption_velocity, terminal);
  draw_figure_of_runs("fig17", script, {540, 760}, context, keys, own_springs);
  return output;
}

}  // namespace

Figure fig17() {
  return {"fig17", "Contacts and velocity over a tenth of a second", needs, draw, "peng_2014/fig17_collisions"};
}

}  // namespace slfb
