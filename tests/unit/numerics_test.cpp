// Studies, maps and benchmarks: what their tables, charts and files say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/numerics/bench/coupled_bench.hpp"
#include "experiments/numerics/frontier/frontier_chart.hpp"
#include "experiments/numerics/frontier/solved_study.hpp"
#include "experiments/numerics/stability/map.hpp"
#include "experiments/numerics/stability/map_chart.hpp"
#include "experiments/numerics/studies/solved_set.hpp"
#include "experiments/numerics/studies/trial.hpp"
#include "solver/support/files.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// One method with points at 1 and 100, whose errors are 10 and 1 %, and one that fails.
frontier::SolvedStudy small_study() {
  frontier::SolvedStudy solved;
  solved.study.id = "small";
  solved.study.problem = "impact";
  solved.study.axis_label = "steps per contact";
  solved.study.count = "steps";
  solved.study.quantities = {"restitution"};
  solved.study.series = {"good", "bad"};
  const auto point = [](const char* series, double axis, double error, const char* failure) {
    frontier::ReducedPoint one;
    one.series = series;
    one.axis = one.cpu_seconds = axis;
    one.counts["steps"] = axis;
    one.replicates = 1;
    one.failure = failure;
    if (*failure == '\0') one.values["restitution"] = {0.9 * (1.0 + error), nothing, error, 0.003};
    return one;
  };
  solved.reduced.set = "full";
  solved.reduced.points = {point("good", 1.0, 0.10, ""), point("good", 100.0, 0.01, ""),
                           point("bad", 10.0, 0.0, "gave up")};
  solved.reduced.reference["restitution"] = {0.9, 0.0036, 0.0, 0.004};
  return solved;
}

TEST(LateReaction, LightSpheresShakeBelowTheDensityThatTheoryGives) {
  const auto growth = [](double ratio, const std::vector<std::string>& settings) {
    studies::Trial trial{"late-reaction", settings, 0};
    trial.settings.insert(trial.settings.end(), {"fluid.tier=three-dimensional", "problem.solids=0.5"});
    const double limit = stability::theory_value("late-reaction", trial.scene(), trial.parameters());
    trial.settings.push_back("problem.density_ratio=" + std::to_string(ratio * limit));
    const studies::TrialResult result = studies::solve(trial);
    EXPECT_EQ(result.failure, "");
    return result.values.at("growth").value;
  };
  for (const std::vector<std::string>& settings :
       {std::vector<std::string>{}, {"fluid.time_scheme=second-order"}, {"problem.interval_steps=2"}}) {
    EXPECT_GT(growth(0.85, settings), 1.0) << (settings.empty() ? "first order" : settings.front());
    EXPECT_LT(growth(1.15, settings), 1.0) << (settings.empty() ? "first order" : settings.front());
  }
}

TEST(SolvedStudy, FindsPointsOnALogarithmicScale) {
  const auto solved = small_study();
  EXPECT_EQ(solved.nearest("good", 9.0)->axis, 1.0);
  EXPECT_EQ(solved.nearest("good", 11.0)->axis, 100.0);
  EXPECT_EQ(solved.nearest("none", 1.0), nullptr);
  EXPECT_EQ(solved.at("good", 9.0), nullptr);
  EXPECT_EQ(solved.at("good", 100.0)->axis, 100.0);
}

// The intervals of a point and of its reference are independent: 0.3 and 0.4 % make 0.5 %.
TEST(SolvedStudy, ErrorsHaveTheIntervalOfTheReferenceToo) {
  const auto solved = small_study();
  const auto error = solved.error_of(*solved.at("good", 100.0), "restitution");
  ASSERT_TRUE(error);
  EXPECT_DOUBLE_EQ(error->value, 0.01);
  EXPECT_NEAR(error->half_width, 0.005, 1e-12);
  EXPECT_EQ(frontier::percent(error), "1 ± 0.5 %");
  EXPECT_FALSE(solved.error_of(*solved.at("bad", 10.0), "restitution"));
  EXPECT_EQ(frontier::percent(std::nullopt), "–");
}

