// Observed order and grid convergence index (Roache 1994, Celik et al. 2008).
#include "experiments/numerics/convergence/grid_convergence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/numerics/convergence/sequences.hpp"
#include "experiments/peng_2014/grid_convergence/run_sequences.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb::convergence {
namespace {

/// φ = 3 + C h^p on cells of 1, 1.5 and 4.
std::vector<Level> of_order(double order, double half_width = 0.0) {
  std::vector<Level> levels;
  for (const double h : {4.0, 1.0, 1.5}) levels.push_back({h, 3.0 + 0.02 * std::pow(h, order), half_width});
  return levels;
}

TEST(GridConvergence, FindsOrderAndLimitOfAnExactSequence) {
  for (const double order : {1.0, 1.5, 2.0}) {
    const GridConvergence found = analyse(of_order(order));
    EXPECT_EQ(found.behaviour, Behaviour::converges);
    EXPECT_NEAR(found.order, order, 1e-5);
    EXPECT_NEAR(found.extrapolated, 3.0, 1e-6);
    EXPECT_NEAR(found.index, 1.25 * 0.02 / 3.02, 1e-6);
    EXPECT_FALSE(found.order_interval);
  }
}

TEST(GridConvergence, RepeatsThePublishedExample) {
  // Celik et al. (2008), Table 1: reattachment length with monotone and with oscillating convergence.
  const GridConvergence monotone = analyse({{1.0, 6.063, 0.0}, {1.5, 5.972, 0.0}, {1.5 * 1.333, 5.863, 0.0}});
  EXPECT_EQ(monotone.behaviour, Behaviour::converges);
  EXPECT_NEAR(monotone.order, 1.53, 0.01);
  EXPECT_NEAR(monotone.extrapolated, 6.1685, 2e-3);
  EXPECT_NEAR(monotone.index, 0.022, 5e-4);
  const GridConvergence oscillating = analyse({{1.0, 6.0042, 0.0}, {2.0, 5.9624, 0.0}, {4.0, 6.0909, 0.0}});
  EXPECT_EQ(oscillating.behaviour, Behaviour::oscillates);
}

TEST(GridConvergence, GivesNoOrderWhereThereIsNone) {
  const GridConvergence oscillates = analyse({{1.0, 0.566, 0.0}, {2.0, 0.588, 0.0}, {4.0, 0.574, 0.0}});
  EXPECT_EQ(oscillates.behaviour, Behaviour::oscillates);
  // Twice the change for half the cells: the formula with the absolute value would call this first order.
  const GridConvergence diverges = analyse({{1.0, 1.0, 0.0}, {2.0, 1.2, 0.0}, {4.0, 1.3, 0.0}});
  EXPECT_EQ(diverges.behaviour, Behaviour::diverges);
  for (const GridConvergence* one : {&oscillates, &diverges}) {
    EXPECT_TRUE(std::isnan(one->order));
    EXPECT_TRUE(std::isnan(one->index));
    EXPECT_TRUE(std::isnan(one->index_of(1.0)));
    EXPECT_NE(describe(*one).find("no order"), std::string::npos);
  }
  EXPECT_NEAR(oscillates.half_range, 0.011 / 0.566, 1e-12);
}

TEST(GridConvergence, IntervalsOfTheValuesBecomeThoseOfTheOrder) {
  const GridConvergence found = analyse(of_order(2.0, 2e-3));
  ASSERT_EQ(found.behaviour, Behaviour::converges);
  EXPECT_LT(found.order_interval->first, 2.0);
  EXPECT_GT(found.order_interval->second, 2.0);
  const GridConvergence finer = analyse(of_order(2.0, 1e-3));
  EXPECT_LT(finer.order_interval->second - finer.order_interval->first,
            found.order_interval->second - found.order_interval->first);
  // As wide as the differences: nothing can be said.
  const GridConvergence hidden = analyse(of_order(2.0, 0.1));
  EXPECT_EQ(hidden.behaviour, Behaviour::undecided);
  EXPECT_TRUE(std::isnan(hidden.order));
  EXPECT_GT(hidden.shares.front(), 0.0);
}

TEST(GridConvergence, ASingleSampleSaysNothing) {
  auto levels = of_order(2.0, 1e-3);
  levels[0].half_width = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(analyse(levels).behaviour, Behaviour::undecided);
}

TEST(GridConvergence, TakesGridsThatAreFarEnoughApart) {
  const auto sizes = [](const std::vector<double>& given) {
    std::vector<Level> levels;
    for (const double size : given) levels.push_back({size, 1.0, 0.0});
    const auto chosen = choose_levels(levels);
    return std::array{chosen[0].size, chosen[1].size, chosen[2].size};
  };
  EXPECT_EQ(sizes({10.0, 8.3, 7.1, 6.25, 5.0}), (std::array{5.0, 7.1, 10.0}));
  EXPECT_EQ(sizes({4.2, 6.25, 7.1}), (std::array{4.2, 6.25, 7.1}));
  EXPECT_THROW(sizes({1.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(sizes({1.0, 2.0, 2.0}), std::invalid_argument);
  EXPECT_THROW(sizes({0.0, 1.0, 2.0}), std::invalid_argument);
}

TEST(GridConvergence, ReadsEverySequenceOfTheCommittedStudies) {
  const Folder nothing_here;
  const auto sequences = study_sequences(nothing_here.path());
  ASSERT_FALSE(sequences.empty());
  for (const Sequence& sequence : sequences)
    for (const QuantitySequence& of : sequence.quantities)
      EXPECT_GE(of.levels.size(), 3u) << sequence.title << ' ' << of.quantity;
}

TEST(GridConvergence, ReadsTheCommittedRunsOfThreeGrids) {
  const Folder nothing_here;
  const auto sequences = grid_convergence::run_sequences(nothing_here.path());
  const auto lattice = std::ranges::find(sequences, "lattice scene, springs 1e3 N/m, 0.10 m/s", &Sequence::title);
  ASSERT_NE(lattice, sequences.end());
  for (const QuantitySequence& of : lattice->quantities) EXPECT_EQ(of.levels.size(), 3u) << of.quantity;
}

}  // namespace
}  // namespace slfb::convergence
