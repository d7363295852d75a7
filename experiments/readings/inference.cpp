#include "experiments/readings/inference.hpp"

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiments/readings/emulator.hpp"

namespace slfb::readings {
namespace {

constexpr std::size_t most_combinations = 2'000'000;
constexpr std::size_t most_ranked = 20;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Numbers of one block: few, so that their matrices need no memory of their own.
constexpr int most_of_a_block = 8;
using BlockVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_of_a_block, 1>;
using BlockMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_of_a_block, most_of_a_block>;

/// The numbers of one block that count.
struct Block {
  std::string name;
  Part part;
  std::vector<std::size_t> numbers;
};

std::vector<Block> blocks_of(const std::vector<PrintedNumber>& numbers, const std::vector<bool>& counts) {
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!counts[i]) continue;
    const PrintedNumber& number = numbers[i];
    auto block = std::ranges::find_if(
        blocks, [&](const Block& known) { return known.name == number.block && known.part == number.part; });
    if (block == blocks.end()) block = blocks.insert(blocks.end(), {number.block, number.part, {}});
    block->numbers.push_back(i);
    if (block->numbers.size() > most_of_a_block)
      throw std::invalid_argument(fmt::format("more than {} numbers in block \"{}\"", most_of_a_block, number.block));
  }
  return blocks;
}

std::vector<double> present(const std::vector<double>& samples) {
  std::vector<double> values;
  for (const double sample : samples)
    if (std::isfinite(sample)) values.push_back(sample);
  return values;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? nan : sum / static_cast<double>(values.size());
}

/// Sum over readings of products of deviations from the reading's mean, and its degrees of freedom, where both numbers
/// have a sample.
std::pair<double, std::size_t> pooled(const std::vector<ReadingRuns>& runs, std::size_t a, std::size_t b) {
  double products = 0.0;
  std::size_t freedom = 0;
  for (const ReadingRuns& one : runs) {
    std::vector<double> x, y;
    const auto &xs = one.samples[a], &ys = one.samples[b];
    for (std::size_t k = 0; k < std::min(xs.size(), ys.size()); ++k)
      if (std::isfinite(xs[k]) && std::isfinite(ys[k])) {
        x.push_back(xs[k]);
        y.push_back(ys[k]);
      }
    if (x.size() < 2) continue;
    const double mean_x = mean_of(x), mean_y = mean_of(y);
    for (std::size_t k = 0; k < x.size(); ++k) products += (x[k] - mean_x) * (y[k] - mean_y);
    freedom += x.size() - 1;
  }
  return {products, freedom};
}

bool equal_but_for(const Reading& a, const Reading& b, std::size_t factor) {
  for (std::size_t f = 0; f < a.size(); ++f)
    if ((a[f] == b[f]) == (f == factor)) return false;
  return true;
}

/// Logarithm of the density of Student's distribution with this scale matrix; the normal one for no degrees of freedom.
double log_density(const BlockVector& deviation, const BlockMatrix& scale, std::size_t freedom) {
  const Eigen::LLT<BlockMatrix> factor(scale);
  const double size = static_cast<double>(deviation.size());
  const double log_root = factor.matrixLLT().diagonal().array().log().sum();
  const BlockVector reduced = factor.matrixL().solve(deviation);
  const double square = reduced.squaredNorm();
  if (freedom == 0) return -0.5 * square - log_root - 0.5 * size * std::log(2.0 * std::numbers::pi);
  const auto nu = static_cast<double>(freedom);
  return std::lgamma(0.5 * (nu + size)) - std::lgamma(0.5 * nu) - 0.5 * size * std::log(nu * std::numbers::pi) -
         log_root - 0.5 * (nu + size) * std::log1p(square / nu);
}

BlockMatrix part_of(const Eigen::MatrixXd& matrix, const std::vector<std::size_t>& numbers) {
  const auto size = static_cast<Eigen::Index>(numbers.size());
  BlockMatrix part(size, size);
  for (Eigen::Index a = 0; a < size; ++a)
    for (Eigen::Index b = 0; b < size; ++b)
      part(a, b) = matrix(static_cast<Eigen::Index>(numbers[static_cast<std::size_t>(a)]),
                          static_cast<Eigen::Index>(numbers[static_cast<std::size_t>(b)]));
  return part;
}

