// From numbers to what they say of the choices behind them. All numbers are made up, with known choices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/readings/emulator.hpp"
#include "experiments/readings/inference.hpp"

namespace slfb::readings {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Factors with two levels each; the second level of the last one departs from the print.
Choices two_level_choices(std::size_t factors) {
  Choices choices;
  for (std::size_t f = 0; f < factors; ++f) {
    const std::string name(1, static_cast<char>('a' + f));
    choices.factors.push_back(
        {name, name, "not said", "-", {{name + "1", "", {}, "", {}}, {name + "2", "", {}, "", {}}}});
  }
  choices.factors.back().levels[1].departs = "p. 1";
  return choices;
}

std::vector<Reading> all_readings(std::size_t factors) {
  std::vector<Reading> readings;
  for (std::size_t bits = 0; bits < (std::size_t{1} << factors); ++bits) {
    Reading reading;
    for (std::size_t f = 0; f < factors; ++f) reading.push_back((bits >> f) & 1U);
    readings.push_back(std::move(reading));
  }
  return readings;
}

PrintedNumber printed(double value, Part part = Part::test, const std::string& quantity = "speed",
                      const std::string& block = "drops") {
  return {quantity + " in " + block, quantity, block, value, 0.0, part};
}

Widths widths_of(const Eigen::MatrixXd& chance, std::size_t freedom) {
  const auto size = chance.rows();
  return {chance, std::vector<std::size_t>(static_cast<std::size_t>(size), freedom), Eigen::VectorXd::Zero(size),
          Eigen::VectorXd::Zero(size)};
}

TEST(Emulator, FindsTheTermsOfASumAndFillsTheGaps) {
  // y = 1 + 0.5 (second level of a) - 0.2 (second level of b), the others without effect; every other combination is
  // left out.
  const auto truth = [](const Reading& reading) {
    return 1.0 + 0.5 * static_cast<double>(reading[0]) - 0.2 * static_cast<double>(reading[1]);
  };
  std::vector<Reading> known, unknown;
  for (const Reading& reading : all_readings(5))
    (std::accumulate(reading.begin(), reading.end(), 0U) % 2 == 0 ? known : unknown).push_back(reading);
  std::vector<double> values;
  for (const Reading& reading : known) values.push_back(truth(reading));
  const Emulator emulator(known, values, std::vector<double>(known.size(), 1e-8));
  EXPECT_NEAR(emulator.effect(0, 1) - emulator.effect(0, 0), 0.5, 0.02);
  EXPECT_NEAR(emulator.effect(1, 1) - emulator.effect(1, 0), -0.2, 0.02);
  EXPECT_NEAR(emulator.effect(2, 1) - emulator.effect(2, 0), 0.0, 0.02);
  for (const Reading& reading : unknown) {
    const auto predicted = emulator.predict(reading);
    EXPECT_NEAR(predicted.mean, truth(reading), 0.03);
  }
}

TEST(Emulator, ItsIntervalsHoldWhatTheySay) {
  // Sums of random terms with random left-overs: of predictions of a reading that was left out, 95 % lie within 1.96
  // standard deviations.
  std::mt19937 generator(1);
  std::normal_distribution<double> normal;
  int inside = 0, all = 0;
  for (int world = 0; world < 60; ++world) {
    std::vector<double> terms(5);
    for (double& term : terms) term = 0.3 * normal(generator);
    const auto readings = all_readings(5);
    std::vector<double> values;
    for (const Reading& reading : readings) {
      double value = 0.1 * normal(generator);
      for (std::size_t f = 0; f < 5; ++f) value += terms[f] * static_cast<double>(reading[f]);
      values.push_back(value);
    }
    std::vector<Reading> first(readings.begin(), readings.begin() + 24);
    const Emulator emulator(first, std::span(values).first(24), std::vector<double>(24, 0.0));
    for (std::size_t r = 24; r < readings.size(); ++r) {
      const auto predicted = emulator.predict(readings[r]);
      inside += std::abs(values[r] - predicted.mean) < 1.96 * std::sqrt(predicted.variance);
      ++all;
    }
  }
  EXPECT_NEAR(static_cast<double>(inside) / all, 0.95, 0.03);
}

TEST(Emulator, LeavingOneOutIsFittingWithoutIt) {
  std::mt19937 generator(2);
  std::normal_distribution<double> normal;
  const auto readings = all_readings(3);
  std::vector<double> values;
  for (const Reading& reading : readings) values.push_back(static_cast<double>(reading[0]) + 0.05 * normal(generator));
  const std::vector<double> chance(readings.size(), 0.01);
  const Emulator whole(readings, values, chance);
  std::vector<Reading> fewer(readings.begin() + 1, readings.end());
  const Emulator without(fewer, std::span(values).subspan(1), std::span(chance).subspan(1));
  EXPECT_NEAR(whole.predict_without(0).mean, without.predict(readings[0]).mean, 0.05);
  EXPECT_THROW(Emulator({{0}, {1}}, std::vector{1.0, 2.0}, std::vector{0.0, 0.0}), std::invalid_argument);
}

TEST(Widths, ChanceIsPooledOverReadings) {
  // Two readings far apart with samples that scatter by 0.1 and by 0.1: the distance between them does not count.
  const std::vector<PrintedNumber> numbers{printed(1.0), printed(1.0, Part::test, "time")};
  const std::vector<ReadingRuns> runs{{{0}, {{0.0, 0.1, 0.2}, {1.0, 0.9, 0.8}}},
                                      {{1}, {{5.0, 5.1, 5.2}, {3.0, 2.9, 2.8}}}};
  const Widths widths = measure_widths(numbers, runs, std::nullopt);
  EXPECT_NEAR(widths.chance(0, 0), 0.01, 1e-12);
  EXPECT_EQ(widths.freedom[0], 4U);
  // The second number falls as the first one rises.
  EXPECT_LT(widths.chance(0, 1), -0.009);
}

TEST(Widths, OfASingleBedItsOwnSeriesSpeaks) {
  const std::vector<ReadingRuns> runs{{{0}, {{0.0}}, {0.03}}, {{1}, {{0.5}}, {0.04}}};
  const Widths widths = measure_widths({printed(1.0)}, runs, std::nullopt);
  EXPECT_NEAR(widths.chance(0, 0), 0.5 * (0.03 * 0.03 + 0.04 * 0.04), 1e-12);
  EXPECT_EQ(widths.freedom[0], 0U);
}

TEST(Widths, TheGridsWidthComesFromReadingsThatDifferInItAlone) {
  std::vector<ReadingRuns> runs{{{0, 0}, {{0.0}}}, {{1, 0}, {{0.2}}}, {{1, 1}, {{9.0}}}};
  EXPECT_NEAR(measure_widths({printed(1.0)}, runs, 0).grid[0], 0.02, 1e-12);  // variance of 0 and 0.2
  EXPECT_EQ(measure_widths({printed(1.0)}, runs, std::nullopt).grid[0], 0.0);
  // A difference that chance explains is none of the grid.
  runs = {{{0, 0}, {{-0.1, 0.1}}}, {{1, 0}, {{-0.12, 0.1}}}};
  EXPECT_EQ(measure_widths({printed(1.0)}, runs, 0).grid[0], 0.0);
}

TEST(Widths, ANumberThatWasRunOnOneGridTakesTheGridsWidthOfItsQuantity) {
  std::vector<PrintedNumber> numbers{printed(1.0), printed(1.0), printed(1.0), printed(1.0)};
  for (const std::size_t i : {0U, 1U, 2U}) numbers[i].quantity = "V_2";
  numbers[3].quantity = "time";
  // The first two have both grids, with variances of 0.02 and 0.08; the third one has one grid, the last a quantity
  // that nothing is known of.
  const std::vector<ReadingRuns> runs{{{0, 0}, {{0.0}, {0.0}, {0.0}, {0.0}}}, {{1, 0}, {{0.2}, {0.4}, {}, {}}}};
  const Widths widths = measure_widths(numbers, runs, 0);
  EXPECT_NEAR(widths.grid[2], 0.05, 1e-12);
  EXPECT_EQ(widths.grid[3], 0.0);
}

TEST(Widths, ThePrintLeavesHalfAStepOnBothSides) {
  PrintedNumber number = printed(2.0);
  number.half_width = 0.1;
  // Variance of an even distribution over 0.1, relative to 2.
  EXPECT_NEAR(measure_widths({number}, {{{0}, {{0.7}}}}, std::nullopt).print[0], 0.05 * 0.05 / 3.0, 1e-15);
}

TEST(Assessment, ImplausibilityIsTheDeviationOverAllWidths) {
  Widths widths = widths_of(Eigen::MatrixXd::Identity(1, 1) * 0.04, 50);
  widths.grid[0] = 0.03;
  widths.print[0] = 0.01;
  // Four samples: the mean's variance is 0.01, one sample's 0.04.
  const std::vector<ReadingRuns> runs{{{0}, {{0.5, 0.7, 0.5, 0.7}}}};
  const auto result = assess({printed(1.0)}, runs, widths, {true});
  EXPECT_NEAR(result[0].comparisons[0].implausibility, 0.6 / 0.3, 1e-12);
  EXPECT_NEAR(result[0].comparisons[0].ours, std::exp(0.6), 1e-12);
  EXPECT_FALSE(result[0].ruled_out);
}

TEST(Assessment, OneCalibrationNumberOrTwoOthersRuleOut) {
  const Widths widths = widths_of(Eigen::MatrixXd::Identity(3, 3) * 0.01, 50);
  const std::vector<PrintedNumber> numbers{printed(1.0, Part::calibration, "height", "bed"), printed(1.0),
                                           printed(1.0, Part::test, "time")};
  const auto with = [&](double height, double speed, double time) {
    return assess(numbers, {{{0}, {{height}, {speed}, {time}}}}, widths, {true, true, true})[0];
  };
  EXPECT_FALSE(with(0.0, 0.0, 0.0).ruled_out);
  EXPECT_TRUE(with(1.0, 0.0, 0.0).ruled_out);
  EXPECT_NE(with(1.0, 0.0, 0.0).reason.find("height in bed (7.1 widths)"), std::string::npos);
  EXPECT_FALSE(with(0.0, 1.0, 0.0).ruled_out) << "one of several numbers may be a slip";
  EXPECT_TRUE(with(0.0, 1.0, -1.0).ruled_out);
  // A number that no reading reaches rules none out.
  EXPECT_FALSE(assess(numbers, {{{0}, {{1.0}, {0.0}, {0.0}}}}, widths, {false, true, true})[0].ruled_out);
}

TEST(Assessment, LikelihoodIsStudentsDistribution) {
  // One number, 5 degrees of freedom, two readings with one sample each: scale 2 * 0.01 of mean and sample.
  const Widths widths = widths_of(Eigen::MatrixXd::Identity(1, 1) * 0.01, 5);
  const std::vector<ReadingRuns> runs{{{0}, {{0.0}}}, {{1}, {{0.3}}}};
  const auto result = assess({printed(1.0)}, runs, widths, {true});
  const double t_squared = 0.3 * 0.3 / 0.02;
  EXPECT_NEAR(*result[0].test, 0.0, 1e-12);
  EXPECT_NEAR(*result[1].test, -3.0 * std::log10(1.0 + t_squared / 5.0), 1e-12);
}

TEST(Assessment, NumbersThatGoTogetherAreNoTwoWitnesses) {
  // Two numbers whose chance is fully shared say hardly more than one; independent ones say twice as much.
  const auto evidence = [](double correlation) {
    Eigen::MatrixXd chance(2, 2);
    chance << 0.01, 0.01 * correlation, 0.01 * correlation, 0.01;
    const std::vector<ReadingRuns> runs{{{0}, {{0.0}, {0.0}}}, {{1}, {{0.2}, {0.2}}}};
    return *assess({printed(1.0), printed(1.0, Part::test, "time")}, runs, widths_of(chance, 0), {true, true})[1].test;
  };
  const double one = -0.5 * 0.04 / 0.02 / std::numbers::ln10;
  EXPECT_NEAR(evidence(0.0), 2.0 * one, 1e-9);
  EXPECT_NEAR(evidence(0.99), one, 0.02);
}

TEST(Assessment, AnErrorThatAllVelocitiesShareCountsOnce) {
  // The same deviation in every one of ten blocks: as much evidence as one block has.
  const auto evidence = [](std::size_t blocks) {
    std::vector<PrintedNumber> numbers;
    ReadingRuns good{{0}}, bad{{1}};
    for (std::size_t b = 0; b < blocks; ++b) {
      numbers.push_back(printed(1.0, Part::test, "speed", std::to_string(b)));
      good.samples.push_back({0.1});
      bad.samples.push_back({0.2});
    }
    const auto size = static_cast<Eigen::Index>(blocks);
    return *assess(numbers, {good, bad}, widths_of(Eigen::MatrixXd::Identity(size, size) * 0.01, 0),
                   std::vector<bool>(blocks, true))[1]
                .test;
  };
  EXPECT_NEAR(evidence(10), evidence(1), 1e-9);
}

TEST(Assessment, DropsThatDoNotArriveAreEvidence) {
  const Widths widths = widths_of(Eigen::MatrixXd::Identity(1, 1) * 0.01, 20);
  const std::vector<ReadingRuns> runs{{{0}, {{0.0, 0.0, 0.0, 0.0, 0.0}}},
                                      {{1}, {{0.0, nan, nan, nan, nan}}},
                                      {{2}, {{nan, nan, nan, nan, nan}}},
                                      {{3}, {{}}}};
  const auto result = assess({printed(1.0)}, runs, widths, {true});
  EXPECT_EQ(*result[0].test, 0.0);
  EXPECT_LT(*result[1].test, -0.3);
  EXPECT_LT(*result[2].test, *result[1].test);
  EXPECT_EQ(result[2].comparisons[0].lost, 5U);
  EXPECT_TRUE(std::isnan(result[2].comparisons[0].implausibility));
  EXPECT_FALSE(result[3].test.has_value()) << "what was not run has no evidence";
}

TEST(Assessment, NumbersThatNobodyReachesAreNamed) {
  const Widths widths = widths_of(Eigen::MatrixXd::Identity(2, 2) * 0.01, 20);
  const std::vector<ReadingRuns> runs{{{0}, {{0.1}, {2.0}}}, {{1}, {{2.0}, {3.0}}}};
  EXPECT_EQ(reached_by_any({printed(1.0), printed(1.0, Part::test, "time")}, runs, widths),
            (std::vector<bool>{true, false}));
}

// Three readings have the height, one alone the pressure drop, and that one misses the height: the print contradicts
// itself by all readings, and what nearly none has cannot rule out the others.
TEST(Assessment, ANumberThatOnlyImplausibleReadingsReachDoesNotCount) {
  const Widths widths = widths_of(Eigen::MatrixXd::Identity(2, 2) * 0.01, 20);
  const std::vector<PrintedNumber> numbers{printed(1.0, Part::calibration, "height", "bed"),
                                           printed(1.0, Part::calibration, "pressure", "bed")};
  std::vector<ReadingRuns> runs{
      {{0}, {{0.1}, {2.0}}}, {{1}, {{0.0}, {3.0}}}, {{2}, {{-0.1}, {3.0}}}, {{3}, {{2.0}, {0.1}}}};
  EXPECT_EQ(reached_by_any(numbers, runs, widths), (std::vector<bool>{true, false}));
  runs.push_back({{4}, {{0.1}, {0.1}}});
  EXPECT_EQ(reached_by_any(numbers, runs, widths), (std::vector<bool>{true, true}));
}

/// A world of four choices: a moves the speed, b the height, c both, d nothing. `scatter` of one drop.
std::vector<ReadingRuns> world(double scatter, unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal(0.0, scatter);
  std::vector<ReadingRuns> runs;
  for (const Reading& reading : all_readings(4)) {
    const double a = static_cast<double>(reading[0]), b = static_cast<double>(reading[1]),
                 c = static_cast<double>(reading[2]);
    ReadingRuns one{reading, {{}, {}}, {}};
    for (int k = 0; k < 3; ++k) {
      one.samples[0].push_back(a + 0.5 * c + normal(generator));
      one.samples[1].push_back(b - 0.5 * c + normal(generator));
    }
    runs.push_back(std::move(one));
  }
  return runs;
}

const std::vector<PrintedNumber> world_numbers{printed(std::exp(1.5), Part::test, "speed", "drops"),
                                               printed(std::exp(-0.5), Part::calibration, "height", "beds")};

TEST(Posterior, GivesTheChoicesBackThatMadeTheNumbers) {
  // The print is that of a = 2nd, b = 1st, c = 2nd.
  const Choices choices = two_level_choices(4);
  const auto runs = world(0.05, 3);
  const Widths widths = measure_widths(world_numbers, runs, std::nullopt);
  const Posterior told =
      posterior(choices, world_numbers, runs, widths, {true, true}, {Part::calibration, Part::test}, false);
  EXPECT_GT(told.levels[0][1], 0.95);
  EXPECT_GT(told.levels[1][0], 0.95);
  EXPECT_GT(told.levels[2][1], 0.95);
  EXPECT_NEAR(told.levels[3][0], 0.5, 0.15) << "nothing speaks for either level of a choice without effect";
  for (const auto& levels : told.levels) EXPECT_NEAR(levels[0] + levels[1], 1.0, 1e-9);
  EXPECT_EQ(told.best.front().log10_evidence, 0.0);
  EXPECT_EQ(told.best.front().reading[0], 1U);
}

TEST(Posterior, ADepartureCostsOneUnit) {
  const Choices choices = two_level_choices(4);  // the second level of d departs
  const auto runs = world(0.05, 3);
  const Widths widths = measure_widths(world_numbers, runs, std::nullopt);
  const auto odds = [&](bool penalised) {
    const Posterior told =
        posterior(choices, world_numbers, runs, widths, {true, true}, {Part::calibration, Part::test}, penalised);
    return told.levels[3][1] / told.levels[3][0];
  };
  EXPECT_NEAR(odds(true) / odds(false), 0.1, 1e-6);
}

TEST(Posterior, CalibrationSeesTheCalibrationNumbersAlone) {
  const Choices choices = two_level_choices(4);
  const auto runs = world(0.05, 4);
  const Widths widths = measure_widths(world_numbers, runs, std::nullopt);
  const Posterior told = posterior(choices, world_numbers, runs, widths, {true, true}, {Part::calibration}, false);
  EXPECT_NEAR(told.levels[0][1], 0.5, 0.15) << "the speed does not speak, and a moves nothing else";
  EXPECT_GT(told.levels[1][0], 0.8);
}

TEST(Identification, TellsChoicesThatShowFromThoseThatDoNot) {
  const Choices choices = two_level_choices(4);
  const auto runs = world(0.05, 5);
  const Widths widths = measure_widths(world_numbers, runs, std::nullopt);
  const auto found = identify(choices, world_numbers, runs, widths);
  for (const std::size_t f : {0U, 1U, 2U}) {
    EXPECT_EQ(found[f].trials, 16U);
    EXPECT_TRUE(found[f].identified) << f;
    EXPECT_GT(found[f].mean_probability, 0.9) << f;
  }
  EXPECT_FALSE(found[3].identified);
  EXPECT_NEAR(found[3].chance, 0.5, 1e-12);
}

TEST(Identification, ToNameTheCommonLevelEveryTimeIsNoKnowledge) {
  // A design about one base: the last choice has its first level in all readings but two, and moves nothing.
  const Choices choices = two_level_choices(4);
  std::vector<ReadingRuns> runs;
  for (ReadingRuns& one : world(0.05, 8))
    if (one.reading[3] == 0 || one.reading[0] + one.reading[1] + one.reading[2] == 1) runs.push_back(std::move(one));
  runs.pop_back();
  const Widths widths = measure_widths(world_numbers, runs, std::nullopt);
  const auto found = identify(choices, world_numbers, runs, widths);
  EXPECT_EQ(found[3].trials, 10U);
  EXPECT_FALSE(found[3].identified) << found[3].hits << " of 10";
  EXPECT_TRUE(found[0].identified);
}

TEST(Identification, NothingIsIdentifiedWhereChanceRules) {
  const Choices choices = two_level_choices(4);
  const auto runs = world(20.0, 6);
  const Widths widths = measure_widths(world_numbers, runs, std::nullopt);
  int identified = 0;
  for (const Identification& one : identify(choices, world_numbers, runs, widths)) identified += one.identified;
  EXPECT_LE(identified, 1);
}

TEST(Sensitivities, NameTheNumbersThatAChoiceMoves) {
  const Choices choices = two_level_choices(4);
  const auto runs = world(0.02, 7);
  const Widths widths = measure_widths(world_numbers, runs, std::nullopt);
  const auto found = sensitivities(choices, world_numbers, runs, widths);
  ASSERT_EQ(found[0].size(), 1U);
  EXPECT_EQ(found[0][0].number, 0U);
  ASSERT_EQ(found[1].size(), 1U);
  EXPECT_EQ(found[1][0].number, 1U);
  EXPECT_EQ(found[2].size(), 2U);
  EXPECT_TRUE(found[3].empty());
}

}  // namespace
}  // namespace slfb::readings
