#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <regex>
#include <set>

#include "experiments/quantities/analysis.hpp"
#include "experiments/reference/reference_data.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

/// Velocities that separate the packed bed from the fluidised one in Fig. 5, on either side of U_mf = 0.042 m/s [m/s].
constexpr double packed_up_to = 0.0401;
constexpr double fluidised_from = 0.0599;

/// All runs that answer one key.
class RunGroup {
 public:
  RunGroup(const RunSpec& spec, const std::vector<const FinishedRun*>& runs, Measurements& measurements)
      : spec_(spec), measurements_(measurements) {
    for (const FinishedRun* run : runs) {
      origin_ += (origin_.empty() ? "" : ", ") + run->result.name;
      summaries_.push_back(run->summary ? *run->summary : summarise(spec.system, run->scene, run->result));
    }
  }

  void measure() {
    pool_bed();
    std::map<std::string, std::vector<double>> values;
    for (const RunSummary& summary : summaries_) {
      for (const auto& [quantity, value] : summary.run) values[quantity].push_back(value);
      for (const auto& drop : summary.drops)
        for (const auto& [quantity, value] : drop) values[quantity].push_back(value);
    }
    const auto total = [&](const std::string& quantity) {
      const auto found = values.extract(quantity);
      return found.empty() ? 0.0 : std::accumulate(found.mapped().begin(), found.mapped().end(), 0.0);
    };
    const double wall = total("wall_seconds"), simulated = total("simulated_seconds");
    add("particles_removed", {total("particles_removed"), 0.0, summaries_.size(), "-", ""});
    if (simulated > 0.0)
      add("wall_seconds_per_simulated_second", {wall / simulated, 0.0, summaries_.size(), "s/s", ""});
    for (const auto& [quantity, samples] : values) {
      const ReplicateEstimate estimate = estimate_replicates(samples);
      add(quantity, {estimate.mean, estimate.half_width, estimate.samples, unit_of(quantity), ""});
    }
  }

 private:
  void add(std::string_view quantity, Measurement measurement) {
    measurement.origin = origin_;
    measurements_[measure_key(quantity, spec_.system, spec_.superficial_velocity, spec_.variant)] =
        std::move(measurement);
  }

  /// Means of the undisturbed bed: of one run with the interval of its own series, of several together.
  void pool_bed() {
    std::map<std::string, std::vector<SeriesEstimate>> estimates;
    for (const RunSummary& summary : summaries_)
      for (const auto& [quantity, estimate] : summary.bed) estimates[quantity].push_back(estimate);
    for (const auto& [quantity, runs] : estimates) {
      const auto samples = [&] {
        double sum = 0.0;
        for (const SeriesEstimate& run : runs) sum += run.effective_samples;
        return static_cast<std::size_t>(std::max(1.0, sum));
      };
      const bool weighable =
          std::all_of(runs.begin(), runs.end(), [](const SeriesEstimate& run) { return run.half_width > 0.0; });
      if (runs.size() == 1) {
        add(quantity, {runs.front().mean, runs.front().half_width, samples(), unit_of(quantity), ""});
      } else if (weighable) {
        const auto [mean, half_width] = weighted_mean(runs);
        add(quantity, {mean, half_width, samples(), unit_of(quantity), ""});
      } else {
        std::vector<double> means;
        for (const SeriesEstimate& run : runs) means.push_back(run.mean);
        const ReplicateEstimate estimate = estimate_replicates(means);
        add(quantity, {estimate.mean, estimate.half_width, estimate.samples, unit_of(quantity), ""});
      }
    }
  }

  /// Mean weighted by the intervals, and its interval: wider by the ratio of Birge (1932, Phys. Rev. 40, 207) where the
  /// runs scatter more than their own intervals say.
  static std::pair<double, double> weighted_mean(const std::vector<SeriesEstimate>& runs) {
    double weights = 0.0, mean = 0.0, scatter = 0.0;
    for (const SeriesEstimate& run : runs) weights += 1.0 / (run.half_width * run.half_width);
    for (const SeriesEstimate& run : runs) mean += run.mean / (run.half_width * run.half_width * weights);
    for (const SeriesEstimate& run : runs) scatter += std::pow((run.mean - mean) / (0.5 * run.half_width), 2);
    const double birge = std::sqrt(scatter / static_cast<double>(runs.size() - 1));
    return {mean, std::max(1.0, birge) / std::sqrt(weights)};
  }

