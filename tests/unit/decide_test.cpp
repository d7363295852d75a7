// The loop of `slfb figures --decide` in a made-up world: a simulation is a draw of a random number.
#include "experiments/work/decide.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "experiments/peng_2014/work.hpp"
#include "experiments/quantities/samples.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

MeasureKey mass_of(const std::string& system) { return measure_key("mass", system, 0.06); }

/// mass/SYSTEM/0.06 equals 10 within 1.
Claim claim_on(const std::string& system) {
  Claim claim;
  claim.id = "fig99." + system;
  claim.figure = "fig99";
  claim.unit = "kg";
  claim.paper = claim.paper_upper = 10.0;
  claim.paper_band = Band{9.0, 11.0};
  claim.systems = {system};
  claim.measures = {mass_of(system)};
  return claim;
}

/// Systems whose runs give numbers about `means`, at a cost each.
struct MadeUpWorld {
  std::map<std::string, double> means, costs;
  std::mt19937 random{1};
  double scatter = 1.0;
  std::map<std::string, std::vector<double>> drawn = {};
  std::vector<std::string> simulated = {};

  void draw(const std::string& system) {
    drawn[system].push_back(std::normal_distribution<double>(means.at(system), scatter)(random));
  }

  DecideWorld world() {
    DecideWorld world;
    world.judge = [this](const MoreRuns& more) {
      std::vector<Claim> claims;
      Measurements measurements;
      for (const auto& [system, mean] : means) {
        claims.push_back(claim_on(system));
        const PooledEstimate estimate = pool_beds(std::vector<std::vector<double>>{drawn.at(system)});
        measurements[mass_of(system)] = {estimate.mean, estimate.half_width, estimate.samples, "kg", ""};
      }
      return evaluate(claims, measurements, more.looks);
    };
    world.next_step = [this](const Evaluation& evaluation) {
      const std::string system = *evaluation.claim.systems.begin();
      NextStep step;
      // As many once more as there are.
      for (std::size_t k = 0; k < drawn.at(system).size(); ++k) {
        step.again.push_back({"quick", system, 0.06, "", k, {}});
        step.specs.push_back({system, 0.06, "", "", {}});
      }
      step.core_seconds = costs.at(system) * static_cast<double>(step.specs.size());
      return step;
    };
    world.simulate = [this](const std::vector<RunSpec>& specs) {
      double spent = 0.0;
      for (const RunSpec& spec : specs) {
        draw(spec.system);
        simulated.push_back(spec.system);
        spent += costs.at(spec.system);
      }
      return std::optional(spent);
    };
    world.rests_on = [](const Claim& claim, const std::vector<RunSpec>& specs) {
      return claim.systems.contains(specs.front().system);
    };
    return world;
  }
};

TEST(Decide, TakesTheCheapestFirstAndEndsWhenAllIsDecided) {
  MadeUpWorld made_up{{{"cheap", 10.0}, {"dear", 20.0}}, {{"cheap", 1.0}, {"dear", 50.0}}};
  for (const char* system : {"cheap", "dear"})
    for (int k = 0; k < 3; ++k) made_up.draw(system);
  made_up.drawn.at("dear") = {10.0, 30.0, 20.0};  // straddles the band
  const DecideOutcome outcome = decide(made_up.world(), {}, 1e6);
  for (const Evaluation& evaluation : outcome.evaluations)
    EXPECT_NE(evaluation.verdict, Verdict::not_decidable) << evaluation.reason;
  ASSERT_FALSE(made_up.simulated.empty());
  const auto first_dear = std::ranges::find(made_up.simulated, "dear");
  EXPECT_EQ(std::ranges::count(first_dear, made_up.simulated.end(), "cheap"), 0) << "all that was cheap came before";
  EXPECT_EQ(outcome.evaluations[1].verdict, Verdict::not_reproduced);
}

TEST(Decide, SpendsNoMoreThanItsBudget) {
  MadeUpWorld made_up{{{"edge", 11.0}}, {{"edge", 1.0}}};
  for (int k = 0; k < 3; ++k) made_up.draw("edge");
  made_up.drawn.at("edge") = {10.0, 11.0, 12.0};
  const DecideOutcome outcome = decide(made_up.world(), {}, 10.0);
  EXPECT_LE(outcome.core_seconds, 10.0);
  EXPECT_GE(outcome.core_seconds, 3.0);
  EXPECT_EQ(decide(made_up.world(), {}, 0.0).steps, 0) << "a budget of nothing only tells";
}

TEST(Decide, GoesOnWhereItWasInterrupted) {
  MadeUpWorld made_up{{{"edge", 11.0}}, {{"edge", 1.0}}};
  made_up.drawn["edge"] = {10.0, 11.0, 12.0};
  DecideWorld world = made_up.world();
  world.simulate = [](const std::vector<RunSpec>&) -> std::optional<double> { return std::nullopt; };
  const DecideOutcome outcome = decide(world, {}, 10.0);
  EXPECT_TRUE(outcome.interrupted);
  EXPECT_TRUE(outcome.more.looks.empty()) << "nothing new was looked at";
}

