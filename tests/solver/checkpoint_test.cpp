// A checkpoint goes on only where it fits: its scene, its version, and the names and lengths of its state.
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "solver/io/hdf5_file.hpp"
#include "solver/run/checkpoint_files.hpp"
#include "solver/run/model.hpp"
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
  io::write_atomically(folder_.path() / "checkpoint.h5", [](io::Hdf5File& target) {
    target.write_attribute("/", "scene_hash", std::string("a scene"));
    target.write("clock", std::vector<std::int64_t>{1, 2});
  });
  expect_failure(two_spheres(), {"checkpoint.h5", "earlier"});
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
