#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/readings/choices.hpp"

/// Which reading of a source do its printed numbers speak for? From plain numbers to implausibility, evidence and the
/// posterior of each choice.
///
/// All numbers are above zero and are compared by the logarithm of ours over the printed one: their scatter grows with
/// them. The width of a comparison is the sum of four variances, each of them measured or printed, none set: our
/// mean's, that of one sample (the source has one drop, or one bed), what another grid changes, and what the print
/// leaves open.
namespace slfb::readings {

/// What a printed number is used for: choices are made by the first kind and tested by the second.
enum class Part { calibration, test };

struct PrintedNumber {
  std::string title;     ///< "V_2 at 0.06 m/s"
  std::string quantity;  ///< numbers of one quantity tell much the same
  std::string block;     ///< numbers of one block come from the same drops, or the same bed
  double value = 0.0;    ///< above zero
  /// What the print leaves open: half its last digit, or half the difference where it gives two numbers for one thing.
  double half_width = 0.0;
  Part part = Part::test;
};

/// What the runs of one reading give.
struct ReadingRuns {
  Reading reading;
  /// By number: natural logarithms of its samples, one for each drop or each bed; empty where nothing was run, not a
  /// number for a drop that does not have it (a sphere that does not arrive). Numbers of one block have their samples
  /// in the same order.
  std::vector<std::vector<double>> samples = {};
  /// By number: standard error of a single sample by its own series (the mean of a bed over time); 0 where it has none.
  std::vector<double> own_errors = {};
};

/// Variances and covariances of relative deviations.
struct Widths {
  Eigen::MatrixXd chance;            ///< covariance of one sample, over all numbers; 0 between blocks
  std::vector<std::size_t> freedom;  ///< by number: degrees of freedom of its variance; 0: from own series alone
  Eigen::VectorXd grid;              ///< variance that another grid brings; 0 where no number of the quantity tells
  Eigen::VectorXd print;             ///< variance of a value that lies anywhere within the half width
};

/// \param grid factor whose levels are grids: readings that differ in it alone tell what a grid changes. A number that
/// was not run with several grids takes the mean of the others of its quantity.
Widths measure_widths(const std::vector<PrintedNumber>& numbers, const std::vector<ReadingRuns>& runs,
                      std::optional<std::size_t> grid);

/// One printed number and one reading.
struct Comparison {
  std::size_t samples = 0;      ///< that have the number
  std::size_t lost = 0;         ///< drops that do not have it
  double ours = 0.0;            ///< geometric mean; not a number without a sample
  double relative_error = 0.0;  ///< standard error of that mean, over it
  double deviation = 0.0;       ///< logarithm of ours over the printed one
  double implausibility = 0.0;  ///< its magnitude over the square root of the summed variances
};

/// What all numbers say of one reading.
struct Assessment {
  std::vector<Comparison> comparisons;  ///< by number
  bool ruled_out = false;
  std::string reason;  ///< why it is ruled out; empty otherwise
  /// Logarithms (base 10) of the likelihood, over that of the best reading; 0 for no
  /// block, empty where a block was not run.
  std::optional<double> calibration, test;
};

/// Beyond this a number is implausible, whatever the distribution: at most one in twenty lies farther out when it has
/// one maximum (Pukelsheim 1994, Am. Stat. 48, 88; in history matching since Craig et al. 1997).
inline constexpr double implausible = 3.0;

/// Standard errors within which 95 of 100 Gaussian values lie.
inline constexpr double inside_95_percent = 1.96;

/// Numbers that some reading comes near (implausibility of at most `implausible`). One that none comes near tells
/// readings apart no more than a mistake in the print does, and counts in neither rule nor likelihood. Nor does a
/// calibration number that only such readings come near as miss the other calibration numbers of its block: there the
/// print contradicts itself by all readings, and the number that more of them come near counts.
std::vector<bool> reached_by_any(const std::vector<PrintedNumber>& numbers, const std::vector<ReadingRuns>& runs,
                                 const Widths& widths);

/// Compares every reading with every number.
///
/// A reading is ruled out when the largest implausibility of its calibration numbers, or the second largest of its test
/// numbers, is above `implausible`. The likelihood of a block is Student's distribution with the covariance of its
/// numbers and the degrees of freedom with which chance was measured. A drop that does not arrive lowers it by the
/// chance (k + 1)/(n + 2) that one does; where none arrives the spread of the number over all readings takes the place
/// of its own. Blocks are not independent, since a reading that errs in one errs in its neighbour: the sum over n
/// blocks is weighted by 1/(1 + (n - 1) r) (Kish 1965, Survey Sampling), r the mean correlation of the deviations of
/// one quantity over the readings that are not ruled out.
std::vector<Assessment> assess(const std::vector<PrintedNumber>& numbers, const std::vector<ReadingRuns>& runs,
                               const Widths& widths, const std::vector<bool>& reached);

/// Logarithm (base 10) of the evidence that a printed statement weighs against a reading that departs from it.
inline constexpr double penalty_per_departure = 1.0;

/// A combination of levels, run or not, with its predicted evidence.
struct RankedReading {
  Reading reading;
  double log10_evidence = 0.0;  ///< over that of the best
};

/// What the numbers say of each choice, from an emulator of each number: all combinations of the levels that were
/// tried.
struct Posterior {
  std::vector<std::vector<double>> levels;  ///< by factor and level; 0 for a level that was not tried
  std::vector<RankedReading> best;          ///< the first ones, at most twenty
};

/// \param parts the numbers that speak \param penalised departures from the print count against a reading
/// Throws std::invalid_argument for more than two million combinations, or fewer than three readings that have a
/// number.
Posterior posterior(const Choices& choices, const std::vector<PrintedNumber>& numbers,
                    const std::vector<ReadingRuns>& runs, const Widths& widths, const std::vector<bool>& reached,
                    std::vector<Part> parts, bool penalised);

/// How far the levels of a factor move a number, over the width of its comparison.
struct Sensitivity {
  std::size_t number;
  double effect;  ///< largest minus smallest term of its levels, over the square root of the summed variances
};

/// By factor: the numbers that move by more than two widths, most first.
std::vector<std::vector<Sensitivity>> sensitivities(const Choices& choices, const std::vector<PrintedNumber>& numbers,
                                                    const std::vector<ReadingRuns>& runs, const Widths& widths);

/// Whether a choice can be told from the numbers at all.
struct Identification {
  std::size_t trials = 0;
  std::size_t hits = 0;           ///< the true level was the most probable one
  double mean_probability = 0.0;  ///< of the true level
  double chance = 0.0;            ///< of a hit by guessing: one over the number of levels that were tried
  bool identified = false;        ///< so many hits come by chance in less than one of twenty cases
};

/// The synthetic twin: each reading in turn gives one drop, and another of its beds where it has one, rounded to the
/// digits of the print, in the place of the printed numbers; all else that is known comes from the other readings. By
/// factor.
std::vector<Identification> identify(const Choices& choices, const std::vector<PrintedNumber>& numbers,
                                     const std::vector<ReadingRuns>& runs, const Widths& widths);

}  // namespace slfb::readings