// A method that breaks down is in the chart: a row with its cost and the number of the reason, and the reason as a
// note.
TEST(FrontierChart, ShowsWhatFailed) {
  const Folder folder;
  const auto solved = small_study();
  const auto output = frontier::draw_frontier(solved.study, solved.reduced, {}, folder.path());
  EXPECT_TRUE(fs::exists(folder.path() / "frontier-small.svg"));
  const std::string table = read_file(folder.path() / "frontier-small_1.csv");
  EXPECT_NE(table.find("\n10,10,10,1,1,NaN"), std::string::npos) << table;
  EXPECT_TRUE(std::ranges::any_of(output.notes, [](const auto& note) { return note == "Failed (x 1): gave up"; }));
  const std::string front = read_file(folder.path() / "frontier-small_front_restitution.csv");
  EXPECT_NE(front.find("\n1,0.1\n100,0.01\n"), std::string::npos) << front;
}

TEST(FrontierChart, SaysWhatComputesAMissingStudy) {
  const Folder folder;
  const auto output = frontier::draw_frontier(small_study().study, {}, {}, folder.path());
  ASSERT_EQ(output.notes.size(), 1u);
  EXPECT_EQ(output.notes.front(), "Not yet computed: slfb frontier small.");
  EXPECT_TRUE(fs::exists(folder.path() / "frontier-small.svg"));
}

// Where a method never fails there is no boundary, but the end of the range in which was looked.
TEST(StabilityChart, KeepsBoundariesApartFromTheEndsOfTheRange) {
  const Folder folder;
  const auto map = stability::load_map(stability::map_file("contact-pair"), studies::Set::quick);
  stability::SolvedMap solved;
  solved.set = "quick";
  stability::Boundary found, never;
  found.series = never.series = map.series.front().name;
  found.x = 1e3, found.y = 1e-4, found.low = 0.9e-4, found.high = 1.1e-4, found.diagnosis = "grows";
  never.x = 1e4, never.y = map.y_high, never.kind = stability::BoundaryKind::never_fails;
  found.theory = never.theory = std::vector<double>(map.theories.size(), 2e-4);
  solved.boundaries = {found, never};
  const auto output = stability::draw_map(map, solved, {}, folder.path());
  EXPECT_TRUE(fs::exists(folder.path() / "stability-contact-pair.svg"));
  const std::string table = read_file(folder.path() / "stability-contact-pair_0.csv");
  EXPECT_NE(table.find("\n1000,0.0001,9e-05,0.00011,NaN"), std::string::npos) << table;
  EXPECT_NE(table.find("\n10000,NaN,NaN,NaN,"), std::string::npos) << table;
  EXPECT_TRUE(std::ranges::any_of(
      output.notes, [&](const auto& note) { return note == found.series + ": beyond the boundary grows."; }));
}

// A quick set of this machine gives way to a committed full one, unless that is of older numerics.
TEST(SolvedSet, CommittedFullSetsComeFirst) {
  const studies::SolvedSet none, quick{"", "quick", "", "", numerics_version},
      full{"", "full", "", "", numerics_version}, old{"", "full", "", "", numerics_version - 1};
  EXPECT_TRUE(committed_is_better(none, quick));
  EXPECT_TRUE(committed_is_better(quick, full));
  EXPECT_FALSE(committed_is_better(quick, old));
  EXPECT_FALSE(committed_is_better(full, full));
}

// Every case of the benchmarks is a valid scene of the liquid and solid steps that it names.
TEST(BenchmarkCases, AreScenes) {
  const auto cases = bench::coupled_cases();
  ASSERT_FALSE(cases.empty());
  for (const auto& one : cases) {
    const Scene scene = bench::column_scene(bench::coupled_case(one.name).overrides);
    const double substeps = scene.fluid.time_step / scene.contact.time_step;
    EXPECT_NEAR(substeps, std::round(substeps), 1e-6) << one.name;
  }
  try {
    bench::coupled_case("nothing");
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(cases.front().name), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace slfb
