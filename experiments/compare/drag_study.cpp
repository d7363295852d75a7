#include "experiments/compare/drag_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

#include "correlations/classification/force_balance.hpp"
#include "correlations/drag/single_sphere/brown_lawler_2003.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/figures/figure_support.hpp"
#include "experiments/runs/measure.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb::compare {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

bool in_range(const LawInfo& info, double voidage, double reynolds) {
  return info.voidage.contains(voidage) && info.reynolds.contains(reynolds);
}

std::string words_of(const Range& range) {
  return std::isinf(range.upper) ? fmt::format("{:g} and more", range.lower)
                                 : fmt::format("{:g} to {:g}", range.lower, range.upper);
}

/// Calls use(voidage, reynolds) at the points of the grid in the range of a law.
template <class Use>
void for_range(const LawInfo& info, Use use) {
  const DragGrid grid = drag_grid();
  for (const double voidage : grid.voidage)
    for (const double reynolds : grid.reynolds)
      if (in_range(info, voidage, reynolds)) use(voidage, reynolds);
}

std::string at(double voidage, double reynolds) { return fmt::format("at e = {:.3g}, Re = {:.3g}", voidage, reynolds); }

/// Largest jump of F along a line, relative: what is left of the change between two points of the grid when the
/// interval between them is halved again and again.
template <class Value>
std::pair<double, double> largest_jump(const std::vector<double>& points, Value value) {
  std::pair<double, double> found{0.0, nothing};
  for (std::size_t i = 1; i < points.size(); ++i) {
    double lower = points[i - 1], upper = points[i];
    for (int halving = 0; halving < 40; ++halving) {
      const double middle = 0.5 * (lower + upper);
      const double f = value(middle);
      (std::abs(f - value(lower)) > std::abs(value(upper) - f) ? upper : lower) = middle;
    }
    const double jump = std::abs(value(upper) / value(lower) - 1.0);
    if (jump > found.first) found = {jump, 0.5 * (lower + upper)};
  }
  return found;
}

std::vector<double> inside(const std::vector<double>& points, const Range& range) {
  std::vector<double> kept;
  std::ranges::copy_if(points, std::back_inserter(kept), [&](double point) { return range.contains(point); });
  return kept;
}

PropertyCheck check_stokes_limit(const drag::DragLawKernels& law) {
  const double drag = law({1.0, 1e-2});
  const bool covered = in_range(law.info, 1.0, 1e-2);
  return {"A sphere alone in creeping flow has Stokes drag: F = 1 within 5 %", std::abs(drag - 1.0) < 0.05,
          fmt::format("F = {:.4g} at e = 1, Re = 0.01{}", drag, covered ? "" : " (outside its range)")};
}

PropertyCheck check_single_sphere(const drag::DragLawKernels& law) {
  const drag::single_sphere::BrownLawler2003 standard;
  LargestValue worst;
  for (const double reynolds : inside(drag_grid().reynolds, law.info.reynolds))
    worst.update(std::abs(law({1.0, reynolds}) / standard(reynolds) - 1.0), at(1.0, reynolds));
  return {"A sphere alone has the standard drag curve (Brown & Lawler 2003) within 15 %", worst.value < 0.15,
          fmt::format("{:.1f} % off {}", 100.0 * worst.value, worst.where)};
}

PropertyCheck check_crowding(const drag::DragLawKernels& law) {
  const DragGrid grid = drag_grid();
  LargestValue worst;
  for (std::size_t i = 1; i < grid.voidage.size(); ++i)
    for (const double reynolds : grid.reynolds)
      if (in_range(law.info, grid.voidage[i], reynolds) && in_range(law.info, grid.voidage[i - 1], reynolds))
        worst.update(law({grid.voidage[i], reynolds}) / law({grid.voidage[i - 1], reynolds}) - 1.0,
                     at(grid.voidage[i], reynolds));
  return {"At one Re the drag falls with the voidage", worst.value <= 0.0,
          worst.value <= 0.0 ? "everywhere" : fmt::format("rises by {:.2g} % {}", 100.0 * worst.value, worst.where)};
}

PropertyCheck check_rise_with_slip(const drag::DragLawKernels& law) {
  LargestValue worst;
  for_range(law.info, [&](double voidage, double reynolds) {
    double slope = 0.0;
    law.slip_derivative(&voidage, &reynolds, &slope, 1);
    worst.update(-slope / law({voidage, reynolds}), at(voidage, reynolds));
  });
  return {"The drag force rises with the slip: F + Re dF/dRe > 0", worst.value < 0.0,
          fmt::format("smallest over F: {:.3g} {}", -worst.value, worst.where)};
}

