#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "experiments/quantities/quantity.hpp"
#include "solver/laws/scene_file.hpp"

/// What `run --accuracy` and `plan --accuracy` share.
namespace slfb {

struct AccuracyOptions {
  std::filesystem::path file;  ///< of the scene
  Scene scene;
  std::vector<std::string> asked;  ///< empty: the usual questions
  double error = 0.0;              ///< relative [-]
  bool keep_forces = false;        ///< the plan leaves added mass, lift, … as the scene has them
  bool best = false;               ///< takes the best that can be had where the goal is out of reach
  double budget = std::numeric_limits<double>::infinity();  ///< CPU time [s]
  std::filesystem::path out;
  int threads = 1;
  bool json = false;
};

/// "5 %", "5%" or "0.05". \throws CLI::ValidationError
double accuracy_of(const std::string& text);

/// Prints what the accuracy is expected to take. \return exit status: 1 where it is out of reach
int plan_for_accuracy(const AccuracyOptions& options);

/// Says what is expected, runs until the answers are as sure as asked, and reports. \param rules of the measurements
/// \return exit status: 0 only where the accuracy is reached; 130 when interrupted
int run_for_accuracy(const AccuracyOptions& options, const MeasuringRules& rules);

/// How an accuracy is asked for, for the help of both commands.
extern const char* const accuracy_help;

}  // namespace slfb