std::size_t freedom_of(const Block& block, const Widths& widths) {
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const std::size_t i : block.numbers) least = std::min(least, widths.freedom[i]);
  return least;
}

Comparison compare(const PrintedNumber& number, std::size_t i, const ReadingRuns& runs, const Widths& widths) {
  const auto place = static_cast<Eigen::Index>(i);
  const std::vector<double> values = present(runs.samples[i]);
  Comparison comparison{values.size(), runs.samples[i].size() - values.size(), nan, nan, nan, nan};
  if (values.empty()) return comparison;
  const double mean = mean_of(values), chance = widths.chance(place, place);
  const double of_mean = chance / static_cast<double>(values.size());
  comparison.ours = std::exp(mean);
  comparison.relative_error = std::sqrt(of_mean);
  comparison.deviation = mean - std::log(number.value);
  comparison.implausibility =
      std::abs(comparison.deviation) / std::sqrt(of_mean + chance + widths.grid[place] + widths.print[place]);
  return comparison;
}

/// How much the sum over the blocks of a part counts, see assess().
double weight_of(Part part, const std::vector<PrintedNumber>& numbers, const std::vector<bool>& reached,
                 const std::vector<Assessment>& assessments) {
  const bool any_left = std::ranges::any_of(assessments, [](const Assessment& one) { return !one.ruled_out; });
  const auto standardised = [&](const Assessment& one, std::size_t i) {
    const Comparison& comparison = one.comparisons[i];
    return std::copysign(comparison.implausibility, comparison.deviation);
  };
  double correlations = 0.0;
  std::size_t pairs = 0, most = 1;
  std::map<std::string, std::size_t> of_quantity;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!reached[i] || numbers[i].part != part) continue;
    most = std::max(most, ++of_quantity[numbers[i].quantity]);
    for (std::size_t j = 0; j < i; ++j) {
      if (!reached[j] || numbers[j].part != part || numbers[j].quantity != numbers[i].quantity) continue;
      double product = 0.0, a = 0.0, b = 0.0;
      for (const Assessment& one : assessments) {
        if (one.ruled_out && any_left) continue;
        const double x = standardised(one, i), y = standardised(one, j);
        if (!std::isfinite(x) || !std::isfinite(y)) continue;
        product += x * y;
        a += x * x;
        b += y * y;
      }
      if (!(a > 0.0) || !(b > 0.0)) continue;
      correlations += product / std::sqrt(a * b);
      ++pairs;
    }
  }
  if (pairs == 0) return 1.0;
  const double mean = std::clamp(correlations / static_cast<double>(pairs), 0.0, 1.0);
  return 1.0 / (1.0 + static_cast<double>(most - 1) * mean);
}

/// Rules out by the largest implausibility of the calibration numbers and the second largest of the others.
void rule(const std::vector<PrintedNumber>& numbers, const std::vector<bool>& reached, Assessment& assessment) {
  std::vector<std::pair<double, std::size_t>> calibration, test;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (const double value = assessment.comparisons[i].implausibility; reached[i] && value > implausible)
      (numbers[i].part == Part::calibration ? calibration : test).emplace_back(value, i);
  std::ranges::sort(calibration, std::greater{});
  std::ranges::sort(test, std::greater{});
  const auto named = [&](const std::pair<double, std::size_t>& one) {
    return fmt::format("{} ({:.1f} widths)", numbers[one.second].title, one.first);
  };
  if (!calibration.empty()) {
    assessment.reason = named(calibration.front());
  } else if (test.size() >= 2) {
    assessment.reason = fmt::format("{} and {}", named(test[0]), named(test[1]));
  }
  assessment.ruled_out = !assessment.reason.empty();
}

