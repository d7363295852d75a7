#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <regex>
#include <set>
#include <stdexcept>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "correlations/collision/collision_frequency/simonin_1991.hpp"
#include "correlations/collision/radial_distribution/lun_savage_1986.hpp"
#include "correlations/collision/stokes_number.hpp"
#include "experiments/analysis.hpp"
#include "experiments/measure.hpp"
#include "experiments/reference_data.hpp"

namespace slfb {
namespace {

/// Velocities that separate the packed bed from the fluidised one in Fig. 5, on either side of U_mf = 0.042 m/s [m/s].
constexpr double packed_up_to = 0.0401;
constexpr double fluidised_from = 0.0599;

double cross_section(const Geometry& geometry) {
  return geometry.shape == Shape::cylinder ? std::numbers::pi / 4.0 * geometry.diameter * geometry.diameter
                                           : geometry.width[0] * geometry.width[1];
}

const Species& species_named(const Scene& scene, const std::string& name) {
  const auto found =
      std::find_if(scene.species.begin(), scene.species.end(), [&](const Species& s) { return s.name == name; });
  if (found == scene.species.end()) throw std::runtime_error("a run dropped the unknown species \"" + name + "\"");
  return *found;
}

const Species& bed_species(const Scene& scene) {
  const auto found =
      std::find_if(scene.species.begin(), scene.species.end(), [](const Species& s) { return s.count > 0; });
  if (found == scene.species.end()) throw std::runtime_error("a run has no bed particles");
  return *found;
}

/// Volume of the spheres that are still in the column [m³].
double solids_volume(const FinishedRun& run) {
  double volume = 0.0;
  std::int64_t count = 0;
  for (const Species& species : run.scene.species) {
    volume += static_cast<double>(species.count) * std::numbers::pi / 6.0 * std::pow(species.diameter, 3);
    count += species.count;
  }
  const double remaining = static_cast<double>(count - run.result.particles_removed) / static_cast<double>(count);
  return volume * remaining;
}

/// The bed before anything is dropped: samples from the start of fluidisation to the first release.
std::vector<double> undisturbed(const BedSeries& bed, const std::vector<double>& history) {
  std::vector<double> values;
  for (std::size_t i = 0; i < bed.time.size(); ++i) {
    if (bed.foreign_present[i] > 0.5) break;
    if (bed.time[i] >= 0.0) values.push_back(history[i]);
  }
  return values;
}

/// All runs that answer one key.
class RunGroup {
 public:
  RunGroup(const RunSpec& spec, std::vector<const FinishedRun*> runs, Measurements& measurements)
      : spec_(spec), runs_(std::move(runs)), measurements_(measurements) {}

  void measure() {
    measure_bed();
    measure_drops();
    measure_cost();
  }

 private:
  void add(std::string_view quantity, Measurement measurement) {
    std::string origin;
    for (const FinishedRun* run : runs_) origin += (origin.empty() ? "" : ", ") + run->result.name;
    measurement.origin = std::move(origin);
    measurements_[measure_key(quantity, spec_.system, spec_.superficial_velocity, spec_.variant)] =
        std::move(measurement);
  }

  /// One value per run or per drop, those that have none left out.
  void add_replicates(std::string_view quantity, const std::string& unit, const std::vector<double>& values) {
    if (values.empty()) return;
    const ReplicateEstimate estimate = estimate_replicates(values);
    add(quantity, {estimate.mean, estimate.half_width, estimate.samples, unit, ""});
  }

  template <class Value>
  void add_per_run(std::string_view quantity, const std::string& unit, Value value) {
    std::vector<double> values;
    for (const FinishedRun* run : runs_) values.push_back(value(*run));
    add_replicates(quantity, unit, values);
  }

  /// Mean over the undisturbed bed after its transient: the interval of the correlated series for one run, that of
  /// the replicates for several. `derive` turns a sample of the history into the quantity.
  template <class Derive>
  void add_series(std::string_view quantity, const std::string& unit, std::vector<double> BedSeries::*history,
                  Derive derive) {
    std::vector<double> means;
    SeriesEstimate last;
    for (const FinishedRun* run : runs_) {
      std::vector<double> values = undisturbed(run->result.bed, run->result.bed.*history);
      if (values.empty()) continue;
      std::transform(values.begin(), values.end(), values.begin(), [&](double value) { return derive(*run, value); });
      last = estimate_steady_mean(values);
      means.push_back(last.mean);
    }
    add_means(quantity, unit, means, last);
  }

