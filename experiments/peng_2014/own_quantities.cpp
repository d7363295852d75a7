#include "experiments/peng_2014/own_quantities.hpp"

#include <fmt/format.h>

#include <cmath>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "experiments/peng_2014/reference.hpp"
#include "experiments/quantities/over_runs.hpp"

namespace slfb::paper {
namespace {

/// Fig. 7: a drop that was followed for a shorter time without reaching the bottom says nothing; one that rests on the
/// bed or in it does not fall.
Quantity falling_after(int seconds) {
  return {fmt::format("falling_after_{}_s", seconds), "-",
          fmt::format("share of drops that still fall after {} s", seconds),
          fmt::format("1 for a drop that is above the bottom and not at rest {} s after its release, else 0.", seconds),
          OfDrop([=](const DropView& drop) -> std::optional<double> {
            const DropStatistics& statistics = drop.statistics;
            if (statistics.time_to_bottom && *statistics.time_to_bottom < seconds) return 0.0;
            if (statistics.time_followed < seconds) return std::nullopt;
            return statistics.penetration ? 0.0 : 1.0;
          })};
}

std::optional<double> equation_40_deviation(const DropView& drop) {
  const auto voidage = drop.run.mean_of_bed("voidage_centre_of_mass");
  if (!drop.statistics.force_ratio || !voidage) return std::nullopt;
  const ForeignSphereInBed state{
      .bed = {}, .foreign = {}, .liquid = {}, .voidage = *voidage, .superficial_velocity = 0.0};
  return *drop.statistics.force_ratio / collision::Peng2014{}(state, 0.0) - 1.0;
}

/// Fig. 26.
std::optional<Measurement> equation_40_share(const Measurements& measurements) {
  double within = 0.0;
  std::size_t runs = 0;
  for (const auto& [key, deviation] : measurements) {
    if (key.quantity != "equation_40_deviation" || !key.at || !key.detail.empty()) continue;
    ++runs;
    if (std::abs(deviation.value) <= peng_2014().value("equation_40_most")) within += 1.0;
  }
  if (runs < 2) return std::nullopt;
  // Wald's interval with two successes and failures added (Agresti and Coull 1998, Am. Stat. 52, 119).
  const double trials = static_cast<double>(runs) + 4.0, share = (within + 2.0) / trials;
  return Measurement{within / static_cast<double>(runs), 1.96 * std::sqrt(share * (1.0 - share) / trials), runs, "",
                     ""};
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
       OfDrop(equation_40_deviation)},
      {"classification_velocity_rise_ratio", "-", "early over late rise of V_2",
       "Rise of V_2 per velocity from 0.06 to 0.09 m/s over that from 0.09 to 0.24 m/s.", OfSystem(early_rise)},
      {"equation_40_share_within_10_percent", "-", "share of runs near Eq. 40",
       "Share of the runs without variant whose collision force lies within 10 % of Eq. 40.",
       OfAllSystems(equation_40_share)}};
  for (Quantity& quantity : of_laws()) list.push_back(std::move(quantity));
  return list;
}

}  // namespace slfb::paper
