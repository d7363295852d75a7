#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/io/hdf5_file.hpp"
#include "solver/io/run_result.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/support/folders.hpp"
#include "tests/hostile_hdf5.hpp"
#include "tests/unit/synthetic_runs.hpp"

namespace slfb {
namespace {

class RunResultTest : public ::testing::Test {
 protected:
  RunResultTest()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                (std::string("slfb_result_") + ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::remove_all(folder_);
  }
  ~RunResultTest() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "runs" / "result.h5"; }

 private:
  std::filesystem::path folder_;
};

std::vector<double> random_values(std::size_t count) {
  static std::mt19937 generator(7);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::vector<double> values(count);
  for (double& value : values) value = normal(generator);
  return values;
}

/// Every field different from its default and from the others.
RunResult example() {
  RunResult result;
  const Scene scene = synthetic::scene(0.06);
  result.name = scene_hash(scene);
  result.scene_text = canonical_toml(scene);
  result.numerics = 17;
  result.suite_version = "1.2.3";
  result.commit = "0123456789ab";
  result.machine = "a machine, 2 cores";
  result.date = "2024-05-06T07:08:09Z";
  result.threads = 3;
  result.wall_seconds = 12.5;
  result.cpu_seconds = 24.25;
  result.simulated_seconds = 0.1 + 0.2;
  result.particle_steps = 123'456'789'012;
  result.particles_removed = 4;
  result.packed_voidage = 0.1 * 4.1;
  result.packed_height = 0.2;
  BedSeries& bed = result.bed;
  for (auto* values : {&bed.time, &bed.pressure_drop, &bed.centre_of_mass_height, &bed.bed_top, &bed.fluctuating_energy,
                       &bed.contacts_per_particle, &bed.local_fluctuating_energy, &bed.cumulative_contacts,
                       &bed.contact_force_bed, &bed.contact_force_foreign, &bed.contact_force_wall, &bed.network_step,
                       &bed.maximum_overlap, &bed.foreign_present, &bed.superficial_velocity}) {
    *values = random_values(700);
  }
  for_each_column(bed, [](std::vector<double>& column) {
    if (column.empty()) column = random_values(700);
  });
  std::ranges::sort(bed.time);
  for (const std::size_t length : {40U, 2000U}) {
    DropSeries& drop = result.drops.emplace_back();
    drop.release_time = 0.3 * static_cast<double>(length);
    drop.bottom_time = 0.7 * static_cast<double>(length);
    drop.species = "steel " + std::to_string(length);
    for (auto* values :
         {&drop.time, &drop.x, &drop.y, &drop.z, &drop.velocity_x, &drop.velocity_y, &drop.velocity_z,
          &drop.angular_speed, &drop.voidage, &drop.liquid_velocity_z, &drop.reynolds, &drop.contact_force,
          &drop.contact_force_mean_x, &drop.contact_force_mean_y, &drop.contact_force_mean_z, &drop.drag_force_z,
          &drop.pressure_force_z, &drop.contacts, &drop.cumulative_contacts}) {
      *values = random_values(length);
    }
    std::ranges::sort(drop.time);
  }
  result.plane.time = 3.3;
  result.plane.x = random_values(8);
  result.plane.z = random_values(96);
  result.plane.voidage = random_values(8 * 96);
  result.plane.velocity_x = random_values(8 * 96);
  result.plane.velocity_z = random_values(8 * 96);
  result.snapshots.push_back(
      {"release", 0.5, 2, random_values(3), random_values(3), random_values(3), random_values(3)});
  return result;
}

void expect_single_precision(const std::vector<double>& ours, const std::vector<double>& theirs) {
  ASSERT_EQ(ours.size(), theirs.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    if (std::isnan(ours[i])) {
      EXPECT_TRUE(std::isnan(theirs[i]));
    } else {
      EXPECT_NEAR(ours[i], theirs[i], 6e-8 * std::abs(ours[i])) << "at " << i;
    }
  }
}

TEST_F(RunResultTest, EveryFieldComesBack) {
  const RunResult written = example();
  save_result(written, file());
  const RunResult read = load_result(file());
  EXPECT_EQ(read.name, written.name);
  EXPECT_EQ(read.scene_text, written.scene_text);
  EXPECT_EQ(read.numerics, written.numerics);
  EXPECT_EQ(read.suite_version, written.suite_version);
  EXPECT_EQ(read.commit, written.commit);
  EXPECT_EQ(read.machine, written.machine);
  EXPECT_EQ(read.date, written.date);
  EXPECT_EQ(read.threads, written.threads);
  EXPECT_EQ(read.wall_seconds, written.wall_seconds);
  EXPECT_EQ(read.cpu_seconds, written.cpu_seconds);
  EXPECT_EQ(read.simulated_seconds, written.simulated_seconds);
  EXPECT_EQ(read.particle_steps, written.particle_steps);
  EXPECT_EQ(read.particles_removed, written.particles_removed);
  EXPECT_EQ(read.packed_voidage, written.packed_voidage);
  EXPECT_EQ(read.packed_height, written.packed_height);

  EXPECT_EQ(read.bed.time, written.bed.time);
  for (auto member :
       {&BedSeries::pressure_drop, &BedSeries::centre_of_mass_height, &BedSeries::bed_top,
        &BedSeries::fluctuating_energy, &BedSeries::contacts_per_particle, &BedSeries::local_fluctuating_energy,
        &BedSeries::cumulative_contacts, &BedSeries::contact_force_bed, &BedSeries::contact_force_foreign,
        &BedSeries::contact_force_wall, &BedSeries::network_step, &BedSeries::maximum_overlap,
        &BedSeries::foreign_present, &BedSeries::superficial_velocity}) {
    expect_single_precision(written.bed.*member, read.bed.*member);
  }
  ASSERT_EQ(read.drops.size(), written.drops.size());
  for (std::size_t i = 0; i < read.drops.size(); ++i) {
    const DropSeries &ours = written.drops[i], &theirs = read.drops[i];
    EXPECT_EQ(theirs.release_time, ours.release_time);
    EXPECT_EQ(theirs.bottom_time, ours.bottom_time);
    EXPECT_EQ(theirs.species, ours.species);
    EXPECT_EQ(theirs.time, ours.time);
    for (auto member :
         {&DropSeries::x, &DropSeries::y, &DropSeries::z, &DropSeries::velocity_x, &DropSeries::velocity_y,
          &DropSeries::velocity_z, &DropSeries::angular_speed, &DropSeries::voidage, &DropSeries::liquid_velocity_z,
          &DropSeries::reynolds, &DropSeries::contact_force, &DropSeries::contact_force_mean_x,
          &DropSeries::contact_force_mean_y, &DropSeries::contact_force_mean_z, &DropSeries::drag_force_z,
          &DropSeries::pressure_force_z, &DropSeries::contacts, &DropSeries::cumulative_contacts}) {
      expect_single_precision(ours.*member, theirs.*member);
    }
  }
  EXPECT_EQ(read.plane.time, written.plane.time);
  EXPECT_EQ(read.plane.x, written.plane.x);
  EXPECT_EQ(read.plane.z, written.plane.z);
  expect_single_precision(written.plane.voidage, read.plane.voidage);
  expect_single_precision(written.plane.velocity_x, read.plane.velocity_x);
  expect_single_precision(written.plane.velocity_z, read.plane.velocity_z);
}

TEST_F(RunResultTest, AnEmptyResultComesBack) {
  save_result({}, file());
  const RunResult read = load_result(file());
  EXPECT_TRUE(read.bed.time.empty());
  EXPECT_TRUE(read.drops.empty());
  EXPECT_TRUE(read.plane.voidage.empty());
  EXPECT_EQ(read.scene_text, "");
}

/// Every data set below `group` has a unit.
void expect_units(const io::Hdf5File& source, const std::string& group) {
  for (const std::string& name : source.children(group)) {
    const std::string path = group + "/" + name;
    bool is_group = true;
    try {
      (void)source.children(path);
    } catch (const std::runtime_error&) {
      is_group = false;
    }
    if (is_group) {
      expect_units(source, path);
    } else {
      EXPECT_TRUE(source.has_attribute(path, "unit")) << path;
      EXPECT_TRUE(source.has_attribute(path, "description")) << path;
    }
  }
}

TEST_F(RunResultTest, EveryDataSetHasAUnitAndTheRootTellsWhereItComesFrom) {
  save_result(example(), file());
  const io::Hdf5File source = io::Hdf5File::open(file());
  for (const char* group : {"bed", "drops", "packed_bed", "plane"}) expect_units(source, group);
  EXPECT_EQ(source.read_string_attribute("bed/pressure_drop", "unit"), "Pa");
  EXPECT_EQ(source.read_string_attribute("drops/0001/contact_force", "unit"), "N");
  EXPECT_EQ(source.read_string_attribute("plane/voidage", "unit"), "1");
  for (const char* name : {"name", "scene", "numerics_version", "suite_version", "commit", "machine", "date", "threads",
                           "wall_seconds", "cpu_seconds", "simulated_seconds", "particle_steps"}) {
    EXPECT_TRUE(source.has_attribute("/", name)) << name;
  }
}

// The list that users are given is that of the file.
TEST_F(RunResultTest, TheListOfDataSetsIsThatOfTheFile) {
  save_result(example(), file());
  const io::Hdf5File source = io::Hdf5File::open(file());
  std::set<std::string> listed;
  for (const ResultDataSet& set : result_data_sets()) {
    listed.insert(set.path);
    if (set.path.starts_with("snapshots") && !source.exists(set.path)) continue;
    ASSERT_TRUE(source.exists(set.path)) << set.path;
    EXPECT_EQ(source.read_string_attribute(set.path, "unit"), set.unit) << set.path;
    EXPECT_EQ(source.read_string_attribute(set.path, "description"), set.description) << set.path;
  }
  for (const std::string& name : source.children("bed")) EXPECT_TRUE(listed.contains("bed/" + name)) << name;
  for (const std::string& name : source.children("drops/0000"))
    EXPECT_TRUE(listed.contains("drops/0000/" + name)) << name;
}

TEST_F(RunResultTest, AFileThatLacksAnItemIsNamedWithIt) {
  io::write_atomically(file(), [](io::Hdf5File& target) { target.write_attribute("/", "name", std::string("x")); });
  try {
    (void)load_result(file());
    FAIL() << "loaded";
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(file().string()), std::string::npos) << message;
    EXPECT_NE(message.find("scene"), std::string::npos) << message;
  }
}

