#include <fmt/format.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiments/runs/campaign.hpp"
#include "experiments/runs/run_campaign.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/runs/run_lock.hpp"
#include "experiments/runs/stop_signals.hpp"
#include "solver/support/child_process.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

const std::filesystem::path single_sphere = source_folder() / "experiments/scenes/single_sphere.toml";

/// A steel sphere in water at rest: takes milliseconds.
Scene falling_sphere(double release_height) {
  RunSpec spec{"sphere", 0.0, "", single_sphere, {}};
  spec.overrides.push_back("stage[0].release_height=" + std::to_string(release_height) + " m");
  return load_run_scene(spec);
}

class RunCampaignTest : public ::testing::Test {
 protected:
  RunCampaignTest()
      : out_(std::filesystem::path(::testing::TempDir()) /
             (std::string("slfb_campaign_") + ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::remove_all(out_);
  }
  ~RunCampaignTest() override { std::filesystem::remove_all(out_); }
  [[nodiscard]] CampaignOptions options() const {
    return {.out = out_, .jobs = 2, .threads_per_run = 1, .progress = false};
  }
  std::filesystem::path out_;
};

TEST_F(RunCampaignTest, RunsWhatIsMissingAndNothingTwice) {
  const std::vector<NamedScene> scenes{
      {"low", falling_sphere(0.2)}, {"high", falling_sphere(0.4)}, {"low again", falling_sphere(0.2)}};
  const CampaignOutcome first = run_scenes(scenes, options());
  EXPECT_EQ(first.finished, 2);
  EXPECT_EQ(first.skipped, 0);
  EXPECT_EQ(first.exit_status(), 0);
  for (const NamedScene& named : scenes) {
    const std::string hash = scene_hash(named.scene);
    const RunResult result = load_result(result_file(out_, hash));
    EXPECT_EQ(result.name, hash);
    ASSERT_EQ(result.drops.size(), 1U);
    EXPECT_GT(result.drops.front().bottom_time, 0.0);
    EXPECT_EQ(scene_hash(load_scene(run_directory(out_, hash) / "scene.toml")), hash);
    EXPECT_FALSE(std::filesystem::exists(run_directory(out_, hash) / "checkpoint.h5"));
  }
  const CampaignOutcome second = run_scenes(scenes, options());
  EXPECT_EQ(second.finished, 0);
  EXPECT_EQ(second.skipped, 2);
}

TEST_F(RunCampaignTest, AFailureDoesNotStopTheOthers) {
  const NamedScene broken{"broken", falling_sphere(0.3)};
  // A file where the folder of the run should be.
  std::filesystem::create_directories(out_ / "runs");
  save_result({}, run_directory(out_, scene_hash(broken.scene)));
  const CampaignOutcome outcome = run_scenes({broken, {"sound", falling_sphere(0.2)}}, options());
  EXPECT_EQ(outcome.failed, 1);
  ASSERT_EQ(outcome.failures.size(), 1U);
  EXPECT_EQ(outcome.failures[0].find("broken: "), 0U) << outcome.failures[0];
  EXPECT_EQ(outcome.finished, 1);
  EXPECT_EQ(outcome.exit_status(), 1);
}

TEST_F(RunCampaignTest, FinishedRunsAreFoundAndMissingOnesLeftOut) {
  const RunSpec done{"sphere", 0.0, "low", single_sphere, {"stage[0].release_height=0.2 m"}};
  const RunSpec missing{"sphere", 0.0, "high", single_sphere, {"stage[0].release_height=0.4 m"}};
  EXPECT_EQ(run_campaign({done}, options()).finished, 1);
  const std::vector<FinishedRun> runs = finished_runs({"test", {}, {done, missing}}, out_);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs.front().spec.variant, "low");
  EXPECT_EQ(runs.front().result.name, scene_hash(runs.front().scene));
  EXPECT_FALSE(runs.front().published);
  EXPECT_FALSE(runs.front().stale);
}

TEST_F(RunCampaignTest, TwoProcessesDoNotSimulateTheSameRun) {
  const NamedScene scene{"sphere", falling_sphere(0.2)};
  const auto directory = run_directory(out_, scene_hash(scene.scene));
  std::filesystem::create_directories(directory);
  {
    const RunLock other(directory);
    const CampaignOutcome outcome = run_scenes({scene}, options());
    ASSERT_EQ(outcome.failed, 1);
    EXPECT_NE(outcome.failures[0].find("another slfb simulates this scene"), std::string::npos) << outcome.failures[0];
  }
  EXPECT_EQ(run_scenes({scene}, options()).finished, 1);
}

TEST_F(RunCampaignTest, ADamagedCheckpointIsNamedAndLeftInPlace) {
  const NamedScene scene{"sphere", falling_sphere(0.2)};
  const auto checkpoint = run_directory(out_, scene_hash(scene.scene)) / "checkpoint.h5";
  std::filesystem::create_directories(checkpoint.parent_path());
  std::ofstream(checkpoint) << "not HDF5";
  const CampaignOutcome outcome = run_scenes({scene}, options());
  ASSERT_EQ(outcome.failed, 1);
  for (const std::string& part : {checkpoint.string(), "remove " + checkpoint.parent_path().string()})
    EXPECT_NE(outcome.failures[0].find(part), std::string::npos) << outcome.failures[0];
  EXPECT_TRUE(std::filesystem::exists(checkpoint));
}

