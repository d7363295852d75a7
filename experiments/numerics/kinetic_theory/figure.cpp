#include <fmt/format.h>

#include "correlations/collision/collision_laws.hpp"
#include "experiments/numerics/figures.hpp"
#include "experiments/numerics/kinetic_theory/periodic_gas.hpp"
#include "reports/gnuplot.hpp"

namespace slfb {
namespace {

double equation_6(double solids, double contact_value) {
  return collision::Simonin1991{}({solids, 1.0, 1.0, 1.0, 0.0, contact_value});
}

FigureOutput draw(const FigureContext& context) {
  FigureOutput output{"kinetic-theory", {}, "", {"512 spheres, 12 collisions of each, 20 steps per contact."}};
  output.caption =
      "Collision frequency of one sphere in a gas of elastic, frictionless spheres, scaled with its diameter and "
      "fluctuating energy, f* = f d/√(q_p²). Symbols: counted by the particle engine in a periodic cube, with 95 % "
      "intervals. Lines: Eq. 6 with the contact value of Carnahan and Starling, which hard spheres have, and with that "
      "of Eq. 7 (α_Sm = 0.575), which the paper uses. Right: the excess of Eq. 7 over the count.";
  DataTable curves{"kinetic-theory_laws",
                   {"solids fraction [-]", "Eq. 6 with Carnahan-Starling [-]", "Eq. 6 with Eq. 7 [-]",
                    "excess of Eq. 7 over Carnahan-Starling [%]"},
                   {}};
  const auto both = [](double solids) {
    return std::pair{equation_6(solids, collision::CarnahanStarling1969{}(solids)),
                     equation_6(solids, collision::LunSavage1986{}(solids))};
  };
  for (int step = 1; step <= 54; ++step) {
    const double solids = 0.01 * step;
    const auto [hard_spheres, paper] = both(solids);
    curves.rows.push_back({solids, hard_spheres, paper, 100.0 * (paper / hard_spheres - 1.0)});
  }
  output.data.push_back(write_csv(curves, context.out));

  DataTable counted{"kinetic-theory_counted",
                    {"solids fraction [-]", "frequency [-]", "half width of its 95 % interval [-]",
                     "deviation from Carnahan-Starling [%]", "its half width [%]", "excess of Eq. 7 [%]",
                     "contact time over free time [-]", "largest change of the energy [-]"},
                    {}};
  for (const double solids : {0.05, 0.15, 0.25, 0.35, 0.45}) {
    const auto measured = kinetic::measure_frequency(solids, 8, 12.0);
    const auto [hard_spheres, paper] = both(solids);
    const double half_width = 2.09 * measured.error;  // Student's t for 20 stretches
    counted.rows.push_back({solids, measured.value, half_width, 100.0 * (measured.value / hard_spheres - 1.0),
                            100.0 * half_width / hard_spheres, 100.0 * (paper / measured.value - 1.0),
                            measured.contact_fraction, measured.energy_change});
  }
  output.data.push_back(write_csv(counted, context.out));

  draw_figure(
      "kinetic-theory",
      "set multiplot layout 1,2 margins 0.09,0.985,0.17,0.95 spacing 0.11,0\n"
      "set xrange [0:0.6]\nset xlabel 'solids fraction α_S [-]'\nset logscale y\nset yrange [0.4:400]\n"
      "set ylabel 'collision frequency f* [-]'\nset key top left reverse Left font ',12'\n"
      "plot 'kinetic-theory_laws.csv' skip 1 using 1:2 with lines linestyle 11 title 'Eq. 6, Carnahan–Starling', "
      "'' skip 1 using 1:3 with lines linestyle 1 title 'Eq. 6 with Eq. 7, as the paper', "
      "'kinetic-theory_counted.csv' skip 1 using 1:2:3 with yerrorbars linestyle 2 title 'counted'\n"
      "unset logscale y\nset yrange [-10:150]\nset ylabel 'difference [%]'\n"
      "plot 0 with lines linestyle 20 notitle, "
      "'kinetic-theory_laws.csv' skip 1 using 1:4 with lines linestyle 1 title 'Eq. 7 over Carnahan–Starling', "
      "'kinetic-theory_counted.csv' skip 1 using 1:6 with points linestyle 3 title 'Eq. 7 over the count', "
      "'' skip 1 using 1:4:5 with yerrorbars linestyle 2 title 'count over Carnahan–Starling'\n"
      "unset multiplot\n",
      {820, 380}, context.out);
  return output;
}

}  // namespace

Figure kinetic_theory() {
  return {"kinetic-theory", "Collision frequency of an elastic gas against kinetic theory", no_runs, draw,
          "numerics/kinetic_theory"};
}

}  // namespace slfb