TEST_F(RunResultTest, ASceneOfAnyLengthComesBack) {
  RunResult result = example();
  result.scene_text.assign(200'000, '#');
  save_result(result, file());
  EXPECT_EQ(load_result(file()).scene_text, result.scene_text);
}

TEST_F(RunResultTest, WhatContradictsItselfIsNamed) {
  const auto expect_refused = [&](const std::string& item, const std::function<void(hid_t)>& edit) {
    save_result(example(), file());
    hostile::change(file(), edit);
    try {
      (void)load_result(file());
      ADD_FAILURE() << "loaded with a changed " << item;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find(item), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(file().string()), std::string::npos) << error.what();
    }
  };
  using hostile::fill, hostile::replace;
  for (const char* column : {"bed/centre_of_mass_height", "drops/0001/z", "plane/voidage", "snapshots/0000/radius"}) {
    expect_refused(column, [&](hid_t target) { replace(target, column, {0.1}); });
    expect_refused(column, [&](hid_t target) { replace(target, column, {}); });
    expect_refused(column, [&](hid_t target) { fill(target, column, std::nan("")); });
  }
  expect_refused("liquid_fluctuation", [&](hid_t target) { replace(target, "liquid_fluctuation/rms_x", {0.1}); });
  expect_refused("drops@count",
                 [&](hid_t target) { hostile::set_attribute(target, "drops", "count", 1'000'000'000'000); });
  expect_refused("drops@count", [&](hid_t target) { hostile::set_attribute(target, "drops", "count", -1); });
  expect_refused("foreign",
                 [&](hid_t target) { hostile::set_attribute(target, "snapshots/0000", "foreign", 1'000'000); });
}

TEST_F(RunResultTest, CommittedResultsStayReadable) {
  int read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(source_folder() / "reports" / "published"))
    if (entry.path().extension() == ".h5") {
      EXPECT_NO_THROW((void)load_result(entry.path())) << entry.path();
      ++read;
    }
  EXPECT_GT(read, 100);
}

TEST_F(RunResultTest, NothingIsLeftBesideTheFile) {
  save_result(example(), file());
  save_result(example(), file());
  const auto entries = std::filesystem::directory_iterator(file().parent_path());
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

}  // namespace
}  // namespace slfb