TEST_F(RunCampaignTest, ADamagedResultIsNamedWithTheWayOut) {
  const auto file = result_file(out_, "0123456789abcdef");
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << "not HDF5";
  try {
    load_own_result(out_, "0123456789abcdef");
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(std::string(error.what()).find(file.string()), 0U) << error.what();
    EXPECT_NE(std::string(error.what()).find("remove it to have it simulated again"), std::string::npos);
  }
}

TEST_F(RunCampaignTest, WhatCannotBePublishedIsAFailureAndTheResultStays) {
  const NamedScene scene{"sphere", falling_sphere(0.2)};
  CampaignOptions publishing = options();
  publishing.finished = [](std::size_t) { throw std::runtime_error("the disk is full"); };
  const CampaignOutcome outcome = run_scenes({scene}, publishing);
  ASSERT_EQ(outcome.failed, 1);
  EXPECT_EQ(outcome.failures[0], "sphere: the disk is full");
  EXPECT_TRUE(std::filesystem::exists(result_file(out_, scene_hash(scene.scene))));
}

TEST(StopSignalsTest, TheFirstSignalRaisesTheFlagOnly) {
  const StopSignals signals;
  const WorkToSave state;
  EXPECT_FALSE(signals.requested());
  std::raise(SIGTERM);
  EXPECT_TRUE(signals.requested());
}

TEST(CampaignOutcomeTest, AnInterruptionIsReportedAsTheShellDoes) {
  EXPECT_EQ((CampaignOutcome{.finished = 1, .skipped = 1}).exit_status(), 0);
  EXPECT_EQ((CampaignOutcome{.failed = 1}).exit_status(), 1);
  EXPECT_EQ((CampaignOutcome{.failed = 1, .interrupted = 1}).exit_status(), 130);
  EXPECT_EQ((CampaignOutcome{.failed = 1, .interrupted = 2}).unfinished(), 3);
}

// What a published result says of its scene is somebody's text.
TEST_F(RunCampaignTest, APublishedSceneMakesNobodyCompileAnything) {
  std::filesystem::create_directories(out_);
  const auto trace = out_ / "trace", law = out_ / "evil.cpp";
  std::ofstream(law) << "#include <fstream>\nstatic const bool ran = (std::ofstream(\"" << trace.string()
                     << "\"), true);\n";
  Profile profile;
  RunSpec spec{"sphere", 0.0, "", single_sphere, {}};
  spec.profile = "quick";
  spec.published = out_ / "published";
  profile.runs = {spec};
  RunResult result;
  result.numerics = numerics_version - 1;
  result.scene_text = canonical_toml(load_run_scene(spec));
  const std::string key = "drag_law = ";
  const auto from = result.scene_text.find(key) + key.size();
  result.scene_text.replace(from, result.scene_text.find('\n', from) - from, "\"" + law.string() + "\"");
  save_result(result, published_file(spec));
  EXPECT_TRUE(finished_runs(profile, out_).empty());
  EXPECT_FALSE(std::filesystem::exists(trace));
  spec.variant = "../../escaped";
  EXPECT_THROW((void)published_file(spec), std::runtime_error);
}

TEST_F(RunCampaignTest, AResultOfAnotherSceneIsNotTaken) {
  const std::string hash = scene_hash(falling_sphere(0.2));
  RunResult other;
  other.name = scene_hash(falling_sphere(0.4));
  save_result(other, result_file(out_, hash));
  EXPECT_THROW((void)load_own_result(out_, hash), std::runtime_error);
}

// As long as nothing is worth saving a signal ends the program; after that it asks for the state to be saved.
TEST(StopSignals, TheFirstSignalActsDuringSetUpAndIsAWishLater) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto during_set_up = trouble_in_child(
        [&] {
          const StopSignals signals;
          raise(signal);
        },
        20);
    ASSERT_TRUE(during_set_up);
    EXPECT_NE(during_set_up->find(fmt::format("signal {} ", signal)), std::string::npos) << *during_set_up;
    const auto later = trouble_in_child(
        [&] {
          const StopSignals signals;
          const WorkToSave state;
          raise(signal);
          if (!signals.requested()) std::abort();
        },
        20);
    EXPECT_FALSE(later) << *later;
  }
  const auto with_nohup = trouble_in_child(
      [] {
        std::signal(SIGHUP, SIG_IGN);
        const StopSignals signals;
        const WorkToSave state;
        raise(SIGHUP);
        if (signals.requested()) std::abort();
      },
      20);
  EXPECT_FALSE(with_nohup) << *with_nohup;
}

}  // namespace
}  // namespace slfb
