#include "experiments/peng_2014/own_quantities.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numeric>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "experiments/peng_2014/paper_conditions.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/quantities/over_runs.hpp"

namespace slfb::paper {
namespace {

/// Fig. 7: a drop that was followed for a shorter time without reaching the bottom says nothing; one that rests on the
/// bed or in it does not fall.
Quantity falling_after(int seconds) {
  Quantity quantity{
      fmt::format("falling_after_{}_s", seconds), "-",
      fmt::format("share of drops that still fall after {} s", seconds),
      fmt::format("1 for a drop that is above the bottom and not at rest {} s after its release, else 0.", seconds),
      OfDrop([=](const DropView& drop) -> std::optional<double> {
        const DropStatistics& statistics = drop.statistics;
        if (statistics.time_to_bottom && *statistics.time_to_bottom < seconds) return 0.0;
        if (statistics.time_followed < seconds) return std::nullopt;
        return statistics.rests ? 0.0 : 1.0;
      })};
  quantity.lowest = 0.0;
  quantity.highest = 1.0;
  quantity.yes_or_no = true;
  quantity.needs = {Recorded::sphere_height};
  return quantity;
}

std::optional<double> over_equation_40(const DropNumbers& numbers, std::optional<double> voidage) {
  const auto force = numbers.of_drop("collision_force_ratio");
  if (!force || !voidage) return std::nullopt;
  const ForeignSphereInBed state{
      .bed = {}, .foreign = {}, .liquid = {}, .voidage = *voidage, .superficial_velocity = 0.0};
  return *force / collision::Peng2014{}(state, 0.0) - 1.0;
}

std::optional<double> equation_40_deviation(const DropNumbers& numbers) {
  const auto voidage = numbers.bed.find("voidage_centre_of_mass");
  return over_equation_40(numbers, voidage == numbers.bed.end() ? std::nullopt : std::optional(voidage->second.mean));
}

std::optional<double> equation_40_deviation_as_printed(const DropNumbers& numbers) {
  return over_equation_40(numbers, voidage_by_equation_36(numbers.system, numbers.superficial_velocity));
}

/// Fig. 26.
OfAllSystems share_near_equation_40(std::string deviation) {
  return [=](const Measurements& measurements) -> std::optional<Measurement> {
    std::size_t within = 0, runs = 0;
    for (const auto& [key, measured] : measurements) {
      if (key.quantity != deviation || !key.at || !key.detail.empty()) continue;
      ++runs;
      within += std::abs(measured.value) <= peng_2014().value("equation_40_most");
    }
    if (runs < 2) return std::nullopt;
    Measurement share{.value = static_cast<double>(within) / static_cast<double>(runs), .samples = runs};
    share.interval = share_interval(within, runs);
    share.half_width = 0.5 * (share.interval->second - share.interval->first);
    return share;
  };
}

/// §5.2: how much faster V_2 rises below 0.09 m/s than above it, up to 0.24 m/s.
std::optional<Measurement> early_rise(const Measurements& measurements, const std::string& system,
                                      const MeasuringRules&) {
  const auto at = [&](double velocity) {
    const auto found = measurements.find(measure_key("classification_velocity", system, velocity));
    return found == measurements.end() ? nullptr : &found->second;
  };
  const Measurement* const low = at(0.06);
  const Measurement* const middle = at(0.09);
  const Measurement* const high = at(0.24);
  if (low == nullptr || middle == nullptr || high == nullptr) return std::nullopt;
  const double early = (middle->value - low->value) / 0.03;
  const double late = (high->value - middle->value) / 0.15;
  const double ratio = early / late;
  LinearNumber error;
  error.add(1.0 / (0.03 * late) + ratio / (0.15 * late), *middle);
  error.add(1.0 / (0.03 * late), *low);
  error.add(ratio / (0.15 * late), *high);
  return Measurement{ratio, std::sqrt(error.variance), 3, "", ""};
}

/// §5.4.2, Fig. 20: slope of ln f over the solid fraction above 0.4 over that below, straight lines by least squares.
/// `solids` of a superficial velocity.
std::optional<Measurement> steepness(const Measurements& measurements, const std::string& system,
                                     const std::function<std::optional<double>(double)>& solids) {
  struct Line {
    std::vector<double> x;
    std::vector<Measurement> y;
    [[nodiscard]] std::optional<LinearNumber> slope() const {
      if (x.size() < 2) return std::nullopt;
      const double middle = std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
      double squares = 0.0;
      for (const double at : x) squares += (at - middle) * (at - middle);
      LinearNumber result;
      for (std::size_t k = 0; k < x.size(); ++k) result.add((x[k] - middle) / squares, y[k]);
      return result;
    }
  } dense, dilute;
  for (const auto& [velocity, frequency] : over_numbers(measurements, "collision_frequency", system)) {
    const auto at = solids(velocity);
    if (!at || !(frequency.value > 0.0)) continue;
    Line& line = *at >= peng_2014().value("steep_solid_fraction") ? dense : dilute;
    line.x.push_back(*at);
    line.y.push_back({.value = std::log(frequency.value), .half_width = frequency.half_width / frequency.value});
  }
  const auto above = dense.slope(), below = dilute.slope();
  if (!above || !below) return std::nullopt;
  const double ratio = above->value / below->value;
  return Measurement{
      .value = ratio,
      .half_width = std::hypot(std::sqrt(above->variance), ratio * std::sqrt(below->variance)) / std::abs(below->value),
      .samples = dense.x.size() + dilute.x.size()};
}

std::optional<Measurement> steepness_over_our_voidage(const Measurements& measurements, const std::string& system,
                                                      const MeasuringRules&) {
  const auto voidages = over_numbers(measurements, "voidage_centre_of_mass", system);
  return steepness(measurements, system, [&](double velocity) -> std::optional<double> {
    const auto found = voidages.find(velocity);
    return found == voidages.end() ? std::nullopt : std::optional(1.0 - found->second.value);
  });
}

std::optional<Measurement> steepness_over_printed_voidage(const Measurements& measurements, const std::string& system,
                                                          const MeasuringRules&) {
  return steepness(measurements, system, [&](double velocity) -> std::optional<double> {
    const auto voidage = voidage_by_equation_36(system, velocity);
    return voidage ? std::optional(1.0 - *voidage) : std::nullopt;
  });
}

std::vector<Quantity> of_laws() {
  const auto none = OfNoRun{};
  return {
      {"particle_count", "-", "number of spheres of the bed", "Mass of the bed over the mass of one sphere.", none},
      {"glass_density", "kg/m³", "density of the glass",
       "Mass of the bed over the volume of its printed number of spheres.", none},
      {"fluidised_mass", "kg", "mass of the bed", "That fills the packed height at the printed density and packing.",
       none},
      {"bed_weight_pressure", "Pa", "apparent weight of the bed",
       "Weight less buoyancy over the section of the column.", none},
      {"pressure_excess", "-", "excess of the plateau", "1 minus the apparent weight over the printed plateau.", none},
      {"packed_pressure", "Pa", "pressure drop of the packed bed", "By a drag law at the voidage of the packed bed.",
       none},
      {"homogeneous_voidage", "-", "voidage of a homogeneous bed",
       "Voidage at which a drag law carries the apparent weight of evenly spread spheres.", none},
      {"voidage_difference", "-", "homogeneous minus printed voidage", "At the velocities of the captions of Fig. 13.",
       none},
      {"collision_force", "-", "collision force over weight by a law", "Mean collision force on the steel sphere.",
       none},
      {"collision_force_peak_voidage", "-", "voidage of the largest collision force", "Where a law has its maximum.",
       none},
      {"collision_force_deviation", "-", "deviation of a force law from Eq. 40", "Mean of its magnitude over Table 2.",
       none},
      {"classification_deviation", "-", "deviation of a law from Table 2", "Its V_2 over that of Table 2, minus 1.",
       none},
      {"classification_deviation_mean", "-", "mean deviation of a law from Table 2",
       "Mean of its magnitude over the rows of Table 2.", none},
      {"classification_velocity_lower", "m/s", "lower end of a law's V_2", "Over all values of its free function.",
       none},
      {"classification_velocity_upper", "m/s", "upper end of a law's V_2", "Over all values of its free function.",
       none},
      {"classification_deviation_smallest", "-", "smallest deviation of a law from Table 2",
       "Over all values of its free function.", none},
      {"classification_deviation_largest", "-", "largest deviation of a law from Table 2",
       "Over all values of its free function.", none},
      {"wet_restitution", "-", "restitution in the liquid", "Over the dry one, at √q_p² of Fig. 18.", none},
      {"buoyancy_ratio", "-", "buoyancy over weight", "Density of the liquid over that of the sphere.", none},
      {"contact_time", "s", "duration of a contact", "With the printed stiffness and restitution.", none},
      {"steps_per_contact", "-", "steps of a contact", "Its duration over the printed step.", none},
      {"mean_cell_size", "m", "mean size of a cell", "Cube root of the column's volume over the number of cells.",
       none},
      {"cell_fraction", "-", "sphere over cell", "Volume of the steel sphere over that of a mean cell.", none},
      {"centroid_volume_error", "-", "volume misplaced by the centroid method",
       "Of a sphere whose centre lies just inside a cell.", none},
      {"particle_meshing_volume_error", "-", "volume misplaced by pieces of a sphere",
       "Largest error of the volume on one side of a plane.", none},
      {"overlap", "-", "overlap under a force", "Static, over the radius of the sphere.", none},
      {"restitution", "-", "restitution as the solver makes it", "Two spheres of the bed meet head-on.", none},
      {"sliding_friction", "-", "friction as the solver makes it", "Deceleration over g of a sphere that slides.",
       none},
      {"frozen_bed_gradient", "Pa/m", "pressure gradient of a frozen bed", "Liquid through spheres on a cubic lattice.",
       none},
  };
}

}  // namespace

std::vector<Quantity> own_quantities() {
  std::vector<Quantity> list{
      falling_after(15),
      falling_after(30),
      {"equation_40_deviation", "-", "deviation of the collision force from Eq. 40",
       "Collision force over weight of a drop over Eq. 40 at the voidage of its bed, minus 1.",
       OfDropNumbers(equation_40_deviation)},
      {"equation_40_deviation_at_printed_voidage", "-", "the same at the voidage of Eq. 36",
       "Collision force over weight of a drop over Eq. 40 at the voidage that Eq. 36 has for the superficial velocity, "
       "minus 1.",
       OfDropNumbers(equation_40_deviation_as_printed)},
      {"classification_velocity_rise_ratio", "-", "early over late rise of V_2",
       "Rise of V_2 per velocity from 0.06 to 0.09 m/s over that from 0.09 to 0.24 m/s.", OfSystem(early_rise)},
      {"collision_frequency_steepness", "-", "steepness of the collision frequency above over below α_S = 0.4",
       "Slope of ln f over the solid fraction of our beds from 0.4 on over the slope below.",
       OfSystem(steepness_over_our_voidage), true},
      {"collision_frequency_steepness_at_printed_voidage", "-", "the same over the solid fraction of Eq. 36",
       "The same over the solid fraction that Eq. 36 has for the superficial velocity.",
       OfSystem(steepness_over_printed_voidage), true},
      {"equation_40_share_within_10_percent", "-", "share of runs near Eq. 40",
       "Share of the runs without variant whose collision force lies within 10 % of Eq. 40.",
       share_near_equation_40("equation_40_deviation")},
      {"equation_40_share_within_10_percent_at_printed_voidage", "-", "the same at the voidage of Eq. 36",
       "The same with Eq. 40 at the voidage that Eq. 36 has for the superficial velocity.",
       share_near_equation_40("equation_40_deviation_at_printed_voidage")}};
  for (Quantity& quantity : of_laws()) list.push_back(std::move(quantity));
  return list;
}

}  // namespace slfb::paper