// The truth lies on the edge of the band: to say that it is inside is wrong in every case. A single look does so in 2.5
// % of all cases; eight looks at 95 % intervals would in about 8 %, those of this loop in less than 3.5 %.
TEST(Decide, LookingAgainDoesNotMakeWrongVerdictsLikelier) {
  constexpr int trials = 4000;
  int wrong = 0, naive = 0;
  std::mt19937 seeds(11);
  for (int trial = 0; trial < trials; ++trial) {
    MadeUpWorld made_up{{{"edge", 11.0}}, {{"edge", 1.0}}, std::mt19937(seeds()), 0.5};
    for (int k = 0; k < 3; ++k) made_up.draw("edge");
    bool fooled = false;
    DecideWorld world = made_up.world();
    const auto judge = world.judge;
    world.judge = [&](const MoreRuns& more) {
      fooled = fooled || judge({}).front().verdict == Verdict::reproduced;
      return judge(more);
    };
    const DecideOutcome outcome = decide(world, {}, 3.0 * 127);  // 3, 6, 12, … 384 samples
    wrong += outcome.evaluations.front().verdict == Verdict::reproduced;
    naive += fooled;
  }
  EXPECT_LT(wrong, 0.035 * trials + 3.0 * std::sqrt(0.035 * trials));
  EXPECT_GT(naive, wrong);
}

TEST(Looks, LaterOnesHaveWiderIntervals) {
  EXPECT_EQ(significance_of_look(1), 0.05);
  double later = 0.0;
  for (int look = 2; look < 10000; ++look) {
    EXPECT_LT(significance_of_look(look), significance_of_look(look - 1));
    later += significance_of_look(look);
  }
  EXPECT_LT(0.5 * (0.05 + later), 0.035);
}

TEST(RunsBehind, ANumberOfOneRunOfSeveralAndAtAVoidage) {
  const Work& work = peng_2014_work();
  std::vector<RunSpec> runs;
  for (const double velocity : {0.06, 0.08, 0.10}) runs.push_back({"6in5W", velocity, "", "", {}});
  runs.push_back({"6in5W", 0.10, "wen-yu-1966", "", {}});
  RunSpec again = runs[0];
  again.seed = 2;
  runs.push_back(again);
  Measurements measurements;
  for (const auto& [velocity, voidage] : {std::pair{0.06, 0.48}, {0.08, 0.56}, {0.10, 0.62}})
    measurements[measure_key("voidage_centre_of_mass", "6in5W", velocity)] = {voidage, 0.0, 5, "-", ""};
  const auto velocities = [&](const char* measure) {
    std::vector<double> found;
    for (const RunSpec& spec : runs_behind(parse_measure_key(measure), runs, work, measurements))
      found.push_back(spec.superficial_velocity);
    return found;
  };
  EXPECT_EQ(velocities("classification_velocity/6in5W/0.08"), std::vector{0.08});
  EXPECT_EQ(velocities("classification_velocity/6in5W/0.10/wen-yu-1966"), std::vector{0.10});
  EXPECT_EQ(velocities("classification_velocity/6in5W/*"), (std::vector{0.06, 0.08, 0.10}));
  EXPECT_EQ(velocities("pressure_plateau/6in5W"), (std::vector{0.06, 0.08, 0.10}));
  EXPECT_EQ(velocities("drag_ratio_at_voidage/6in5W/0.58"), (std::vector{0.08, 0.10}));
  EXPECT_EQ(velocities("drag_ratio_at_voidage/6in5W/0.45"), std::vector{0.06});
  EXPECT_EQ(velocities("drag_ratio_at_printed_voidage/6in5W/0.46"), (std::vector{0.06, 0.08}));
  EXPECT_EQ(velocities("equation_40_deviation_at_printed_voidage/6in5W/0.08"), std::vector{0.08});
  EXPECT_TRUE(velocities("equation_40_share_within_10_percent/all").empty());
}

TEST(MoreRunsFile, ComesBackAndAddsToItsProfile) {
  const Folder folder;
  Work work;
  work.id = "sand_1900";
  MoreRuns more;
  more.runs = {{"quick", "sand", 0.07, "", 2, {"stage[1].duration=2 s"}}};
  more.looks["fig05.pressure"] = 3;
  save_more_runs(more, more_runs_file(folder.path(), work));
  const MoreRuns read = load_more_runs(work, folder.path());
  ASSERT_EQ(read.runs.size(), 1U);
  EXPECT_EQ(read.runs[0].overrides, more.runs[0].overrides);
  EXPECT_EQ(read.looks.at("fig05.pressure"), 3);

  Profile profile{
      "quick", {}, {{"sand", 0.07, "", "bed.toml", {"a=1"}, "quick"}, {"sand", 0.08, "", "bed.toml", {}, "quick"}}};
  profile = with_more_runs(profile, read);
  ASSERT_EQ(profile.runs.size(), 3U);
  EXPECT_EQ(profile.runs[2].seed, std::optional<std::uint64_t>(2));
  EXPECT_EQ(profile.runs[2].overrides, (Overrides{"a=1", "stage[1].duration=2 s", "seed=2"}));
}

// A bed that was made to decide a claim and that the profile has got since is one bed: counted twice it would make the
// interval too narrow.
TEST(MoreRunsFile, ABedOfTheProfileIsNotTakenTwice) {
  RunSpec replicate{"sand", 0.07, "", "bed.toml", {"seed=2"}, "quick"};
  replicate.seed = 2;
  const Profile profile{"quick", {}, {{"sand", 0.07, "", "bed.toml", {}, "quick"}, replicate}};
  MoreRuns more;
  more.runs = {{"quick", "sand", 0.07, "", 2, {}}, {"quick", "sand", 0.07, "", 3, {}}};
  const Profile both = with_more_runs(profile, more);
  ASSERT_EQ(both.runs.size(), 3U);
  EXPECT_EQ(both.runs[2].seed, std::optional<std::uint64_t>(3));
}

}  // namespace
}  // namespace slfb
