#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/numerics/studies/solved_set.hpp"
#include "experiments/numerics/studies/trial_store.hpp"

/// Where methods fail: the boundary over two parameters, by bisection on a criterion stated in physics.
namespace slfb::stability {

/// A limit that theory gives, drawn beside the boundary.
struct Theory {
  std::string name;     ///< for the key
  std::string formula;  ///< one of theory_formulas(), "value" or "quantity:NAME" of the last trial that held
  double value = 0.0;   ///< of the formula "value", in the unit of y
  std::vector<std::string> settings;  ///< of the scene for which the formula is evaluated
};

/// One method of a map.
struct MapSeries {
  std::string name;
  std::vector<std::string> settings;
  double limit;  ///< of the criterion, in the unit of its quantity
};

/// A file experiments/numerics/stability/maps/ID.toml (README.md there explains the keys).
struct Map {
  std::string id, title, caption, problem;
  std::vector<std::string> settings;
  std::string x_label, y_label;
  std::vector<std::string> x_settings, y_settings;  ///< with {} for the value
  std::vector<double> x_values;
  double y_low = 0.0, y_high = 0.0;  ///< between which the boundary is looked for, on a logarithmic scale
  bool x_logarithmic = true;
  bool fails_high = true;   ///< methods fail at large y; false: at small y
  double tolerance = 0.05;  ///< of the boundary: upper over lower end of the bracket, less one [-]
  std::string quantity;  ///< the criterion: fails where it is above (below) the limit, or where the method breaks down
  bool fails_above = true;
  std::string criterion_text;
  std::vector<MapSeries> series;
  std::vector<Theory> theories;
  /// Settings in use, drawn as a star.
  struct Mark {
    double x, y;
    std::string text;
  };
  std::vector<Mark> marks;

  [[nodiscard]] studies::Trial trial(const MapSeries& of, double x, double y) const;
};

/// Reads a map and checks its scenes at both ends of y.
/// \throws std::runtime_error with file, line and key, or with the setting that is wrong
Map load_map(const std::filesystem::path& file, studies::Set set);
/// Files of all maps, by name.
std::vector<std::filesystem::path> map_files();
std::filesystem::path map_file(const std::string& id);

/// Whether the criterion changes within the range of y.
enum class BoundaryKind { found, never_fails, always_fails };

/// The boundary of one method at one x.
struct Boundary {
  std::string series;
  double x = 0.0;
  BoundaryKind kind = BoundaryKind::found;
  double y = 0.0;                ///< middle of the bracket; the end of the range where nothing was found
  double low = 0.0, high = 0.0;  ///< bracket
  std::string diagnosis;         ///< how the nearest failing trial failed
  std::vector<double> theory;    ///< of each Theory; NaN where it says nothing
  int trials = 0;                ///< that were looked at
};

/// Bisection on the logarithm of y. Trials come from the store or are solved and kept there. Empty when `stop`,
/// which is asked before each trial, returned true. Throws what studies::solve and TrialStore::keep throw.
std::optional<Boundary> find_boundary(const Map& map, const MapSeries& series, double x,
                                      const studies::TrialStore& store, const std::function<bool()>& stop = {});

/// What is known of a map.
struct SolvedMap : studies::SolvedSet {
  std::vector<Boundary> boundaries;
};

/// What is known of a map: what a run of this machine left in `out`/stability, or the committed set where there is
/// none, or where it is the full one and this machine's the quick one. Empty boundaries when there is neither.
SolvedMap load_solved(const Map& map, const std::filesystem::path& out);
/// This machine's quick set where load_solved gives the committed full one, to be drawn beside it; else empty.
SolvedMap load_beside(const Map& map, const std::filesystem::path& out);
/// Finds the boundaries of every method of a map, `jobs` side by side, and keeps them in `out`/stability; `found` is
/// told of each, by one thread at a time. A signal (Ctrl-C) stops it: what was found is returned, `whole` is false and
/// nothing is kept, since half a map must not take the place of a whole one. Throws what find_boundary and save_solved
/// throw.
struct MapAnswer {
  SolvedMap solved;
  bool whole = true;
};
MapAnswer solve_map(const Map& map, studies::Set set, const std::filesystem::path& out, int jobs,
                    const std::function<void(const Boundary&)>& found);
/// How many boundaries solve_map finds.
std::size_t boundaries_of(const Map& map);
/// Throws std::runtime_error that names the file if it cannot be written.
void save_solved(const SolvedMap& solved, const std::filesystem::path& file);
/// The committed result.
std::filesystem::path committed_file(const std::string& id);
/// This machine's.
std::filesystem::path solved_file(const std::filesystem::path& out, const std::string& id);

/// Names of the formulas that a [[theory]] may name.
std::vector<std::string> theory_formulas();
/// Value of such a formula for a scene and the parameters of its problem, in the SI unit of the map's y; NaN where it
/// says nothing. Throws std::invalid_argument, with a list of the known ones, for an unknown formula.
double theory_value(const std::string& formula, const Scene& scene, const studies::Parameters& parameters);

}  // namespace slfb::stability
