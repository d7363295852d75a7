#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/numerics/studies/solved_set.hpp"
#include "experiments/numerics/studies/trial_store.hpp"

/// Error against cost of methods: what a study asks, what was found, and how that is kept.
namespace slfb::frontier {

/// One setting of one method.
struct StudyPoint {
  std::string series;                  ///< the method
  double axis = 0.0;                   ///< value of the study's axis
  std::vector<studies::Trial> trials;  ///< replicates
};

/// A file experiments/numerics/frontier/studies/ID.toml (README.md there explains the keys).
struct Study {
  std::string id, title, caption;
  std::string problem;
  std::string axis_label;               ///< "steps per contact"
  std::vector<std::string> quantities;  ///< of the problem
  std::vector<std::string> series;      ///< names of the methods, in order
  std::vector<StudyPoint> points;
  std::vector<studies::Trial> reference;     ///< replicates of the converged run; empty where the problem is exact
  std::string reference_text;                ///< what the errors are measured against
  std::string count;                         ///< the machine-independent cost that is drawn
  double default_axis = 0.0;                 ///< where the suite's default stands, with `default_series`
  std::string default_series, default_text;  ///< empty: the study backs no default
};

/// Reads a study and checks the scene of each of its points.
/// \throws std::runtime_error with file, line and key, or with the setting that is wrong; std::invalid_argument for an
/// unknown problem or quantity
Study load_study(const std::filesystem::path& file, studies::Set set);
/// Every trial of a study: those of its reference, then those of its points.
std::vector<studies::Trial> trials_of(const Study& study);
/// Files of all studies, by name.
std::vector<std::filesystem::path> study_files();
std::filesystem::path study_file(const std::string& id);

/// One quantity at one point, replicates taken together.
struct PointValue {
  double value, half_width;        ///< mean and 95 % interval, NaN for a single replicate; in the problem's unit
  double error, error_half_width;  ///< relative to the reference [-]
};

/// What is known of one point of a study.
struct ReducedPoint {
  std::string series;
  double axis = 0.0;
  double cpu_seconds = 0.0;              ///< per unit of the problem's cost [s]
  std::map<std::string, double> counts;  ///< per that unit
  int replicates = 0;
  std::map<std::string, PointValue> values;
  std::string failure;  ///< of a replicate; empty when all have answered
};

/// What is known of a study.
struct ReducedStudy : studies::SolvedSet {
  std::vector<ReducedPoint> points;
  /// Of the reference: value, half_width, and in error_half_width the half width over the value.
  std::map<std::string, PointValue> reference;
};

/// From the stored trials of the study to means, intervals and errors. Points without any trial are left out.
ReducedStudy reduce(const Study& study, studies::Set set, const studies::TrialStore& store);

/// Keeps the reduced result in `out`/frontier if every trial of the study is solved: half a study must not take the
/// place of a whole one. Returns whether it did. Throws as save_reduced.
bool keep_if_whole(const Study& study, studies::Set set, const studies::TrialStore& store,
                   const std::filesystem::path& out);
/// What is known of a study: what a run of this machine left in `out`/frontier, or the committed set where there is
/// none, or where it is the full one and this machine's the quick one. Empty points when there is neither.
ReducedStudy load_reduced(const Study& study, const std::filesystem::path& out);
/// This machine's quick set where load_reduced gives the committed full one, to be drawn beside it; else empty.
ReducedStudy load_beside(const Study& study, const std::filesystem::path& out);
/// The committed set alone; empty points where there is none.
ReducedStudy load_committed(const std::string& id);
/// Throws std::runtime_error that names the file if it cannot be written.
void save_reduced(const ReducedStudy& reduced, const std::filesystem::path& file);
/// The committed result.
std::filesystem::path committed_file(const std::string& id);
/// This machine's.
std::filesystem::path reduced_file(const std::filesystem::path& out, const std::string& id);

/// Points that no other of the successful ones beats in both cost and error, by rising cost.
/// The cost is CPU time, or the count of this name.
std::vector<const ReducedPoint*> pareto_front(const ReducedStudy& reduced, const std::string& quantity,
                                              const std::string& count = "");

}  // namespace slfb::frontier
