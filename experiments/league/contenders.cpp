#include "experiments/league/contenders.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "correlations/drag/drag_laws.hpp"
#include "correlations/drag/single_sphere/brown_lawler_2003.hpp"
#include "correlations/drag/single_sphere/single_sphere_laws.hpp"
#include "correlations/fluidisation/expansion_exponent/expansion_conditions.hpp"
#include "correlations/fluidisation/fluidisation_laws.hpp"
#include "correlations/fluidisation/terminal_velocity.hpp"
#include "solver/support/close_names.hpp"

namespace slfb::league {
namespace {

double wall_factor(const Bed& bed) {
  return bed.motion == BedMotion::fluidised ? fluidisation::RichardsonZakiWall1954{}(bed.diameter_ratio()) : 1.0;
}

/// U = u_t ε^n, u_t by a law for one sphere.
template <class OneSphere, class Exponent>
double expansion_velocity(const OneSphere& one_sphere, const Exponent& exponent, const Bed& bed, double voidage) {
  const double terminal = fluidisation::terminal_velocity(one_sphere, bed.sphere, bed.liquid);
  const fluidisation::ExpansionConditions conditions{reynolds_number(bed.liquid, bed.sphere.diameter, terminal),
                                                     bed.archimedes(), bed.diameter_ratio()};
  return fluidisation::expansion_velocity(terminal, exponent(conditions), voidage);
}

void add(std::vector<Contender>& list, std::string_view law, ContenderKind kind, const Contender::Velocity& velocity) {
  for (const bool with_wall : {false, true}) list.emplace_back(std::string(law), kind, with_wall, velocity);
}

}  // namespace

Bed bed_of(const ExpansionLine& line) { return {line.sphere, line.liquid, line.tube_diameter, line.motion}; }

double terminal_velocity(const Bed& bed) {
  return fluidisation::terminal_velocity(drag::single_sphere::BrownLawler2003{}, bed.sphere, bed.liquid);
}

double terminal_reynolds(const Bed& bed) {
  return reynolds_number(bed.liquid, bed.sphere.diameter, terminal_velocity(bed));
}

double Contender::velocity(const Bed& bed, double voidage) const {
  const double factor = with_wall_ ? wall_factor(bed) : 1.0;
  try {
    return factor * velocity_(bed, voidage);
  } catch (const std::domain_error&) {  // the law has no solution there
    return std::numeric_limits<double>::quiet_NaN();
  }
}

fluidisation::BedState Contender::voidage(const Bed& bed, double superficial_velocity, double packed) const {
  using fluidisation::BedRegime;
  const auto excess = [&](double voidage) { return velocity(bed, voidage) - superficial_velocity; };
  if (excess(packed) >= 0.0) return {packed, BedRegime::packed};
  if (excess(1.0) <= 0.0) return {1.0, BedRegime::washed_out};
  double lower = packed, upper = 1.0;
  // Halved by hand: a law may lack an answer in between, which counts as one that lifts the bed.
  for (int halving = 0; halving < 50; ++halving) {
    const double middle = 0.5 * (lower + upper);
    (excess(middle) >= 0.0 ? upper : lower) = middle;
  }
  const double jump = velocity(bed, upper) / velocity(bed, lower) - 1.0;
  return {0.5 * (lower + upper), std::abs(jump) > 1e-6 ? BedRegime::at_jump : BedRegime::expanded};
}

std::vector<Contender> contenders_of(const drag::DragLawKernels& law) {
  std::vector<Contender> list;
  add(list, law.info.name, ContenderKind::drag_law, [law](const Bed& bed, double voidage) {
    return fluidisation::superficial_velocity(law, bed.sphere, bed.liquid, voidage);
  });
  return list;
}

std::vector<Contender> contenders() {
  std::vector<Contender> list;
  for_each_law<drag::DragLaws>([&](const auto& law) {
    add(list, law.info.name, ContenderKind::drag_law, [law](const Bed& bed, double voidage) {
      return fluidisation::superficial_velocity(law, bed.sphere, bed.liquid, voidage);
    });
  });
  for_each_law<fluidisation::ExpansionExponentLaws>([&](const auto& exponent) {
    add(list, exponent.info.name, ContenderKind::expansion_formula, [exponent](const Bed& bed, double voidage) {
      return expansion_velocity(drag::single_sphere::BrownLawler2003{}, exponent, bed, voidage);
    });
  });
  return list;
}

std::vector<Contender> formula_contenders() {
  std::vector<Contender> list;
  for_each_law<drag::single_sphere::SingleSphereLaws>([&](const auto& one_sphere) {
    for_each_law<fluidisation::ExpansionExponentLaws>([&](const auto& exponent) {
      const auto add_with = [&](std::string_view wall_name, const auto& wall) {
        list.emplace_back(fmt::format("{}, {}, {}", one_sphere.info.name, exponent.info.name, wall_name),
                          ContenderKind::expansion_formula, false,
                          [one_sphere, exponent, wall](const Bed& bed, double voidage) {
                            const double factor = bed.motion == BedMotion::fluidised ? wall(bed.diameter_ratio()) : 1.0;
                            return factor * expansion_velocity(one_sphere, exponent, bed, voidage);
                          });
      };
      add_with("no wall", [](double) { return 1.0; });
      for_each_law<fluidisation::WallCorrectionLaws>([&](const auto& wall) { add_with(wall.info.name, wall); });
    });
  });
  return list;
}

const Contender& find_contender(const std::vector<Contender>& contenders, const std::string& name) {
  const auto found = std::ranges::find(contenders, name, &Contender::name);
  if (found != contenders.end()) return *found;
  std::vector<std::string> known;
  for (const Contender& contender : contenders) known.push_back(contender.name());
  throw std::invalid_argument(
      fmt::format("there is no law \"{}\" in the league; close: {}", name, fmt::join(close_names(name, known), ", ")));
}

}  // namespace slfb::league