/// Logarithms of the likelihoods of the blocks under all readings.
class BlockLikelihood {
 public:
  BlockLikelihood(const Block& block, const std::vector<PrintedNumber>& numbers, const std::vector<ReadingRuns>& runs,
                  const Widths& widths)
      : block_(block), widths_(widths), chance_(part_of(widths.chance, block.numbers)) {
    const auto size = static_cast<Eigen::Index>(block.numbers.size());
    printed_.resize(size);
    centre_.resize(size);
    spread_.resize(size);
    for (Eigen::Index a = 0; a < size; ++a) {
      const std::size_t i = block.numbers[static_cast<std::size_t>(a)];
      printed_[a] = std::log(numbers[i].value);
      std::vector<double> means;
      for (const ReadingRuns& one : runs)
        if (const double mean = mean_of(present(one.samples[i])); std::isfinite(mean)) means.push_back(mean);
      centre_[a] = means.empty() ? printed_[a] : mean_of(means);
      double squares = 0.0;
      for (const double mean : means) squares += (mean - centre_[a]) * (mean - centre_[a]);
      spread_[a] = means.size() < 2 ? 0.0 : squares / static_cast<double>(means.size() - 1);
    }
    for (const ReadingRuns& one : runs) some_lost_ = some_lost_ || complete(one).size() < count(one);
  }

  /// Empty where the block was not run.
  [[nodiscard]] std::optional<double> under(const ReadingRuns& runs) const {
    const std::size_t all = count(runs);
    if (all == 0) return std::nullopt;
    const std::vector<std::size_t> whole = complete(runs);
    const auto arrived = static_cast<double>(whole.size());
    const double chance_of_arrival = some_lost_ ? std::log((arrived + 1.0) / (static_cast<double>(all) + 2.0)) : 0.0;
    const auto size = printed_.size();
    if (whole.empty())
      return chance_of_arrival + density(centre_, BlockMatrix(chance_ + BlockMatrix(spread_.asDiagonal())));
    BlockVector mean = BlockVector::Zero(size);
    for (Eigen::Index a = 0; a < size; ++a)
      for (const std::size_t k : whole)
        mean[a] += runs.samples[block_.numbers[static_cast<std::size_t>(a)]][k] / arrived;
    return chance_of_arrival + density(mean, BlockMatrix(chance_ * (1.0 + 1.0 / arrived)));
  }

  /// Of a predicted mean and the variances of the prediction.
  [[nodiscard]] double under(const BlockVector& mean, const BlockVector& variances) const {
    return density(mean, BlockMatrix(chance_ + BlockMatrix(variances.asDiagonal())));
  }

 private:
  [[nodiscard]] double density(const BlockVector& mean, BlockMatrix scale) const {
    for (Eigen::Index a = 0; a < printed_.size(); ++a) {
      const auto i = static_cast<Eigen::Index>(block_.numbers[static_cast<std::size_t>(a)]);
      scale(a, a) += widths_.grid[i] + widths_.print[i];
    }
    return log_density(printed_ - mean, scale, freedom_of(block_, widths_));
  }

  /// Samples of a block, 0 where one of its numbers was not run.
  [[nodiscard]] std::size_t count(const ReadingRuns& runs) const {
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const std::size_t i : block_.numbers) least = std::min(least, runs.samples[i].size());
    return least;
  }

  /// Places of the samples that have all numbers of the block.
  [[nodiscard]] std::vector<std::size_t> complete(const ReadingRuns& runs) const {
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < count(runs); ++k)
      if (std::ranges::all_of(block_.numbers, [&](std::size_t i) { return std::isfinite(runs.samples[i][k]); }))
        places.push_back(k);
    return places;
  }

  const Block& block_;
  const Widths& widths_;
  BlockMatrix chance_;
  BlockVector printed_, centre_, spread_;
  bool some_lost_ = false;
};

/// One emulator a number, from the readings that have it; none for fewer than three.
std::vector<std::optional<Emulator>> emulators(const std::vector<PrintedNumber>& numbers,
                                               const std::vector<ReadingRuns>& runs, const Widths& widths) {
  std::vector<std::optional<Emulator>> all;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double chance = widths.chance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i));
    std::vector<Reading> readings;
    std::vector<double> means, variances;
    for (const ReadingRuns& one : runs) {
      const std::vector<double> values = present(one.samples[i]);
      if (values.empty()) continue;
      readings.push_back(one.reading);
      means.push_back(mean_of(values));
      variances.push_back(chance / static_cast<double>(values.size()));
    }
    if (readings.size() < 3) {
      all.emplace_back();
    } else {
      all.emplace_back(Emulator(readings, means, variances));
    }
  }
  return all;
}