PropertyCheck check_turbulent_limit(const drag::DragLawKernels& law) {
  LargestValue worst;
  for_range(law.info, [&](double voidage, double reynolds) {
    double slope = 0.0;
    law.slip_derivative(&voidage, &reynolds, &slope, 1);
    worst.update(slope / law({voidage, reynolds}), at(voidage, reynolds));
  });
  return {"The force rises no faster than the square of the slip", worst.value < 2.0 + 1e-6,
          fmt::format("largest exponent {:.3g} {}", worst.value, worst.where)};
}

PropertyCheck check_derivative(const drag::DragLawKernels& law) {
  LargestValue worst;
  for_range(law.info, [&](double voidage, double reynolds) {
    double slope = 0.0;
    law.slip_derivative(&voidage, &reynolds, &slope, 1);
    constexpr double step = 1e-4;
    const auto product = [&](double factor) { return factor * law({voidage, factor * reynolds}); };
    const double forward = (product(1.0 + step) - product(1.0)) / step;
    const double backward = (product(1.0) - product(1.0 - step)) / step;
    // At a kink the derivative is that of one side.
    const double off = std::min(std::abs(slope - forward), std::abs(slope - backward));
    worst.update(off / std::abs(slope), at(voidage, reynolds));
  });
  return {"The derivative with respect to the slip is that of the formula", worst.value < 1e-3,
          fmt::format("{:.1g} off differences {}", worst.value, worst.where)};
}

PropertyCheck check_jumps(const drag::DragLawKernels& law) {
  const DragGrid grid = drag_grid();
  LargestValue worst;
  for (const double reynolds : inside(grid.reynolds, law.info.reynolds)) {
    const auto [jump, voidage] = largest_jump(inside(grid.voidage, law.info.voidage), [&](double e) {
      return law({e, reynolds});
    });
    worst.update(jump, at(voidage, reynolds));
  }
  for (const double voidage : inside(grid.voidage, law.info.voidage)) {
    const auto [jump, reynolds] = largest_jump(inside(grid.reynolds, law.info.reynolds), [&](double re) {
      return law({voidage, re});
    });
    worst.update(jump, at(voidage, reynolds));
  }
  return {"No jumps: a jump over the balance leaves a bed without a steady voidage", worst.value < 1e-3,
          worst.value < 1e-3 ? "none above 0.1 %" : fmt::format("{:.0f} % {}", 100.0 * worst.value, worst.where)};
}

PropertyCheck check_expansion(const drag::DragLawKernels& law, const ComparisonBed& bed) {
  std::string where = "everywhere from the packed bed to a sphere alone";
  bool holds = true;
  double before = 0.0;
  for (const double voidage : drag_grid().voidage) {
    if (voidage < bed.packed_voidage) continue;
    const double velocity = bed_velocity(law, bed, voidage);
    if (holds && !(velocity > before)) {
      holds = false;
      where = fmt::format("falls from {:.4g} to {:.4g} m/s at e = {:.3g}", before, velocity, voidage);
    }
    before = velocity;
  }
  return {
      fmt::format("The bed of {} in {} expands steadily: U rises with the voidage", bed.bed.words(), bed.liquid_name),
      holds, where};
}

void require_usable(const ComparedDragLaw& compared) {
  bool any = false;
  for_range(compared.law.info, [&](double voidage, double reynolds) {
    any = true;
    const double drag = compared.law({voidage, reynolds});
    if (std::isfinite(drag) && drag > 0.0) return;
    throw std::runtime_error(
        fmt::format("{}: F = {} {}, inside the law's own range; needed is a number above zero (or a narrower range in "
                    "info.voidage and info.reynolds)",
                    compared.argument, drag, at(voidage, reynolds)));
  });
  if (!any)
    throw std::runtime_error(
        fmt::format("{}: the range of the law holds no voidage from 0.36 to 1 or no Re from 0.01 "
                    "to 10000, where laws are compared",
                    compared.argument));
}

}  // namespace

std::vector<ComparedDragLaw> compared_drag_laws(const std::vector<std::string>& arguments) {
  std::vector<ComparedDragLaw> laws;
  std::set<std::string> names;
  for (const std::string& argument : arguments) {
    laws.push_back({argument, find_drag_law(argument)});
    require_usable(laws.back());
    if (!names.insert(laws.back().name()).second)
      throw std::runtime_error(
          fmt::format("{}: \"{}\" is compared twice; each law needs a name of its own", argument, laws.back().name()));
  }
  return laws;
}

