#include <cmath>

#include "correlations/collision/collision_force/grbavcic_2009.hpp"
#include "correlations/collision/collision_force/peng_2014.hpp"
#include "correlations/collision/collision_force/van_der_wielen_1996.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/peng_2014/figures.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"

namespace slfb::fig25_collision_force {
namespace {

const FigureFolder folder{"peng_2014/fig25_collision_force"};
constexpr const char* system_name = "6in5W";

bool wanted(const RunSpec& spec) { return spec.system == system_name && spec.superficial_velocity > 0.055; }

std::vector<std::string> needs(const Profile& profile) { return select_run_keys(profile, wanted); }

/// Eq. 40, and Grbavčić's force with f = 0, over the voidage.
DataTable collision_force_laws() {
  using Foreign = collision::Grbavcic2009<collision::DisplacedDrag::of_foreign_sphere>;
  using Bed = collision::Grbavcic2009<collision::DisplacedDrag::of_bed_spheres>;
  DataTable curves{"fig25",
                   {"voidage [-]", "Eq. 40 [-]", "Grbavcic 2009 with f = 0 and the foreign sphere [-]",
                    "Grbavcic 2009 with f = 0 and the bed spheres [-]"},
                   {}};
  for (int step = 0; step <= 120; ++step) {
    const double voidage = 0.4 + 0.005 * step;
    const auto state = paper::steel_in_glass(0.0, voidage);  // the velocity has no part in these laws
    curves.rows.push_back(
        {voidage,
         collision::Peng2014::info.voidage.contains(voidage) ? collision::Peng2014{}(state, 0.0) : std::nan(""),
         Foreign{0.0}(state), Bed{0.0}(state)});
  }
  return curves;
}

/// Van der Wielen's force at the velocities of Table 2.
DataTable van_der_wielen_of_table_2() {
  DataTable points{"fig25_van_der_wielen",
                   {"superficial velocity [m/s]", "voidage by Eq. 36 [-]", "classification velocity of Table 2 [m/s]",
                    "force over weight [-]"},
                   {}};
  for (const auto& row : peng_2014().table2()) {
    const auto state = paper::steel_in_glass(row.superficial_velocity);
    points.rows.push_back({row.superficial_velocity, state.voidage, row.classification_velocity,
                           collision::VanDerWielen1996{}(state, row.classification_velocity)});
  }
  return points;
}

FigureOutput draw(const FigureContext& context) {
  const auto keys = needs(context.profile);
  FigureOutput output{"fig25", {}, folder.caption(), run_notes(context, keys)};
  grid_convergence::add_note({grid_convergence::force_ratio, grid_convergence::voidage}, context, output);
  output.data.push_back(write_csv(collision_force_laws(), context.out));
  output.data.push_back(write_csv(van_der_wielen_of_table_2(), context.out));

  PlotValues values;
  add_series("simulated",
             variants_against_bed("fig25", "collision_force_ratio", "force over weight [-]", system_name,
                                  BedAbscissa::voidage, context),
             values, context, output);
  draw_plot_of_runs("fig25", folder.plot(), values, {520, 520}, context, keys);
  return output;
}

}  // namespace

Figure figure() { return {"fig25", folder.title(), needs, draw, folder.path().string()}; }

}  // namespace slfb::fig25_collision_force
