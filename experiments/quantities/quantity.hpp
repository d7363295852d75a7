#pragma once

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "experiments/quantities/analysis.hpp"
#include "experiments/quantities/measurement.hpp"
#include "experiments/quantities/samples.hpp"
#include "solver/io/run_result.hpp"
#include "solver/scene/scene.hpp"

/// What is measured: each quantity once, with its definition and the way it is computed.
namespace slfb {

struct MeasuringRules;
struct RunSummary;

/// One run, as the quantities see it.
struct RunView {
  const Scene& scene;
  const RunResult& result;
  const MeasuringRules& rules;
  double release_clock = 0.0;                        ///< reading of the work's clock at a release [s]
  const std::map<std::string, SeriesEstimate>& bed;  ///< what has been estimated of its bed so far

  /// The species of the bed: the first with spheres. Throws std::runtime_error for a run without.
  [[nodiscard]] const Species& bed_species() const;
  /// Volume of the spheres that are still in the column [m³].
  [[nodiscard]] double solids_volume() const;
  /// Mean height of the top of the undisturbed bed, or of the packed bed where nothing was recorded [m].
  [[nodiscard]] double bed_top() const;
  /// Mean of a quantity of the bed that stands before this one in the list; empty where it was not recorded.
  [[nodiscard]] std::optional<double> mean_of_bed(const std::string& quantity) const;
};

/// One drop of a run.
struct DropView {
  const RunView& run;
  const DropSeries& series;
  const DropStatistics& statistics;
  bool from_release_height;  ///< false: released so much lower that times since the release are no others' times
  bool first = true;         ///< into this bed: later ones meet what the first has left
};

/// What has been measured of a drop, and of the bed it fell into: enough for quantities that only combine such numbers,
/// also those of a summary that was written before the quantity was thought of.
struct DropNumbers {
  const std::map<std::string, double>& drop;         ///< by the id of the quantity
  const std::map<std::string, SeriesEstimate>& bed;  ///< the same of the bed
  const Scene& scene;
  const MeasuringRules& rules;
  std::string_view system;
  double superficial_velocity;  ///< [m/s]

  [[nodiscard]] std::optional<double> of_drop(const std::string& quantity) const;
};

/// Mean over the undisturbed bed with the interval of its own series; empty where nothing was recorded.
using OfBed = std::function<std::optional<SeriesEstimate>(const RunView&)>;
/// One number a run.
using OfRun = std::function<std::optional<double>(const RunView&)>;
/// One number a drop; the drops of all runs of one key are samples of one mean.
using OfDrop = std::function<std::optional<double>(const DropView&)>;
/// One number a drop, from its other numbers.
using OfDropNumbers = std::function<std::optional<double>(const DropNumbers&)>;
/// What a drop without the number still says: a bound.
using BoundOfDrop = std::function<std::optional<BoundedSample>(const DropView&)>;
/// One number of all runs of one key together.
using OfReplicates = std::function<std::optional<double>(std::span<const RunSummary>)>;
/// One number of all runs of a system without variant, from what was measured in each.
using OfSystem =
    std::function<std::optional<Measurement>(const Measurements&, const std::string& system, const MeasuringRules&)>;
/// One number of all systems together.
using OfAllSystems = std::function<std::optional<Measurement>(const Measurements&)>;
/// What may be known of a bed of others, of which not all is recorded that this suite records.
enum class Recorded {
  pressure_drop,       ///< over time
  bed_centre_of_mass,  ///< over time
  bed_top,             ///< over time
  sphere_velocities,   ///< of the bed, over time
  settled_bed,         ///< its height and voidage
  sphere_height,       ///< z of a dropped sphere over time
  sphere_path,         ///< its x and y too
};

/// Computed by laws or probes of a work, in no run.
using OfNoRun = std::monostate;

struct Quantity {
  std::string id;          ///< "classification_velocity"
  std::string unit;        ///< SI; "-" for a ratio or a count
  std::string title;       ///< a few words
  std::string definition;  ///< one or two sentences
  std::variant<OfNoRun, OfBed, OfRun, OfDrop, OfDropNumbers, OfReplicates, OfSystem, OfAllSystems> computed;
  /// True for counts of contacts and for single forces: a softer spring makes contacts last longer and hide the next.
  bool depends_on_contact_stiffness = false;
  double lowest = -std::numeric_limits<double>::infinity();  ///< bounds of nature
  double highest = std::numeric_limits<double>::infinity();
  bool of_packing = false;  ///< of the settled bed: runs that begin with the same packing are one sample
  bool yes_or_no = false;   ///< 1 or 0 for each drop: its mean is a share
  double step = 0.0;        ///< between neighbouring values: 1 for counts
  /// Committed results are thinned; true where it is also found in them, for summaries of before it was thought of.
  bool from_thinned = false;
  BoundOfDrop bound = {};  ///< of drops that have no such number; found in thinned results
  /// What of a bed of others suffices for it; empty: only what a run of this suite records.
  std::vector<Recorded> needs = {};
};

/// The quantities of every fluidised bed and every drop into one (quantities.cpp): adding one is one entry there.
const std::vector<Quantity>& general_quantities();

/// What is measured and by which conventions: those of a work, or the general ones.
struct MeasuringRules {
  std::vector<Quantity> quantities = general_quantities();  ///< a work adds its own behind them
  /// Lowest and highest z between which the classification velocity is fitted [m]; without them the window of the
  /// scene, recording.fluctuation_window.
  std::optional<std::array<double, 2>> classification_window = {};
  std::map<std::string, double> release_clocks = {};  ///< by system [s]: 0 for one that is not named
  double release_height = 0.0;  ///< drops from below 98 % of it say nothing of times since the release [m]
  double packed_up_to = 0.0;    ///< largest superficial velocity of a bed that is surely packed [m/s]
  /// Smallest one of a bed that is surely fluidised [m/s].
  double fluidised_from = std::numeric_limits<double>::infinity();
  /// Voidages at which a work states something of a bed whose superficial velocity it does not give [-].
  std::vector<double> printed_voidages = {};
  double voidage_tolerance = 0.0;  ///< a run that misses a stated voidage by no more stands for it [-]
  /// Quantities that are read there, as "QUANTITY_at_voidage" over the voidage of our beds, and where the work has a
  /// voidage of its own for each velocity as "QUANTITY_at_printed_voidage" over that one.
  std::vector<std::string> at_voidages = {};
  /// The voidage that the work has for a system at a superficial velocity; empty for a work that prints none.
  std::function<std::optional<double>(std::string_view system, double superficial_velocity)> printed_voidage = {};
  double steady_voidage = 0.005;  ///< a bed whose voidage changes by more at the end of its series is not steady [-]

  [[nodiscard]] double release_clock(const std::string& system) const;
};

/// Those of no work: general_quantities(), times from the release.
const MeasuringRules& general_rules();

/// Null when the rules have no quantity of this id. "QUANTITY_at_voidage" and "QUANTITY_at_printed_voidage" are
/// QUANTITY.
const Quantity* find_quantity(const MeasuringRules& rules, std::string_view id);

/// False for an id that is not in the rules.
bool depends_on_contact_stiffness(const MeasuringRules& rules, std::string_view id);

/// The classification velocity V_2 of a drop and its line, in the window of the rules (see fit_classification).
/// \param release_clock reading of the clock at the release, from which the intercept counts [s]
std::optional<ClassificationFit> classification_of(const DropSeries& drop, const Scene& scene,
                                                   const MeasuringRules& rules = general_rules(),
                                                   double release_clock = 0.0);

}  // namespace slfb
