#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "correlations/collision/collision_laws.hpp"
#include "correlations/drag/drag_laws.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb::drag_law_question {
namespace {

const FigureFolder folder{"peng_2014/drag_law_question"};
constexpr const char* system_name = "6in5W";

/// One law with one friction, as its runs are called in profiles.toml.
struct Combination {
  const char *variant, *law;
  double friction;
};
constexpr std::array combinations{Combination{"gidaspow-1994_friction-0_3", "Gidaspow", 0.3},
                                  Combination{"gidaspow-1994_friction-0_1", "Gidaspow", 0.1},
                                  Combination{"gidaspow-1994_friction-0", "Gidaspow", 0.0},
                                  Combination{"wen-yu-1966_friction-0_3", "Wen-Yu", 0.3},
                                  Combination{"wen-yu-1966_friction-0_1", "Wen-Yu", 0.1},
                                  Combination{"wen-yu-1966_friction-0", "Wen-Yu", 0.0}};

/// Its runs belong to a profile of their own: nothing else waits for them.
std::vector<std::string> needs(const Profile& profile) {
  if (profile.name != "drag-law") return {};
  return select_run_keys(profile, [](const RunSpec&) { return true; });
}

template <class Law>
double homogeneous_voidage(const Law& law, double superficial_velocity) {
  const auto bed = fluidisation::bed_voidage(law, paper::glass(0.005), paper::water(), superficial_velocity,
                                             paper::packed_voidage());
  return bed.regime == fluidisation::BedRegime::expanded ? bed.voidage : std::nan("");
}

std::optional<double> printed_voidage(double superficial_velocity) {
  for (const auto& point : peng_2014().figure13())
    if (std::fabs(point.superficial_velocity - superficial_velocity) < 1e-6) return point.voidage;
  return {};
}

std::optional<double> printed_velocity(double superficial_velocity) {
  for (const auto& row : peng_2014().table2())
    if (std::fabs(row.superficial_velocity - superficial_velocity) < 1e-6) return row.classification_velocity;
  return {};
}

struct Value {
  double value = std::nan(""), half_width = std::nan("");
};
Value measured(const Measurements& measurements, const char* quantity, double velocity, const char* variant) {
  const auto found = measurements.find(measure_key(quantity, system_name, velocity, variant));
  return found == measurements.end() ? Value{} : Value{found->second.value, found->second.half_width};
}

FigureOutput draw(const FigureContext& outer) {
  const Profile profile = load_profile("drag-law");
  const auto runs = finished_runs(profile, outer.results);
  const Measurements measurements = measure_runs(runs, peng_2014_work().measuring);
  const FigureContext context{profile, runs, measurements, outer.out, outer.results};
  const auto keys = needs(profile);
  FigureOutput output{"drag-law", {}, "", run_notes(context, keys)};

  DataTable lines{
      "drag_law_homogeneous", {"superficial velocity [m/s]", "Gidaspow 1994 [-]", "Wen and Yu 1966 [-]"}, {}};
  for (int step = 45; step <= 250; ++step) {
    const double velocity = 1e-3 * step;
    lines.rows.push_back({velocity, homogeneous_voidage(drag::Gidaspow1994{}, velocity),
                          homogeneous_voidage(drag::WenYu1966{}, velocity)});
  }
  DataTable printed{"drag_law_paper", {"superficial velocity [m/s]", "voidage [-]", "V_2 [m/s]"}, {}};
  for (const auto& row : peng_2014().table2())
    printed.rows.push_back({row.superficial_velocity, printed_voidage(row.superficial_velocity).value_or(std::nan("")),
                            row.classification_velocity});
  DataTable equation40{"drag_law_equation_40", {"voidage [-]", "|F_c|/mg [-]"}, {}};
  for (int step = 44; step <= 90; ++step)
    equation40.rows.push_back({0.01 * step, collision::Peng2014{}(paper::steel_in_glass(0.1, 0.01 * step), 0.0)});
  for (const auto* table : {&lines, &printed, &equation40}) output.data.push_back(write_csv(*table, outer.out));

  std::vector<std::string> tables, laws;
  std::vector<double> frictions, shifts;
  std::string deviations;
  double least = std::numeric_limits<double>::infinity();
  std::string nearest;
  for (std::size_t k = 0; k < combinations.size(); ++k) {
    const Combination& c = combinations[k];
    DataTable table{fmt::format("drag_law_{}", c.variant),
                    {"superficial velocity [m/s]", "voidage [-]", "half width [-]", "V_2 [m/s]", "half width [m/s]",
                     "|F_c|/mg [-]", "half width [-]", "drag over weight [-]", "wall time per simulated time [s/s]"},
                    {}};
    double squares = 0.0;
    int counted = 0;
    for (const double velocity : {0.06, 0.10, 0.20}) {
      const Value voidage = measured(measurements, "voidage_centre_of_mass", velocity, c.variant),
                  v2 = measured(measurements, "classification_velocity", velocity, c.variant),
                  force = measured(measurements, "collision_force_ratio", velocity, c.variant),
                  drag = measured(measurements, "drag_ratio", velocity, c.variant),
                  cost = measured(measurements, "wall_seconds_per_simulated_second", velocity, c.variant);
      if (std::isnan(voidage.value)) continue;
      table.rows.push_back({velocity, voidage.value, voidage.half_width, v2.value, v2.half_width, force.value,
                            force.half_width, drag.value, cost.value});
      if (const auto paper = printed_velocity(velocity); paper && std::isfinite(v2.value)) {
        squares += std::pow(v2.value / *paper - 1.0, 2);
        ++counted;
      }
      if (const auto paper = printed_voidage(velocity)) {
        // A tenth of the voidage's distance from packing is about as wide as a tenth of V_2.
        squares += std::pow((voidage.value - *paper) / (*paper - 0.4), 2);
        ++counted;
      }
    }
    if (table.rows.empty()) continue;
    const double deviation = std::sqrt(squares / std::max(1, counted));
    const std::string title = fmt::format("{}, friction {}", c.law, c.friction);
    deviations += fmt::format("{}{}: {:.0f} %", deviations.empty() ? "" : "; ", title, 100.0 * deviation);
    if (deviation < least) least = deviation, nearest = title;
    output.data.push_back(write_csv(table, outer.out));
    tables.push_back(table.name);
    laws.emplace_back(c.law);
    frictions.push_back(c.friction);
    // Along U_L, so that the points of one velocity do not hide each other [m/s].
    shifts.push_back(0.0016 * (static_cast<double>(k) - 2.5));
  }
  output.caption = folder.caption(
      {{"deviations",
        nearest.empty() ? ""
                        : fmt::format("Root mean square deviation from the printed V_2, and from the printed voidages "
                                      "over their distance from 0.4: {}. Nearest: {}.",
                                      deviations, nearest)}});

  PlotValues values;
  values.files("simulated", tables);
  values.texts("law", laws);
  values.numbers("friction", frictions);
  values.numbers("shift", shifts);
  draw_plot_of_runs("drag-law", folder.plot(), values, {1180, 420}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"drag-law", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::drag_law_question
