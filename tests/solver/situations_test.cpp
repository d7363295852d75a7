// Inputs of users that once ended in a crash, a wrong number or silence, each with the right value.
#include <gtest/gtest.h>
#include <signal.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>

#include "solver/laws/scene_file.hpp"
#include "solver/laws/scene_remarks.hpp"
#include "solver/run/bed_recorder.hpp"
#include "solver/run/simulation.hpp"
#include "solver/support/child_process.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

/// Some glass spheres of 5 mm in a small periodic box of water.
const std::string box = R"([geometry]
shape = "box"
width = ["25 mm", "25 mm"]
height = "0.15 m"
[liquid]
density = "998.2 kg/m3"
viscosity = "1.0 mPa s"
superficial_velocity = "0.05 m/s"
[fluid]
tier = "one-dimensional"
wall = "periodic"
cell_height = "6.25 mm"
time_step = "1 ms"
[contact]
stiffness = "1e3 N/m"
time_step = "0.1 ms"
[[species]]
name = "glass"
diameter = "5 mm"
density = "2230 kg/m3"
count = 20
[[stage]]
kind = "settle"
duration = "20 ms"
[[stage]]
kind = "fluidise"
duration = "20 ms"
)";

/// One sphere that falls in a quiescent tube.
std::string tube(const std::string& diameter, const std::string& liquid, const std::string& sphere) {
  return "[geometry]\nshape = \"cylinder\"\nheight = \"0.3 m\"\ndiameter = \"" + diameter + "\"\n[liquid]\n" + liquid +
         "superficial_velocity = 0\n[fluid]\ntier = \"quiescent\"\n[contact]\nstiffness = \"10 N/m\"\n"
         "time_step = \"0.2 ms\"\n[[species]]\nname = \"one\"\n" +
         sphere +
         "[[stage]]\nkind = \"drop\"\nspecies = \"one\"\nrelease_height = \"0.25 m\"\nduration = \"60 s\"\n"
         "[recording]\ndrop_interval = \"1 ms\"\n";
}
const std::string water = "density = 998.2\nviscosity = \"1.0 cP\"\n";

std::string refusal(const std::string& text, const Overrides& overrides = {}) {
  try {
    parse_scene(text, "scene.toml", overrides);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "valid";
}

void expect_refused(const std::string& text, const Overrides& overrides, const std::string& part) {
  const std::string message = refusal(text, overrides);
  EXPECT_NE(message.find(part), std::string::npos) << message;
}

/// What a piece of the program logs.
std::string logged(const std::function<void()>& work) {
  std::ostringstream text;
  const auto before = spdlog::default_logger();
  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text)));
  work();
  spdlog::set_default_logger(before);
  return text.str();
}

class Situations : public testing::Test {
 protected:
  RunResult run(const Scene& scene) { return run_scene(scene, {.directory = folder_.path()}).result; }
  /// Files of snapshots, without those that list them.
  [[nodiscard]] std::ptrdiff_t snapshots() const {
    return std::count_if(fs::directory_iterator(folder_.path() / "snapshots"), {},
                         [](const auto& entry) { return entry.path().extension() == ".hdf"; });
  }
  Folder folder_;
};

