#include <fmt/format.h>

#include "correlations/collision/collision_laws.hpp"
#include "experiments/figures/figure_folder.hpp"
#include "experiments/numerics/figures.hpp"
#include "experiments/numerics/kinetic_theory/periodic_gas.hpp"
#include "reports/gnuplot.hpp"

namespace slfb {
namespace {

const FigureFolder folder{"numerics/kinetic_theory"};

/// Collision frequency over √(q_p²)/d [-].
double frequency(double solids, double contact_value) {
  return collision::Simonin1991{}({solids, 1.0, 1.0, 1.0, 0.0, contact_value});
}

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{
      "kinetic-theory", {}, folder.caption(), {"512 spheres, 12 collisions of each, 20 steps per contact."}};
  DataTable curves{"kinetic-theory_laws",
                   {"solids fraction [-]", "with Carnahan-Starling [-]", "with Lun-Savage [-]",
                    "excess of Lun-Savage over Carnahan-Starling [%]"},
                   {}};
  const auto both = [](double solids) {
    return std::pair{frequency(solids, collision::CarnahanStarling1969{}(solids)),
                     frequency(solids, collision::LunSavage1986{}(solids))};
  };
  for (int step = 1; step <= 54; ++step) {
    const double solids = 0.01 * step;
    const auto [hard_spheres, dense] = both(solids);
    curves.rows.push_back({solids, hard_spheres, dense, 100.0 * (dense / hard_spheres - 1.0)});
  }
  output.data.push_back(write_csv(curves, context.out));

  DataTable counted{"kinetic-theory_counted",
                    {"solids fraction [-]", "frequency [-]", "half width of its 95 % interval [-]",
                     "deviation from Carnahan-Starling [%]", "its half width [%]", "excess of Lun-Savage [%]",
                     "contact time over free time [-]", "largest change of the energy [-]"},
                    {}};
  for (const double solids : {0.05, 0.15, 0.25, 0.35, 0.45}) {
    const auto measured = kinetic::measure_frequency(solids, 8, 12.0);
    const auto [hard_spheres, dense] = both(solids);
    const double half_width = 2.09 * measured.error;  // Student's t for 20 stretches
    counted.rows.push_back({solids, measured.value, half_width, 100.0 * (measured.value / hard_spheres - 1.0),
                            100.0 * half_width / hard_spheres, 100.0 * (dense / measured.value - 1.0),
                            measured.contact_fraction, measured.energy_change});
  }
  output.data.push_back(write_csv(counted, context.out));

  draw_plot("kinetic-theory", folder.plot(), {}, {820, 380}, context.out);
  return output;
}

}  // namespace

Figure kinetic_theory() { return {"kinetic-theory", folder.title(), no_runs, draw, folder.path().string()}; }

}  // namespace slfb
