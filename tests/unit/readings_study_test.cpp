// From finished runs to findings, on made-up runs of a made-up work.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/readings/study.hpp"
#include "solver/support/folders.hpp"

namespace slfb::readings {
namespace {

/// Two choices, "spring" and "wall"; the second level of "wall" departs from the print.
Choices choices() {
  Choices made;
  made.factors = {
      {"spring", "spring", "not said", "-", {{"hard", "hard spring", {}, "", {}}, {"soft", "soft spring", {}, "", {}}}},
      {"wall", "wall", "rough", "-", {{"rough", "rough wall", {}, "", {}}, {"smooth", "smooth wall", {}, "p. 1", {}}}}};
  return made;
}

PrintedNumber number(const std::string& quantity, double velocity, double value, Part part, const std::string& block) {
  return {quantity + " at " + velocity_text(velocity), quantity, block, value, 0.001, part};
}

Evidence evidence(const std::string& quantity, double velocity, double value, Part part = Part::test,
                  const std::string& block = "drops") {
  return {number(quantity, velocity, value, part, block), "sand", velocity, ""};
}

const std::filesystem::path scene_file = source_folder() / "experiments/scenes/fluidised_box.toml";

FinishedRun run(const std::string& variant, double velocity, std::uint64_t seed, const std::string& profile = "first") {
  FinishedRun finished{{"sand", velocity, variant, scene_file, {}, profile, {}, {}, seed},
                       load_scene(scene_file),
                       {},
                       false,
                       false,
                       RunSummary{}};
  finished.scene.seed = seed;
  return finished;
}

/// A drop with V_2, or one that does not arrive.
std::map<std::string, double> drop(double velocity) {
  return std::isnan(velocity) ? std::map<std::string, double>{{"bottom_fraction", 0.0}}
                              : std::map<std::string, double>{{"classification_velocity", velocity}};
}

TEST(Collect, TakesTheLastProfileThatHasAReading) {
  std::vector<FinishedRun> runs{run("soft", 0.06, 1, "short"),
                                run("soft", 0.06, 1, "long"),
                                run("soft", 0.06, 2, "long"),
                                run("base", 0.06, 1, "short"),
                                run("", 0.06, 1),
                                run("other-kind", 0.06, 1)};
  for (std::size_t r = 0; r < runs.size(); ++r) runs[r].summary->drops = {drop(0.1 * static_cast<double>(r + 1))};
  const auto collected = collect(choices(), {evidence("classification_velocity", 0.06, 0.1)}, runs, general_rules());
  ASSERT_EQ(collected.size(), 2U);
  EXPECT_EQ(collected[0].name, "soft");
  ASSERT_EQ(collected[0].runs.samples[0].size(), 2U);
  EXPECT_NEAR(std::exp(collected[0].runs.samples[0][0]), 0.2, 1e-12);
  EXPECT_NEAR(std::exp(collected[0].runs.samples[0][1]), 0.3, 1e-12);
  EXPECT_NEAR(std::exp(collected[1].runs.samples[0][0]), 0.4, 1e-12);
}

TEST(Collect, DropsThatDoNotArriveKeepTheirPlace) {
  std::vector<FinishedRun> runs{run("base", 0.06, 1)};
  runs[0].summary->drops = {drop(0.1), drop(std::nan("")), drop(0.2)};
  const auto samples =
      collect(choices(), {evidence("classification_velocity", 0.06, 0.1), evidence("drag_ratio", 0.06, 0.1)}, runs,
              general_rules())[0]
          .runs.samples;
  ASSERT_EQ(samples[0].size(), 3U);
  EXPECT_TRUE(std::isnan(samples[0][1]));
  EXPECT_TRUE(samples[1].empty()) << "a number that no drop has beside another of its block was not recorded";
}

TEST(Collect, ANumberMayFollowFromThoseOfItsDrop) {
  std::vector<FinishedRun> runs{run("base", 0.06, 1)};
  runs[0].summary->drops = {{{"terminal_velocity", 0.5}}, {}};
  MeasuringRules rules;
  rules.quantities.push_back({"half_terminal_velocity", "m/s", "half", "Half the terminal velocity.",
                              OfDropNumbers([](const DropNumbers& numbers) -> std::optional<double> {
                                const auto whole = numbers.of_drop("terminal_velocity");
                                return whole ? std::optional(0.5 * *whole) : std::nullopt;
                              })});
  const auto samples =
      collect(choices(), {evidence("half_terminal_velocity", 0.06, 0.2)}, runs, rules)[0].runs.samples[0];
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_NEAR(std::exp(samples[0]), 0.25, 1e-12);
  EXPECT_TRUE(std::isnan(samples[1]));
}

TEST(Collect, NumbersOfABedHaveTheSeedsInCommon) {
  std::vector<FinishedRun> runs{run("base", 0.03, 1), run("base", 0.03, 2), run("base", 0.04, 2), run("base", 0.04, 3)};
  for (FinishedRun& one : runs)
    one.summary->bed["pressure_drop"] = {100.0 * one.spec.superficial_velocity + static_cast<double>(one.scene.seed),
                                         0.1, 1.0, 10.0, 0};
  const auto samples = collect(choices(),
                               {evidence("pressure_drop", 0.03, 5.0, Part::calibration, "bed"),
                                evidence("pressure_drop", 0.04, 6.0, Part::calibration, "bed")},
                               runs, general_rules())[0]
                           .runs;
  ASSERT_EQ(samples.samples[0].size(), 1U);
  EXPECT_NEAR(std::exp(samples.samples[0][0]), 5.0, 1e-12);  // of seed 2
  EXPECT_NEAR(std::exp(samples.samples[1][0]), 6.0, 1e-12);
  EXPECT_NEAR(samples.own_errors[0], 0.1 / 1.96 / 5.0, 1e-12);
}

TEST(Collect, ContactsComeFromTheSpringsOfTheScene) {
  std::vector<FinishedRun> runs{run("base", 0.06, 1)};
  runs[0].summary->drops = {{{"collision_frequency", 500.0}, {"classification_velocity", 0.1}}};
  const std::vector<Evidence> asked{evidence("collision_frequency", 0.06, 500.0, Part::test, "collisions")};
  EXPECT_EQ(collect(choices(), asked, runs, general_rules())[0].runs.samples[0].size(), 1U);
  runs[0].scene.contact.stiffness *= 0.1;
  EXPECT_TRUE(collect(choices(), asked, runs, general_rules())[0].runs.samples[0].empty());
}

TEST(Collect, AnUnknownQuantityIsNamed) {
  std::vector<FinishedRun> runs{run("base", 0.06, 1)};
  EXPECT_THROW(collect(choices(), {evidence("grains_in_a_spoon", 0.06, 1.0)}, runs, general_rules()),
               std::invalid_argument);
}

/// All four readings: a soft spring doubles V_2, a smooth wall lowers the packed bed's pressure drop by a fifth.
std::vector<FinishedRun> four_readings() {
  std::vector<FinishedRun> runs;
  for (const auto& [variant, velocity, pressure] :
       {std::tuple{"base", 0.1, 100.0}, {"soft", 0.2, 100.0}, {"smooth", 0.1, 80.0}, {"soft_smooth", 0.2, 80.0}})
    for (const std::uint64_t seed : {1U, 2U}) {
      runs.push_back(run(variant, 0.06, seed));
      RunSummary& summary = *runs.back().summary;
      const double shift = seed == 1 ? 0.99 : 1.01;
      summary.bed["pressure_drop"] = {pressure * shift, 0.5, 1.0, 10.0, 0};
      summary.drops = {drop(velocity * 0.97), drop(velocity * 1.03)};
    }
  return runs;
}

TEST(Study, FindsTheReadingThatThePrintIsOf) {
  // Printed: the V_2 of a soft spring, the pressure drop of a rough wall; and a number that nothing gives.
  std::vector<Evidence> printed{evidence("pressure_drop", 0.06, 101.0, Part::calibration, "bed"),
                                evidence("classification_velocity", 0.06, 0.2)};
  const Study found = study(choices(), printed, four_readings(), general_rules(), "");
  ASSERT_EQ(found.readings.size(), 4U);
  EXPECT_EQ(found.readings[0].name, "soft");
  EXPECT_EQ(found.readings[0].log10_evidence, 0.0);
  EXPECT_FALSE(found.readings[0].assessment.ruled_out);
  EXPECT_EQ(found.readings[0].inside, 1U);
  for (const StudiedReading& one : found.readings)
    if (one.name.find("smooth") != std::string::npos) {
      EXPECT_TRUE(one.assessment.ruled_out);
      EXPECT_NE(one.assessment.reason.find("pressure_drop at 0.06"), std::string::npos);
      EXPECT_EQ(one.departures, 1U);
    }
  ASSERT_TRUE(found.penalised.has_value());
  EXPECT_GT(found.penalised->levels[0][1], 0.8);
  EXPECT_GT(found.penalised->levels[1][0], 0.8);
  EXPECT_TRUE(found.sensitivities[0].front().number == 1U);

  const auto json = study_json(found);
  EXPECT_EQ(json.at("readings").size(), 4U);
  EXPECT_EQ(json.at("readings")[0].at("name"), "soft");
  const std::string text = study_text(found);
  EXPECT_NE(text.find("| soft spring | 0.0 |"), std::string::npos) << text;
  EXPECT_NE(text.find("smooth wall (p. 1)"), std::string::npos);
  EXPECT_EQ(text.find("no reading satisfies"), std::string::npos);
}

TEST(Study, BarsInTitlesDoNotEndCells) {
  std::vector<Evidence> printed{evidence("pressure_drop", 0.06, 101.0, Part::calibration, "bed"),
                                evidence("classification_velocity", 0.06, 0.2)};
  printed[0].printed.title = "|dp|";
  EXPECT_NE(study_text(study(choices(), printed, four_readings(), general_rules(), "")).find("\\|dp\\| ("),
            std::string::npos);
}

TEST(Study, ListsWhatNoReadingSatisfies) {
  std::vector<Evidence> printed{evidence("pressure_drop", 0.06, 500.0, Part::calibration, "bed"),
                                evidence("classification_velocity", 0.06, 0.2)};
  const Study found = study(choices(), printed, four_readings(), general_rules(), "");
  EXPECT_FALSE(found.reached[0]);
  const std::string text = study_text(found);
  EXPECT_NE(text.find("pressure_drop at 0.06: printed 500, nearest 99.99"), std::string::npos) << text;
}

TEST(Study, DisputedNumbersCountOnlyInTheirOwnColumn) {
  std::vector<Evidence> printed{evidence("pressure_drop", 0.06, 101.0, Part::calibration, "bed"),
                                evidence("classification_velocity", 0.06, 0.2)};
  printed[1].disputed = "may be computed";
  printed.push_back(evidence("classification_velocity", 0.06, 0.1, Part::test, "other"));
  const Study found = study(choices(), printed, four_readings(), general_rules(), "");
  EXPECT_EQ(found.readings[0].name, "base");
  EXPECT_FALSE(found.counted[1]);
  EXPECT_NE(study_text(found).find("may be computed"), std::string::npos);
}

TEST(Study, NumbersThatMadeAChoiceAreEvidenceAndNoTest) {
  std::vector<Evidence> printed{evidence("pressure_drop", 0.06, 101.0, Part::calibration, "bed"),
                                evidence("classification_velocity", 0.06, 0.1)};
  const Study tested = study(choices(), printed, four_readings(), general_rules(), "");
  printed[1].chose = "the spring";
  const Study chosen = study(choices(), printed, four_readings(), general_rules(), "");
  ASSERT_EQ(tested.readings.size(), chosen.readings.size());
  for (std::size_t r = 0; r < chosen.readings.size(); ++r) {
    EXPECT_EQ(tested.readings[r].tested, 1U) << tested.readings[r].name;
    EXPECT_EQ(chosen.readings[r].tested, 0U) << chosen.readings[r].name;
    EXPECT_EQ(chosen.readings[r].assessment.test, tested.readings[r].assessment.test) << chosen.readings[r].name;
  }
  EXPECT_NE(study_text(chosen).find("classification_velocity at 0.06: the spring"), std::string::npos)
      << study_text(chosen);
}

TEST(Study, WithoutRunsItSaysSo) {
  const Study nothing = study(choices(), {evidence("pressure_drop", 0.06, 1.0)}, {}, general_rules(), "");
  EXPECT_EQ(study_text(nothing), "No reading has been run yet.\n");
  EXPECT_FALSE(nothing.penalised.has_value());
  EXPECT_THROW(study(choices(), {}, {}, general_rules(), "colour"), std::invalid_argument);
}

}  // namespace
}  // namespace slfb::readings