DragGrid drag_grid() {
  DragGrid grid;
  for (int i = 0; i <= 64; ++i) grid.voidage.push_back(0.36 + 0.01 * i);
  for (int i = 0; i <= 72; ++i) grid.reynolds.push_back(std::pow(10.0, -2.0 + i / 12.0));
  grid.voidage.back() = 1.0;
  return grid;
}

std::vector<double> drag_on_grid(const drag::DragLawKernels& law) {
  const DragGrid grid = drag_grid();
  std::vector<double> values(grid.voidage.size() * grid.reynolds.size()), voidage(grid.reynolds.size());
  for (std::size_t i = 0; i < grid.voidage.size(); ++i) {
    std::ranges::fill(voidage, grid.voidage[i]);
    law.drag(voidage.data(), grid.reynolds.data(), values.data() + i * grid.reynolds.size(), voidage.size());
  }
  return values;
}

DragRatio drag_ratio(const drag::DragLawKernels& law, const drag::DragLawKernels& other) {
  std::vector<double> ratios;
  for_range(law.info, [&](double voidage, double reynolds) {
    if (in_range(other.info, voidage, reynolds))
      ratios.push_back(law({voidage, reynolds}) / other({voidage, reynolds}));
  });
  if (ratios.empty()) return {nothing, nothing, nothing, 0};
  std::ranges::sort(ratios);
  return {ratios.front(), ratios[ratios.size() / 2], ratios.back(), ratios.size()};
}

std::vector<PropertyCheck> check_properties(const drag::DragLawKernels& law, const ComparisonBed& bed) {
  return {check_stokes_limit(law),    check_single_sphere(law), check_crowding(law), check_rise_with_slip(law),
          check_turbulent_limit(law), check_derivative(law),    check_jumps(law),    check_expansion(law, bed)};
}

double bed_velocity(const drag::DragLawKernels& law, const ComparisonBed& bed, double voidage) {
  try {
    return fluidisation::superficial_velocity(law, bed.bed.sphere, bed.liquid, voidage);
  } catch (const std::domain_error&) {
    return nothing;
  }
}

bool bed_in_range(const drag::DragLawKernels& law, const ComparisonBed& bed, double voidage,
                  double superficial_velocity) {
  return in_range(law.info, voidage, reynolds_number(bed.liquid, bed.bed.sphere.diameter, superficial_velocity));
}

HomogeneousBed homogeneous_bed(const drag::DragLawKernels& law, const ComparisonBed& bed, double superficial_velocity) {
  try {
    const auto [voidage, regime] =
        fluidisation::bed_voidage(law, bed.bed.sphere, bed.liquid, superficial_velocity, bed.packed_voidage);
    const bool meant_for_bed = bed_in_range(law, bed, voidage, superficial_velocity);
    if (regime != fluidisation::BedRegime::expanded) return {voidage, nothing, meant_for_bed, false};
    const ForeignSphereInBed state{bed.bed.sphere, bed.foreign.sphere, bed.liquid, voidage, superficial_velocity};
    const double velocity = classification::force_balance_velocity(law, state);
    const double slip = velocity + state.interstitial_velocity();
    const double reynolds = reynolds_number(bed.liquid, bed.foreign.sphere.diameter, voidage * slip);
    return {voidage, velocity, meant_for_bed, meant_for_bed && in_range(law.info, voidage, reynolds)};
  } catch (const std::domain_error&) {
    return {nothing, nothing, false, false};
  }
}

Measurements measure_homogeneous_bed(const drag::DragLawKernels& law, const ComparisonBed& bed) {
  Measurements found;
  const auto put = [&](const MeasureKey& key, double value, const char* unit) {
    if (std::isfinite(value)) found[key] = {value, 0.0, 1, unit, "law"};
  };
  put({"minimum_fluidisation_velocity", bed.system}, bed_velocity(law, bed, bed.packed_voidage), "m/s");
  for (const PrintedPoint& point : bed.classification.points) {
    const double velocity = point.superficial_velocity;
    const HomogeneousBed answer = homogeneous_bed(law, bed, velocity);
    put(measure_key("voidage_centre_of_mass", bed.system, velocity), answer.voidage, "-");
    put(measure_key("classification_velocity", bed.system, velocity), answer.classification_velocity, "m/s");
  }
  return found;
}