  /// Means of one or more runs; the interval of a single one is that of its own series, `last`.
  void add_means(std::string_view quantity, const std::string& unit, const std::vector<double>& means,
                 const SeriesEstimate& last) {
    if (means.size() > 1) {
      add_replicates(quantity, unit, means);
    } else if (means.size() == 1) {
      add(quantity,
          {last.mean, last.half_width, static_cast<std::size_t>(std::max(1.0, last.effective_samples)), unit, ""});
    }
  }

  /// u'_L of Eq. 37: mean over the samples, each the mean of |u − ū| over the cells of the window.
  void add_fluctuation(std::string_view quantity, std::vector<double> LiquidFluctuation::*history) {
    std::vector<double> means;
    SeriesEstimate last;
    for (const FinishedRun* run : runs_) {
      const auto& values = run->result.fluctuation.*history;
      if (values.empty()) continue;
      last = estimate_mean(values);
      means.push_back(last.mean);
    }
    add_means(quantity, "m/s", means, last);
  }

  void measure_bed() {
    const auto as_recorded = [](const FinishedRun&, double value) { return value; };
    add_series("pressure_drop", "Pa", &BedSeries::pressure_drop, as_recorded);
    add_series("fluctuating_energy", "m²/s²", &BedSeries::fluctuating_energy, as_recorded);
    add_series("local_fluctuating_energy", "m²/s²", &BedSeries::local_fluctuating_energy, as_recorded);
    add_series("contacts_per_particle", "-", &BedSeries::contacts_per_particle, as_recorded);
    add_series("maximum_overlap_mean", "-", &BedSeries::maximum_overlap, as_recorded);
    add_series("bed_top", "m", &BedSeries::bed_top, as_recorded);
    add_series("voidage_centre_of_mass", "-", &BedSeries::centre_of_mass_height,
               [](const FinishedRun& run, double height) {
                 return voidage_from_height(solids_volume(run), cross_section(run.scene.geometry), 2.0 * height);
               });
    // The top is a height of centres; half a diameter of the uppermost particles stands above it.
    add_series("voidage_bed_top", "-", &BedSeries::bed_top, [](const FinishedRun& run, double height) {
      return voidage_from_height(solids_volume(run), cross_section(run.scene.geometry),
                                 height + 0.5 * bed_species(run.scene).diameter);
    });
    add_series("stokes_number", "-", &BedSeries::fluctuating_energy, [](const FinishedRun& run, double energy) {
      const Species& bed = bed_species(run.scene);
      return collision::stokes_number({bed.diameter, bed.density},
                                      {run.scene.liquid.density, run.scene.liquid.viscosity}, energy);
    });
    add_per_run("packed_voidage", "-", [](const FinishedRun& run) { return run.result.packed_voidage; });
    add_per_run("packed_height", "m", [](const FinishedRun& run) { return run.result.packed_height; });

    std::vector<double> voidage, vorticity, speed;
    for (const FinishedRun* run : runs_) {
      const auto plane = analyse_plane(run->result.plane, bed_top(*run));
      if (!plane) continue;
      voidage.push_back(plane->voidage_deviation);
      if (std::isfinite(plane->vorticity_range)) vorticity.push_back(plane->vorticity_range);
      if (std::isfinite(plane->speed_maximum)) speed.push_back(plane->speed_maximum);
    }
    add_replicates("plane_voidage_deviation", "-", voidage);
    add_replicates("plane_vorticity_range", "1/s", vorticity);
    add_replicates("plane_speed_maximum", "m/s", speed);
    add_fluctuation("liquid_fluctuation", &LiquidFluctuation::series_vector);
    add_fluctuation("liquid_fluctuation_vertical", &LiquidFluctuation::series_z);
  }

  /// Mean height of the top of the undisturbed bed; that of the packed bed where nothing was recorded [m].
  static double bed_top(const FinishedRun& run) {
    const auto top = undisturbed(run.result.bed, run.result.bed.bed_top);
    return top.empty() ? run.result.packed_height : estimate_steady_mean(top).mean;
  }

