#include "experiments/quantities/run_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>

#include "correlations/collision/collision_force/peng_2014.hpp"
#include "correlations/collision/collision_frequency/simonin_1991.hpp"
#include "correlations/collision/radial_distribution/lun_savage_1986.hpp"
#include "correlations/collision/stokes_number.hpp"
#include "experiments/reference/reference_data.hpp"

namespace slfb {
namespace {

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
double solids_volume(const Scene& scene, const RunResult& result) {
  double volume = 0.0;
  std::int64_t count = 0;
  for (const Species& species : scene.species) {
    volume += static_cast<double>(species.count) * std::numbers::pi / 6.0 * std::pow(species.diameter, 3);
    count += species.count;
  }
  const double remaining = static_cast<double>(count - result.particles_removed) / static_cast<double>(count);
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

using Numbers = std::map<std::string, double>;

class Summary {
 public:
  Summary(const std::string& system, const Scene& scene, const RunResult& result)
      : system_(system), scene_(scene), result_(result), bed_(bed_species(scene)) {}

  RunSummary measure() {
    measure_bed();
    measure_plane();
    for (const DropSeries& drop : result_.drops) summary_.drops.push_back(measure_drop(drop));
    // Facts about this very run, not samples of something.
    summary_.run["wall_seconds"] = result_.wall_seconds;
    summary_.run["simulated_seconds"] = result_.simulated_seconds;
    summary_.run["particles_removed"] = static_cast<double>(result_.particles_removed);
    return std::move(summary_);
  }

 private:
  /// Mean over the undisturbed bed after its transient. `derive` turns a sample of the history into the quantity.
  template <class Derive>
  void add_series(const std::string& quantity, std::vector<double> BedSeries::*history, Derive derive) {
    std::vector<double> values = undisturbed(result_.bed, result_.bed.*history);
    if (values.empty()) return;
    std::transform(values.begin(), values.end(), values.begin(), derive);
    summary_.bed[quantity] = estimate_steady_mean(values);
  }
  void add_series(const std::string& quantity, std::vector<double> BedSeries::*history) {
    add_series(quantity, history, [](double value) { return value; });
  }

  void measure_bed() {
    add_series("pressure_drop", &BedSeries::pressure_drop);
    add_series("fluctuating_energy", &BedSeries::fluctuating_energy);
    add_series("local_fluctuating_energy", &BedSeries::local_fluctuating_energy);
    add_series("contacts_per_particle", &BedSeries::contacts_per_particle);
    add_series("maximum_overlap_mean", &BedSeries::maximum_overlap);
    add_series("bed_top", &BedSeries::bed_top);
    const double solids = solids_volume(scene_, result_), area = scene_.geometry.cross_section();
    add_series("voidage_centre_of_mass", &BedSeries::centre_of_mass_height,
               [=](double height) { return voidage_from_height(solids, area, 2.0 * height); });
    // The top is a height of centres; half a diameter of the uppermost particles stands above it.
    add_series("voidage_bed_top", &BedSeries::bed_top,
               [=, this](double height) { return voidage_from_height(solids, area, height + 0.5 * bed_.diameter); });
    add_series("stokes_number", &BedSeries::fluctuating_energy, [this](double energy) {
      return collision::stokes_number({bed_.diameter, bed_.density}, {scene_.liquid.density, scene_.liquid.viscosity},
                                      energy);
    });
    summary_.run["packed_voidage"] = result_.packed_voidage;
    summary_.run["packed_height"] = result_.packed_height;
    // u'_L of Eq. 37: mean over the samples, each the mean of |u − ū| over the cells of the window.
    if (!result_.fluctuation.series_vector.empty()) {
      summary_.bed["liquid_fluctuation"] = estimate_mean(result_.fluctuation.series_vector);
      summary_.bed["liquid_fluctuation_vertical"] = estimate_mean(result_.fluctuation.series_z);
    }
  }

  void measure_plane() {
    const auto plane = analyse_plane(result_.plane, bed_top());
    if (!plane) return;
    summary_.run["plane_voidage_deviation"] = plane->voidage_deviation;
    if (std::isfinite(plane->vorticity_range)) summary_.run["plane_vorticity_range"] = plane->vorticity_range;
    if (std::isfinite(plane->speed_maximum)) summary_.run["plane_speed_maximum"] = plane->speed_maximum;
  }

  /// Mean height of the top of the undisturbed bed; that of the packed bed where nothing was recorded [m].
  [[nodiscard]] double bed_top() const {
    const auto found = summary_.bed.find("bed_top");
    return found == summary_.bed.end() ? result_.packed_height : found->second.mean;
  }

  [[nodiscard]] std::optional<double> mean_of_bed(const std::string& quantity) const {
    const auto found = summary_.bed.find(quantity);
    return found == summary_.bed.end() ? std::nullopt : std::optional(found->second.mean);
  }

  [[nodiscard]] Numbers measure_drop(const DropSeries& drop) const {
    const Species& sphere = species_named(scene_, drop.species);
    const double release_clock =
        peng_2014().value(system_.ends_with('N') ? "drop_time_sodium_iodide" : "drop_time_water");
    const DropStatistics statistics = analyse_drop(drop, {.bed_top = bed_top(),
                                                          .bed_diameter = bed_.diameter,
                                                          .sphere_diameter = sphere.diameter,
                                                          .sphere_density = sphere.density,
                                                          .release_clock = release_clock});
    Numbers numbers;
    const auto add = [&](const std::string& quantity, const std::optional<double>& value) {
      if (value) numbers[quantity] = *value;
    };
    // Times since the release are the paper's only from its height.
    const bool from_the_top = !drop.z.empty() && drop.z.front() > 0.98 * peng_2014().value("column_height");
    if (statistics.classification) {
      numbers["classification_velocity"] = statistics.classification->velocity;
      if (from_the_top) numbers["classification_intercept"] = statistics.classification->intercept;
      numbers["classification_r2"] = statistics.classification->r_squared;
    }
    if (from_the_top) add("time_to_bottom", statistics.time_to_bottom);
    add("terminal_velocity", statistics.terminal_velocity);
    add("terminal_reynolds", statistics.terminal_reynolds);
    add("penetration", statistics.penetration);
    add("collision_frequency", statistics.collision_frequency);
    add("collision_force_ratio", statistics.force_ratio);
    add("collision_force_ratio_of_mean", statistics.force_ratio_of_mean);
    add("peak_force_ratio", statistics.peak_force_ratio);
    add("drag_ratio", statistics.drag_ratio);
    add("pressure_gradient_ratio", statistics.pressure_gradient_ratio);
    add("collision_to_drag_ratio", statistics.collision_to_drag_ratio);
    add("mean_contacts", statistics.mean_contacts);
    add("maximum_contacts", statistics.maximum_contacts);
    add("contact_fraction", statistics.contact_fraction);
    add("lateral_travel", statistics.lateral_travel);
    add("local_voidage_mean", statistics.local_voidage_mean);
    add("local_voidage_minimum", statistics.local_voidage_minimum);
    add("local_voidage_maximum", statistics.local_voidage_maximum);
    // A drop that was followed for a shorter time without reaching the bottom says nothing; one that rests on the bed
    // or in it does not fall.
    for (const int seconds : {15, 30}) {
      const std::string quantity = fmt::format("falling_after_{}_s", seconds);
      if (statistics.time_to_bottom && *statistics.time_to_bottom < seconds)
        numbers[quantity] = 0.0;
      else if (statistics.time_followed >= seconds)
        numbers[quantity] = statistics.penetration ? 0.0 : 1.0;
    }
    numbers["bottom_fraction"] = statistics.time_to_bottom ? 1.0 : 0.0;
    add_kinetic_theory(numbers, statistics);
    return numbers;
  }

  void add_kinetic_theory(Numbers& numbers, const DropStatistics& statistics) const {
    const auto voidage = mean_of_bed("voidage_centre_of_mass"), energy = mean_of_bed("fluctuating_energy");
    if (statistics.force_ratio && voidage) {
      const ForeignSphereInBed state{
          .bed = {}, .foreign = {}, .liquid = {}, .voidage = *voidage, .superficial_velocity = 0.0};
      numbers["equation_40_deviation"] = *statistics.force_ratio / collision::Peng2014{}(state, 0.0) - 1.0;
    }
    if (!statistics.collision_frequency || !energy || !(*energy > 0.0)) return;
    const double frequency = *statistics.collision_frequency * bed_.diameter / std::sqrt(*energy);
    numbers["dimensionless_collision_frequency"] = frequency;
    const collision::LunSavage1986 contact_value;
    if (!voidage || 1.0 - *voidage >= contact_value.packed_solids) return;
    const collision::CollisionState state{.solids = 1.0 - *voidage,
                                          .bed_diameter = bed_.diameter,
                                          .foreign_diameter = bed_.diameter,
                                          .kinetic_energy = *energy,
                                          .contact_value = contact_value(1.0 - *voidage)};
    numbers["ktgf_ratio"] = frequency / collision::dimensionless_frequency(collision::Simonin1991{}(state), state);
  }

  const std::string& system_;
  const Scene& scene_;
  const RunResult& result_;
  const Species& bed_;
  RunSummary summary_;
};

/// JSON knows no NaN; the interval of a series too short to have one is null.
nlohmann::json number(double value) { return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(); }
double number(const nlohmann::json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

}  // namespace

RunSummary summarise(const std::string& system, const Scene& scene, const RunResult& result) {
  return Summary(system, scene, result).measure();
}

std::string unit_of(const std::string& quantity) {
  static const std::map<std::string, std::string> units{{"pressure_drop", "Pa"},
                                                        {"fluctuating_energy", "m²/s²"},
                                                        {"local_fluctuating_energy", "m²/s²"},
                                                        {"bed_top", "m"},
                                                        {"packed_height", "m"},
                                                        {"liquid_fluctuation", "m/s"},
                                                        {"liquid_fluctuation_vertical", "m/s"},
                                                        {"plane_vorticity_range", "1/s"},
                                                        {"plane_speed_maximum", "m/s"},
                                                        {"classification_velocity", "m/s"},
                                                        {"classification_intercept", "m"},
                                                        {"time_to_bottom", "s"},
                                                        {"terminal_velocity", "m/s"},
                                                        {"penetration", "m"},
                                                        {"collision_frequency", "1/s"},
                                                        {"wall_seconds", "s"},
                                                        {"simulated_seconds", "s"}};
  const auto found = units.find(quantity);
  return found == units.end() ? "-" : found->second;
}

void save_summary(const RunSummary& summary, const std::filesystem::path& file) {
  nlohmann::ordered_json json;
  for (const auto& [quantity, estimate] : summary.bed)
    json["bed"][quantity] = {{"unit", unit_of(quantity)},
                             {"mean", number(estimate.mean)},
                             {"half_width", number(estimate.half_width)},
                             {"autocorrelation_time", number(estimate.autocorrelation_time)},
                             {"effective_samples", number(estimate.effective_samples)},
                             {"discarded", estimate.discarded}};
  for (const auto& [quantity, value] : summary.run) json["run"][quantity] = number(value);
  json["drops"] = nlohmann::json::array();
  for (const auto& drop : summary.drops) json["drops"].push_back(drop);
  std::ofstream out(file);
  out << json.dump(1) << "\n";
  if (!out.flush()) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

RunSummary load_summary(const std::filesystem::path& file) {
  std::ifstream in(file);
  try {
    const auto json = nlohmann::json::parse(in);
    RunSummary summary;
    for (const auto& [quantity, e] : json.at("bed").items())
      summary.bed[quantity] = {number(e.at("mean")), number(e.at("half_width")), number(e.at("autocorrelation_time")),
                               number(e.at("effective_samples")), e.at("discarded").get<std::size_t>()};
    for (const auto& [quantity, value] : json.at("run").items()) summary.run[quantity] = number(value);
    for (const auto& drop : json.at("drops")) summary.drops.push_back(drop.get<Numbers>());
    return summary;
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(fmt::format("{}: not a summary of a run: {}", file.string(), error.what()));
  }
}

}  // namespace slfb