/// By factor: the levels that some reading with samples has.
std::vector<std::vector<std::size_t>> tried_levels(std::size_t factors, const std::vector<ReadingRuns>& runs) {
  std::vector<std::set<std::size_t>> tried(factors);
  for (const ReadingRuns& one : runs)
    if (std::ranges::any_of(one.samples, [](const auto& samples) { return !samples.empty(); }))
      for (std::size_t f = 0; f < factors; ++f) tried[f].insert(one.reading[f]);
  std::vector<std::vector<std::size_t>> lists;
  for (const auto& levels : tried) lists.emplace_back(levels.begin(), levels.end());
  return lists;
}

std::vector<Assessment> compare_all(const std::vector<PrintedNumber>& numbers, const std::vector<ReadingRuns>& runs,
                                    const Widths& widths, const std::vector<bool>& reached) {
  std::vector<Assessment> assessments;
  for (const ReadingRuns& one : runs) {
    Assessment assessment;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      assessment.comparisons.push_back(compare(numbers[i], i, one, widths));
    rule(numbers, reached, assessment);
    assessments.push_back(std::move(assessment));
  }
  return assessments;
}

/// A value as the print would have it.
double rounded(double value, double half_width) {
  if (!(half_width > 0.0)) return value;
  const double step = 2.0 * half_width;
  return std::max(std::round(value / step) * step, 0.5 * step);
}

/// Half the mean square of what readings differ in that differ in the factor `grid` alone, less what chance does to it.
/// Where no such readings have a number, the mean over those of its quantity that have one stands for it.
Eigen::VectorXd variance_of_grid(const std::vector<PrintedNumber>& numbers, const std::vector<ReadingRuns>& runs,
                                 std::size_t grid, const Eigen::MatrixXd& chance) {
  std::vector<std::optional<double>> measured(numbers.size());
  std::map<std::string, std::vector<double>> of_quantity;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto a = static_cast<Eigen::Index>(i);
    double squares = 0.0;
    std::size_t pairs = 0;
    for (std::size_t r = 0; r < runs.size(); ++r)
      for (std::size_t s = 0; s < r; ++s) {
        if (!equal_but_for(runs[r].reading, runs[s].reading, grid)) continue;
        const auto x = present(runs[r].samples[i]), y = present(runs[s].samples[i]);
        if (x.empty() || y.empty()) continue;
        const double by_chance =
            chance(a, a) * (1.0 / static_cast<double>(x.size()) + 1.0 / static_cast<double>(y.size()));
        squares += 0.5 * (std::pow(mean_of(x) - mean_of(y), 2) - by_chance);
        ++pairs;
      }
    if (pairs == 0) continue;
    measured[i] = std::max(0.0, squares / static_cast<double>(pairs));
    of_quantity[numbers[i].quantity].push_back(*measured[i]);
  }
  Eigen::VectorXd variance = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto known = of_quantity.find(numbers[i].quantity);
    variance[static_cast<Eigen::Index>(i)] = measured[i]                  ? *measured[i]
                                             : known == of_quantity.end() ? 0.0
                                                                          : mean_of(known->second);
  }
  return variance;
}

}  // namespace

