// Profiles with replicates and designs, on a made-up work: which runs they are and what they are called.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "experiments/runs/measure.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/profiles.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

constexpr const char* choices = R"(
[[factor]]
name = "bounce"
title = "restitution"
source = "not said"
[[factor.level]]
name = "hard"
title = "hard"
overrides = ["contact.restitution=0.9"]
[[factor.level]]
name = "dull"
title = "dull"
overrides = ["contact.restitution=0.5"]

[[factor]]
name = "slide"
title = "friction"
source = "not said"
[[factor.level]]
name = "rough"
title = "rough"
overrides = ["contact.sliding_friction=0.3"]
[[factor.level]]
name = "smooth"
title = "smooth"
overrides = ["contact.sliding_friction=0"]

[designs.alone]
kind = "one-at-a-time"

[designs.all]
kind = "full"
)";

class ProfileDesigns : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_.path() / "scenes");
    fs::copy_file(source_folder() / "experiments/scenes/fluidised_box.toml", folder_.path() / "scenes/bed.toml");
    write_file(folder_.path() / "readings.toml", choices);
    work_.id = "sand_2099";
    work_.folders = {folder_.path(), folder_.path(), folder_.path() / "published"};
  }

  Profile profile(const std::string& runs) {
    write_file(folder_.path() / "profiles.toml",
               "[systems.sand]\nscene = \"bed.toml\"\n[profiles.it]\noverrides = []\n" + runs);
    return load_profile(work_, "it");
  }

  std::string problem(const std::string& runs) {
    try {
      profile(runs);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  static std::vector<std::string> keys(const Profile& profile) {
    std::vector<std::string> keys;
    for (const RunSpec& run : profile.runs) keys.push_back(run_key(run));
    return keys;
  }

  Folder folder_;
  Work work_;
};

constexpr const char* run = "[[profiles.it.runs]]\nsystem = \"sand\"\nsuperficial_velocities = [0.07]\n";

TEST_F(ProfileDesigns, ReplicatesDifferInTheirSeedAlone) {
  const Profile one = profile(run), three = profile(std::string(run) + "seeds = [1, 2, 3]\n");
  EXPECT_EQ(keys(three), (std::vector<std::string>{"sand/0.07", "sand/0.07/seed-2", "sand/0.07/seed-3"}));
  // The run with the scene's own seed is the run without seeds: its result and its file stay.
  EXPECT_EQ(scene_hash(load_run_scene(three.runs[0])), scene_hash(load_run_scene(one.runs[0])));
  EXPECT_EQ(published_file(three.runs[0]), published_file(one.runs[0]));
  EXPECT_EQ(published_file(three.runs[1]).filename(), "sand_0.07_default_seed-2.h5");
  std::set<std::string> hashes;
  for (const RunSpec& spec : three.runs) {
    Scene scene = load_run_scene(spec);
    EXPECT_TRUE(hashes.insert(scene_hash(scene)).second);
    scene.seed = load_run_scene(one.runs[0]).seed;
    EXPECT_EQ(canonical_toml(scene), canonical_toml(load_run_scene(one.runs[0])));
  }
}

TEST_F(ProfileDesigns, ReplicatesAnswerOneKey) {
  const Profile profile = this->profile(std::string(run) + "seeds = [1, 2]\n");
  std::vector<FinishedRun> runs;
  for (const RunSpec& spec : profile.runs) {
    FinishedRun finished{spec, load_run_scene(spec), {}, false, false, RunSummary{}};
    finished.result.name = scene_hash(finished.scene);
    finished.summary->drops = {{{"classification_velocity", spec.seed ? 0.3 : 0.1}}};
    runs.push_back(std::move(finished));
  }
  const Measurement& pooled =
      measure_runs(runs, general_rules()).at(measure_key("classification_velocity", "sand", 0.07));
  EXPECT_DOUBLE_EQ(pooled.value, 0.2);
  EXPECT_EQ(pooled.samples, 2U);
}

TEST_F(ProfileDesigns, EachReadingIsAVariant) {
  const Profile designed = profile(std::string(run) + "design = \"alone\"\nseeds = [1, 5]\n");
  EXPECT_EQ(keys(designed),
            (std::vector<std::string>{"sand/0.07/base", "sand/0.07/base/seed-5", "sand/0.07/dull",
                                      "sand/0.07/dull/seed-5", "sand/0.07/smooth", "sand/0.07/smooth/seed-5"}));
  EXPECT_EQ(load_run_scene(designed.runs[2]).contact.restitution, 0.5);
  EXPECT_EQ(load_run_scene(designed.runs[4]).contact.sliding_friction, 0.0);
}

TEST_F(ProfileDesigns, AReadingOfTwoDesignsIsOneRun) {
  const std::string alone = std::string(run) + "design = \"alone\"\n", all = std::string(run) + "design = \"all\"\n";
  const Profile both = profile(alone + all);
  EXPECT_EQ(keys(both), (std::vector<std::string>{"sand/0.07/base", "sand/0.07/dull", "sand/0.07/smooth",
                                                  "sand/0.07/dull_smooth"}));
}

TEST_F(ProfileDesigns, RunsMayHaveASceneOfTheirOwn) {
  const Profile both = profile(std::string(run) + "scene = \"other.toml\"\n" + run);
  EXPECT_EQ(both.runs[0].scene.filename(), "other.toml");
  EXPECT_EQ(both.runs[1].scene.filename(), "bed.toml");
}

TEST_F(ProfileDesigns, WhatAllProfilesShareMayBeUntrueOfOne) {
  write_file(folder_.path() / "profiles.toml", R"(
[systems.sand]
scene = "bed.toml"
[common]
differences = ["Sand is round."]
[profiles.round]
differences = ["Short."]
[profiles.edged]
own_differences_only = true
differences = ["Sand is edged."]
)");
  EXPECT_EQ(load_profile(work_, "round").differences, (std::vector<std::string>{"Sand is round.", "Short."}));
  EXPECT_EQ(load_profile(work_, "edged").differences, (std::vector<std::string>{"Sand is edged."}));
}

TEST_F(ProfileDesigns, WrongProfilesAreExplained) {
  const auto has = [&](const std::string& more, const std::string& part) {
    EXPECT_NE(problem(run + more).find(part), std::string::npos) << problem(run + more);
  };
  has("design = \"some\"\n", "design: there is no design \"some\"; known: all, alone");
  has("design = \"all\"\nvariant = \"other\"\n", "variant: stands beside a design");
  has("seeds = []\n", "seeds: is empty");
  has("seeds = [1, 1]\n", "seeds: has 1 twice");
  has("seeds = [1.5]\n", "seeds: 1.5 is no seed; allowed are whole numbers");
  has("seeds = [-1]\n", "seeds: -1 is no seed");
}

}  // namespace
}  // namespace slfb
