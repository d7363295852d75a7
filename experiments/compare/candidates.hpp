#pragma once

#include <map>
#include <string>
#include <vector>

#include "experiments/claims/claims.hpp"
#include "experiments/compare/comparison_bed.hpp"
#include "experiments/runs/campaign.hpp"
#include "experiments/runs/run_campaign.hpp"

/// The part of a comparison that does not depend on what is compared: the same simulations with some values of the
/// scene exchanged, and the claims of the work side by side.
namespace slfb::compare {

/// How much a comparison computes.
enum class Tier {
  correlation,        ///< nothing is simulated
  one_dimensional,    ///< a slice of the bed in a one-dimensional liquid
  three_dimensional,  ///< the bed itself
};

/// One of the things compared: what it is called and what it changes in a scene.
struct Candidate {
  std::string name;
  std::vector<std::string> overrides;  ///< {"coupling.drag_law=mine.cpp"}
  Measurements measurements;
  std::vector<Evaluation> evaluations;  ///< of the claims of the comparison, in their order
  std::size_t runs = 0;
  double core_seconds = 0.0;       ///< computing time of its runs
  double simulated_seconds = 0.0;  ///< simulated in them
};

/// The claims of the bed that begin with one of `ids` (all without any) and that a simulation answers. \throws
/// std::invalid_argument where an id begins none of them
std::vector<Claim> claims_of_runs(const ComparisonBed& bed, const std::vector<std::string>& ids);

/// The runs of a tier that the claims ask for, at `velocities` [m/s] (empty: the usual ones of the tier), without
/// overrides of candidates. \throws std::invalid_argument where there is no run left, or no run at a velocity
std::vector<RunSpec> runs_of(const ComparisonBed& bed, Tier tier, const std::vector<Claim>& claims,
                             const std::vector<double>& velocities);

/// Makes the runs for every candidate and fills in what is measured in them beside `measurements`, and what it costs.
/// A run that fails or is interrupted is counted in the outcome; its candidate has fewer measurements. \throws
/// SceneError where a candidate's overrides do not fit the scene
CampaignOutcome simulate(const ComparisonBed& bed, std::vector<Candidate>& candidates, const std::vector<RunSpec>& runs,
                         const CampaignOptions& options);

/// Evaluates the claims for every candidate from its measurements.
void evaluate_candidates(std::vector<Candidate>& candidates, const std::vector<Claim>& claims);

/// How a candidate does at a claim beside the first one.
enum class Change { better, worse, same, undecided };
std::string_view to_string(Change change);

/// Better: nearer to what the paper states by more than the 95 % intervals of both. A trend, which has no distance,
/// goes by its verdict.
Change change(const Evaluation& first, const Evaluation& other);

/// How many of the claims that a candidate answers are better, worse, … beside the first candidate.
std::map<Change, std::size_t> count_changes(const Candidate& first, const Candidate& other);

/// Whether some candidate answers the claim of that place.
bool answered(const std::vector<Candidate>& candidates, std::size_t claim);

}  // namespace slfb::compare