Widths measure_widths(const std::vector<PrintedNumber>& numbers, const std::vector<ReadingRuns>& runs,
                      std::optional<std::size_t> grid) {
  const auto size = static_cast<Eigen::Index>(numbers.size());
  Widths widths{Eigen::MatrixXd::Zero(size, size), std::vector<std::size_t>(numbers.size(), 0),
                Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size)};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto a = static_cast<Eigen::Index>(i);
    const auto [squares, freedom] = pooled(runs, i, i);
    widths.freedom[i] = freedom;
    if (freedom > 0) {
      widths.chance(a, a) = squares / static_cast<double>(freedom);
    } else {
      double errors = 0.0;
      std::size_t count = 0;
      for (const ReadingRuns& one : runs)
        if (!one.own_errors.empty() && one.own_errors[i] > 0.0) {
          errors += one.own_errors[i] * one.own_errors[i];
          ++count;
        }
      if (count > 0) widths.chance(a, a) = errors / static_cast<double>(count);
    }
    // Evenly spread over the half width on both sides.
    widths.print[a] = std::pow(numbers[i].half_width / numbers[i].value, 2) / 3.0;
  }
  if (grid) widths.grid = variance_of_grid(numbers, runs, *grid, widths.chance);
  for (const Block& block : blocks_of(numbers, std::vector<bool>(numbers.size(), true))) {
    BlockMatrix correlation = BlockMatrix::Identity(static_cast<Eigen::Index>(block.numbers.size()),
                                                    static_cast<Eigen::Index>(block.numbers.size()));
    for (std::size_t p = 0; p < block.numbers.size(); ++p)
      for (std::size_t q = 0; q < p; ++q) {
        const std::size_t i = block.numbers[p], j = block.numbers[q];
        const auto [products, freedom] = pooled(runs, i, j);
        const double root = std::sqrt(pooled(runs, i, i).first * pooled(runs, j, j).first);
        const double value = freedom > 1 && root > 0.0 ? std::clamp(products / root, -1.0, 1.0) : 0.0;
        correlation(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(q)) = value;
        correlation(static_cast<Eigen::Index>(q), static_cast<Eigen::Index>(p)) = value;
      }
    // A correlation from few samples may be no correlation matrix: towards independence until it is one.
    const double ridge = 1e-6;
    for (int step = 0; step < 100; ++step) {
      BlockMatrix tried = correlation;
      tried.diagonal().array() += ridge;
      const Eigen::LLT<BlockMatrix> factor(tried);
      if (factor.info() == Eigen::Success && factor.matrixLLT().diagonal().minCoeff() > std::sqrt(ridge)) break;
      correlation *= 0.95;
      correlation.diagonal().setOnes();
    }
    for (std::size_t p = 0; p < block.numbers.size(); ++p)
      for (std::size_t q = 0; q < block.numbers.size(); ++q) {
        const auto a = static_cast<Eigen::Index>(block.numbers[p]), b = static_cast<Eigen::Index>(block.numbers[q]);
        if (p != q)
          widths.chance(a, b) = correlation(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(q)) *
                                std::sqrt(widths.chance(a, a) * widths.chance(b, b));
      }
  }
  return widths;
}

std::vector<bool> reached_by_any(const std::vector<PrintedNumber>& numbers, const std::vector<ReadingRuns>& runs,
                                 const Widths& widths) {
  // By number: the readings that come near it.
  std::vector<std::set<std::size_t>> near(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t r = 0; r < runs.size(); ++r)
      if (compare(numbers[i], i, runs[r], widths).implausibility <= implausible) near[i].insert(r);
  std::vector<bool> reached;
  for (const auto& readings : near) reached.push_back(!readings.empty());

  std::map<std::string, std::vector<std::size_t>> calibration;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i].part == Part::calibration && reached[i]) calibration[numbers[i].block].push_back(i);
  for (auto& [block, members] : calibration) {
    std::ranges::stable_sort(members, std::greater{}, [&](std::size_t i) { return near[i].size(); });
    std::set<std::size_t> together = near[members.front()];
    for (const std::size_t i : members) {
      std::set<std::size_t> rest;
      std::ranges::set_intersection(together, near[i], std::inserter(rest, rest.end()));
      reached[i] = !rest.empty();
      if (reached[i]) together = std::move(rest);
    }
  }
  return reached;
}