std::vector<std::string> uses_outside_range(const drag::DragLawKernels& law, const ComparisonBed& bed,
                                            const Measurements& measured) {
  std::vector<std::string> sentences;
  const auto look = [&](const std::string& what, const Range& range, const std::vector<MeasuredPoint>& points) {
    std::vector<MeasuredPoint> outside;
    std::ranges::copy_if(points, std::back_inserter(outside), [&](const MeasuredPoint& point) {
      return std::isfinite(point.value) && !range.contains(point.value);
    });
    if (outside.empty()) return;
    const auto [least, most] = std::ranges::minmax(outside, {}, &MeasuredPoint::value);
    const auto [slowest, fastest] = std::ranges::minmax(outside, {}, &MeasuredPoint::superficial_velocity);
    const auto interval = [](const std::string& from, const std::string& to) {
      return from == to ? from : from + " to " + to;
    };
    sentences.push_back(fmt::format("{} {} at {} m/s; the law is meant for {}", what,
                                    interval(fmt::format("{:.4g}", least.value), fmt::format("{:.4g}", most.value)),
                                    interval(fmt::format("{:.2f}", slowest.superficial_velocity),
                                             fmt::format("{:.2f}", fastest.superficial_velocity)),
                                    words_of(range)));
  };
  const Sphere& sphere = bed.bed.sphere;
  const Sphere& foreign = bed.foreign.sphere;
  std::vector<MeasuredPoint> voidages, bed_spheres, foreign_spheres;
  for (const PrintedPoint& point : bed.classification.points) {
    const double velocity = point.superficial_velocity;
    const HomogeneousBed found = homogeneous_bed(law, bed, velocity);
    if (std::isnan(found.classification_velocity)) continue;
    const double slip = found.classification_velocity + velocity / found.voidage;
    voidages.push_back({velocity, found.voidage});
    bed_spheres.push_back({velocity, reynolds_number(bed.liquid, sphere.diameter, velocity)});
    foreign_spheres.push_back({velocity, reynolds_number(bed.liquid, foreign.diameter, found.voidage * slip)});
  }
  const double fluidised = bed_velocity(law, bed, bed.packed_voidage);
  const std::string of_bed = "Re of the " + bed.bed.material;
  const std::string of_foreign = fmt::format("Re of the {} sphere", bed.foreign.material);
  look("Minimum fluidisation: voidage", law.info.voidage, {{fluidised, bed.packed_voidage}});
  look("Minimum fluidisation: " + of_bed, law.info.reynolds,
       {{fluidised, reynolds_number(bed.liquid, sphere.diameter, fluidised)}});
  look("Homogeneous bed: voidage", law.info.voidage, voidages);
  look("Homogeneous bed: " + of_bed, law.info.reynolds, bed_spheres);
  look("Homogeneous bed: " + of_foreign, law.info.reynolds, foreign_spheres);
  look(fmt::format("Runs: lowest voidage at the {} sphere", bed.foreign.material), law.info.voidage,
       measured_points(measured, "local_voidage_minimum", bed.system));
  look("Runs: " + of_foreign, law.info.reynolds, measured_points(measured, "terminal_reynolds", bed.system));
  return sentences;
}

double seconds_per_evaluation(const drag::DragLawKernels& law) {
  using Clock = std::chrono::steady_clock;
  std::array<double, 256> voidage{}, reynolds{}, drag{};
  for (std::size_t i = 0; i < voidage.size(); ++i) {
    voidage[i] = 0.4 + 0.5 * static_cast<double>(i) / 256.0;
    reynolds[i] = 1.0 + 4.0 * static_cast<double>((37 * i) % 256);
  }
  // The fastest of several rounds: others use the machine too.
  double fastest = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 20; ++round) {
    constexpr int blocks = 40;
    const auto start = Clock::now();
    for (int block = 0; block < blocks; ++block) law.drag(voidage.data(), reynolds.data(), drag.data(), drag.size());
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    fastest = std::min(fastest, seconds / (blocks * static_cast<double>(drag.size())));
  }
  return fastest;
}

DragFindings characterise(const drag::DragLawKernels& law, const ComparisonBed& bed) {
  return {check_properties(law, bed), bed_velocity(law, bed, bed.packed_voidage), seconds_per_evaluation(law)};
}

}  // namespace slfb::compare