TEST_F(Situations, ABedThatTheLiquidAnswersTooLateIsToldSo) {
  const Overrides packed{"fluid.tier=three-dimensional", "fluid.cells_across=4",    "species[0].count=120",
                         "stage[0].duration=0.3 s",      "stage[1].duration=50 ms", "fluid.time_step=0.1 ms"};
  Overrides second = packed, rare = packed;
  second.emplace_back("fluid.time_scheme=second-order");
  rare.emplace_back("coupling.void_fraction_interval=2 ms");
  const auto failure = [&](const Overrides& overrides) -> std::string {
    try {
      (void)run(parse_scene(box, "scene.toml", overrides));
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "finished";
  };
  EXPECT_EQ(failure(packed), "finished");
  // Four and nearly three times the ratio of solids to liquid, 1.5.
  const std::string of_second = failure(second), of_rare = failure(rare);
  EXPECT_NE(of_second.find("one step late"), std::string::npos) << of_second;
  EXPECT_NE(of_second.find("6 times the liquid's density with fluid.time_scheme"), std::string::npos) << of_second;
  EXPECT_NE(of_rare.find("4.35 times the liquid's density with coupling.void_fraction_interval = 0.002 s"),
            std::string::npos)
      << of_rare;
}

TEST_F(Situations, TimesAreWholeLiquidStepsOrRefused) {
  EXPECT_EQ(refusal(box), "valid");
  expect_refused(box, {"recording.snapshot_interval=0.2 ms"}, "recording.snapshot_interval");
  expect_refused(box, {"recording.snapshot_interval=0.49999 ms"}, "0.001 s or more");
  expect_refused(box, {"contact.time_step=1e-8", "fluid.time_step=1e-7", "recording.snapshot_interval=1e-7"},
                 "named by microseconds");
  expect_refused(box, {"recording.drop_interval=1.5 ms"}, "is 1.5 liquid steps");
  expect_refused(box, {"stage[0].duration=0.4 ms"}, "stage[0].duration");
  expect_refused(box, {"stage[0].duration=100 ms", "stage[1].duration=0.12 s", "fluid.time_step=30 ms"},
                 "such as 0.09 s or 0.12 s");
  // Sampled at the default intervals, a bed takes the next whole steps and says so.
  const Scene scene = parse_scene(box, "scene.toml", {"fluid.time_step=4 ms"});
  const auto remarks = remarks_on(scene);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_EQ(remarks[0], "recording.bed_interval = 0.01 s is 2.5 liquid steps of 0.004 s: 0.012 s is taken");
}

TEST_F(Situations, EachStageTakesItsTime) {
  EXPECT_NEAR(run(parse_scene(box, "scene.toml", {"stage[0].duration=0.1", "stage[1].duration=0.1"})).simulated_seconds,
              0.2, 1e-9);
}

TEST_F(Situations, ASnapshotInEachLiquidStepHasItsOwnFile) {
  run(parse_scene(box, "scene.toml", {"recording.snapshot_interval=1 ms"}));
  EXPECT_EQ(snapshots(), 2 * 20);
}

TEST_F(Situations, SnapshotsCloserThanAMillisecondKeepTheirOwnFiles) {
  const Scene scene = parse_scene(tube("50 mm", water, "diameter = 0.005\ndensity = 2230\n"), "scene.toml",
                                  {"contact.time_step=0.1 ms", "recording.snapshot_interval=0.2 ms",
                                   "recording.drop_interval=0.2 ms", "stage[0].duration=10 ms"});
  run(scene);
  EXPECT_EQ(snapshots(), 50);
}

TEST_F(Situations, AThousandSizesAreSavedAndReadBack) {
  Scene scene = parse_scene(box, "scene.toml");
  scene.species.clear();
  for (int k = 0; k < 1200; ++k)
    scene.species.push_back({"glass-" + std::to_string(k), 0.001 + 1e-7 * k, 2230.0, k % 100 == 0 ? 1 : 0});
  scene.species.back().count = 1;
  RunResult result;
  result.scene_text = canonical_toml(scene);
  ASSERT_GT(result.scene_text.size(), 65'536U);
  save_result(result, folder_.path() / "result.h5");
  EXPECT_EQ(load_result(folder_.path() / "result.h5").scene_text, result.scene_text);
}

// A cube with sides below d/√3 fits into a sphere of diameter d: 2.887 mm for 5 mm.
TEST_F(Situations, CellsThatFitIntoASphereAreRefused) {
  const auto cubes = [](const std::string& side, const std::string& width) {
    return Overrides{"fluid.tier=three-dimensional", "fluid.cells_across=9", "fluid.cell_height=" + side,
                     "geometry.width=[\"" + width + "\", \"" + width + "\"]", "geometry.height=0.1"};
  };
  for (const auto& [side, width] :
       {std::pair{"2.5 mm", "22.5 mm"}, std::pair{"2.75 mm", "24.75 mm"}, std::pair{"2.85 mm", "25.65 mm"}})
    expect_refused(box, cubes(side, width), "such as cubes with sides of 0.002887 m");
  EXPECT_EQ(refusal(box, cubes("3 mm", "27 mm")), "valid");
  // In pieces each goes into one cell as a whole: one piece is the sphere.
  Overrides coarse = cubes("4 mm", "36 mm");
  coarse.insert(coarse.end(), {"coupling.void_fraction=particle-meshing", "coupling.meshing_pieces=1"});
  expect_refused(box, coarse, "cut into 1 pieces");
  coarse.back() = "coupling.meshing_pieces=1214";
  EXPECT_EQ(refusal(box, coarse), "valid");
  // The largest sphere counts, also where it is only dropped.
  expect_refused(box +
                     "[[species]]\nname = \"steel\"\ndiameter = \"6 mm\"\ndensity = 7800\n[[stage]]\nkind = \"drop\"\n"
                     "species = \"steel\"\nrelease_height = \"0.09 m\"\nduration = \"1 s\"\n",
                 cubes("3 mm", "27 mm"), "the largest sphere (0.006 m)");
  // A box whose depth is no multiple of the width's cells has other cells in y.
  Overrides flat = cubes("3 mm", "27 mm");
  flat[3] = R"(geometry.width=["27 mm", "13.4 mm"])";
  EXPECT_EQ(refusal(box, flat), "valid");
  flat[3] = R"(geometry.width=["27 mm", "11 mm"])";
  flat[2] = "fluid.cell_height=2.6 mm";
  expect_refused(box, flat, "can lie wholly inside");
}

// Published: 22.738 s for 0.1 m in a tube 40 times as wide as the sphere, 21.57 s without the wall.
TEST_F(Situations, AFallingBallIsSlowedByTheWall) {
  const std::string text =
      tube("20 mm", "density = 950\nviscosity = \"0.2 Pa s\"\n", "diameter = \"0.5 mm\"\ndensity = 7800\n");
  const auto seconds = [&](const std::string& law) {
    const Scene scene = parse_scene(text, "scene.toml",
                                    {"coupling.drag_law=wen-yu-1966", "coupling.wall_retardation=" + law,
                                     "recording.drop_interval=10 ms", "stage[0].duration=30 s"});
    const Folder folder;
    const DropSeries drop = run_scene(scene, {.directory = folder.path()}).result.drops.at(0);
    const auto passes = [&](double height) {
      std::size_t i = 0;
      while (drop.z.at(i) > height) ++i;
      const double part = (drop.z[i - 1] - height) / (drop.z[i - 1] - drop.z[i]);
      return drop.time[i - 1] + part * (drop.time[i] - drop.time[i - 1]);
    };
    return passes(0.14) - passes(0.24);
  };
  EXPECT_NEAR(seconds("haberman-sayre-1958"), 22.738, 0.003 * 22.738);
  EXPECT_NEAR(seconds("none"), 21.574, 0.001 * 21.574);
  // The name of a run without the key is what it was.
  EXPECT_EQ(scene_hash(parse_scene(text, "scene.toml")),
            scene_hash(parse_scene(text, "scene.toml", {"coupling.wall_retardation=none"})));
  expect_refused(text, {"coupling.wall_retardation=faxen"}, "haberman-sayre-1958");
  expect_refused(box, {"fluid.tier=quiescent", "coupling.wall_retardation=munroe-1888"}, "shape = \"cylinder\"");
}

TEST_F(Situations, ALawOutsideItsRangeIsSaidBeforeAndAfterTheRun) {
  const std::string text = tube("50 mm", water, "diameter = \"6 mm\"\ndensity = 7800\n");
  const Scene ergun = parse_scene(text, "scene.toml", {"coupling.drag_law=ergun-1952", "stage[0].duration=50 ms"});
  const auto before = remarks_on(ergun);
  ASSERT_FALSE(before.empty());
  EXPECT_NE(before[0].find("ergun-1952 is meant for voidages"), std::string::npos) << before[0];
  const std::string after = logged([&] { run(ergun); });
  EXPECT_NE(after.find("ergun-1952 was asked outside its range"), std::string::npos) << after;
  EXPECT_NE(after.find("in 100 % of"), std::string::npos) << after;
  // A law for one sphere is at home there: 1.06 to 1.10 m/s by the laws of the literature.
  const Scene single = parse_scene(text, "scene.toml", {"coupling.drag_law=wen-yu-1966"});
  EXPECT_TRUE(remarks_on(single).empty());
  const Folder folder;
  const DropSeries drop = run_scene(single, {.directory = folder.path()}).result.drops.at(0);
  EXPECT_GT(-drop.velocity_z.at(drop.velocity_z.size() / 2), 0.9);
}

// A sphere that is let go has Re = 0 in its first step, below what Di Felice's law is made for: that moves nothing.
TEST_F(Situations, ALawThatIsHardlyEverOutsideItsRangeIsNoWarning) {
  const std::string text =
      tube("50 mm", "density = 998.2\nviscosity = \"30 cP\"\n", "diameter = \"0.5 mm\"\ndensity = 2230\n");
  const auto said = [&](const std::string& duration) {
    const Scene scene =
        parse_scene(text, "scene.toml",
                    {"coupling.drag_law=di-felice-1994", "contact.time_step=0.1 ms", "fluid.time_step=0.1 ms",
                     "recording.bed_interval=0.1 ms", "stage[0].duration=" + duration});
    const Folder folder;
    return logged([&] { run_scene(scene, {.directory = folder.path()}); });
  };
  const std::string whole = said("0.5 s");
  EXPECT_NE(whole.find("[info] "), std::string::npos) << whole;
  EXPECT_NE(whole.find("was asked outside its range"), std::string::npos) << whole;
  EXPECT_EQ(whole.find("[warning] "), std::string::npos) << whole;
  // Of 200 steps one is enough to be told.
  const std::string start = said("20 ms");
  EXPECT_NE(start.find("[warning] run "), std::string::npos) << start;
}

// One sphere among many has a small share of all samples; it is the one that is measured. Alone above the bed it has a
// voidage of 1 and not of some rounding more, where Tang's law would take the root of a negative number.
TEST_F(Situations, ALawsRangeIsJudgedForEachSpecies) {
  const std::string text = box +
                           "[[species]]\nname = \"steel\"\ndiameter = \"6 mm\"\ndensity = 7800\n[[stage]]\n"
                           "kind = \"drop\"\nspecies = \"steel\"\nrelease_height = \"0.14 m\"\nduration = \"0.1 s\"\n";
  const std::string said = logged([&] {
    run(parse_scene(text, "scene.toml", {"coupling.drag_law=gidaspow-1994", "recording.bed_interval=1 ms"}));
  });
  EXPECT_EQ(said.find("outside its range"), std::string::npos) << said;
  const std::string outside = logged([&] {
    const Folder folder;
    run_scene(parse_scene(text, "scene.toml", {"coupling.drag_law=tang-2015", "recording.bed_interval=1 ms"}),
              {.directory = folder.path()});
  });
  EXPECT_NE(outside.find("samples of steel"), std::string::npos) << outside;
}

TEST_F(Situations, AViscosityInCentipoise) {
  EXPECT_DOUBLE_EQ(parse_scene(box, "scene.toml", {"liquid.viscosity=1.8 cP"}).liquid.viscosity, 1.8e-3);
}

// The forces are compared with the weight of what the spheres displace, which is nothing here.
TEST_F(Situations, SpheresAsHeavyAsTheLiquidGiveAResultThatCanBeRead) {
  const RunResult floating = run(parse_scene(box, "scene.toml", {"species[0].density=998.2 kg/m3"}));
  ASSERT_FALSE(floating.bed.balance_residual.empty());
  for (const double residual : floating.bed.balance_residual) EXPECT_LT(residual, 1e-6);
  save_result(floating, folder_.path() / "result.h5");
  EXPECT_EQ(load_result(folder_.path() / "result.h5").bed.time, floating.bed.time);
}

TEST_F(Situations, ARunTooShortForASampleIsToldBefore) {
  const auto said = remarks_on(parse_scene(box, "scene.toml", {"recording.bed_interval=1 hour"}));
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("recording.bed_interval = 3600 s is longer than"), std::string::npos) << said[0];
}

TEST_F(Situations, ASizeDistributionIsOneTable) {
  const std::string table = box.substr(0, box.find("[[species]]")) +
                            "[[species]]\nname = \"glass\"\ndensity = 2230\ndiameters = [\"4 mm\", \"5 mm\"]\n";
  const std::string stages = box.substr(box.find("[[stage]]"));
  const auto with = [&](const std::string& lines) { return table + lines + stages; };
  const Scene counted = parse_scene(with("counts = [10, 5]\n"), "scene.toml");
  ASSERT_EQ(counted.species.size(), 2U);
  EXPECT_EQ(counted.species[0].name, "glass-1");
  EXPECT_DOUBLE_EQ(counted.species[1].diameter, 0.005);
  EXPECT_EQ(counted.species[1].count, 5);
  const double small = counted.species[0].mass(), large = counted.species[1].mass();
  const Scene weighed = parse_scene(
      with("total_mass = " + std::to_string(20.0 * small) + "\nmass_fractions = [0.5, 0.5]\n"), "scene.toml");
  EXPECT_EQ(weighed.species[0].count, 10);
  EXPECT_EQ(weighed.species[1].count, static_cast<std::int64_t>(10.0 * small / large));
  EXPECT_EQ(scene_hash(parse_scene(canonical_toml(counted), "canonical")), scene_hash(counted));
  for (const auto& [lines, part] : {std::pair{"counts = [10]\n", "has 1 values for 2 diameters"},
                                    std::pair{"total_mass = 1\nmass_fractions = [0.5, 0.6]\n", "add up to 1.1"},
                                    std::pair{"counts = [10, 5]\ncount = 3\n", "count"},
                                    std::pair{"counts = [10, 5]\ntotal_mass = 1\n", "total_mass"},
                                    std::pair{"mass_fractions = [0.5, 0.5]\n", "total_mass"}, std::pair{"", "counts"}})
    expect_refused(with(lines), {}, part);
}

TEST_F(Situations, AFullDiskIsSaidWithTheFirstFileAndTheRunGoesOnLater) {
  Scene scene = parse_scene(box, "scene.toml");
  const RunResult expected = [&] {
    const Folder elsewhere;
    return run_scene(scene, {.directory = elsewhere.path()}).result;
  }();
  scene.recording.checkpoint_interval = 1e-9;  // after each step
  const auto on_a_full_disk = [&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};  // no file grows beyond these bytes
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      run(scene);
    } catch (const std::runtime_error& error) {
      const std::string message = error.what();
      if (message.find("File too large") == message.npos || message.find("records_") == message.npos) std::abort();
      return;
    }
    std::abort();  // finished
  };
  EXPECT_EQ(trouble_in_child(on_a_full_disk, 60), std::nullopt);
  EXPECT_EQ(run(scene).bed.pressure_drop, expected.bed.pressure_drop);
}

