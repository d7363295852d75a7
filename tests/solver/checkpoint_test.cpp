// A checkpoint goes on only where it fits: its scene, its version, and the names and lengths of its state.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

#include "solver/io/hdf5_file.hpp"
#include "solver/run/checkpoint_files.hpp"
#include "solver/run/model.hpp"
#include "tests/hostile_hdf5.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb::simulation {
namespace {

Scene two_spheres() {
  Scene scene;
  scene.geometry.diameter = 0.03;
  scene.geometry.height = 0.05;
  scene.liquid = {998.2, 1e-3, 0.05};
  scene.fluid.cells_across = 4;
  scene.fluid.cell_height = 0.0075;
  scene.fluid.time_step = 1e-3;
  scene.species = {{"glass", 0.005, 2230, 2}};
  scene.contact.stiffness = 1e3;
  scene.contact.time_step = 1e-4;
  return scene;
}

class CheckpointTest : public testing::Test {
 protected:
  /// Two steps of the scene, then a checkpoint.
  void save(
      const Scene& scene, const std::function<void(io::StateGroup&)>& more = [](io::StateGroup&) {}) {
    Model model(scene, 1);
    model.fill();
    for (int k = 0; k < 2; ++k) model.advance(simulation::Surroundings::liquid);
    files_.save({}, 1, [&](io::StateGroup& state) {
      model.exchange(state);
      more(state);
    });
  }
  /// What going on with a scene fails with.
  std::string failure(const Scene& scene) {
    Model model(scene, 1);
    RunResult result;
    try {
      files_.load(result, [&](io::StateGroup& state) { model.exchange(state); });
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }
  void expect_failure(const Scene& scene, std::initializer_list<const char*> parts) {
    const std::string message = failure(scene);
    for (const std::string part : parts) EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_NE(message.find("remove " + folder_.path().string()), std::string::npos) << message;
  }

  Folder folder_;
  CheckpointFiles files_{folder_.path(), "a scene"};
};

TEST_F(CheckpointTest, TheMotionGoesOnAsIfNothingHadHappened) {
  Scene scene = two_spheres();
  scene.coupling.basset_history = true;
  scene.coupling.added_mass = 0.5;
  Model model(scene, 1);
  model.fill();
  for (int k = 0; k < 20; ++k) model.advance(simulation::Surroundings::liquid);
  files_.save({}, 1, [&](io::StateGroup& state) { model.exchange(state); });
  Model other(scene, 1);
  RunResult result;
  ASSERT_TRUE(files_.load(result, [&](io::StateGroup& state) { other.exchange(state); }));
  for (int k = 0; k < 20; ++k) {
    model.advance(simulation::Surroundings::liquid);
    other.advance(simulation::Surroundings::liquid);
  }
  EXPECT_EQ(model.particles().position.z, other.particles().position.z);
  EXPECT_EQ(model.liquid().pressure(), other.liquid().pressure());
}

TEST_F(CheckpointTest, AMissingNameIsNamed) {
  save(two_spheres());
  Scene scene = two_spheres();
  scene.coupling.basset_history = true;
  expect_failure(scene, {"exchange_", "basset_history"});
}

TEST_F(CheckpointTest, AnUnknownNameIsNamed) {
  Scene scene = two_spheres();
  scene.coupling.basset_history = true;
  save(scene);
  expect_failure(two_spheres(), {"forces_beyond_drag/basset_", "is not a name of this state"});
  double more = 0.0;
  save(two_spheres(), [&](io::StateGroup& state) { state.value("more", more); });
  expect_failure(two_spheres(), {"\"more\" is not a name of this state"});
}

TEST_F(CheckpointTest, AWrongLengthIsNamed) {
  save(two_spheres());
  Scene scene = two_spheres();
  scene.fluid.cells_across = 5;
  expect_failure(scene, {"liquid/", "values instead of"});
  scene = two_spheres();
  scene.contact.integrator = Integrator::gear;
  expect_failure(scene, {"spheres/memory", "integrator", "values instead of"});
}

// Also within an interval of the void fraction, and of what the forces beyond drag remember.
TEST_F(CheckpointTest, TheCouplingTakesNoFieldThatIsAValueShort) {
  Scene scene = two_spheres();
  scene.coupling.void_fraction_interval = 3e-3;
  scene.coupling.basset_history = true;
  Model model(scene, 1);
  model.fill();
  for (int k = 0; k < 3; ++k) model.advance(simulation::Surroundings::liquid);
  const NamedFields state = model.coupling().state();
  ASSERT_TRUE(state.contains("interval/centre_x"));
  EXPECT_NO_THROW(model.coupling().restore(state, model.particles()));
  for (const auto& [name, values] : state) {
    NamedFields shortened = state;
    shortened[name].pop_back();
    EXPECT_ANY_THROW(model.coupling().restore(shortened, model.particles())) << name;
  }
}

TEST_F(CheckpointTest, OneOfAnotherVersionIsSaidToBeSo) {
  const auto earlier = [](io::Hdf5File& target) {
    target.write_attribute("/", "scene_hash", std::string("a scene"));
    target.write("clock", std::vector<std::int64_t>{1, 2});
  };
  for (const io::Checksum checksum : {io::Checksum::none, io::Checksum::whole_file}) {
    io::write_atomically(folder_.path() / "checkpoint.h5", earlier, checksum);
    expect_failure(two_spheres(), {"checkpoint.h5", "earlier"});
  }
}

// A bit that turns over in a file must not lead to another result in silence.
TEST_F(CheckpointTest, NoChangedByteGoesUnnoticed) {
  save(two_spheres());
  for (const char* name : {"checkpoint.h5", "records_1.h5"}) {
    const auto file = folder_.path() / name;
    const std::string whole = hostile::bytes_of(file);
    for (std::size_t k = 0; k < whole.size(); k += 1 + whole.size() / 40) {
      std::string damaged = whole;
      damaged[k] = static_cast<char>(damaged[k] ^ 0x08);
      hostile::set_bytes(file, damaged);
      EXPECT_NE(failure(two_spheres()), "no error") << name << ", byte " << k;
    }
    hostile::set_bytes(file, whole);
  }
  EXPECT_EQ(failure(two_spheres()), "no error");
}

// With a checksum that fits, as somebody could write it.
TEST_F(CheckpointTest, ValuesThatNoRunCanHaveAreNamed) {
  const auto file = folder_.path() / "checkpoint.h5";
  const auto expect_refused = [&](const std::string& item, const std::function<void(hid_t)>& edit) {
    Scene scene = two_spheres();
    scene.coupling.basset_history = true;
    scene.coupling.void_fraction_interval = 3e-3;
    save(scene);
    hostile::change(file, edit);
    const std::string message = failure(scene);
    EXPECT_NE(message.find(item), std::string::npos) << message;
  };
  const auto set_whole = [](hid_t target, const char* path, std::int64_t value) {
    const hid_t data = H5Dopen2(target, path, H5P_DEFAULT);
    const std::vector<std::int64_t> values(2, value);
    H5Dwrite(data, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(data);
  };
  const auto replace_whole = [](hid_t target, const char* path, std::vector<std::int64_t> values) {
    H5Ldelete(target, path, H5P_DEFAULT);
    const hsize_t length = values.size();
    const hid_t space = H5Screate_simple(1, &length, nullptr);
    const hid_t data = H5Dcreate2(target, path, H5T_STD_I64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(data, H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(data);
    H5Sclose(space);
  };
  using hostile::fill, hostile::replace;
  expect_refused("position", [&](hid_t target) { fill(target, "spheres/particles/position/x", 1e303); });
  expect_refused("position", [&](hid_t target) { fill(target, "spheres/memory/neighbour_list/position/z", -1e303); });
  expect_refused("velocity", [&](hid_t target) { fill(target, "spheres/particles/velocity/x", std::nan("")); });
  expect_refused("mass", [&](hid_t target) { fill(target, "spheres/particles/mass", -1.0); });
  expect_refused("radius", [&](hid_t target) { fill(target, "spheres/particles/radius", 1.0); });
  expect_refused("species", [&](hid_t target) { set_whole(target, "spheres/particles/species", 7); });
  expect_refused("skin", [&](hid_t target) { fill(target, "spheres/memory/neighbour_list/skin", 1e6); });
  expect_refused("first", [&](hid_t target) { replace_whole(target, "spheres/memory/sphere_contacts/first", {-1}); });
  expect_refused("second", [&](hid_t target) {
    replace_whole(target, "spheres/memory/sphere_contacts/first", {0});
    replace_whole(target, "spheres/memory/sphere_contacts/second", {1LL << 32});
  });
  expect_refused("spheres 0 and 2", [&](hid_t target) {
    replace_whole(target, "spheres/memory/sphere_contacts/first", {0});
    replace_whole(target, "spheres/memory/sphere_contacts/second", {2});
  });
  expect_refused("velocity_z", [&](hid_t target) { replace(target, "liquid/velocity_z", {}); });
  expect_refused("earlier_volume", [&](hid_t target) { replace(target, "liquid/earlier_volume", {1.0}); });
  expect_refused("interval/steps", [&](hid_t target) { fill(target, "exchange_in_flow/interval/steps", -3.0); });
  expect_refused("basset_newest",
                 [&](hid_t target) { fill(target, "exchange_in_flow/forces_beyond_drag/basset_newest", 1e18); });
}

TEST_F(CheckpointTest, OneOfAnotherSceneIsLeftAlone) {
  save(two_spheres());
  RunResult result;
  const CheckpointFiles others(folder_.path(), "another scene");
  EXPECT_FALSE(others.load(result, [](io::StateGroup&) { FAIL() << "nothing is read"; }));
}

TEST_F(CheckpointTest, EachHasItsOwnRecordsAndRemovalLeavesNothing) {
  const auto nothing = [](io::StateGroup&) {};
  RunResult first, second, read_back;
  second.particle_steps = 7;
  files_.save(first, 1, nothing);
  files_.save(second, 2, nothing);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "records_1.h5"));
  ASSERT_TRUE(files_.load(read_back, nothing));
  EXPECT_EQ(read_back.particle_steps, 7);
  files_.save_failure(nothing);
  CheckpointFiles::remove(folder_.path());
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

}  // namespace
}  // namespace slfb::simulation
