#include <cmath>
#include <map>
#include <numeric>
#include <string_view>

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

double voidage_of(const RunView& run, double height) {
  return voidage_from_height(run.solids_volume(), run.scene.geometry.cross_section(), 2.0 * height);
}

std::optional<double> voidage_drift(const RunView& run) {
  std::vector<double> values = undisturbed(run.result.bed, run.result.bed.centre_of_mass_height);
  if (values.empty()) return std::nullopt;
  for (double& value : values) value = voidage_of(run, value);
  return change_at_the_end(values);
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

/// A dimensionless frequency over that of the kinetic theory, which does not depend on diameter and energy then.
std::optional<double> over_kinetic_theory(double frequency, double voidage) {
  const collision::LunSavage1986 contact_value;
  if (1.0 - voidage >= contact_value.packed_solids) return std::nullopt;
  const collision::CollisionState state{.solids = 1.0 - voidage,
                                        .bed_diameter = 1.0,
                                        .foreign_diameter = 1.0,
                                        .kinetic_energy = 1.0,
                                        .contact_value = contact_value(1.0 - voidage)};
  return frequency / collision::dimensionless_frequency(collision::Simonin1991{}(state), state);
}

std::optional<double> ratio_to_kinetic_theory(const DropView& drop) {
  const auto frequency = dimensionless_frequency(drop);
  const auto voidage = drop.run.mean_of_bed("voidage_centre_of_mass");
  return frequency && voidage ? over_kinetic_theory(*frequency, *voidage) : std::nullopt;
}

double total(std::span<const RunSummary> runs, const std::string& fact) {
  return std::accumulate(runs.begin(), runs.end(), 0.0, [&](double sum, const RunSummary& run) {
    const auto found = run.run.find(fact);
    return found == run.run.end() ? sum : sum + found->second;
  });
}

/// How much higher the fluidised bed stands than the settled one.
std::optional<double> expansion(const RunView& run) {
  const auto voidage = run.mean_of_bed("voidage_centre_of_mass");
  if (!voidage || !(*voidage < 1.0)) return std::nullopt;
  return (1.0 - run.result.packed_voidage) / (1.0 - *voidage) - 1.0;
}

std::optional<double> largest_angular_speed(const DropView& drop) {
  constexpr double coarsest_interval = 2e-3;  // a contact changes the spin from one sample to the next
  const DropSeries& series = drop.series;
  if (series.time.size() < 2 || series.time[1] - series.time[0] > coarsest_interval) return std::nullopt;
  return *std::ranges::max_element(series.angular_speed);
}

/// In the frame of the column, before the bed is reached.
std::optional<double> fall_speed(const DropNumbers& numbers) {
  const auto slip = numbers.of_drop("terminal_velocity");
  return slip ? std::optional(*slip - numbers.superficial_velocity) : std::nullopt;
}

Quantity within(double lowest, double highest, Quantity quantity) {
  quantity.lowest = lowest;
  quantity.highest = highest;
  return quantity;
}
constexpr double unlimited = std::numeric_limits<double>::infinity();
/// A whole number for each drop.
Quantity a_count(Quantity quantity) {
  quantity.step = 1.0;
  return within(0.0, unlimited, std::move(quantity));
}

Quantity not_negative(Quantity quantity) { return within(0.0, unlimited, std::move(quantity)); }
Quantity a_share(Quantity quantity) { return within(0.0, 1.0, std::move(quantity)); }

Quantity of_packing(Quantity quantity) {
  quantity.of_packing = true;
  return quantity;
}
Quantity yes_or_no(Quantity quantity) {
  quantity.yes_or_no = true;
  return a_share(std::move(quantity));
}
Quantity from_thinned(Quantity quantity) {
  quantity.from_thinned = true;
  return quantity;
}
Quantity bounded(BoundOfDrop bound, Quantity quantity) {
  quantity.bound = std::move(bound);
  return quantity;
}

/// Of a drop that was followed for so long without reaching the bottom.
std::optional<BoundedSample> longer_than_followed(const DropView& drop) {
  if (!drop.from_release_height || drop.statistics.time_to_bottom) return std::nullopt;
  return BoundedSample{drop.statistics.time_followed, BoundedSample::Kind::at_least};
}

/// A sphere that is in the bed for so long without having left the window of height through its bottom passes it no
/// faster than this.
std::optional<BoundedSample> slower_than_a_passage(const DropView& drop) {
  const DropSeries& series = drop.series;
  const auto [bottom, top] = drop.run.rules.classification_window.value_or(drop.run.scene.recording.fluctuation_window);
  if (series.z.empty() || drop.statistics.classification || series.z.back() < bottom) return std::nullopt;
  if (rises_through_window(series, bottom)) return std::nullopt;
  const double entry = std::max(top, drop.run.bed_top());
  const auto below = std::ranges::find_if(series.z, [&](double z) { return z < entry; });
  if (below == series.z.end()) return std::nullopt;
  const double time = series.time.back() - series.time[static_cast<std::size_t>(below - series.z.begin())];
  if (!(time > 0.0)) return std::nullopt;
  return BoundedSample{(top - bottom) / time, BoundedSample::Kind::at_most};
}

/// Time from the release at which the line of V_2 stands at the middle of its window.
std::optional<double> time_to_window(const DropNumbers& numbers) {
  const auto intercept = numbers.of_drop("classification_intercept"),
             speed = numbers.of_drop("classification_velocity");
  if (!intercept || !speed || *speed == 0.0) return std::nullopt;
  const auto [bottom, top] = numbers.rules.classification_window.value_or(numbers.scene.recording.fluctuation_window);
  return (*intercept - 0.5 * (bottom + top)) / *speed - numbers.rules.release_clock(std::string(numbers.system));
}

std::optional<BoundedSample> later_than_followed(const DropView& drop) {
  if (drop.statistics.classification) return std::nullopt;
  return longer_than_followed(drop);
}

std::optional<double> line_residual(const DropNumbers& numbers) {
  const auto r_squared = numbers.of_drop("classification_r2");
  if (!r_squared) return std::nullopt;
  return std::sqrt(std::max(0.0, 1.0 - *r_squared));
}

/// The dimensionless frequency of a drop over the kinetic theory at the voidage that the work has for its velocity.
std::optional<double> ratio_to_kinetic_theory_as_printed(const DropNumbers& numbers) {
  const auto frequency = numbers.of_drop("dimensionless_collision_frequency");
  if (!frequency || !numbers.rules.printed_voidage) return std::nullopt;
  const auto voidage = numbers.rules.printed_voidage(numbers.system, numbers.superficial_velocity);
  return voidage ? over_kinetic_theory(*frequency, *voidage) : std::nullopt;
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
      a_share({"voidage_centre_of_mass", "-", "voidage of the bed",
               "1 − V_s/(A h): the spheres' volume V_s over a column of section A, filled evenly up to h, twice the "
               "height of "
               "their centre of mass.",
               mean_over_bed(&BedSeries::centre_of_mass_height, voidage_of)}),
      a_share({"voidage_bed_top", "-", "voidage of the bed by its top",
               "The same with the height of the top of the bed and half a diameter, which stands above the uppermost "
               "centres.",
               mean_over_bed(&BedSeries::bed_top,
                             [](const RunView& run, double height) {
                               return voidage_from_height(run.solids_volume(), run.scene.geometry.cross_section(),
                                                          height + 0.5 * run.bed_species().diameter);
                             })}),
      not_negative({"fluctuating_energy", "m²/s²", "fluctuating kinetic energy of the spheres",
                    "q_p²: mean of |v − v̄|² over the spheres of the bed, v̄ their mean velocity.",
                    mean_over_bed(&BedSeries::fluctuating_energy)}),
      not_negative(
          {"local_fluctuating_energy", "m²/s²", "fluctuating kinetic energy about the local mean",
           "The same about the mean velocity of the spheres nearby, so that circulation of the bed does not count.",
           mean_over_bed(&BedSeries::local_fluctuating_energy)}),
      not_negative({"stokes_number", "-", "Stokes number of the spheres",
                    "ρ_P √q_p² d/(9 μ), with the fluctuating kinetic energy for the velocity.",
                    mean_over_bed(&BedSeries::fluctuating_energy,
                                  [](const RunView& run, double energy) {
                                    const Species& bed = run.bed_species();
                                    const Liquid& liquid = run.scene.liquid;
                                    return collision::stokes_number({bed.diameter, bed.density},
                                                                    {liquid.density, liquid.viscosity}, energy);
                                  })}),
      not_negative({"contacts_per_particle", "-", "contacts of a sphere of the bed",
                    "Mean number of spheres that touch a sphere of the bed.",
                    mean_over_bed(&BedSeries::contacts_per_particle), depends_on_stiffness}),
      not_negative({"maximum_overlap_mean", "-", "largest overlap in the bed",
                    "Largest overlap of two spheres over the radius of the smaller one, mean over the undisturbed bed.",
                    mean_over_bed(&BedSeries::maximum_overlap), depends_on_stiffness}),
      not_negative({"liquid_fluctuation", "m/s", "fluctuation of the liquid's velocity",
                    "u'_L: mean of |u − ū| over time and the cells of the plane y = 0 in the window of the scene, ū "
                    "the mean over "
                    "these cells.",
                    fluctuation(&LiquidFluctuation::series_vector)}),
      not_negative({"liquid_fluctuation_vertical", "m/s", "fluctuation of the liquid's vertical velocity",
                    "The same of the vertical component alone.", fluctuation(&LiquidFluctuation::series_z)}),
      from_thinned({"voidage_drift", "-", "change of the bed's voidage at the end of its series",
                    "Mean voidage of the last quarter of the undisturbed bed less that of the quarter before.",
                    OfRun(voidage_drift)}),
      of_packing(a_share({"packed_voidage", "-", "voidage of the packed bed",
                          "Voidage of the bed when it has settled without flow.",
                          OfRun([](const RunView& run) { return std::optional(run.result.packed_voidage); })})),
      of_packing(
          not_negative({"packed_height", "m", "height of the packed bed", "Height of the top of the settled bed.",
                        OfRun([](const RunView& run) { return std::optional(run.result.packed_height); })})),
      from_thinned({"expansion", "-", "expansion of the bed",
                    "(1 − ε_0)/(1 − ε) − 1 of the bed's voidage ε and that of the settled one, ε_0.",
                    OfRun(expansion)}),
      from_thinned({"wall_voidage_excess", "-", "voidage at the wall less that in the core",
                    "In the plane y = 0 below the top of the bed: mean of the outermost cells less that of the middle "
                    "half of the section.",
                    of_plane(&PlaneStatistics::wall_excess)}),
      from_thinned({"wake_voidage_excess", "-", "voidage behind the falling sphere less that before it",
                    "In two balls of its size that touch it from above and from below, halfway through the bed.",
                    OfRun([](const RunView& run) { return wake_excess(run.result.snapshots); })}),
      not_negative({"plane_voidage_deviation", "-", "unevenness of the bed",
                    "Standard deviation of the voidage over the cells of the plane y = 0 below the top of the bed.",
                    of_plane(&PlaneStatistics::voidage_deviation)}),
      not_negative({"plane_vorticity_range", "1/s", "range of the vorticity",
                    "Largest minus smallest vorticity about y in the plane y = 0 below the top of the bed.",
                    of_plane(&PlaneStatistics::vorticity_range)}),
      not_negative({"plane_speed_maximum", "m/s", "largest speed of the liquid",
                    "Largest interstitial speed in the plane y = 0 below the top of the bed.",
                    of_plane(&PlaneStatistics::speed_maximum)}),
  };
}

