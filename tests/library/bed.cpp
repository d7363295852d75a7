// How far a bed of 5 mm glass in water expands, by a law of the suite and by an own one.

#include <cmath>
#include <cstdio>

#include "correlations/catalogue.hpp"
#include "correlations/drag/di_felice_1994.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"

int main() {
  using namespace slfb;
  const Sphere glass{.diameter = 5e-3, .density = 2230.0};            // [m], [kg/m³]
  const LiquidProperties water{.density = 998.2, .viscosity = 1e-3};  // [kg/m³], [Pa s]
  const double packed = 0.40;                                         // voidage [-]

  // Any callable that gives F from voidage and Reynolds number is a law.
  const auto own = [](drag::SuspensionFlow flow) {
    return (1.0 + 0.15 * std::pow(flow.reynolds, 0.687)) * std::pow(flow.voidage, -3.65);
  };
  for (const double velocity : {0.06, 0.08, 0.10}) {  // [m/s]
    const auto suite = fluidisation::bed_voidage(drag::DiFelice1994{}, glass, water, velocity, packed);
    const auto ours = fluidisation::bed_voidage(own, glass, water, velocity, packed);
    std::printf("U = %.2f m/s: voidage %.4f (Di Felice), %.4f (own)\n", velocity, suite.voidage, ours.voidage);
  }

  // Or by name, with every number that the law gives.
  LawArguments arguments;
  arguments.voidage = packed;
  const LawAnswer answer = find_law("doroodchi-2012-minimum-fluidisation").evaluate(arguments);
  std::printf("U_mf = %.4f m/s\n", answer.at("minimum_fluidisation_velocity").value);
}