std::vector<Assessment> assess(const std::vector<PrintedNumber>& numbers, const std::vector<ReadingRuns>& runs,
                               const Widths& widths, const std::vector<bool>& reached) {
  std::vector<Assessment> assessments = compare_all(numbers, runs, widths, reached);
  const std::vector<Block> blocks = blocks_of(numbers, reached);
  for (const Part part : {Part::calibration, Part::test}) {
    const double weight = weight_of(part, numbers, reached, assessments);
    const auto target = part == Part::calibration ? &Assessment::calibration : &Assessment::test;
    std::vector<BlockLikelihood> likelihoods;
    for (const Block& block : blocks)
      if (block.part == part) likelihoods.emplace_back(block, numbers, runs, widths);
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t r = 0; r < runs.size(); ++r) {
      std::optional<double> sum = 0.0;
      for (const BlockLikelihood& likelihood : likelihoods) {
        const auto one = likelihood.under(runs[r]);
        sum = sum && one ? std::optional(*sum + *one) : std::nullopt;
      }
      if (!sum) continue;
      assessments[r].*target = weight * *sum / std::numbers::ln10;
      best = std::max(best, *(assessments[r].*target));
    }
    for (Assessment& assessment : assessments)
      if (assessment.*target) *(assessment.*target) -= best;
  }
  return assessments;
}

Posterior posterior(const Choices& choices, const std::vector<PrintedNumber>& numbers,
                    const std::vector<ReadingRuns>& runs, const Widths& widths, const std::vector<bool>& reached,
                    std::vector<Part> parts, bool penalised) {
  const auto emulated = emulators(numbers, runs, widths);
  std::vector<bool> counts(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    counts[i] = reached[i] && emulated[i] && std::ranges::find(parts, numbers[i].part) != parts.end();
  const std::vector<Block> blocks = blocks_of(numbers, counts);
  if (blocks.empty()) throw std::invalid_argument("posterior: no number has been run for three readings");
  std::vector<BlockLikelihood> likelihoods;
  for (const Block& block : blocks) likelihoods.emplace_back(block, numbers, runs, widths);
  const std::vector<Assessment> direct = compare_all(numbers, runs, widths, reached);
  std::map<Part, double> weights;
  for (const Part part : parts) weights[part] = weight_of(part, numbers, counts, direct);

  const auto tried = tried_levels(choices.factors.size(), runs);
  std::size_t combinations = 1;
  for (const auto& levels : tried) {
    if (levels.empty()) throw std::invalid_argument("posterior: a choice has no level that was run");
    combinations *= levels.size();
    if (combinations > most_combinations)
      throw std::invalid_argument(fmt::format("posterior: more than {} combinations of levels", most_combinations));
  }
  const auto reading_at = [&](std::size_t place) {
    Reading reading(tried.size());
    for (std::size_t f = 0; f < tried.size(); ++f) {
      reading[f] = tried[f][place % tried[f].size()];
      place /= tried[f].size();
    }
    return reading;
  };
  std::vector<double> logs(combinations);
  for (std::size_t place = 0; place < combinations; ++place) {
    const Reading reading = reading_at(place);
    double sum = 0.0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const auto size = static_cast<Eigen::Index>(blocks[b].numbers.size());
      BlockVector mean(size), variances(size);
      for (Eigen::Index a = 0; a < size; ++a) {
        const auto predicted = emulated[blocks[b].numbers[static_cast<std::size_t>(a)]]->predict(reading);
        mean[a] = predicted.mean;
        variances[a] = predicted.variance;
      }
      sum += weights.at(blocks[b].part) * likelihoods[b].under(mean, variances);
    }
    if (penalised)
      sum -= penalty_per_departure * std::numbers::ln10 * static_cast<double>(choices.departures_of(reading).size());
    logs[place] = sum;
  }
  const double best = *std::ranges::max_element(logs);
  Posterior result;
  for (const Factor& factor : choices.factors) result.levels.emplace_back(factor.levels.size(), 0.0);
  double total = 0.0;
  for (const double value : logs) total += std::exp(value - best);
  std::vector<std::size_t> order(combinations);
  for (std::size_t place = 0; place < combinations; ++place) {
    order[place] = place;
    const Reading reading = reading_at(place);
    for (std::size_t f = 0; f < reading.size(); ++f)
      result.levels[f][reading[f]] += std::exp(logs[place] - best) / total;
  }
  const std::size_t shown = std::min(most_ranked, combinations);
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(shown), order.end(),
                    [&](std::size_t a, std::size_t b) { return logs[a] > logs[b]; });
  for (std::size_t k = 0; k < shown; ++k)
    result.best.push_back({reading_at(order[k]), (logs[order[k]] - best) / std::numbers::ln10});
  return result;
}