std::vector<Quantity> of_drops() {
  return {
      bounded(slower_than_a_passage, {"classification_velocity", "m/s", "classification velocity V_2",
                                      "Speed at which a sphere settles through the bed: the slope of the line z = z_0 "
                                      "− V_2 t fitted to its passage "
                                      "through the window of height; negative of a sphere that rises from below it.",
                                      of_line(&ClassificationFit::velocity)}),
      {"classification_intercept", "m", "intercept of the line of V_2",
       "z_0 of that line on the clock of the work; only of drops from the height of release.",
       OfDrop([](const DropView& drop) -> std::optional<double> {
         if (!drop.from_release_height || !drop.statistics.classification) return std::nullopt;
         return drop.statistics.classification->intercept;
       })},
      a_share({"classification_r2", "-", "R² of the line of V_2", "Coefficient of determination of that line.",
               of_line(&ClassificationFit::r_squared)}),
      not_negative({"line_residual", "-", "what the line of V_2 leaves",
                    "√(1 − R²): standard deviation of the heights about that line over their own.",
                    OfDropNumbers(line_residual)}),
      bounded(later_than_followed,
              {"time_to_window", "s", "time to the middle of the window",
               "From the release to where the line of V_2 is at the middle of its window: (z_0 − z_m)/V_2 less the "
               "reading of the clock at the release.",
               OfDropNumbers(time_to_window)}),
      bounded(longer_than_followed,
              {"time_to_bottom", "s", "time to the bottom",
               "From the release to the first touch of the distributor; only of drops from the height of release.",
               OfDrop([](const DropView& drop) {
                 return drop.from_release_height ? drop.statistics.time_to_bottom : std::nullopt;
               })}),
      yes_or_no(
          {"bottom_fraction", "-", "share of drops that reach the bottom",
           "1 for a drop that touches the distributor before its time is over, else 0.",
           OfDrop([](const DropView& drop) { return std::optional(drop.statistics.time_to_bottom ? 1.0 : 0.0); })}),
      {"terminal_velocity", "m/s", "terminal velocity above the bed",
       "Velocity of the falling sphere against the liquid in the last fifth of its way to the bed.",
       of_drop(&DropStatistics::terminal_velocity)},
      {"fall_speed", "m/s", "speed of the fall above the bed",
       "Terminal velocity less the superficial velocity: in the frame of the column.", OfDropNumbers(fall_speed)},
      from_thinned({"angular_speed_maximum", "rad/s", "largest angular speed", "Largest |ω| of the falling sphere.",
                    OfDrop(largest_angular_speed)}),
      {"terminal_reynolds", "-", "Reynolds number above the bed", "ρ_L ε w d/μ over the same stretch.",
       of_drop(&DropStatistics::terminal_reynolds)},
      from_thinned(not_negative(
          {"sinking", "m", "depth to which a sphere sinks that comes to rest",
           "From its first contact with the bed to where it comes to rest; of the first drop "
           "into a bed, since later ones fall into the crater of those before.",
           OfDrop([](const DropView& drop) { return drop.first ? drop.statistics.sinking : std::nullopt; })})),
      not_negative({"collision_frequency", "1/s", "collision frequency of the falling sphere",
                    "New contacts with spheres of the bed per second, from entering the bed to the bottom.",
                    of_drop(&DropStatistics::collision_frequency), depends_on_stiffness}),
      not_negative({"dimensionless_collision_frequency", "-", "dimensionless collision frequency",
                    "f d/√q_p², with the diameter d and the fluctuating kinetic energy of the bed's spheres.",
                    OfDrop(dimensionless_frequency), depends_on_stiffness}),
      not_negative(
          {"ktgf_ratio", "-", "collision frequency over that of the kinetic theory",
           "Dimensionless frequency over that of Simonin (1991) with the contact value of Lun and Savage (1986) at the "
           "solid fraction of the bed.",
           OfDrop(ratio_to_kinetic_theory), depends_on_stiffness}),
      not_negative({"ktgf_ratio_at_printed_voidage", "-", "the same at the voidage of the work",
                    "The same ratio at the solid fraction that the work has for the superficial velocity.",
                    OfDropNumbers(ratio_to_kinetic_theory_as_printed), depends_on_stiffness}),
      not_negative({"collision_force_ratio", "-", "collision force over weight",
                    "Mean of |F_c|, the sum of the contact forces on the falling sphere, over its weight.",
                    of_drop(&DropStatistics::force_ratio)}),
      not_negative({"collision_force_ratio_of_mean", "-", "mean collision force over weight",
                    "|mean of F_c| over the weight: sideways forces cancel.",
                    of_drop(&DropStatistics::force_ratio_of_mean)}),
      not_negative({"peak_force_ratio", "-", "largest collision force over weight",
                    "Largest |F_c| of the passage over the weight.", of_drop(&DropStatistics::peak_force_ratio),
                    depends_on_stiffness}),
      not_negative({"collision_to_drag_ratio", "-", "collision force over drag",
                    "Mean of |F_c| over the mean of |F_d,z|.", of_drop(&DropStatistics::collision_to_drag_ratio)}),
      not_negative({"drag_ratio", "-", "drag over weight", "Mean of |F_d,z| on the falling sphere over its weight.",
                    of_drop(&DropStatistics::drag_ratio)}),
      {"pressure_gradient_ratio", "-", "pressure-gradient force over weight",
       "Mean of −V ∂p/∂z on the falling sphere over its weight, the static part included.",
       of_drop(&DropStatistics::pressure_gradient_ratio)},
      not_negative({"mean_contacts", "-", "contacts of the falling sphere",
                    "Mean number of spheres that it touches, from entering the bed to the bottom.",
                    of_drop(&DropStatistics::mean_contacts), depends_on_stiffness}),
      a_count({"maximum_contacts", "-", "most contacts of the falling sphere",
               "Largest number of spheres that it touches at once.", of_drop(&DropStatistics::maximum_contacts),
               depends_on_stiffness}),
      a_share({"contact_fraction", "-", "share of the passage in contact",
               "Part of the passage in which the falling sphere touches another.",
               of_drop(&DropStatistics::contact_fraction), depends_on_stiffness}),
      not_negative({"lateral_travel", "-", "sideways travel of the falling sphere",
                    "Length of its path in the horizontal plane over the height that it passes.",
                    of_drop(&DropStatistics::lateral_travel)}),
      a_share({"local_voidage_mean", "-", "voidage at the falling sphere",
               "Mean over the passage of the voidage where it is.", of_drop(&DropStatistics::local_voidage_mean)}),
      a_share({"local_voidage_minimum", "-", "smallest voidage at the falling sphere", "Smallest value of the same.",
               of_drop(&DropStatistics::local_voidage_minimum)}),
      a_share({"local_voidage_maximum", "-", "largest voidage at the falling sphere", "Largest value of the same.",
               of_drop(&DropStatistics::local_voidage_maximum)}),
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
      {"pressure_plateau_rise", "-", "rise of the plateau",
       "Of the straight line through the pressure drops of the runs whose beds are surely fluidised, from the lowest "
       "velocity to the highest, over their mean.",
       of_curve(&PressureCurve::plateau_rise)},
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

/// What of a bed of others suffices for a quantity; of what is not here, only runs of this suite have it.
const std::map<std::string_view, std::vector<Recorded>> sufficient{
    {"pressure_drop", {Recorded::pressure_drop}},
    {"bed_top", {Recorded::bed_top}},
    {"voidage_centre_of_mass", {Recorded::bed_centre_of_mass}},
    {"voidage_drift", {Recorded::bed_centre_of_mass}},
    {"voidage_bed_top", {Recorded::bed_top}},
    {"fluctuating_energy", {Recorded::sphere_velocities}},
    {"local_fluctuating_energy", {Recorded::sphere_velocities}},
    {"stokes_number", {Recorded::sphere_velocities}},
    {"packed_voidage", {Recorded::settled_bed}},
    {"packed_height", {Recorded::settled_bed}},
    {"expansion", {Recorded::settled_bed, Recorded::bed_centre_of_mass}},
    {"classification_velocity", {Recorded::sphere_height}},
    {"classification_intercept", {Recorded::sphere_height}},
    {"classification_r2", {Recorded::sphere_height}},
    {"line_residual", {Recorded::sphere_height}},
    {"time_to_window", {Recorded::sphere_height}},
    {"time_to_bottom", {Recorded::sphere_height}},
    {"bottom_fraction", {Recorded::sphere_height}},
    {"lateral_travel", {Recorded::sphere_height, Recorded::sphere_path, Recorded::bed_top}},
};

}  // namespace

const std::vector<Quantity>& general_quantities() {
  static const std::vector<Quantity> list = [] {
    std::vector<Quantity> all = of_the_bed();
    for (auto* more : {&of_drops, &of_several_runs})
      for (Quantity& quantity : more()) all.push_back(std::move(quantity));
    for (Quantity& quantity : all)
      if (const auto found = sufficient.find(quantity.id); found != sufficient.end()) quantity.needs = found->second;
    return all;
  }();
  return list;
}

}  // namespace slfb
