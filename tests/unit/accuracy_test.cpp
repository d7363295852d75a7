// An accuracy is asked for: what it takes, and a loop that stops when the answers are sure enough.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "experiments/numerics/accuracy/sequence.hpp"
#include "experiments/numerics/plan/settled_bed.hpp"
#include "experiments/quantities/analysis.hpp"
#include "experiments/runs/run_estimate.hpp"
#include "solver/run/simulation.hpp"
#include "solver/support/folders.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

using accuracy::Answer;
using accuracy::Answers;
using accuracy::Deviation;
using accuracy::Expectation;
using accuracy::World;

Scene box(const Overrides& overrides = {}) {
  return load_scene(source_folder() / "experiments/scenes/fluidised_box.toml", overrides);
}

/// Three beds of the box are asked for the voidage; models, grid and steps make no error.
Expectation voidage_to(double error) {
  Expectation expected;
  expected.goal = {.asked = {"voidage"}, .error = error};
  expected.scene = box();
  expected.parts["voidage"] = {};
  return expected;
}

/// Beds whose voidages scatter about the truth as a normal distribution, each by its seed.
World scattering(double truth, double deviation) {
  World world;
  world.simulate = [](const std::vector<Scene>& scenes) { return static_cast<double>(scenes.size()); };
  world.measure = [=](const std::vector<Scene>& scenes) {
    std::vector<double> values;
    for (const Scene& scene : scenes) {
      std::mt19937_64 numbers(scene.seed);
      values.push_back(std::normal_distribution(truth, deviation)(numbers));
    }
    const ReplicateEstimate estimate = estimate_replicates(values);
    return Answers{{"voidage", Answer{estimate.mean, estimate.half_width, estimate.samples, "-", ""}}};
  };
  return world;
}

