#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/numerics/accuracy/expectation.hpp"

/// Beds of a scene until its answers are as sure as asked.
///
/// The answers are looked at after three beds, then after as many more as the scatter asks for, at most twice as many
/// as there were. Look k uses intervals that miss the truth with probability 5 % · 6/(π² k²): over all looks together
/// at most 5 % (Bonferroni), so that looking until an interval is narrow enough, which takes narrow ones by preference,
/// does not make it miss more often.
namespace slfb::accuracy {

/// Probability that an interval of this look misses the truth [-].
double level_of_look(int look);
/// Half width of the interval of a mean of samples with this standard deviation, at this look; infinite for one sample.
double half_width_of(double deviation, int samples, int look);
/// Fewest samples whose interval at the first look has at most this half width; 10 000 where no fewer do.
int samples_for(double deviation, double half_width);

/// What several beds say of a quantity.
struct Answer {
  double value = std::numeric_limits<double>::quiet_NaN();       ///< SI
  double half_width = std::numeric_limits<double>::quiet_NaN();  ///< of the 95 % interval; infinite: open on one side
  std::size_t samples = 0;                                       ///< independent ones
  std::string unit = {}, remark = {};
};
using Answers = std::map<std::string, Answer>;  ///< by quantity, and "voidage_drift"

/// What the planned scene says less what the richer one says, over the latter [-].
struct Deviation {
  double value = 0.0;
  double uncertainty = 0.0;  ///< half width of the interval of the difference
};

/// Error that a deviation stands for: what was estimated for the choices, unless the scene itself says more, or for
/// sure less. \param estimated relative error [-]
double error_by(const Deviation& deviation, double estimated);

/// What the loop needs of the world, so that it can be tested without one.
struct World {
  /// Simulates scenes that have no result yet; CPU time of all of them [s], or nothing when interrupted or failed.
  std::function<std::optional<double>(const std::vector<Scene>&)> simulate;
  std::function<Answers(const std::vector<Scene>&)> measure;
  std::function<void(const std::string&)> tell = {};  ///< before each step, in words
};

struct Outcome {
  Scene scene;                         ///< of the first bed, as it was run at last
  std::vector<Scene> beds, richer;     ///< those of the answers, and those of the check
  Answers answers;                     ///< with the intervals of the last look
  std::map<std::string, Parts> parts;  ///< achieved
  std::map<std::string, Deviation> check;
  std::map<std::string, double> scatter;  ///< of one bed or drop, as measured [-]
  int looks = 0;
  double core_seconds = 0.0;  ///< of all runs, also of those that have been found finished
  bool reached = false, unfinished = false;
  std::string reason;  ///< why it is not reached
};

/// Runs beds until every asked quantity is inside the goal. A bed that still changes is run again over twice the time,
/// at most three times. Where the check finds more than the goal leaves, the richer scene takes the place of the
/// planned one and is checked against a refined one. \param budget CPU time that may be spent [s]: what is expected to
/// take more than what is left is not begun
Outcome run_until(const Expectation& expected, const World& world,
                  double budget = std::numeric_limits<double>::infinity());

}  // namespace slfb::accuracy
