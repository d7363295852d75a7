#include "experiments/peng_2014/paper_conditions.hpp"

#include <algorithm>

#include "correlations/drag/doroodchi_2012.hpp"
#include "correlations/drag/ergun_1952.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/peng_2014/bed_systems.hpp"
#include "solver/dem/linear_spring_dashpot.hpp"

namespace slfb::paper {

ForeignSphereInBed steel_in_glass(double superficial_velocity) {
  const auto bed =
      fluidisation::bed_voidage(drag::Doroodchi2012{}, glass(0.005), water(), superficial_velocity, packed_voidage());
  return steel_in_glass(superficial_velocity, bed.voidage);
}

ForeignSphereInBed steel_in_glass(double superficial_velocity, double voidage) {
  return {.bed = glass(0.005),
          .foreign = steel(0.006),
          .liquid = water(),
          .voidage = voidage,
          .superficial_velocity = superficial_velocity};
}

std::optional<double> voidage_by_equation_36(std::string_view system, double superficial_velocity) {
  const auto found = std::ranges::find(bed_systems, system, &BedSystem::name);
  if (found == bed_systems.end()) return std::nullopt;
  const LiquidProperties liquid = found->liquid == BedLiquid::water ? water() : sodium_iodide();
  return fluidisation::bed_voidage(drag::Doroodchi2012{}, glass(found->bed_diameter), liquid, superficial_velocity,
                                   packed_voidage())
      .voidage;
}

double ergun_pressure(double voidage, double superficial_velocity) {
  const LiquidProperties liquid = water();
  const double diameter = 0.005;
  const double reynolds = reynolds_number(liquid, diameter, superficial_velocity);
  const double exchange =
      drag::exchange_coefficient(drag::Ergun1952{}({voidage, reynolds}), voidage, diameter, liquid.viscosity);
  // Steady liquid in a fixed bed: ε Δp/L = β U/ε.
  return exchange * superficial_velocity / (voidage * voidage) * peng_2014().value("packed_height");
}

double contact_time(Sphere a, Sphere b) {
  const double mass_a = a.volume() * a.density;
  const double mass_b = b.volume() * b.density;
  return dem::LinearSpringDashpot::contact_time(peng_2014().value("normal_stiffness"),
                                                peng_2014().value("restitution_coefficient"),
                                                mass_a * mass_b / (mass_a + mass_b));
}

}  // namespace slfb::paper
