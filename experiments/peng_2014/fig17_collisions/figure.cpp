#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "correlations/drag/drag_laws.hpp"
#include "correlations/drag/single_sphere/brown_lawler_2003.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"

namespace slfb::fig17_collisions {
namespace {

const FigureFolder folder{"peng_2014/fig17_collisions"};

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

  output.caption = folder.caption(
      {{"begin", fmt::format("{:.2f}", window_begin)},
       {"end", fmt::format("{:.2f}", window_end)},
       {"case", run == nullptr ? "" : fmt::format(", {}: the nearest case that exists here", description)},
       {"caption_velocity", fmt::format("{:.2f}", caption_velocity)},
       {"terminal", fmt::format("{:.3f}", terminal)},
       {"contacts", run == nullptr ? ""
                                   : fmt::format("In this tenth of a second the sphere makes {:g} new contacts.",
                                                 history.rows.back()[1] - history.rows.front()[1])}});

  PlotValues values;
  values.number("begin", window_begin);
  values.number("end", window_end);
  values.number("simulated", run == nullptr ? 0 : 1);
  values.text("description", run == nullptr ? "not yet simulated" : description);
  values.number("caption_velocity", caption_velocity);
  values.number("terminal", terminal);
  draw_plot_of_runs("fig17", folder.plot(), values, {540, 760}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig17", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig17_collisions
