// Valid scenes that nobody would write: all tiers, options and laws, extreme ratios, small beds. Each is refused, or
// finishes with its spheres counted, its forces in balance and its overlaps told, or stops with a diagnosis.
// SLFB_RANDOM_SCENES=400 build/tests/solver_tests --gtest_filter=RandomScenes* runs more of them.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <sstream>
#include <string>

#include "correlations/drag/drag_laws.hpp"
#include "correlations/law_list.hpp"
#include "solver/coupling/force_balance.hpp"
#include "solver/dem/packing.hpp"
#include "solver/dem/particles.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/run/simulation.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

class Generator {
 public:
  explicit Generator(std::uint32_t seed) : random_(seed) {}

  Scene scene() {
    Scene scene;
    scene.title = "random";
    scene.seed = random_();
    const double diameter = logarithmic(5e-4, 1e-2);
    column(scene, diameter);
    scene.liquid = {logarithmic(700.0, 2000.0), logarithmic(3e-4, 0.5), one_in(6) ? 0.0 : logarithmic(1e-3, 0.3)};
    liquid_numerics(scene, diameter);
    spheres(scene, diameter);
    contacts(scene);
    coupling(scene, diameter);
    stages(scene);
    scene.outlet.rule = one_in(3) ? OutletRule::remove : OutletRule::lid;
    scene.recording.bed_interval = scene.fluid.time_step * static_cast<double>(1 + random_() % 4);
    scene.recording.drop_interval = scene.fluid.time_step;
    if (one_in(5) && scene.fluid.wall != LateralBoundary::periodic) scene.geometry.inclination = uniform(1.0, 80.0);
    if (one_in(4)) scene.recording.snapshot_interval = 3.0 * scene.fluid.time_step;
    return scene;
  }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  double logarithmic(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  bool one_in(unsigned n) { return random_() % n == 0; }
  template <class Value>
  Value any_of(std::initializer_list<Value> values) {
    return values.begin()[random_() % values.size()];
  }

  void column(Scene& scene, double diameter) {
    auto& geometry = scene.geometry;
    geometry.shape = one_in(2) ? Shape::box : Shape::cylinder;
    geometry.diameter = geometry.shape == Shape::cylinder ? uniform(1.05, 8.0) * diameter : 0.0;
    if (geometry.shape == Shape::box) geometry.width = {uniform(1.05, 8.0) * diameter, uniform(1.05, 8.0) * diameter};
    geometry.height = uniform(4.0, 25.0) * diameter;
  }

  void liquid_numerics(Scene& scene, double diameter) {
    auto& fluid = scene.fluid;
    fluid.tier = any_of({FluidTier::quiescent, FluidTier::one_dimensional, FluidTier::three_dimensional});
    fluid.wall = scene.geometry.shape == Shape::box
                     ? any_of({LateralBoundary::no_slip, LateralBoundary::slip, LateralBoundary::periodic})
                     : any_of({LateralBoundary::no_slip, LateralBoundary::slip});
    fluid.cells_across = 1 + static_cast<int>(random_() % 6);
    fluid.cell_height = uniform(0.5, 3.0) * diameter;
    fluid.convection =
        any_of({ConvectionScheme::upwind, ConvectionScheme::central, ConvectionScheme::quick, ConvectionScheme::muscl});
    fluid.time_scheme = any_of({TimeScheme::euler, TimeScheme::second_order});
    fluid.pressure_velocity = any_of({PressureVelocity::projection, PressureVelocity::simple});
  }

  void spheres(Scene& scene, double diameter) {
    const auto density = [&] { return one_in(5) ? logarithmic(100.0, 900.0) : logarithmic(1010.0, 1e4); };
    scene.species = {{"bed", diameter, density(), one_in(8) ? 0 : static_cast<std::int64_t>(random_() % 60)}};
    if (one_in(2))
      scene.species.push_back(
          {"other", diameter * logarithmic(0.3, 2.0), density(), static_cast<std::int64_t>(random_() % 10)});
  }

  void contacts(Scene& scene) {
    auto& contact = scene.contact;
    if (one_in(4)) {
      contact.law = "hertz";
      contact.youngs_modulus = logarithmic(1e5, 1e8);
    } else {
      contact.stiffness = logarithmic(10.0, 1e4);
    }
    contact.restitution = uniform(0.05, 1.0);
    contact.sliding_friction = uniform(0.0, 1.0);
    contact.rolling_friction = one_in(2) ? 0.0 : uniform(0.0, 0.1);
    contact.rolling_model = any_of({RollingModel::constant_torque, RollingModel::elastic_plastic});
    contact.integrator = any_of(
        {Integrator::symplectic_euler, Integrator::velocity_verlet, Integrator::position_verlet, Integrator::gear});
    contact.time_step = uniform(0.05, 0.9) * contact_time_step_bound(scene);
    if (!(contact.time_step > 0.0 && std::isfinite(contact.time_step))) contact.time_step = 1e-5;
    scene.fluid.time_step = contact.time_step * static_cast<double>(1 + random_() % 20);
  }

  void coupling(Scene& scene, double diameter) {
    auto& coupling = scene.coupling;
    std::vector<std::string> laws;
    for_each_law<drag::DragLaws>([&](const auto& law) { laws.emplace_back(law.info.name); });
    coupling.drag_law = laws[random_() % laws.size()];
    coupling.void_fraction =
        any_of({VoidFractionScheme::centroid, VoidFractionScheme::particle_meshing, VoidFractionScheme::exact_overlap});
    coupling.meshing_pieces = static_cast<int>(logarithmic(1.0, 1e4));
    coupling.exchange =
        any_of({MomentumExchange::explicit_in_time, MomentumExchange::semi_implicit, MomentumExchange::implicit});
    coupling.interpolation = any_of({Interpolation::shares, Interpolation::gradient, Interpolation::trilinear});
    coupling.void_fraction_interval = one_in(3) ? scene.fluid.time_step * static_cast<double>(random_() % 5) : 0.0;
    coupling.added_mass = one_in(2) ? 0.0 : 0.5;
    coupling.saffman_lift = one_in(3);
    coupling.magnus_lift = one_in(3);
    coupling.basset_history = one_in(4);
    coupling.disturbance_correction = one_in(4);
    if (one_in(4)) {
      coupling.lubrication_range = 0.05 * diameter;
      coupling.lubrication_roughness = 0.001 * diameter;
    }
    if (one_in(4)) coupling.smoothing_length = uniform(0.0, 1.0) * diameter;
  }

  void stages(Scene& scene) {
    const double step = scene.fluid.time_step;
    const auto stage = [&](StageKind kind, int least, int most) {
      Stage made;
      made.kind = kind;
      made.duration = step * static_cast<double>(least + static_cast<int>(random_() % static_cast<unsigned>(most)));
      return made;
    };
    if (one_in(2)) scene.stages.push_back(stage(StageKind::settle, 1, 60));
    if (scene.liquid.superficial_velocity > 0.0) scene.stages.push_back(stage(StageKind::fluidise, 1, 60));
    if (scene.stages.empty() || one_in(2)) {
      Stage drop = stage(StageKind::drop, 5, 60);
      const Species& species = scene.species.back();
      drop.species = species.name;
      drop.release_height = scene.geometry.height - 0.51 * species.diameter;
      drop.repetitions = 1 + static_cast<int>(random_() % 2);
      drop.relaxation = 3.0 * step;
      scene.stages.push_back(drop);
    }
  }

  std::mt19937 random_;
};

/// Time of the spheres' own steps that every sphere of the bed has to have had, and one dropped one could have.
std::string wrong_count(const Scene& scene, const RunResult& result) {
  std::int64_t spheres = 0;
  for (const Species& species : scene.species) spheres += species.count;
  const bool drops =
      std::ranges::any_of(scene.stages, [](const Stage& stage) { return stage.kind == StageKind::drop; });
  const std::int64_t steps = std::llround(result.simulated_seconds / scene.contact.time_step);
  const std::int64_t most = (spheres + (drops ? 1 : 0)) * steps,
                     least = std::max<std::int64_t>(0, spheres - result.particles_removed) * steps;
  if (result.particle_steps < least || result.particle_steps > most)
    return fmt::format("{} steps of spheres, and {} spheres had {} steps; {} were removed", result.particle_steps,
                       spheres, steps, result.particles_removed);
  for (const Snapshot& snapshot : result.snapshots) {
    const auto there = static_cast<std::int64_t>(snapshot.x.size());
    // The dropped sphere is one more; what left through the outlet left before or after this moment.
    if (there > spheres + 1 || there < spheres + 1 - result.particles_removed)
      return fmt::format("{} spheres of {}, and {} were removed", there, spheres + 1, result.particles_removed);
  }
  return "";
}

/// A centre outside the column, by more than the rounding of snapshots. Through periodic sides spheres go as far as the
/// skin of the neighbour list before they come in on the other side.
std::string sphere_outside(const Scene& scene, const RunResult& result) {
  const auto& g = scene.geometry;
  const bool round = g.shape == Shape::cylinder;
  for (const Snapshot& snapshot : result.snapshots)
    for (std::size_t i = 0; i < snapshot.x.size(); ++i) {
      const double x = snapshot.x[i], y = snapshot.y[i], z = snapshot.z[i], rounding = 1e-4;
      const double side = scene.fluid.wall == LateralBoundary::periodic ? snapshot.radius[i] : rounding;
      const bool inside = round ? std::hypot(x, y) < 0.5 * g.diameter + side
                                : std::abs(x) < 0.5 * g.width[0] + side && std::abs(y) < 0.5 * g.width[1] + side;
      const bool below = scene.outlet.rule == OutletRule::remove || z < g.height + rounding;
      if (!(inside && below && z > -rounding)) return fmt::format("a sphere at ({}, {}, {})", x, y, z);
    }
  return "";
}

/// Whether a sphere was put in or taken out shortly before a sample: what it displaced, and the momentum of its added
/// mass, come and go with it.
bool sphere_came_or_went(const BedSeries& bed, std::size_t sample) {
  for (std::size_t k = sample > 2 ? sample - 2 : 0; k < sample; ++k)
    if (bed.foreign_present[k] != bed.foreign_present[sample] || bed.buoyant_weight[k] != bed.buoyant_weight[sample])
      return true;
  return false;
}

/// What is wrong with a finished run; empty if nothing is.
/// \param said what the run logged
std::string contradiction(const Scene& scene, const RunResult& result, const std::string& said) {
  if (auto wrong = wrong_count(scene, result); !wrong.empty()) return wrong;
  if (auto wrong = sphere_outside(scene, result); !wrong.empty()) return wrong;
  const BedSeries& bed = result.bed;
  for (const double value : bed.centre_of_mass_height)
    if (!std::isfinite(value)) return "the bed has no height";
  constexpr double deep = 0.2;
  if (!bed.maximum_overlap.empty() && std::ranges::max(bed.maximum_overlap) > deep &&
      said.find(" overlaps ") == std::string::npos)
    return fmt::format("an overlap of {} radii, without a word", std::ranges::max(bed.maximum_overlap));
  if (!coupling::imbalance_of_forces(scene).empty()) return "";
  for (std::size_t k = 0; k < bed.balance_residual.size(); ++k) {
    // Of the largest force, as heavy and light spheres may weigh nothing together.
    const double weight = std::abs(bed.buoyant_weight[k]);
    double largest = 0.0;
    for (const auto* force : {&bed.pressure_force, &bed.buoyant_weight, &bed.bottom_force, &bed.wall_force,
                              &bed.shear_force, &bed.flow_force, &bed.sphere_inertia, &bed.liquid_inertia})
      largest = std::max(largest, std::abs((*force)[k]));
    if (!(weight > 0.0) || sphere_came_or_went(bed, k)) continue;
    // SIMPLE ends its iterations at a residual that is not zero.
    const double tolerance = scene.fluid.pressure_velocity == PressureVelocity::simple
                                 ? std::max(1e-6, 10.0 * scene.fluid.simple_tolerance)
                                 : 1e-6;
    if (!(bed.balance_residual[k] * weight < tolerance * largest))
      return fmt::format("forces add up to {} of the largest of them", bed.balance_residual[k] * weight / largest);
  }
  return "";
}

/// Collects what is logged while it lives.
class Log {
 public:
  Log() : before_(spdlog::default_logger()) {
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text_)));
  }
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  ~Log() { spdlog::set_default_logger(before_); }
  [[nodiscard]] std::string text() const { return text_.str(); }

 private:
  std::ostringstream text_;
  std::shared_ptr<spdlog::logger> before_;
};

