#include <cmath>
#include <numeric>

#include "correlations/collision/collision_frequency/simonin_1991.hpp"
#include "correlations/collision/radial_distribution/lun_savage_1986.hpp"
#include "correlations/collision/stokes_number.hpp"
#include "experiments/quantities/over_runs.hpp"
#include "experiments/quantities/quantity.hpp"
#include "experiments/quantities/run_summary.hpp"

namespace slfb {
namespace {

constexpr bool depends_on_stiffness = true;

/// The bed before anything is dropped: samples from the start of fluidisation, or from the last change of the liquid's
/// velocity, to the first release.
std::vector<double> undisturbed(const BedSeries& bed, const std::vector<double>& history) {
  std::vector<double> values;
  for (std::size_t i = 0; i < bed.time.size(); ++i) {
    if (bed.foreign_present[i] > 0.5) break;
    const bool recorded = i > 0 && i < bed.superficial_velocity.size();
    if (recorded && bed.superficial_velocity[i] != bed.superficial_velocity[i - 1]) values.clear();
    if (bed.time[i] >= 0.0) values.push_back(history[i]);
  }
  return values;
}

/// Mean over the undisturbed bed after its transient; `derive` turns a sample of the history into the quantity.
template <class Derive>
OfBed mean_over_bed(std::vector<double> BedSeries::*history, Derive derive) {
  return [=](const RunView& run) -> std::optional<SeriesEstimate> {
    std::vector<double> values = undisturbed(run.result.bed, run.result.bed.*history);
    if (values.empty()) return std::nullopt;
    for (double& value : values) value = derive(run, value);
    return estimate_steady_mean(values);
  };
}
OfBed mean_over_bed(std::vector<double> BedSeries::*history) {
  return mean_over_bed(history, [](const RunView&, double value) { return value; });
}

/// u'_L: mean over the samples, each the mean of |u − ū| over the cells of the window.
OfBed fluctuation(std::vector<double> LiquidFluctuation::*series) {
  return [=](const RunView& run) -> std::optional<SeriesEstimate> {
    const auto& values = run.result.fluctuation.*series;
    return values.empty() ? std::nullopt : std::optional(estimate_mean(values));
  };
}

OfRun of_plane(double PlaneStatistics::*member) {
  return [=](const RunView& run) -> std::optional<double> {
    const auto plane = analyse_plane(run.result.plane, run.bed_top());
    if (!plane || !std::isfinite((*plane).*member)) return std::nullopt;
    return (*plane).*member;
  };
}

OfDrop of_drop(std::optional<double> DropStatistics::*member) {
  return [=](const DropView& drop) { return drop.statistics.*member; };
}

OfDrop of_line(double ClassificationFit::*member) {
  return [=](const DropView& drop) -> std::optional<double> {
    if (!drop.statistics.classification) return std::nullopt;
    return (*drop.statistics.classification).*member;
  };
}

/// f d/√q_p² [-].
std::optional<double> dimensionless_frequency(const DropView& drop) {
  const auto energy = drop.run.mean_of_bed("fluctuating_energy");
  if (!drop.statistics.collision_frequency || !energy || !(*energy > 0.0)) return std::nullopt;
  return *drop.statistics.collision_frequency * drop.run.bed_species().diameter / std::sqrt(*energy);
}

std::optional<double> ratio_to_kinetic_theory(const DropView& drop) {
  const auto frequency = dimensionless_frequency(drop);
  const auto voidage = drop.run.mean_of_bed("voidage_centre_of_mass"),
             energy = drop.run.mean_of_bed("fluctuating_energy");
  const collision::LunSavage1986 contact_value;
  if (!frequency || !voidage || 1.0 - *voidage >= contact_value.packed_solids) return std::nullopt;
  const double diameter = drop.run.bed_species().diameter;
  const collision::CollisionState state{.solids = 1.0 - *voidage,
                                        .bed_diameter = diameter,
                                        .foreign_diameter = diameter,
                                        .kinetic_energy = *energy,
                                        .contact_value = contact_value(1.0 - *voidage)};
  return *frequency / collision::dimensionless_frequency(collision::Simonin1991{}(state), state);
}

double total(std::span<const RunSummary> runs, const std::string& fact) {
  return std::accumulate(runs.begin(), runs.end(), 0.0, [&](double sum, const RunSummary& run) {
    const auto found = run.run.find(fact);
    return found == run.run.end() ? sum : sum + found->second;
  });
}

OfSystem of_curve(std::optional<Measurement> PressureCurve::*member) {
  return [=](const Measurements& measurements, const std::string& system, const MeasuringRules& rules) {
    return pressure_curve(over_numbers(measurements, "pressure_drop", system), rules.packed_up_to,
                          rules.fluidised_from).*
           member;
  };
}

std::vector<Quantity> of_the_bed() {
  return {
      {"pressure_drop", "Pa", "pressure drop of the bed",
       "Difference of the pressure below and above the bed without its static part, mean over the undisturbed bed.",
       mean_over_bed(&BedSeries::pressure_drop)},
      {"bed_top", "m", "height of the top of the bed",
       "Height of the centres of the uppermost spheres, mean over the undisturbed bed.",
       mean_over_bed(&BedSeries::bed_top)},
      {"voidage_centre_of_mass", "-", "voidage of the bed",
       "1 − V_s/(A h): the spheres' volume V_s over a column of section A, filled evenly up to h, twice the height of "
       "their centre of mass.",
       mean_over_bed(&BedSeries::centre_of_mass_height,
                     [](const RunView& run, double height) {
                       return voidage_from_height(run.solids_volume(), run.scene.geometry.cross_section(),
                                                  2.0 * height);
                     })},
      {"voidage_bed_top", "-", "voidage of the bed by its top",
       "The same with the height of the top of the bed and half a diameter, which stands above the uppermost centres.",
       mean_over_bed(&BedSeries::bed_top,
                     [](const RunView& run, double height) {
                       return voidage_from_height(run.solids_volume(), run.scene.geometry.cross_section(),
                                                  height + 0.5 * run.bed_species().diameter);
                     })},
      {"fluctuating_energy", "m²/s²", "fluctuating kinetic energy of the spheres",
       "q_p²: mean of |v − v̄|² over the spheres of the bed, v̄ their mean velocity.",
       mean_over_bed(&BedSeries::fluctuating_energy)},
      {"local_fluctuating_energy", "m²/s²", "fluctuating kinetic energy about the local mean",
       "The same about the mean velocity of the spheres nearby, so that circulation of the bed does not count.",
       mean_over_bed(&BedSeries::local_fluctuating_energy)},
      {"stokes_number", "-", "Stokes number of the spheres",
       "ρ_P √q_p² d/(9 μ), with the fluctuating kinetic energy for the velocity.",
       mean_over_bed(
           &BedSeries::fluctuating_energy,
           [](const RunView& run, double energy) {
             const Species& bed = run.bed_species();
             const Liquid& liquid = run.scene.liquid;
             return collision::stokes_number({bed.diameter, bed.density}, {liquid.density, liquid.viscosity}, energy);
           })},
      {"contacts_per_particle", "-", "contacts of a sphere of the bed",
       "Mean number of spheres that touch a sphere of the bed.", mean_over_bed(&BedSeries::contacts_per_particle),
       depends_on_stiffness},
      {"maximum_overlap_mean", "-", "largest overlap in the bed",
       "Largest overlap of two spheres over the radius of the smaller one, mean over the undisturbed bed.",
       mean_over_bed(&BedSeries::maximum_overlap), depends_on_stiffness},
      {"liquid_fluctuation", "m/s", "fluctuation of the liquid's velocity",
       "u'_L: mean of |u − ū| over time and the cells of the plane y = 0 in the window of the scene, ū the mean over "
       "these cells.",
       fluctuation(&LiquidFluctuation::series_vector)},
      {"liquid_fluctuation_vertical", "m/s", "fluctuation of the liquid's vertical velocity",
       "The same of the vertical component alone.", fluctuation(&LiquidFluctuation::series_z)},
      {"packed_voidage", "-", "voidage of the packed bed", "Voidage of the bed when it has settled without flow.",
       OfRun([](const RunView& run) { return std::optional(run.result.packed_voidage); })},
      {"packed_height", "m", "height of the packed bed", "Height of the top of the settled bed.",
       OfRun([](const RunView& run) { return std::optional(run.result.packed_height); })},
      {"plane_voidage_deviation", "-", "unevenness of the bed",
       "Standard deviation of the voidage over the cells of the plane y = 0 below the top of the bed.",
       of_plane(&PlaneStatistics::voidage_deviation)},
      {"plane_vorticity_range", "1/s", "range of the vorticity",
       "Largest minus smallest vorticity about y in the plane y = 0 below the top of the bed.",
       of_plane(&PlaneStatistics::vorticity_range)},
      {"plane_speed_maximum", "m/s", "largest speed of the liquid",
       "Largest interstitial speed in the plane y = 0 below the top of the bed.",
       of_plane(&PlaneStatistics::speed_maximum)},
  };
}

std::vector<Quantity> of_drops() {
  return {
      {"classification_velocity", "m/s", "classification velocity V_2",
       "Speed at which a sphere settles through the bed: the slope of the line z = z_0 − V_2 t fitted to its passage "
       "through the window of height.",
       of_line(&ClassificationFit::velocity)},
      {"classification_intercept", "m", "intercept of the line of V_2",
       "z_0 of that line on the clock of the work; only of drops from the height of release.",
       OfDrop([](const DropView& drop) -> std::optional<double> {
         if (!drop.from_release_height || !drop.statistics.classification) return std::nullopt;
         return drop.statistics.classification->intercept;
       })},
      {"classification_r2", "-", "R² of the line of V_2", "Coefficient of determination of that line.",
       of_line(&ClassificationFit::r_squared)},
      {"time_to_bottom", "s", "time to the bottom",
       "From the release to the first touch of the distributor; only of drops from the height of release.",
       OfDrop([](const DropView& drop) {
         return drop.from_release_height ? drop.statistics.time_to_bottom : std::nullopt;
       })},
      {"bottom_fraction", "-", "share of drops that reach the bottom",
       "1 for a drop that touches the distributor before its time is over, else 0.",
       OfDrop([](const DropView& drop) { return std::optional(drop.statistics.time_to_bottom ? 1.0 : 0.0); })},
      {"terminal_velocity", "m/s", "terminal velocity above the bed",
       "Velocity of the falling sphere against the liquid in the last fifth of its way to the bed.",
       of_drop(&DropStatistics::terminal_velocity)},
      {"terminal_reynolds", "-", "Reynolds number above the bed", "ρ_L ε w d/μ over the same stretch.",
       of_drop(&DropStatistics::terminal_reynolds)},
      {"penetration", "m", "depth of a sphere that stays in the bed",
       "Surface of the bed minus the lowest point of a sphere that has come to rest.",
       of_drop(&DropStatistics::penetration)},
      {"collision_frequency", "1/s", "collision frequency of the falling sphere",
       "New contacts with spheres of the bed per second, from entering the bed to the bottom.",
       of_drop(&DropStatistics::collision_frequency), depends_on_stiffness},
      {"dimensionless_collision_frequency", "-", "dimensionless collision frequency",
       "f d/√q_p², with the diameter d and the fluctuating kinetic energy of the bed's spheres.",
       OfDrop(dimensionless_frequency), depends_on_stiffness},
      {"ktgf_ratio", "-", "collision frequency over that of the kinetic theory",
       "Dimensionless frequency over that of Simonin (1991) with the contact value of Lun and Savage (1986) at the "
       "solid fraction of the bed.",
       OfDrop(ratio_to_kinetic_theory), depends_on_stiffness},
      {"collision_force_ratio", "-", "collision force over weight",
       "Mean of |F_c|, the sum of the contact forces on the falling sphere, over its weight.",
       of_drop(&DropStatistics::force_ratio)},
      {"collision_force_ratio_of_mean", "-", "mean collision force over weight",
       "|mean of F_c| over the weight: sideways forces cancel.", of_drop(&DropStatistics::force_ratio_of_mean)},
      {"peak_force_ratio", "-", "largest collision force over weight", "Largest |F_c| of the passage over the weight.",
       of_drop(&DropStatistics::peak_force_ratio), depends_on_stiffness},
      {"collision_to_drag_ratio", "-", "collision force over drag", "Mean of |F_c| over the mean of |F_d,z|.",
       of_drop(&DropStatistics::collision_to_drag_ratio)},
      {"drag_ratio", "-", "drag over weight", "Mean of |F_d,z| on the falling sphere over its weight.",
       of_drop(&DropStatistics::drag_ratio)},
      {"pressure_gradient_ratio", "-", "pressure-gradient force over weight",
       "Mean of −V ∂p/∂z on the falling sphere over its weight, the static part included.",
       of_drop(&DropStatistics::pressure_gradient_ratio)},
      {"mean_contacts", "-", "contacts of the falling sphere",
       "Mean number of spheres that it touches, from entering the bed to the bottom.",
       of_drop(&DropStatistics::mean_contacts), depends_on_stiffness},
      {"maximum_contacts", "-", "most contacts of the falling sphere",
       "Largest number of spheres that it touches at once.", of_drop(&DropStatistics::maximum_contacts),
       depends_on_stiffness},
      {"contact_fraction", "-", "share of the passage in contact",
       "Part of the passage in which the falling sphere touches another.", of_drop(&DropStatistics::contact_fraction),
       depends_on_stiffness},
      {"lateral_travel", "-", "sideways travel of the falling sphere",
       "Length of its path in the horizontal plane over the height that it passes.",
       of_drop(&DropStatistics::lateral_travel)},
      {"local_voidage_mean", "-", "voidage at the falling sphere", "Mean over the passage of the voidage where it is.",
       of_drop(&DropStatistics::local_voidage_mean)},
      {"local_voidage_minimum", "-", "smallest voidage at the falling sphere", "Smallest value of the same.",
       of_drop(&DropStatistics::local_voidage_minimum)},
      {"local_voidage_maximum", "-", "largest voidage at the falling sphere", "Largest value of the same.",
       of_drop(&DropStatistics::local_voidage_maximum)},
  };
}

std::vector<Quantity> of_several_runs() {
  return {
      {"particles_removed", "-", "spheres washed out", "Spheres that left through the outlet, all runs of one key.",
       OfReplicates([](std::span<const RunSummary> runs) { return std::optional(total(runs, "particles_removed")); })},
      {"wall_seconds_per_simulated_second", "s/s", "computing time per simulated time",
       "Wall-clock time over simulated time, all runs of one key.",
       OfReplicates([](std::span<const RunSummary> runs) -> std::optional<double> {
         const double simulated = total(runs, "simulated_seconds");
         if (!(simulated > 0.0)) return std::nullopt;
         return total(runs, "wall_seconds") / simulated;
       })},
      {"pressure_plateau", "Pa", "pressure drop of the fluidised bed",
       "Mean pressure drop of the runs whose beds are surely fluidised.", of_curve(&PressureCurve::plateau)},
      {"packed_line_slope", "Pa s/m", "slope of the line through the packed bed",
       "Straight line through the pressure drops of the runs whose beds are surely packed, by least squares.",
       of_curve(&PressureCurve::slope)},
      {"packed_line_intercept", "Pa", "intercept of the line through the packed bed", "Of the same line.",
       of_curve(&PressureCurve::intercept)},
      {"minimum_fluidisation_velocity", "m/s", "minimum fluidisation velocity",
       "Superficial velocity at which that line crosses the pressure drop of the fluidised bed.",
       of_curve(&PressureCurve::crossing)},
  };
}

}  // namespace

const std::vector<Quantity>& general_quantities() {
  static const std::vector<Quantity> list = [] {
    std::vector<Quantity> all = of_the_bed();
    for (auto* more : {&of_drops, &of_several_runs})
      for (Quantity& quantity : more()) all.push_back(std::move(quantity));
    return all;
  }();
  return list;
}

}  // namespace slfb
