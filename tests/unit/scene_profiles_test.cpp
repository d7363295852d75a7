#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/campaign.hpp"
#include "experiments/work/profiles.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

const std::filesystem::path scenes = source_folder() / "experiments" / "peng_2014" / "scenes";

TEST(Scenes, OfTheSuiteAreValid) {
  for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
    EXPECT_NO_THROW(load_scene(entry.path())) << entry.path();
  }
}

TEST(Scenes, ReferenceTableNamesEveryKey) {
  std::ifstream file(source_folder() / "solver" / "scene" / "README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  for (const auto& scene : {scenes / "6in5W.toml", source_folder() / "experiments/scenes/fluidised_box.toml"}) {
    std::istringstream canonical(canonical_toml(load_scene(scene)));
    for (std::string line; std::getline(canonical, line);) {
      const bool table = line.front() == '[';
      const std::string cell = "| `" + (table ? line : line.substr(0, line.find(' '))) + "` |";
      EXPECT_NE(readme.find(cell), std::string::npos) << cell;
    }
  }
}

TEST(Scenes, WorkingAndLiteralSceneAreTheSameCase) {
  const Scene working = load_scene(scenes / "6in5W.toml");
  const Scene literal = load_scene(scenes / "6in5W_paper-literal.toml");
  EXPECT_EQ(literal.species[0].count, 3600);
  EXPECT_EQ(literal.fluid.pressure_velocity, PressureVelocity::simple);
  EXPECT_EQ(literal.coupling.void_fraction, VoidFractionScheme::particle_meshing);
  EXPECT_EQ(literal.coupling.interpolation, Interpolation::gradient);
  EXPECT_EQ(literal.start.arrangement, Arrangement::random);
  Scene numerics_exchanged = working;
  numerics_exchanged.start = literal.start;
  numerics_exchanged.fluid = literal.fluid;
  numerics_exchanged.coupling = literal.coupling;
  numerics_exchanged.stages = literal.stages;
  EXPECT_EQ(scene_hash(numerics_exchanged), scene_hash(literal));
}

// Its runs count as runs of this reading: the scene must not move away from its name.
TEST(Scenes, TheDefaultSceneIsTheReadingThatItIsCalled) {
  const readings::Choices choices = load_choices(peng_2014_work());
  const Scene scene = load_scene(scenes / "6in5W.toml");
  Scene reading = load_scene(scenes / "6in5W.toml", choices.overrides_of(choices.reading_named(default_reading)));
  reading.stages[0].duration = scene.stages[0].duration;  // readings settle for a shorter time
  EXPECT_EQ(canonical_toml(reading), canonical_toml(scene));
}

TEST(Scenes, TheLiteralSceneIsTheReadingOfItsProfile) {
  const Profile profile = load_profile("literal");
  for (const RunSpec& run : profile.runs) {
    Scene reading = load_scene(run.scene, run.overrides);
    Scene literal = load_scene(scenes / "6in5W_paper-literal.toml");
    literal.liquid.superficial_velocity = reading.liquid.superficial_velocity;
    literal.seed = run.seed.value_or(literal.seed);
    reading.stages[0].duration = literal.stages[0].duration;                  // readings settle for a shorter time
    EXPECT_NEAR(reading.fluid.cell_height, literal.fluid.cell_height, 5e-6);  // 7.14 mm, not all digits
    reading.fluid.cell_height = literal.fluid.cell_height;
    EXPECT_EQ(canonical_toml(reading), canonical_toml(literal));
  }
}

class EachProfile : public testing::TestWithParam<std::string> {};

TEST_P(EachProfile, HoldDistinctRunsOfValidScenes) {
  const Profile profile = load_profile(GetParam());
  EXPECT_EQ(profile.name, GetParam());
  EXPECT_FALSE(profile.runs.empty());
  std::set<std::string> hashes;
  for (const RunSpec& run : profile.runs) {
    const Scene scene = load_scene(scenes / run.scene, run.overrides);
    EXPECT_EQ(scene.liquid.superficial_velocity, run.superficial_velocity);
    EXPECT_EQ(scene.coupling.drag_law, run.variant.empty() ? "gidaspow-1994" : run.variant);
    EXPECT_TRUE(hashes.insert(scene_hash(scene)).second) << run.system << " " << run.superficial_velocity;
  }
}

TEST_P(EachProfile, SayWhatSetsThemApart) {
  for (const std::string& sentence : load_profile(GetParam()).differences) {
    EXPECT_EQ(sentence.back(), '.') << sentence;
  }
}

INSTANTIATE_TEST_SUITE_P(All, EachProfile, testing::Values("quick", "full", "paper-steps"));

class ProfileOfReadings : public testing::TestWithParam<std::string> {};

TEST_P(ProfileOfReadings, HoldDistinctRunsOfValidScenes) {
  const Profile profile = load_profile(GetParam());
  EXPECT_FALSE(profile.runs.empty());
  std::set<std::string> hashes;
  for (const RunSpec& run : profile.runs) {
    const Scene scene = load_scene(run.scene, run.overrides);
    EXPECT_EQ(scene.liquid.superficial_velocity, run.superficial_velocity);
    EXPECT_FALSE(run.variant.empty());  // without a variant it would stand for the default reading
    EXPECT_TRUE(hashes.insert(scene_hash(scene)).second) << run_key(run);
  }
}

INSTANTIATE_TEST_SUITE_P(All, ProfileOfReadings, testing::Values("packed", "screening", "candidates", "literal"));

TEST(Profiles, QuickCoversTheVelocitiesOfTheFirstFigures) {
  const Profile quick = load_profile("quick");
  const auto runs_at = [&](double velocity, const std::string& variant) {
    return std::ranges::count_if(
        quick.runs, [&](const RunSpec& run) { return run.superficial_velocity == velocity && run.variant == variant; });
  };
  for (const double velocity : {0.06, 0.07, 0.08, 0.09, 0.10, 0.11}) EXPECT_EQ(runs_at(velocity, ""), 1) << velocity;
  EXPECT_EQ(runs_at(0.10, "di-felice-1994"), 1);
}

TEST(Profiles, UnknownNameListsTheKnownOnes) {
  try {
    load_profile("swift");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what())
                  .find("known: \"candidates\", \"causes\", \"defluidised\", \"drag-law\", \"full\", "
                        "\"grid-convergence\", \"lattice\", \"literal\", \"packed\", \"paper-steps\", "
                        "\"quick\", \"screening\", \"seconds\""),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace slfb
