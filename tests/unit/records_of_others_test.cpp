// Raw records of an experiment or another code, reduced as our own runs are.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "experiments/claims/measured_file.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/sphere_frames.hpp"
#include "experiments/work/measured_systems.hpp"
#include "solver/support/files.hpp"
#include "solver/support/folders.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

constexpr int bed_count = 3600;         // of 6in5W
constexpr double bed_diameter = 0.005;  // [m]
constexpr double column_area = std::numbers::pi / 4.0 * 0.05 * 0.05;

const std::string head = "[[series]]\nsystem = \"6in5W\"\nsuperficial_velocity = \"10 cm/s\"\n";

class RecordsOfOthersTest : public testing::Test {
 protected:
  Measurements load(const std::string& text) {
    const auto file = folder_.path() / "mine.toml";
    write_file(file, text);
    return load_measured(file, claims_, systems_);
  }
  Measurement measured(const std::string& text, const std::string& key) {
    const Measurements all = load(text);
    const auto found = all.find(parse_measure_key(key));
    EXPECT_NE(found, all.end()) << key;
    return found == all.end() ? Measurement{} : found->second;
  }
  std::string complaint(const std::string& text) {
    try {
      load(text);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }
  void write(const std::string& name, const std::string& text) { write_file(folder_.path() / name, text); }

  /// z(t) of a sphere that falls evenly from 0.5 m, in mm and ms.
  void write_fall(const std::string& name, double speed) {
    std::string text = "# a fall\ntime [ms],z [mm]\n";
    for (int k = 0; k <= 1000; ++k) {
      const double time = 0.01 * k, z = std::max(0.5 - speed * time, 0.003);
      text += fmt::format("{},{}\n", 1e3 * (time + 7.0), 1e3 * z);
    }
    write(name, text);
  }

  Work work_ = peng_2014_work();
  std::vector<Claim> claims_ = load_claims();
  MeasuredSystems systems_ = measured_systems(work_);
  Folder folder_;
};

/// Three samples have Student's t of 4.303 at 95 %: 4.303 · 0.01/√3 m/s about 0.20 m/s.
TEST_F(RecordsOfOthersTest, SlopeOfEachFallIsASample) {
  write_fall("a.csv", 0.19);
  write_fall("b.csv", 0.20);
  write_fall("c.csv", 0.21);
  const Measurement velocity =
      measured(head + "drops = [\"a.csv\", \"b.csv\", \"c.csv\"]\n", "classification_velocity/6in5W/0.10");
  EXPECT_NEAR(velocity.value, 0.20, 1e-9);
  EXPECT_NEAR(velocity.half_width, 4.3027 * 0.01 / std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(velocity.scatter, 0.01, 1e-9);
}

TEST_F(RecordsOfOthersTest, OneFallHasNoInterval) {
  write_fall("a.csv", 0.2);
  EXPECT_FALSE(measured(head + "drops = \"a.csv\"\n", "classification_velocity/6in5W/0.10").has_interval());
}

/// A constant with a start-up that dies away and white noise: the mean is that constant, its interval 1.96 σ/√n.
TEST_F(RecordsOfOthersTest, MeanOfABedLeavesOutItsTransient) {
  std::mt19937 generator(3);
  std::normal_distribution<double> noise(0.0, 0.05);
  std::string text = "time [s],pressure_drop [mbar]\n";
  constexpr int size = 4000;
  for (int k = 0; k < size; ++k)
    text += fmt::format("{},{}\n", 0.01 * k - 1.0,
                        k < 100 ? 50.0 : 14.5 + 3.0 * std::exp(-0.05 * (k - 100)) + noise(generator));
  write("bed.csv", text);
  const Measurement pressure = measured(head + "bed = \"bed.csv\"\n", "pressure_drop/6in5W/0.10");
  const double expected = 1.96 * 5.0 / std::sqrt(size - 100.0);  // [Pa]
  EXPECT_NEAR(pressure.value, 1450.0, 2.0 * expected);
  EXPECT_NEAR(pressure.half_width, expected, 0.25 * expected);
}

/// Spheres evenly over the height H have their centre of mass at H/2: the voidage is 1 − V/(A H).
std::string dump_of(double height, int frames, const std::string& columns, double unit, double dropped_from = -1.0) {
  std::string text;
  for (int frame = 0; frame < frames; ++frame) {
    const bool dropped = dropped_from >= 0.0;
    text += fmt::format(
        "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n0 1\nITEM: ATOMS id "
        "type "
        "x y z{}\n",
        1000 * frame, bed_count + (dropped ? 1 : 0), columns);
    for (int i = 0; i < bed_count; ++i) {
      const double z = height * (i + 0.5) / bed_count;
      text += fmt::format("{} 1 0 0 {:.17g}", i + 1, z / unit);
      if (columns == " vx vy vz radius") text += fmt::format(" 0 0 {} {}", i % 2 == 0 ? 0.1 : -0.1, 0.0025 / unit);
      text += '\n';
    }
    if (dropped) text += fmt::format("{} 2 0 0 {:.17g}\n", bed_count + 1, (dropped_from - 0.02 * frame) / unit);
  }
  return text;
}

/// The scene of the work with 400 spheres.
std::string replaced_count() {
  std::string text = read_file(source_folder() / "experiments/peng_2014/scenes/6in5W.toml");
  const auto begin = text.find("total_mass = "), end = text.find('\n', begin);
  return text.replace(begin, end - begin, "count = 400");
}

double voidage_at(double height) {
  return 1.0 - bed_count * std::numbers::pi / 6.0 * std::pow(bed_diameter, 3) / (column_area * height);
}

TEST_F(RecordsOfOthersTest, SpheresOfADumpMakeTheVoidage) {
  write("bed.dump", dump_of(0.27, 12, "", 1e-3));
  EXPECT_NEAR(measured(head + "positions = \"bed.dump\"\nlength_unit = \"mm\"\ntime_step = \"0.01 ms\"\n",
                       "voidage_centre_of_mass/6in5W/0.10")
                  .value,
              voidage_at(0.27), 1e-9);
}

/// Of a packing one sample is one bed, however long it is looked at: two of them have an interval.
TEST_F(RecordsOfOthersTest, SettledBedsAreSamplesOfThePackedVoidage) {
  write("a.dump", dump_of(0.30, 1, "", 1.0) + dump_of(0.21, 2, "", 1.0).substr(dump_of(0.21, 1, "", 1.0).size()));
  write("b.dump", dump_of(0.22, 1, "", 1.0));
  const std::string of_packed = "[[series]]\nsystem = \"6in5W\"\nsuperficial_velocity = \"0.03 m/s\"\n";
  const Measurement voidage = measured(of_packed + "settled = \"a.dump\"\n" + of_packed + "settled = \"b.dump\"\n",
                                       "packed_voidage/6in5W/0.03");
  EXPECT_NEAR(voidage.value, 0.5 * (voidage_at(0.21) + voidage_at(0.22)), 1e-9) << "of the last frames";
  EXPECT_TRUE(voidage.has_interval());
}

TEST_F(RecordsOfOthersTest, ADroppedSphereOfADumpIsADrop) {
  // 0.02 m in 1000 steps of 0.1 ms: 0.2 m/s, and the bed is not disturbed by it, for its centre of mass is its own.
  write("bed.dump", dump_of(0.27, 30, "", 1.0, 0.5));
  const Measurement velocity = measured(head + "positions = \"bed.dump\"\ntime_step = \"0.1 ms\"\ndropped_type = 2\n",
                                        "classification_velocity/6in5W/0.10");
  EXPECT_NEAR(velocity.value, 0.2, 1e-9);
}

/// Half of the spheres at +v, half at −v: q_p² = ½ v² n/(n − 1).
TEST_F(RecordsOfOthersTest, VelocitiesOfADumpMakeTheFluctuatingEnergy) {
  write("bed.dump", dump_of(0.27, 2, " vx vy vz radius", 1.0));
  RecordsOfOthers records;
  records.spec.system = "6in5W";
  records.spec.superficial_velocity = 0.10;
  records.scene = systems_.scene_of("6in5W");
  records.positions = folder_.path() / "bed.dump";
  records.dump.time_step = 1e-4;
  const FinishedRun run = reduce_records(records, 1, systems_.rules);
  ASSERT_TRUE(run.summary);
  EXPECT_NEAR(run.summary->bed.at("fluctuating_energy").mean, 0.5 * 0.01 * bed_count / (bed_count - 1.0), 1e-12);
  EXPECT_FALSE(run.summary->bed.contains("pressure_drop")) << "nobody recorded it";
  EXPECT_FALSE(run.summary->run.contains("expansion")) << "of which settled bed?";
}

TEST_F(RecordsOfOthersTest, PositionsOfACsvAreThoseOfADump) {
  std::string text = "time [s],x [mm],y [mm],z [cm],diameter [mm]\n";
  for (const double time : {0.0, 0.1})
    for (int i = 0; i < bed_count; ++i)
      text += fmt::format("{},0,0,{:.17g},5\n", time, 100.0 * 0.27 * (i + 0.5) / bed_count);
  write("spheres.csv", text);
  EXPECT_NEAR(measured(head + "positions = \"spheres.csv\"\n", "voidage_centre_of_mass/6in5W/0.10").value,
              voidage_at(0.27), 1e-9);
}

TEST_F(RecordsOfOthersTest, ComplainsWithFileLineAndColumn) {
  const auto of_drop = [&](const std::string& csv) {
    write("drop.csv", csv);
    return complaint(head + "drops = \"drop.csv\"\n");
  };
  const auto expect = [](const std::string& said, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) EXPECT_NE(said.find(part), std::string::npos) << said;
  };
  expect(of_drop("time [s],height [m]\n0,1\n"), {"drop.csv:1: ", "unknown column \"height\"", "z [m]"});
  expect(of_drop("time [s],z\n0,1\n"), {"drop.csv:1: column z: has no unit"});
  expect(of_drop("time [s],z [s]\n0,1\n"), {"drop.csv:1: column z: the unit \"s\""});
  expect(of_drop("time [s]\n0\n"), {"drop.csv:1: has no column z"});
  expect(of_drop("time [s],z [m]\n# nothing\n0,high\n"), {"drop.csv:3: column z: \"high\" is no finite number"});
  expect(of_drop("time [s],z [m]\n0,1\n0,1\n"), {"drop.csv:3: column time: does not rise"});
  expect(of_drop("\xEF\xBB\xBFtime [s],z\r\n0,1\r\n"), {"drop.csv:1: column z: has no unit"});
  expect(of_drop("time [s],z [m]\n"), {"drop.csv:1: has no line of numbers"});
  expect(of_drop("time [s];z [m]\n0;0,5\n"), {"drop.csv:1: \"time [s];z [m]\"", "needed are commas"});
  expect(of_drop(std::string(100, '\0')), {"drop.csv: is no text"});
  expect(of_drop("time [s],z [m]\n0,0.5\n"), {"drop.csv:2: is the only line of numbers"});
  expect(of_drop("time [s],z [m]\n0,0.5\n1,400\n"), {"drop.csv:3: column z: 400 m lies outside the column"});
  expect(complaint(head + "drops = \"none.csv\"\n"), {"mine.toml:4: drops: there is no file"});
  std::filesystem::create_symlink("circle.csv", folder_.path() / "circle.csv");
  expect(complaint(head + "drops = \"circle.csv\"\n"), {"mine.toml:4: drops: there is no file"});
  write_fall("fall.csv", 0.2);
  std::filesystem::create_symlink("fall.csv", folder_.path() / "same.csv");
  expect(complaint(head + "drops = [\"fall.csv\", \"same.csv\"]\n"), {"mine.toml:2: ", "same.csv is named twice"});
  write("few.toml", replaced_count());
  expect(complaint(head + "drops = \"fall.csv\"\n" + head + "drops = \"fall.csv\"\nscene = \"few.toml\"\n"),
         {"mine.toml:9: scene: ", "no samples of one number"});
  expect(complaint(head), {"mine.toml:2: system: has no file"});
  expect(complaint("[[series]]\nsystem = \"7in5W\"\nsuperficial_velocity = \"1 m/s\"\n"),
         {"mine.toml:2: system: ", "6in5W"});
  expect(complaint(head + "drop = \"none.csv\"\n"), {"mine.toml:"});
  write("bed.dump", dump_of(0.27, 1, "", 1.0));
  expect(complaint(head + "positions = \"bed.dump\"\n"), {"bed.dump: ", "time_step"});
  write("bed.dump", dump_of(0.27, 1, " vx vy vz radius", 1.0));
  expect(complaint(head + "positions = \"bed.dump\"\ntime_step = \"1 ms\"\nlength_unit = \"mm\"\n"),
         {"bed.dump: ", "length_unit"});
  write("bed.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id xs ys zs\n1 0 0 0\n");
  expect(complaint(head + "positions = \"bed.dump\"\ntime_step = \"1 ms\"\n"), {"bed.dump:5: ", "xs ys zs", "x y z"});
  write("bed.dump", "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id x y z\n1 0 0 0\n");
  expect(complaint(head + "positions = \"bed.dump\"\ntime_step = \"1 ms\"\n"), {"bed.dump:6: ", "1 of 2 atoms"});
}

TEST_F(RecordsOfOthersTest, AValueMayNotStandBesideItsSeries) {
  write_fall("a.csv", 0.2);
  const std::string said = complaint(head +
                                     "drops = \"a.csv\"\n[[measured]]\nmeasure = "
                                     "\"classification_velocity/6in5W/0.10\"\nvalue = 0.2\nunit = \"m/s\"\n");
  EXPECT_NE(said.find("[[series]] gives it too"), std::string::npos) << said;
}

}  // namespace
}  // namespace slfb
