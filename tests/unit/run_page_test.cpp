#include "experiments/figures/run_page.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>
#include <string>

#include "solver/dem/particles.hpp"
#include "solver/io/vtkhdf.hpp"
#include "solver/support/files.hpp"
#include "tests/temporary_folder.hpp"
#include "tests/unit/synthetic_runs.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

pugi::xml_document parsed(const fs::path& page) {
  pugi::xml_document document;
  const auto result = document.load_file(page.c_str(), pugi::parse_default, pugi::encoding_utf8);
  EXPECT_TRUE(result) << result.description();
  return document;
}

TEST(RunPage, ShowsEveryPlotOfWhatWasRecorded) {
  const Folder folder;
  const FinishedRun run = synthetic::runs(synthetic::profile()).front();
  const fs::path page = write_run_page(run.scene, run.result, general_rules(), folder.path() / "page");
  const auto document = parsed(page);
  std::set<std::string> pictures;
  for (const auto& found : document.select_nodes("//img/@src")) pictures.insert(found.attribute().value());
  for (const char* picture : {"heights.svg", "pressure.svg", "track.svg", "spheres.svg"})
    EXPECT_TRUE(pictures.contains(picture)) << picture;
  for (const std::string& picture : pictures) EXPECT_TRUE(fs::exists(page.parent_path() / picture)) << picture;
}

/// A number that a script of gnuplot sets.
double number_in(const std::string& script, const std::string& name) {
  const std::size_t place = script.find("\n" + name + " = ");
  return place == std::string::npos ? std::nan("") : std::stod(script.substr(place + name.size() + 4));
}

TEST(RunPage, DrawsTheLineOfTheClassificationVelocityThroughTheTrack) {
  const Folder folder;
  const FinishedRun run = synthetic::runs(synthetic::profile()).front();
  const fs::path page = write_run_page(run.scene, run.result, general_rules(), folder.path() / "page");
  const std::string script = read_file(page.parent_path() / "track.gp");
  const DropSeries& drop = run.result.drops.front();
  // In the bed's part of the window, which is what is fitted, the line lies on the track.
  const auto [bottom, window_top] = run.scene.recording.fluctuation_window;
  const double top = 0.5 * (bottom + window_top);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < drop.z.size(); ++i) {
    if (drop.z[i] < bottom || drop.z[i] > top) continue;
    ++inside;
    const double line = number_in(script, "intercept") - number_in(script, "velocity") * drop.time[i];
    EXPECT_NEAR(line, drop.z[i], 0.1 * (top - bottom)) << drop.time[i] << " s";
  }
  EXPECT_GE(inside, 3u);
}

TEST(RunPage, SaysWhatWasNotRecorded) {
  const Folder folder;
  RunResult nothing;
  nothing.name = "0123456789abcdef";
  const std::string page = read_file(write_run_page(synthetic::scene(0.1), nothing, general_rules(), folder.path()));
  EXPECT_EQ(page.find("<img"), std::string::npos);
  for (const char* reason : {"No sphere was dropped", "No samples of the bed", "No positions of the spheres"})
    EXPECT_NE(page.find(reason), std::string::npos) << reason;
}

TEST(Snapshots, AreThoseForParaViewInOrderOfTime) {
  const Folder folder;
  dem::Particles particles;
  particles.add({0.001, 0.002, 0.003}, 0.0025, 2230.0, 0);
  particles.add({0.004, 0.005, 0.006}, 0.003, 7800.0, 1);
  const fs::path snapshots = folder.path() / "snapshots";
  fs::create_directories(snapshots);
  for (const double time : {10.5, 2.25}) {
    io::write_particles_vtkhdf(io::snapshot_file(snapshots, "particles", time), particles, time);
    io::write_snapshot_series(snapshots, "particles");
  }
  const auto read = snapshots_of({}, folder.path());
  ASSERT_EQ(read.size(), 2U);
  EXPECT_DOUBLE_EQ(read[0].time, 2.25);
  EXPECT_DOUBLE_EQ(read[1].time, 10.5);
  EXPECT_EQ(read[0].foreign, 1);
  EXPECT_FLOAT_EQ(static_cast<float>(read[0].z[1]), 0.006F);
  const auto series = nlohmann::json::parse(read_file(snapshots / "particles.hdf.series"));
  ASSERT_EQ(series.at("files").size(), 2U);
  EXPECT_DOUBLE_EQ(series.at("files").at(0).at("time"), 2.25);
  EXPECT_TRUE(fs::exists(snapshots / series.at("files").at(1).at("name").get<std::string>()));
}

TEST(Frames, AreOneForEachSnapshot) {
  const Folder folder;
  const std::vector<Snapshot> snapshots{synthetic::snapshot("enters", 0.2), synthetic::snapshot("halfway", 0.1)};
  EXPECT_EQ(draw_frames(synthetic::scene(0.1), snapshots, folder.path()), 2U);
  EXPECT_TRUE(fs::exists(folder.path() / "frame_0000.png"));
  EXPECT_TRUE(fs::exists(folder.path() / "frame_0001.png"));
}

}  // namespace
}  // namespace slfb