  static std::optional<double> mean_of_bed(const FinishedRun& run, const std::vector<double>& history) {
    const auto values = undisturbed(run.result.bed, history);
    if (values.empty()) return std::nullopt;
    return estimate_steady_mean(values).mean;
  }

  void measure_drops() {
    struct Drop {
      DropStatistics statistics;
      double bed_diameter;
      std::optional<double> voidage;
      std::optional<double> energy;
    };
    std::vector<Drop> drops;
    const double release_clock =
        peng_2014().value(spec_.system.ends_with('N') ? "drop_time_sodium_iodide" : "drop_time_water");
    for (const FinishedRun* run : runs_) {
      if (run->result.drops.empty()) continue;
      const double top = bed_top(*run);
      const auto height = mean_of_bed(*run, run->result.bed.centre_of_mass_height);
      std::optional<double> voidage;
      if (height) {
        voidage = voidage_from_height(solids_volume(*run), cross_section(run->scene.geometry), 2.0 * *height);
      }
      for (const DropSeries& drop : run->result.drops) {
        const Species& sphere = species_named(run->scene, drop.species);
        const double bed_diameter = bed_species(run->scene).diameter;
        drops.push_back({analyse_drop(drop, {.bed_top = top,
                                             .bed_diameter = bed_diameter,
                                             .sphere_diameter = sphere.diameter,
                                             .sphere_density = sphere.density,
                                             .release_clock = release_clock}),
                         bed_diameter, voidage, mean_of_bed(*run, run->result.bed.fluctuating_energy)});
      }
    }

    const auto add_per_drop = [&](std::string_view quantity, const std::string& unit, auto value) {
      std::vector<double> values;
      for (const Drop& drop : drops) {
        if (const std::optional<double> v = value(drop)) values.push_back(*v);
      }
      add_replicates(quantity, unit, values);
    };
    const auto add_statistic = [&](std::string_view quantity, const std::string& unit,
                                   std::optional<double> DropStatistics::*member) {
      add_per_drop(quantity, unit, [member](const Drop& drop) { return drop.statistics.*member; });
    };
    const auto add_fitted = [&](std::string_view quantity, const std::string& unit, double ClassificationFit::*member) {
      add_per_drop(quantity, unit, [member](const Drop& drop) -> std::optional<double> {
        if (!drop.statistics.classification) return std::nullopt;
        return *drop.statistics.classification.*member;
      });
    };
    add_fitted("classification_velocity", "m/s", &ClassificationFit::velocity);
    add_fitted("classification_intercept", "m", &ClassificationFit::intercept);
    add_fitted("classification_r2", "-", &ClassificationFit::r_squared);
    add_statistic("time_to_bottom", "s", &DropStatistics::time_to_bottom);
    add_statistic("terminal_velocity", "m/s", &DropStatistics::terminal_velocity);
    add_statistic("terminal_reynolds", "-", &DropStatistics::terminal_reynolds);
    add_statistic("penetration", "m", &DropStatistics::penetration);
    add_statistic("collision_frequency", "1/s", &DropStatistics::collision_frequency);
    add_statistic("collision_force_ratio", "-", &DropStatistics::force_ratio);
    add_statistic("collision_force_ratio_of_mean", "-", &DropStatistics::force_ratio_of_mean);
    add_statistic("peak_force_ratio", "-", &DropStatistics::peak_force_ratio);
    add_statistic("drag_ratio", "-", &DropStatistics::drag_ratio);
    add_statistic("pressure_gradient_ratio", "-", &DropStatistics::pressure_gradient_ratio);
    add_statistic("collision_to_drag_ratio", "-", &DropStatistics::collision_to_drag_ratio);
    add_statistic("mean_contacts", "-", &DropStatistics::mean_contacts);
    add_statistic("maximum_contacts", "-", &DropStatistics::maximum_contacts);
    add_statistic("contact_fraction", "-", &DropStatistics::contact_fraction);
    add_statistic("lateral_travel", "-", &DropStatistics::lateral_travel);
    add_statistic("local_voidage_mean", "-", &DropStatistics::local_voidage_mean);
    add_statistic("local_voidage_minimum", "-", &DropStatistics::local_voidage_minimum);
    add_statistic("local_voidage_maximum", "-", &DropStatistics::local_voidage_maximum);

    // A drop that was followed for a shorter time without reaching the bottom says nothing.
    for (const int seconds : {15, 30}) {
      add_per_drop(fmt::format("falling_after_{}_s", seconds), "-",
                   [seconds](const Drop& drop) -> std::optional<double> {
                     const auto& bottom = drop.statistics.time_to_bottom;
                     if (bottom && *bottom < seconds) return 0.0;
                     return drop.statistics.time_followed >= seconds ? std::optional(1.0) : std::nullopt;
                   });
    }
    add_per_drop("bottom_fraction", "-",
                 [](const Drop& drop) -> std::optional<double> { return drop.statistics.time_to_bottom ? 1.0 : 0.0; });

    const auto dimensionless_frequency = [](const Drop& drop) -> std::optional<double> {
      if (!drop.statistics.collision_frequency || !drop.energy || !(*drop.energy > 0.0)) return std::nullopt;
      return *drop.statistics.collision_frequency * drop.bed_diameter / std::sqrt(*drop.energy);
    };
    add_per_drop("dimensionless_collision_frequency", "-", dimensionless_frequency);
    add_per_drop("ktgf_ratio", "-", [&](const Drop& drop) -> std::optional<double> {
      const auto ours = dimensionless_frequency(drop);
      const collision::LunSavage1986 contact_value;
      if (!ours || !drop.voidage || 1.0 - *drop.voidage >= contact_value.packed_solids) return std::nullopt;
      const collision::CollisionState state{.solids = 1.0 - *drop.voidage,
                                            .bed_diameter = drop.bed_diameter,
                                            .foreign_diameter = drop.bed_diameter,
                                            .kinetic_energy = *drop.energy,
                                            .contact_value = contact_value(1.0 - *drop.voidage)};
      return *ours / collision::dimensionless_frequency(collision::Simonin1991{}(state), state);
    });
    add_per_drop("equation_40_deviation", "-", [](const Drop& drop) -> std::optional<double> {
      if (!drop.statistics.force_ratio || !drop.voidage) return std::nullopt;
      const ForeignSphereInBed state{
          .bed = {}, .foreign = {}, .liquid = {}, .voidage = *drop.voidage, .superficial_velocity = 0.0};
      return *drop.statistics.force_ratio / collision::Peng2014{}(state, 0.0) - 1.0;
    });
  }

