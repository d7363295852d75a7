#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "experiments/quantities/measurement.hpp"
#include "experiments/reference/reference_numbers.hpp"

/// Checkable statements of a work and what our measurements say to each.
namespace slfb {

/// Closed interval; an open side is ±infinity.
struct Band {
  double lower;
  double upper;
  [[nodiscard]] bool contains(double value) const { return value >= lower && value <= upper; }
};

/// What kind of statement the paper makes.
enum class StatementKind {
  value,       ///< "is X"
  at_most,     ///< "not more than X"
  at_least,    ///< "not less than X"
  between,     ///< "between X and Y"
  increasing,  ///< the listed measures rise in the order given
  decreasing,  ///< the listed measures fall in the order given
  words,       ///< without a number; never decidable
};

/// How several measures become one number.
enum class Reduction { single, largest, smallest, largest_magnitude, ratio, relative_spread };

/// Whose statement a claim is.
enum class Origin {
  paper,       ///< the paper states it
  arithmetic,  ///< what follows from its numbers, or what a law gives, worked out by this suite: no simulation of ours
};

/// What the printed number was made from.
enum class PrintedFrom {
  mean,      ///< a mean, a bound, a rule: held against the interval of our mean
  one_drop,  ///< one drop: held against what one drop of ours would give
};

/// What is missing where a claim is not decidable.
enum class Lack {
  nothing,       ///< it is decided
  paper,         ///< the paper's number or definition is lost, or one printed drop cannot tell
  run,           ///< a simulation that does not exist yet
  steadiness,    ///< a bed that was measured before it was steady
  more_samples,  ///< more drops, or more beds
};

enum class Verdict { reproduced, not_reproduced, not_decidable };
enum class Gate { holds, broken, none };

std::string_view to_string(Verdict verdict);  ///< "reproduced", "not reproduced", "not decidable"
std::string_view to_string(Gate gate);        ///< "holds", "broken", "none"
std::string_view to_string(Origin origin);    ///< "paper", "arithmetic"
std::string_view to_string(Lack lack);        ///< "nothing", "paper", "run", "steady bed", "samples"

/// One claim of reference-data/WORK/claims.toml with its references resolved.
struct Claim {
  std::string id;        ///< "fig05.u_mf_crossing"
  std::string figure;    ///< "fig05", "table2", "text"
  std::string quantity;  ///< in words
  std::string unit;
  std::string source;  ///< page and section, table or figure
  StatementKind kind = StatementKind::value;
  double paper = 0.0;                ///< the value or bound; the lower one of `between`; unused for a trend
  double paper_upper = 0.0;          ///< the upper bound of `between`
  std::string words;                 ///< what the paper states, for StatementKind::words
  std::optional<Band> paper_band;    ///< inside: reproduced; empty for a trend and for words
  std::string band_reason;           ///< why the band is as wide as it is
  double paper_uncertainty = 0.0;    ///< of the printed value, half its last digit
  std::vector<MeasureKey> measures;  ///< keys into Measurements, or patterns of them
  /// The same statement where the paper leaves open what its abscissa is; empty where it does not.
  std::vector<MeasureKey> other_measures = {};
  std::string reading = {}, other_reading = {};  ///< what sets the two apart, in words
  Origin origin = Origin::paper;
  PrintedFrom printed_from = PrintedFrom::mean;
  Reduction reduction = Reduction::single;
  std::optional<Band> regression_band;  ///< around our own accepted value: what CI gates on
  std::string regression_reason;
  std::string undecidable;             ///< why no measurement can decide it; empty otherwise
  std::set<std::string> systems = {};  ///< of the work: the subjects whose measures are taken in runs

  /// Whether a measure is answered by simulations: its subject is a system of the work, or all of them.
  [[nodiscard]] bool needs_run(const MeasureKey& measure) const;
  /// Whether any of its measures is.
  [[nodiscard]] bool needs_run() const;
  /// The paper's side in words: "0.0424", "at most 9", "between 10 and 50", "increasing".
  [[nodiscard]] std::string paper_text() const;
};

/// What our measurements say to a claim.
struct Evaluation {
  Claim claim;
  std::optional<double> ours;                         ///< for a trend: change from the first measure to the last
  std::optional<std::pair<double, double>> interval;  ///< 95 %
  std::optional<double> deviation;  ///< signed, relative: to the value, or to the nearer bound when outside it, else 0
  Verdict verdict = Verdict::not_decidable;
  Gate gate = Gate::none;
  Lack lack = Lack::nothing;
  /// With Lack::more_samples: how many times as many samples would decide it, were means and scatter what they seem to
  /// be; infinite where the mean lies on an edge. Empty where that is not known.
  std::optional<double> samples_needed = {};
  std::string reason;    ///< why not decidable, or why a gate is broken; for the others how it was decided
  double seconds = 0.0;  ///< that it took to evaluate
};

/// Reads the claims of a work. \param reference its printed numbers, by which claims name them
/// \param systems its systems of runs. Throws std::runtime_error with file, line and claim on anything unexpected.
std::vector<Claim> load_claims(const std::filesystem::path& file, const ReferenceNumbers& reference,
                               const std::set<std::string>& systems);

/// How often the runs behind a claim have been looked at and made more because it was not decided (`slfb figures
/// --decide`); a claim that is not named is at its first look.
using Looks = std::map<std::string, int, std::less<>>;

/// Probability that the intervals of a look miss the truth. Looking again until an interval happens to lie on one side
/// of an edge would decide wrongly more often than the interval says, so later looks share what the first leaves: 5 %
/// at the first one, 5 % · 6/(π² k²) at look k. Where the truth is on an edge, a verdict is wrong with at most half of
/// the sum, 3.5 %, however long one looks.
double significance_of_look(int look);

/// Verdict and gate of each claim by the rules of reference-data/README.md.
std::vector<Evaluation> evaluate(const std::vector<Claim>& claims, const Measurements& measurements,
                                 const Looks& looks = {});

/// Gates of the claims that rest on simulations and have no band of their own: this machine's measurements (`fresh`)
/// against the committed ones (`accepted`). A gate breaks when a measure of its claim differs by more than chance
/// allows: Welch's t-test of the two means, at a level that lets all gates together raise a false alarm once in a
/// thousand times. Without a fresh or an accepted measurement, or with a single sample, there is no gate.
void judge_run_gates(std::vector<Evaluation>& evaluations, const Measurements& fresh, const Measurements& accepted);

/// How many of each verdict and gate.
struct ClaimCounts {
  std::size_t reproduced = 0, not_reproduced = 0, not_decidable = 0;
  std::size_t gates_holding = 0, gates_broken = 0;
};
ClaimCounts count(const std::vector<Evaluation>& evaluations);
/// The same of the claims of one origin.
ClaimCounts count(const std::vector<Evaluation>& evaluations, Origin origin);

/// A line for the statements of the paper and one for what was worked out from its numbers: how many are reproduced,
/// not reproduced, not decidable.
std::string counts_text(const std::vector<Evaluation>& evaluations);

/// {"claims": [{"id", "figure", "quantity", "unit", "paper", "ours", "interval", "deviation", "paper_band", "verdict",
/// "gate", "origin", "lack", "reason"}, …]}.
nlohmann::ordered_json claims_json(const std::vector<Evaluation>& evaluations);

/// JUnit XML: each claim is a test case. A broken gate is a failure, with our number and what it may be; a claim
/// without a gate, undecided or not measured here, is skipped, with the reason.
std::string claims_junit(const std::vector<Evaluation>& evaluations);

}  // namespace slfb