// All looks together may miss in 5 % of cases: the sum of 1/k² is π²/6.
TEST(Accuracy, LooksShareFivePercent) {
  double all = 0.0;
  for (int look = 1; look <= 100'000; ++look) all += accuracy::level_of_look(look);
  EXPECT_LE(all, 0.05);
  EXPECT_NEAR(all, 0.05, 1e-6);
}

// Whoever looks until an interval is narrow enough stops at the narrow ones. The loop keeps its error rate all the
// same: of 2000 answers, at most 5 % (and three standard deviations of that count) are farther off than asked.
TEST(Accuracy, TheRuleKeepsItsErrorRate) {
  const World world = scattering(0.5, 0.05);
  int missed = 0, looks = 0;
  constexpr int trials = 2000;
  for (int k = 0; k < trials; ++k) {
    Expectation expected = voidage_to(0.04);
    expected.scene.seed = 1000 * static_cast<std::uint64_t>(k + 1);
    const auto outcome = accuracy::run_until(expected, world);
    ASSERT_TRUE(outcome.reached) << outcome.reason;
    missed += std::abs(outcome.answers.at("voidage").value / 0.5 - 1.0) > 0.04;
    looks = std::max(looks, outcome.looks);
  }
  EXPECT_LE(missed, 0.05 * trials + 3.0 * std::sqrt(0.05 * 0.95 * trials));
  EXPECT_GT(looks, 1);
}

// Beds are added, never begun anew: those of one look are the first of the next.
TEST(Accuracy, BedsOfALookStay) {
  World world = scattering(0.5, 0.05);
  std::vector<std::uint64_t> seeds;
  const auto simulate = world.simulate;
  world.simulate = [&](const std::vector<Scene>& scenes) {
    for (const Scene& scene : scenes) seeds.push_back(scene.seed);
    return simulate(scenes);
  };
  const auto outcome = accuracy::run_until(voidage_to(0.03), world);
  EXPECT_TRUE(outcome.reached);
  EXPECT_EQ(seeds.size(), outcome.beds.size());
  for (std::size_t k = 0; k < seeds.size(); ++k) EXPECT_EQ(seeds[k], k + 1);
}

TEST(Accuracy, ABedThatChangesIsRunOverTwiceTheTime) {
  World world = scattering(0.5, 0.001);
  const auto measure = world.measure;
  world.measure = [&](const std::vector<Scene>& scenes) {
    Answers answers = measure(scenes);
    const double seconds = scenes.front().stages[1].duration;
    answers["voidage_drift"] = {0.05 / seconds, 0.001, scenes.size(), "-", ""};  // 0.025, 0.0125, ...
    return answers;
  };
  // A quarter of 4 % of 0.5 is 0.005: below that after 16 s.
  const auto outcome = accuracy::run_until(voidage_to(0.04), world);
  EXPECT_TRUE(outcome.reached);
  EXPECT_EQ(outcome.scene.stages[1].duration, 16.0);
}

/// The planned scene is 10 % above the richer one, that 2 % above a refined one.
World world_of_three_scenes() {
  World world;
  world.simulate = [](const std::vector<Scene>&) { return 1.0; };
  world.measure = [](const std::vector<Scene>& scenes) {
    const double step = scenes.front().contact.time_step;
    const double value = step > 0.9e-4 ? 0.55 : step > 0.4e-4 ? 0.5 : 0.49;
    return Answers{{"voidage", Answer{value, 0.001, scenes.size(), "-", ""}}};
  };
  return world;
}

Expectation checked_voidage(double error) {
  Expectation expected = voidage_to(error);
  expected.checked = {"solid step"};
  plan::Decision step{.subject = "solid step", .choice = "coarse"};
  step.part = plan::Part::discretisation;
  step.effect = {{"voidage", 0.01}};
  expected.plan.decisions = {step};
  expected.check = box({"contact.time_step=0.05 ms"});
  return expected;
}

// What no study covers is measured: a richer scene that says otherwise takes the place of the planned one.
TEST(Accuracy, TheRicherSceneTakesThePlaceOfTheRefuted) {
  const auto outcome = accuracy::run_until(checked_voidage(0.05), world_of_three_scenes());
  EXPECT_TRUE(outcome.reached) << outcome.reason;
  EXPECT_EQ(outcome.answers.at("voidage").value, 0.5);
  EXPECT_NEAR(outcome.check.at("voidage").value, 0.5 / 0.49 - 1.0, 1e-12);
  EXPECT_NEAR(outcome.parts.at("voidage").systematic(), 0.5 / 0.49 - 1.0, 1e-12);
}

// An accuracy that the check allows keeps the planned scene and counts what was found.
TEST(Accuracy, WhatTheCheckFindsCounts) {
  const auto outcome = accuracy::run_until(checked_voidage(0.2), world_of_three_scenes());
  EXPECT_TRUE(outcome.reached);
  EXPECT_EQ(outcome.answers.at("voidage").value, 0.55);
  EXPECT_NEAR(outcome.parts.at("voidage").systematic(), 0.1, 1e-12);
}

TEST(Accuracy, ADeviationCountsAsFarAsItIsSure) {
  EXPECT_EQ(accuracy::error_by({0.10, 0.02}, 0.03), 0.10);         // for sure more than estimated
  EXPECT_EQ(accuracy::error_by({-0.10, 0.02}, 0.03), 0.10);        // of either sign
  EXPECT_EQ(accuracy::error_by({0.01, 0.20}, 0.03), 0.03);         // says nothing: the estimate stands
  EXPECT_DOUBLE_EQ(accuracy::error_by({0.01, 0.01}, 0.30), 0.02);  // for sure less than estimated
}

TEST(Accuracy, AStopLosesNothingAndABudgetIsKept) {
  World world = scattering(0.5, 0.05);
  world.simulate = [](const std::vector<Scene>&) -> std::optional<double> { return std::nullopt; };
  EXPECT_TRUE(accuracy::run_until(voidage_to(0.03), world).unfinished);
  world.simulate = [](const std::vector<Scene>&) -> std::optional<double> {
    ADD_FAILURE() << "beyond the budget";
    return 0.0;
  };
  const auto outcome = accuracy::run_until(voidage_to(0.03), world, 0.1 * estimate_run(box()).core_seconds);
  EXPECT_FALSE(outcome.reached);
  EXPECT_NE(outcome.reason.find("budget"), std::string::npos);
}

// Half the error takes four times the samples, or thereabouts: Student's t is larger for few.
TEST(Accuracy, SamplesGoWithTheSquareOfTheError) {
  const int some = accuracy::samples_for(0.1, 0.02), more = accuracy::samples_for(0.1, 0.01);
  EXPECT_GE(more, 3 * some);
  EXPECT_LE(more, 4 * some);
  EXPECT_LE(accuracy::half_width_of(0.1, some, 1), 0.02);
  EXPECT_GT(accuracy::half_width_of(0.1, some - 1, 1), 0.02);
}

TEST(Accuracy, TheSmallerTheErrorTheMoreItCosts) {
  const auto rules = plan::load_rules();
  double before = 0.0;
  for (const double error : {0.2, 0.1, 0.05, 0.03}) {
    const auto expected = accuracy::expect(box(), {.asked = {"voidage"}, .error = error}, rules);
    ASSERT_TRUE(expected.obstacle.empty()) << expected.obstacle;
    EXPECT_GE(expected.core_seconds, before);
    EXPECT_LE(expected.parts.at("voidage").total(), error);
    before = expected.core_seconds;
  }
}

// What cannot be had is said before anything runs, with the choice that makes most of the error.
TEST(Accuracy, SaysWhatKeepsAnAccuracyOutOfReach) {
  const auto expected = accuracy::expect(box(), {.asked = {"fluctuating_energy"}, .error = 0.001}, plan::load_rules());
  EXPECT_NE(expected.obstacle.find("fluctuating_energy"), std::string::npos);
  EXPECT_GT(expected.best, 0.001);
}

TEST(Accuracy, RefusesWhatTheSceneCannotAnswer) {
  const auto rules = plan::load_rules();
  const auto ask = [&](const Scene& scene, const char* quantity) {
    return accuracy::expect(scene, {.asked = {quantity}, .error = 0.05}, rules);
  };
  try {
    ask(box(), "classification_velocity");
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("drop"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("voidage"), std::string::npos);
  }
  EXPECT_THROW(ask(box(), "colour"), std::invalid_argument);
  const Scene alone = load_scene(source_folder() / "experiments/scenes/single_sphere.toml");
  EXPECT_THROW(ask(alone, "voidage"), std::invalid_argument);
  EXPECT_TRUE(ask(alone, "terminal_velocity").by_formula());
}

// The studies ran 5 mm glass in water: a bed of it is covered; of 1 mm glass in glycerol, a thousand times the
// viscosity, it is not, and every error is larger.
TEST(Plan, SaysWhereNoStudyReaches) {
  const auto rules = plan::load_rules();
  EXPECT_TRUE(plan::make_plan(box(), {"voidage"}, rules).not_covered().empty());
  const Scene viscous = box({"liquid.viscosity=0.1", "liquid.superficial_velocity=1 mm/s", "fluid.time_step=0.1 ms"});
  const auto made = plan::make_plan(viscous, {"voidage"}, rules);
  const auto sentences = made.not_covered();
  EXPECT_TRUE(std::ranges::any_of(
      sentences, [](const std::string& sentence) { return sentence.starts_with("archimedes_number"); }));
  for (const plan::Decision& decision : made.decisions)
    for (const auto& [quantity, error] : decision.effect) EXPECT_GE(error, decision.studied.at(quantity));
  EXPECT_GT(made.effect.at("voidage"), plan::make_plan(box(), {"voidage"}, rules).effect.at("voidage"));
}

// Friction holds a packing open: without it spheres settle closer, and less velocity lifts them. What settles here is
// what the scene itself starts from.
TEST(Plan, TheMinimumFluidisationVelocityIsOfThePackingThatSettles) {
  const Scene rough = box(), smooth = box({"contact.sliding_friction=0"});
  const auto rules = plan::load_rules();
  const auto answer = [&](const Scene& scene) {
    return plan::answer_by_formula(scene, plan::make_plan(scene, {"minimum_fluidisation_velocity"}, rules))
        .at("minimum_fluidisation_velocity");
  };
  EXPECT_LT(answer(smooth).value, 0.95 * answer(rough).value);
  EXPECT_GT(answer(rough).error, 0.0);
  const plan::SettledBed settled = plan::settle(rough);
  Scene only = rough;
  only.stages.resize(1);
  only.fluid.tier = FluidTier::quiescent;
  only.fluid.time_step = only.contact.time_step;
  only.seed = 17;
  const Folder folder;
  const double whole = run_scene(only, {.directory = folder.path()}).result.packed_voidage;
  EXPECT_NEAR(settled.voidage, whole, 4.0 * settled.half_width);
}

// A sphere that a law of walls holds back falls as much slower as the law says, and one without is told what they would
// take: by Munroe (1888), 1 − (d/D)^1.5 of the velocity in Newton's regime stays.
TEST(Plan, ATerminalVelocityKnowsItsWalls) {
  const auto rules = plan::load_rules();
  const auto answer = [&](const Overrides& overrides) {
    const Scene scene = load_scene(source_folder() / "experiments/scenes/single_sphere.toml", overrides);
    return plan::answer_by_formula(scene, plan::make_plan(scene, {"terminal_velocity"}, rules)).at("terminal_velocity");
  };
  const auto free = answer({}), held = answer({"coupling.wall_retardation=munroe-1888"});
  EXPECT_NEAR(held.value / free.value, 1.0 - std::pow(6.0 / 50.0, 1.5), 1e-9);
  EXPECT_NE(free.remark.find("munroe-1888"), std::string::npos);
}

// A hundredth of the Archimedes number is farther from the studies than a tenth.
TEST(Plan, ErrorsGrowWithTheDistanceFromTheStudies) {
  plan::Rules rules;
  rules.reach = {{"archimedes_number", 4.0}};
  plan::Rule rule;
  rule.covered["archimedes_number"] = {1e6, 2e6};
  rule.effect["voidage"] = 0.01;
  rule.standard_error["voidage"] = 0.002;
  const auto steps = [&](double archimedes) {
    const auto found = plan::beyond(rule, rules, {{"archimedes_number", archimedes}});
    return found.empty() ? 0.0 : found.front().steps;
  };
  EXPECT_EQ(steps(1.5e6), 0.0);
  EXPECT_EQ(steps(0.3e6), 0.0);  // within the reach of 4
  EXPECT_NEAR(steps(1e6 / 64.0), 2.0, 1e-12);
  EXPECT_NEAR(steps(2e6 * 16.0), 1.0, 1e-12);
  EXPECT_EQ(plan::effect_beyond(rule, "voidage", 0.0), 0.01);
  EXPECT_DOUBLE_EQ(plan::effect_beyond(rule, "voidage", 2.0), 3.0 * std::hypot(0.01, 0.002));
}

}  // namespace
}  // namespace slfb
