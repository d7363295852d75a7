// Runs of a profile for other machines: they are listed, written as jobs, run one by one, and brought together.
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/run_entries.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/run_files.hpp"
#include "experiments/work/profiles.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

/// What a command prints; an exception goes on.
std::string slfb(std::vector<std::string> arguments) {
  std::ranges::reverse(arguments);  // as CLI11 takes a vector
  CLI::App app;
  add_list_command(app);
  add_run_command(app);
  add_campaign_command(app);
  testing::internal::CaptureStdout();
  try {
    app.parse(arguments);
  } catch (...) {
    testing::internal::GetCapturedStdout();
    throw;
  }
  return testing::internal::GetCapturedStdout();
}

std::string error_of(const std::vector<std::string>& arguments) {
  try {
    slfb(arguments);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

/// The result of a scene that needs no simulation to be told apart from another.
RunResult result_of(const Scene& scene) {
  RunResult result;
  result.name = scene_hash(scene);
  result.scene_text = canonical_toml(scene);
  return result;
}

Scene small_scene() { return load_scene(source_folder() / "experiments/scenes/fluidised_box.toml", {}); }

TEST(ListRuns, TellsASchedulerWhatThereIsToDo) {
  const Folder folder;
  const auto& work = peng_2014_work();
  const Profile profile = load_profile(work, "quick");
  const Scene first = load_run_scene(profile.runs.front());
  save_result(result_of(first), result_file(folder.path(), scene_hash(first)));
  const auto listed =
      nlohmann::json::parse(slfb({"list", "--runs", "quick", "--json", "--out", folder.path().string()}));
  EXPECT_EQ(listed.at("profile"), "quick");
  ASSERT_EQ(listed.at("runs").size(), profile.runs.size());
  std::set<std::string> hashes;
  for (std::size_t i = 0; i < profile.runs.size(); ++i) {
    const auto& run = listed.at("runs").at(i);
    EXPECT_EQ(run.at("key"), run_key(profile.runs[i]));
    EXPECT_EQ(run.at("hash"), scene_hash(load_run_scene(profile.runs[i])));
    EXPECT_GT(run.at("estimated_core_seconds").get<double>(), 1.0);
    EXPECT_EQ(run.at("done").get<bool>(), i == 0);
    EXPECT_EQ(run.at("needed").get<bool>(), i != 0);
    hashes.insert(run.at("hash"));
  }
  EXPECT_EQ(hashes.size(), profile.runs.size());
}

TEST(RunOfAProfile, IsThatOfTheFigures) {
  const Profile profile = load_profile(peng_2014_work(), "quick");
  const RunSpec& spec = profile.runs.back();
  for (const std::string& name : {run_key(spec), scene_hash(load_run_scene(spec))}) {
    const auto plan = nlohmann::json::parse(slfb({"run", "--profile", "quick", name, "--dry-run", "--json"}));
    EXPECT_EQ(plan.at("hash"), scene_hash(load_run_scene(spec))) << name;
  }
  const std::string close = run_key(spec) + "x";
  EXPECT_NE(error_of({"run", "--profile", "quick", close, "--dry-run"}).find(run_key(spec)), std::string::npos);
}

TEST(Campaign, TheMakefileRunsEachRunOnceAndThenTheReport) {
  const Folder folder;
  const std::string out = (folder.path() / "out").string();
  write_file(folder.path() / "campaign.mk", slfb({"campaign", "quick", "--to", "make", "--out", out}));
  const fs::path said = folder.path() / "said";
  const std::string command =
      "make --dry-run -f '" + (folder.path() / "campaign.mk").string() + "' > '" + said.string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string commands = read_file(said);
  const std::size_t report = commands.find("figures --profile quick");
  ASSERT_NE(report, std::string::npos);
  EXPECT_GT(commands.find("check --profile quick"), report);
  for (const RunSpec& spec : load_profile(peng_2014_work(), "quick").runs) {
    const std::string run = "run --profile quick " + run_key(spec) + " ";
    const std::size_t found = commands.find(run);
    EXPECT_LT(found, report) << run;
    EXPECT_EQ(commands.find(run, found + 1), std::string::npos) << run;
  }
}

TEST(Campaign, AFinishedRunIsNoJob) {
  const Folder folder;
  const Scene scene = load_run_scene(load_profile(peng_2014_work(), "quick").runs.front());
  save_result(result_of(scene), result_file(folder.path(), scene_hash(scene)));
  for (const char* engine : {"make", "snakemake", "slurm"}) {
    const std::string jobs = slfb({"campaign", "quick", "--to", engine, "--out", folder.path().string()});
    EXPECT_EQ(jobs.find(scene_hash(scene)), std::string::npos) << engine;
  }
}

TEST(Campaign, TheScriptForSlurmIsOneAndItsArrayHasAllRuns) {
  const Folder folder;
  write_file(folder.path() / "campaign.sh",
             slfb({"campaign", "quick", "--to", "slurm", "--out", folder.path().string()}));
  EXPECT_EQ(std::system(("sh -n '" + (folder.path() / "campaign.sh").string() + "'").c_str()), 0);
  const std::string script = read_file(folder.path() / "campaign.sh");
  const Profile profile = load_profile(peng_2014_work(), "quick");
  EXPECT_NE(script.find("--array=1-" + std::to_string(profile.runs.size()) + "\n"), std::string::npos) << script;
  for (const RunSpec& spec : profile.runs) EXPECT_NE(script.find("\n" + run_key(spec) + "\n"), std::string::npos);
}

TEST(Campaign, MergeTakesWhatIsMissingAndLeavesWhatIsThere) {
  const Folder one, other, out;
  Scene scene = small_scene();
  save_result(result_of(scene), result_file(one.path(), scene_hash(scene)));
  save_result(result_of(scene), result_file(out.path(), scene_hash(scene)));
  scene.liquid.superficial_velocity = 0.09;
  save_result(result_of(scene), result_file(one.path(), scene_hash(scene)));
  save_result(result_of(scene), result_file(other.path(), scene_hash(scene)));
  const std::string said =
      slfb({"campaign", "merge", one.path().string(), other.path().string(), "--out", out.path().string()});
  EXPECT_TRUE(said.starts_with("1 results merged")) << said;
  EXPECT_EQ(load_result(result_file(out.path(), scene_hash(scene))).name, scene_hash(scene));
}

TEST(Campaign, MergeRefusesAnotherNumericsVersionAndAnotherScene) {
  const Folder stranger, out;
  const Scene scene = small_scene();
  RunResult result = result_of(scene);
  result.numerics = numerics_version - 1;
  save_result(result, result_file(stranger.path(), scene_hash(scene)));
  const std::vector<std::string> command{"campaign", "merge", stranger.path().string(), "--out", out.path().string()};
  EXPECT_NE(error_of(command).find("numerics version"), std::string::npos);
  Scene another = scene;
  another.liquid.superficial_velocity = 0.09;
  result = result_of(another);
  result.name = scene_hash(scene);
  save_result(result, result_file(stranger.path(), scene_hash(scene)));
  EXPECT_NE(error_of(command).find(scene_hash(another)), std::string::npos);
  EXPECT_FALSE(fs::exists(out.path() / "runs"));
}

}  // namespace
}  // namespace slfb
