#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/quantities/quantity.hpp"
#include "experiments/readings/inference.hpp"
#include "experiments/runs/campaign.hpp"

/// From finished runs to the samples that inference.hpp takes.
namespace slfb::readings {

/// A printed number and what answers it: a quantity (PrintedNumber::quantity) of a system at a superficial velocity.
struct Evidence {
  PrintedNumber printed;
  std::string system;
  std::optional<double> superficial_velocity;  ///< [m/s]; empty: any, for what the flow does not change
  /// Why it may be no result of what is asked for: it is compared, and counts in no ranking but one of its own. Empty:
  /// it counts.
  std::string disputed = {};
  /// The choice that a reading was given because of this number: for the likelihood it is evidence as any other, and no
  /// test of a prediction. Empty: none.
  std::string chose = {};
};

/// A reading that was run, by the name of its variant.
struct NamedRuns {
  std::string name;
  ReadingRuns runs;
};

std::vector<PrintedNumber> printed_numbers(const std::vector<Evidence>& evidence);

/// Takes the runs whose variant is the name of a reading, stale ones left out. Where several profiles have a reading at
/// one velocity the last of them in `runs` speaks. A number of drops has a sample for each drop; one of the bed or of
/// the run has one for each seed, and the numbers of a block have the seeds that all of them have. What depends on the
/// contact stiffness is taken only from runs with the stiffness of the scene file.
std::vector<NamedRuns> collect(const Choices& choices, const std::vector<Evidence>& evidence,
                               const std::vector<FinishedRun>& runs, const MeasuringRules& rules);

}  // namespace slfb::readings