TEST_F(Situations, AFolderThatVanishesIsNoticed) {
  Scene scene = parse_scene(box, "scene.toml");
  scene.recording.checkpoint_interval = 1e-9;
  const Folder other;
  const fs::path directory = other.path() / "run";
  try {
    run_scene(scene, {.directory = directory,
                      .progress = [&](const Progress&) { fs::remove_all(directory); },
                      .progress_interval = 0.0});
    FAIL() << "the run went on";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("has vanished"), std::string::npos) << error.what();
  }
}

TEST_F(Situations, ABedThatStandsStillInAFastLiquidIsTold) {
  Scene scene = parse_scene(box, "scene.toml", {"liquid.superficial_velocity=0.08"});  // U_mf is 0.042 m/s
  RunResult result;
  result.packed_voidage = 0.4;
  result.bed.time = {0.0, 0.01};
  result.bed.fluctuating_energy = {1e-4, 1e-12};
  const std::string still = logged([&] { simulation::BedRecorder(scene, result).look_for_standing_bed(); });
  EXPECT_NE(still.find("stands still"), std::string::npos) << still;
  result.bed.fluctuating_energy = {1e-4, 1e-4};
  EXPECT_EQ(logged([&] { simulation::BedRecorder(scene, result).look_for_standing_bed(); }), "");
  scene.liquid.superficial_velocity = 0.03;
  result.bed.fluctuating_energy = {1e-12, 1e-12};
  EXPECT_EQ(logged([&] { simulation::BedRecorder(scene, result).look_for_standing_bed(); }), "");
}

}  // namespace
}  // namespace slfb