std::vector<std::vector<Sensitivity>> sensitivities(const Choices& choices, const std::vector<PrintedNumber>& numbers,
                                                    const std::vector<ReadingRuns>& runs, const Widths& widths) {
  const auto emulated = emulators(numbers, runs, widths);
  const auto tried = tried_levels(choices.factors.size(), runs);
  std::vector<std::vector<Sensitivity>> all(choices.factors.size());
  for (std::size_t f = 0; f < choices.factors.size(); ++f) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!emulated[i] || tried[f].size() < 2) continue;
      double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
      for (const std::size_t level : tried[f]) {
        lowest = std::min(lowest, emulated[i]->effect(f, level));
        highest = std::max(highest, emulated[i]->effect(f, level));
      }
      const auto a = static_cast<Eigen::Index>(i);
      const double width = std::sqrt(widths.chance(a, a) + widths.grid[a] + widths.print[a] +
                                     emulated[i]->left_over() * emulated[i]->left_over());
      if (width > 0.0 && highest - lowest > 2.0 * width) all[f].push_back({i, (highest - lowest) / width});
    }
    std::ranges::sort(all[f], std::greater{}, &Sensitivity::effect);
  }
  return all;
}

std::vector<Identification> identify(const Choices& choices, const std::vector<PrintedNumber>& numbers,
                                     const std::vector<ReadingRuns>& runs, const Widths& widths) {
  std::vector<Identification> found(choices.factors.size());
  // By factor: how often each level was true, and told.
  std::vector<std::map<std::size_t, std::pair<double, double>>> levels(choices.factors.size());
  for (std::size_t twin = 0; twin < runs.size(); ++twin) {
    std::vector<PrintedNumber> printed = numbers;
    std::vector<bool> known(numbers.size(), false);
    // One sample of each block: the last one that has all its numbers.
    for (const Block& block : blocks_of(numbers, std::vector<bool>(numbers.size(), true))) {
      std::size_t count = std::numeric_limits<std::size_t>::max();
      for (const std::size_t i : block.numbers) count = std::min(count, runs[twin].samples[i].size());
      for (std::size_t k = count; k-- > 0;) {
        if (!std::ranges::all_of(block.numbers, [&](std::size_t i) { return std::isfinite(runs[twin].samples[i][k]); }))
          continue;
        for (const std::size_t i : block.numbers) {
          printed[i].value = rounded(std::exp(runs[twin].samples[i][k]), numbers[i].half_width);
          known[i] = true;
        }
        break;
      }
    }
    std::vector<ReadingRuns> others = runs;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(twin));
    if (std::ranges::none_of(known, [](bool one) { return one; }) || others.size() < 3) continue;
    const auto tried = tried_levels(choices.factors.size(), others);
    Posterior told;
    try {
      told = posterior(choices, printed, others, widths, known, {Part::calibration, Part::test}, false);
    } catch (const std::invalid_argument&) {
      continue;  // what this reading has was not run for three others
    }
    for (std::size_t f = 0; f < choices.factors.size(); ++f) {
      const std::size_t truth = runs[twin].reading[f];
      if (tried[f].size() < 2 || std::ranges::find(tried[f], truth) == tried[f].end()) continue;
      ++found[f].trials;
      found[f].mean_probability += told.levels[f][truth];
      const auto said = static_cast<std::size_t>(std::ranges::max_element(told.levels[f]) - told.levels[f].begin());
      if (said == truth) ++found[f].hits;
      levels[f][truth].first += 1.0;
      levels[f][said].second += 1.0;
    }
  }
  for (std::size_t f = 0; f < found.size(); ++f) {
    Identification& one = found[f];
    if (one.trials == 0) continue;
    const auto trials = static_cast<double>(one.trials);
    one.mean_probability /= trials;
    for (const auto& [level, count] : levels[f]) one.chance += count.first / trials * count.second / trials;
    const double by_chance = one.hits == 0 ? 1.0
                                           : gsl_cdf_binomial_Q(static_cast<unsigned>(one.hits - 1), one.chance,
                                                                static_cast<unsigned>(one.trials));
    one.identified = by_chance < 0.05;
  }
  return found;
}

}  // namespace slfb::readings