  const RunSpec& spec_;
  std::vector<RunSummary> summaries_;
  std::string origin_;
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

/// Fig. 5: the straight line through the packed bed, the plateau, and the velocity where they cross.
void measure_pressure_curve(const std::string& system, Measurements& measurements) {
  std::vector<double> velocities;
  std::vector<Measurement> packed, fluidised;
  for (const auto& [velocity, pressure] : over_numbers(measurements, "pressure_drop", system)) {
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
    measurements[{quantity, system}] = {value, half_width, samples, unit, "runs of " + system + " over U_L"};
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
  measurements[{"classification_velocity_rise_ratio", system}] = {ratio, std::sqrt(error.variance), 3, "-",
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
  const auto voidages = over_numbers(measurements, "voidage_centre_of_mass", system);
  for (const auto& [velocity, value] : over_numbers(measurements, quantity, system))
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
    measurements[measure_key(quantity + "_at_voidage", system, stated)] = {
        result.value, std::sqrt(result.variance), std::min(lower.value.samples, upper.value.samples), upper.value.unit,
        "runs of " + system + " over the voidage"};
  }
}

/// The share of all runs without variant whose collision force lies within 10 % of Eq. 40 (Fig. 26).
void measure_equation_40_share(Measurements& measurements) {
  double within = 0.0;
  std::size_t runs = 0;
  for (const auto& [key, deviation] : measurements) {
    if (key.quantity != "equation_40_deviation" || !key.at || !key.detail.empty()) continue;
    ++runs;
    if (std::abs(deviation.value) <= peng_2014().value("equation_40_most")) within += 1.0;
  }
  if (runs < 2) return;
  // Wald's interval with two successes and failures added (Agresti and Coull 1998, Am. Stat. 52, 119).
  const double trials = static_cast<double>(runs) + 4.0, share = (within + 2.0) / trials;
  measurements[{"equation_40_share_within_10_percent", "all"}] = {within / static_cast<double>(runs),
                                                                  1.96 * std::sqrt(share * (1.0 - share) / trials),
                                                                  runs, "-", "runs of all systems"};
}

}  // namespace

bool depends_on_contact_stiffness(std::string_view quantity) {
  constexpr std::string_view at_voidage = "_at_voidage";
  if (quantity.ends_with(at_voidage)) quantity.remove_suffix(at_voidage.size());
  constexpr std::array names{"collision_frequency", "dimensionless_collision_frequency",
                             "ktgf_ratio",          "mean_contacts",
                             "maximum_contacts",    "contact_fraction",
                             "peak_force_ratio",    "contacts_per_particle",
                             "maximum_overlap_mean"};
  return std::ranges::find(names, quantity) != names.end();
}

void take_contacts_from(const Measurements& own_springs, Measurements& measurements) {
  const auto of_contacts = [](const MeasureKey& key) {
    return needs_run(key) && key.at && key.detail.empty() && depends_on_contact_stiffness(key.quantity);
  };
  std::map<std::string, int> velocities;
  for (const auto& [key, measured] : own_springs)
    if (of_contacts(key) && key.quantity == "collision_frequency") ++velocities[key.subject];
  const auto changes_over = [&](const MeasureKey& key) {
    const auto found = velocities.find(key.subject);
    return found != velocities.end() && found->second >= 2 && of_contacts(key);
  };
  std::erase_if(measurements, [&](const auto& entry) { return changes_over(entry.first); });
  for (auto& [key, measured] : measurements)
    if (of_contacts(key)) measured.springs = Springs::softened;
  for (const auto& [key, measured] : own_springs) {
    if (!changes_over(key)) continue;
    measurements[key] = measured;
    measurements[key].springs = Springs::own;
  }
}

bool needs_run(const MeasureKey& key) {
  static const std::regex system("[0-9]+in[0-9]+[WN]|all");
  return std::regex_match(key.subject, system);
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

Measurements measure_all(const std::vector<FinishedRun>& runs, const std::filesystem::path& out) {
  Measurements measurements = measure_without_runs();
  measurements.merge(measure_runs(runs));
  take_contacts_from(measure_runs(runs_with_own_springs(out)), measurements);
  return measurements;
}

}  // namespace slfb