  void measure_cost() {
    double wall = 0.0, simulated = 0.0, removed = 0.0;
    for (const FinishedRun* run : runs_) {
      wall += run->result.wall_seconds;
      simulated += run->result.simulated_seconds;
      removed += static_cast<double>(run->result.particles_removed);
    }
    // Facts about these very runs, not samples of something.
    add("particles_removed", {removed, 0.0, runs_.size(), "-", ""});
    if (simulated > 0.0) add("wall_seconds_per_simulated_second", {wall / simulated, 0.0, runs_.size(), "s/s", ""});
  }

  const RunSpec& spec_;
  std::vector<const FinishedRun*> runs_;
  Measurements& measurements_;
};

/// A number that is linear in independent measurements.
struct Linear {
  double value = 0.0;
  double variance = 0.0;  ///< of half-widths
  void add(double weight, const Measurement& term) {
    value += weight * term.value;
    variance += weight * weight * term.half_width * term.half_width;
  }
};

/// Measurements of one quantity over the velocities of a system, without variants.
std::map<double, Measurement> over_velocity(const Measurements& measurements, const std::string& quantity,
                                            const std::string& system) {
  const std::string stem = quantity + "/" + system + "/";
  std::map<double, Measurement> points;
  for (auto entry = measurements.lower_bound(stem); entry != measurements.end() && entry->first.starts_with(stem);
       ++entry) {
    const std::string tail = entry->first.substr(stem.size());
    if (tail.find('/') == std::string::npos) points.emplace(std::stod(tail), entry->second);
  }
  return points;
}

/// Fig. 5: the straight line through the packed bed, the plateau, and the velocity where they cross.
void measure_pressure_curve(const std::string& system, Measurements& measurements) {
  std::vector<double> velocities;
  std::vector<Measurement> packed, fluidised;
  for (const auto& [velocity, pressure] : over_velocity(measurements, "pressure_drop", system)) {
    if (velocity < packed_up_to) {
      velocities.push_back(velocity);
      packed.push_back(pressure);
    } else if (velocity > fluidised_from) {
      fluidised.push_back(pressure);
    }
  }
  Linear plateau;
  for (const Measurement& pressure : fluidised) plateau.add(1.0 / static_cast<double>(fluidised.size()), pressure);
  const auto put = [&](const char* quantity, double value, double half_width, std::size_t samples, const char* unit) {
    measurements[fmt::format("{}/{}", quantity, system)] = {value, half_width, samples, unit,
                                                            "runs of " + system + " over U_L"};
  };
  if (!fluidised.empty()) {
    put("pressure_plateau", plateau.value, std::sqrt(plateau.variance), fluidised.size(), "Pa");
  }
  if (packed.size() < 2) return;

  // Least squares as weights of the points, so that their intervals carry over to the line and the crossing.
  const auto size = static_cast<double>(packed.size());
  double mean = 0.0, squares = 0.0;
  for (const double velocity : velocities) mean += velocity / size;
  for (const double velocity : velocities) squares += (velocity - mean) * (velocity - mean);
  Linear slope, intercept;
  for (std::size_t i = 0; i < packed.size(); ++i) {
    const double weight = (velocities[i] - mean) / squares;
    slope.add(weight, packed[i]);
    intercept.add(1.0 / size - mean * weight, packed[i]);
  }
  put("packed_line_slope", slope.value, std::sqrt(slope.variance), packed.size(), "Pa s/m");
  put("packed_line_intercept", intercept.value, std::sqrt(intercept.variance), packed.size(), "Pa");
  if (fluidised.empty()) return;

  const double crossing = (plateau.value - intercept.value) / slope.value;
  Linear error;  // of plateau − intercept − crossing · slope, first order
  for (std::size_t i = 0; i < packed.size(); ++i) {
    const double weight = (velocities[i] - mean) / squares;
    error.add(1.0 / size - mean * weight + crossing * weight, packed[i]);
  }
  put("minimum_fluidisation_velocity", crossing, std::sqrt(plateau.variance + error.variance) / std::abs(slope.value),
      packed.size() + fluidised.size(), "m/s");
}

/// How much faster V_2 rises below 0.09 m/s than above it, up to 0.24 m/s.
void measure_early_rise(const std::string& system, Measurements& measurements) {
  const auto at = [&](double velocity) {
    const auto found = measurements.find(measure_key("classification_velocity", system, velocity));
    return found == measurements.end() ? nullptr : &found->second;
  };
  const Measurement* const low = at(0.06);
  const Measurement* const middle = at(0.09);
  const Measurement* const high = at(0.24);
  if (low == nullptr || middle == nullptr || high == nullptr) return;
  const double early = (middle->value - low->value) / 0.03;
  const double late = (high->value - middle->value) / 0.15;
  const double ratio = early / late;
  Linear error;
  error.add(1.0 / (0.03 * late) + ratio / (0.15 * late), *middle);
  error.add(1.0 / (0.03 * late), *low);
  error.add(ratio / (0.15 * late), *high);
  measurements["classification_velocity_rise_ratio/" + system] = {ratio, std::sqrt(error.variance), 3, "-",
                                                                  "runs of " + system + " over U_L"};
}

/// Voidages at which the paper states something of a bed whose superficial velocity it does not give [-].
constexpr std::array stated_voidages{0.45, 0.46, 0.52, 0.55, 0.57, 0.58, 0.62, 0.65, 0.79, 0.80};
/// A run that misses a stated voidage by no more than this stands for it: half the last printed digit, and as much for
/// an unstated definition of the bed's voidage [-].
constexpr double voidage_tolerance = 0.01;

/// `quantity` at the stated voidages, on straight lines between the runs of a system, as
/// QUANTITY_at_voidage/SYSTEM/0.45.
void measure_at_voidages(const std::string& quantity, const std::string& system, Measurements& measurements) {
  struct Point {
    Measurement voidage, value;
  };
  std::vector<Point> points;
  const auto voidages = over_velocity(measurements, "voidage_centre_of_mass", system);
  for (const auto& [velocity, value] : over_velocity(measurements, quantity, system))
    if (const auto voidage = voidages.find(velocity); voidage != voidages.end())
      points.push_back({voidage->second, value});
  if (points.empty()) return;
  std::sort(points.begin(), points.end(),
            [](const Point& a, const Point& b) { return a.voidage.value < b.voidage.value; });
  for (const double stated : stated_voidages) {
    const auto above =
        std::find_if(points.begin(), points.end(), [&](const Point& point) { return point.voidage.value >= stated; });
    const Point& upper = above == points.end() ? points.back() : *above;
    const Point& lower = above == points.begin() || above == points.end() ? upper : *(above - 1);
    const double extent = upper.voidage.value - lower.voidage.value;
    if (!(extent > 0.0) && std::abs(upper.voidage.value - stated) > voidage_tolerance) continue;
    const double share = extent > 0.0 ? (stated - lower.voidage.value) / extent : 1.0;
    const double slope = extent > 0.0 ? (upper.value.value - lower.value.value) / extent : 0.0;
    Linear result;
    result.add(1.0 - share, lower.value);
    if (share > 0.0) result.add(share, upper.value);
    result.variance += std::pow(slope * std::max(lower.voidage.half_width, upper.voidage.half_width), 2);
    measurements[fmt::format("{}_at_voidage/{}/{:.2f}", quantity, system, stated)] = {
        result.value, std::sqrt(result.variance), std::min(lower.value.samples, upper.value.samples), upper.value.unit,
        "runs of " + system + " over the voidage"};
  }
}

/// The share of all runs without variant whose collision force lies within 10 % of Eq. 40 (Fig. 26).
void measure_equation_40_share(Measurements& measurements) {
  double within = 0.0;
  std::size_t runs = 0;
  const std::string stem = "equation_40_deviation/";
  for (auto entry = measurements.lower_bound(stem); entry != measurements.end() && entry->first.starts_with(stem);
       ++entry) {
    if (std::count(entry->first.begin(), entry->first.end(), '/') != 2) continue;
    ++runs;
    if (std::abs(entry->second.value) <= peng_2014().value("equation_40_most")) within += 1.0;
  }
  if (runs < 2) return;
  // Wald's interval with two successes and failures added (Agresti and Coull 1998, Am. Stat. 52, 119).
  const double trials = static_cast<double>(runs) + 4.0, share = (within + 2.0) / trials;
  measurements["equation_40_share_within_10_percent/all"] = {within / static_cast<double>(runs),
                                                             1.96 * std::sqrt(share * (1.0 - share) / trials), runs,
                                                             "-", "runs of all systems"};
}

}  // namespace

std::string measure_key(std::string_view quantity, std::string_view system, double superficial_velocity,
                        std::string_view variant) {
  std::string key = fmt::format("{}/{}/{:.2f}", quantity, system, superficial_velocity);
  if (!variant.empty()) key += fmt::format("/{}", variant);
  return key;
}

std::string run_key(const RunSpec& spec) {
  std::string key = fmt::format("{}/{:.2f}", spec.system, spec.superficial_velocity);
  if (!spec.variant.empty()) key += "/" + spec.variant;
  return key;
}

bool needs_run(std::string_view key) {
  static const std::regex system("[^/]+/([0-9]+in[0-9]+[WN](/.*)?|all)");
  return std::regex_match(key.begin(), key.end(), system);
}

Measurements measure_runs(const std::vector<FinishedRun>& runs) {
  std::map<std::string, std::vector<const FinishedRun*>> groups;
  for (const FinishedRun& run : runs) groups[run_key(run.spec)].push_back(&run);

  Measurements measurements;
  std::set<std::string> systems;
  for (auto& [key, group] : groups) {
    if (std::any_of(group.begin(), group.end(), [](const FinishedRun* run) { return !run->stale; })) {
      std::erase_if(group, [](const FinishedRun* run) { return run->stale; });
    }
    std::set<std::string> names;
    std::erase_if(group, [&](const FinishedRun* run) { return !names.insert(run->result.name).second; });
    RunGroup(group.front()->spec, group, measurements).measure();
    systems.insert(group.front()->spec.system);
  }
  for (const std::string& system : systems) {
    measure_pressure_curve(system, measurements);
    measure_early_rise(system, measurements);
    for (const char* quantity : {"collision_frequency", "drag_ratio", "lateral_travel", "liquid_fluctuation",
                                 "maximum_contacts", "mean_contacts", "pressure_gradient_ratio"})
      measure_at_voidages(quantity, system, measurements);
  }
  measure_equation_40_share(measurements);
  return measurements;
}

}  // namespace slfb