TEST(RandomScenes, AreRefusedOrFinishOrStopWithADiagnosis) {
  const char* const asked = std::getenv("SLFB_RANDOM_SCENES");
  const std::uint32_t scenes = asked != nullptr ? static_cast<std::uint32_t>(std::stoul(asked)) : 40;
  int refused = 0, finished = 0, stopped = 0, told = 0;
  std::map<std::string, int> reasons;
  for (std::uint32_t k = 0; k < scenes; ++k) {
    const Scene scene = Generator(k).scene();
    try {
      validate_scene(scene);
      dem::start_positions(scene);  // as --dry-run looks for them
    } catch (const SceneError& error) {
      const std::string message = error.what();
      EXPECT_NE(message, "");
      ++refused;
      ++reasons[message.substr(0, message.find(" = "))];
      continue;
    }
    SCOPED_TRACE(fmt::format("random scene {}:\n{}", k, canonical_toml(scene)));
    const Folder folder;
    const Log log;
    try {
      const RunResult result = run_scene(scene, {.directory = folder.path()}).result;
      EXPECT_EQ(contradiction(scene, result, log.text()), "");
      ++finished;
      if (log.text().find(" overlaps ") != std::string::npos) ++told;
    } catch (const SceneError& error) {
      ADD_FAILURE() << "valid, but then: " << error.what();
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("after the start of the run"), std::string::npos) << error.what();
      ++stopped;
    }
  }
  fmt::print(
      "{} random scenes: {} refused, {} finished ({} of them with a warning of overlaps), {} stopped with a "
      "diagnosis\n",
      scenes, refused, finished, told, stopped);
  for (const auto& [key, count] : reasons) fmt::print("  {} refused for {}\n", count, key);
  EXPECT_GT(finished, 0);
}

}  // namespace
}  // namespace slfb
