// Boundaries of stability that theory knows, found by bisection; and plans whose answers the laws know.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "correlations/drag/wen_yu_1966.hpp"
#include "correlations/fluidisation/bed_expansion.hpp"
#include "experiments/frontier/study.hpp"
#include "experiments/plan/plan.hpp"
#include "experiments/stability/map.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

/// A store of trials that goes away with the test.
class Store {
 public:
  Store() {
    std::string name = (fs::temp_directory_path() / "slfb-stability-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;
  ~Store() { fs::remove_all(path_); }
  [[nodiscard]] studies::TrialStore trials() const { return studies::TrialStore(path_); }

 private:
  fs::path path_;
};

stability::Map map_named(const std::string& id) {
  return stability::load_map(fs::path(SLFB_SOURCE_DIR) / "experiments/stability/maps" / (id + ".toml"),
                             stability::Set::quick);
}

stability::Boundary boundary_of(const stability::Map& map, const std::string& series, double x) {
  const Store store;
  for (const auto& one : map.series)
    if (one.name == series) return *stability::find_boundary(map, one, x, store.trials());
  throw std::runtime_error("no series " + series);
}

// A harmonic oscillator by symplectic Euler or a Verlet scheme is stable up to a step of 2/ω (Hairer, Lubich & Wanner
// 2006, I.1.4), ω = sqrt(k/m), here of 5 mm glass. To the 1 % of the bisection.
TEST(StabilityGate, IntegratorsOfSecondOrderFailAtTwoOverOmega) {
  const auto map = map_named("contact-pair");
  const double mass = 2230.0 * M_PI / 6.0 * std::pow(0.005, 3);
  for (const char* name : {"symplectic Euler", "velocity Verlet", "position Verlet"})
    for (const double stiffness : {1e3, 1e5}) {
      const auto boundary = boundary_of(map, name, stiffness);
      EXPECT_EQ(boundary.kind, stability::BoundaryKind::found);
      EXPECT_NEAR(boundary.y, 2.0 * std::sqrt(mass / stiffness), 0.01 * boundary.y) << name << " at " << stiffness;
    }
}

// Explicit Euler on the slip of two phases: β Δt/ρ_L = 2/(1/α + ρ_L/(ρ_S α_S)). The others have no limit.
TEST(StabilityGate, ExplicitExchangeFailsAtItsLimitAndImplicitOnesHold) {
  const auto map = map_named("exchange-solids");
  for (const double solids : {0.1, 0.6}) {
    const double limit = 2.0 / (1.0 / (1.0 - solids) + 1.0 / (2.23 * solids));
    const auto boundary = boundary_of(map, "explicit", solids);
    EXPECT_EQ(boundary.kind, stability::BoundaryKind::found);
    EXPECT_NEAR(boundary.y, limit, 0.03 * limit) << solids;
  }
  EXPECT_EQ(boundary_of(map, "semi-implicit", 0.6).kind, stability::BoundaryKind::never_fails);
  EXPECT_EQ(boundary_of(map, "implicit", 0.6).kind, stability::BoundaryKind::never_fails);
}

// By hand for 5 mm glass in water: at a voidage of 0.8 both branches of Gidaspow's law are fluidised from other
// velocities; between those of Wen & Yu (drag smaller) and Ergun (larger) there is no bed.
TEST(StabilityGate, HomogeneousBedsEndAtTheJumpOfTheDragLaw) {
  const auto map = map_named("drag-jump");
  const auto below = boundary_of(map, map.series.at(0).name, 0.005),
             above = boundary_of(map, map.series.at(1).name, 0.005);
  const Sphere glass{0.005, 2230.0};
  const LiquidProperties water{998.2, 1e-3};
  const double wen_yu = fluidisation::superficial_velocity(drag::WenYu1966{}, glass, water, 0.8);
  EXPECT_NEAR(std::max(below.y, above.y), wen_yu, 0.002 * wen_yu);
  EXPECT_LT(below.y, above.y);
}

// The terminal velocity of a sphere alone is planned as an ODE, and CVODE ends where drag and weight balance:
// C_D = 24/Re (1 + 0.15 Re^0.687) up to Re = 1000, 0.44 beyond, the root taken here by its own iteration.
TEST(PlanGate, TerminalVelocityIsAnOrdinaryDifferentialEquation) {
  const Scene scene = load_scene(fs::path(SLFB_SOURCE_DIR) / "experiments/scenes/single_sphere.toml");
  const auto made = plan::make_plan(scene, {"terminal_velocity"}, plan::load_rules());
  ASSERT_TRUE(made.by_formula);
  EXPECT_NE(made.decisions.front().choice.find("CVODE"), std::string::npos);
  const double d = 0.006, excess = (7800.0 - 998.2) / 998.2;
  double velocity = 1.0;
  for (int k = 0; k < 200; ++k) {
    const double reynolds = 998.2 * velocity * d / 1e-3;
    const double drag = reynolds > 1000.0 ? 0.44 : 24.0 / reynolds * (1.0 + 0.15 * std::pow(reynolds, 0.687));
    velocity = std::sqrt(4.0 / 3.0 * 9.81 * d * excess / drag);
  }
  EXPECT_NEAR(plan::answer_by_formula(scene, made).at("terminal_velocity"), velocity, 1e-6 * velocity);
}

// What is asked decides: a root for U_mf, one dimension for the force balance, three for V_2 in a narrow column; a soft
// spring for V_2, the scene's own for peak forces.
TEST(PlanGate, ChoosesNoMoreThanTheQuestionNeeds) {
  const Scene scene = load_scene(fs::path(SLFB_SOURCE_DIR) / "experiments/scenes/6in5W.toml");
  const auto rules = plan::load_rules();
  EXPECT_TRUE(plan::make_plan(scene, {"minimum_fluidisation_velocity"}, rules).by_formula);
  const auto planned = [&](const std::string& quantity) {
    return plan::changed(scene, plan::make_plan(scene, {quantity}, rules).overrides);
  };
  EXPECT_EQ(planned("force_ratio").fluid.tier, FluidTier::one_dimensional);
  EXPECT_EQ(planned("classification_velocity").fluid.tier, FluidTier::three_dimensional);
  EXPECT_EQ(planned("classification_velocity").contact.stiffness, 1e3);
  EXPECT_EQ(planned("peak_force").contact.stiffness, 1e4);
  // The richer the plan, the more it costs; and the planned scene is a valid one, whose steps resolve its contacts.
  const auto cheap = plan::make_plan(scene, {"force_ratio"}, rules);
  EXPECT_LT(cheap.core_seconds, cheap.given_core_seconds);
  EXPECT_GE(3.1416 * contact_time_step_bound(planned("classification_velocity")) /
                planned("classification_velocity").contact.time_step,
            8.0);
}

TEST(PlanGate, RefusesUnknownQuantities) {
  const Scene scene = load_scene(fs::path(SLFB_SOURCE_DIR) / "experiments/scenes/6in5W.toml");
  EXPECT_THROW(plan::make_plan(scene, {"colour"}, plan::load_rules()), std::invalid_argument);
}

TEST(PlanGate, RefusesSpheresThatDoNotSink) {
  const Scene scene = load_scene(fs::path(SLFB_SOURCE_DIR) / "experiments/scenes/6in5W.toml", {"liquid.density=2230"});
  try {
    plan::make_plan(scene, {"voidage"}, plan::load_rules());
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("species \"glass\" of 2230 kg/m3 does not sink"), std::string::npos)
        << error.what();
  }
}

// Every study and map can be read and each of its scenes is valid, in both sets.
TEST(StudyFiles, AreReadable) {
  for (const auto& file : frontier::study_files())
    for (const auto set : {frontier::Set::quick, frontier::Set::full}) EXPECT_NO_THROW(frontier::load_study(file, set));
  for (const auto& file : stability::map_files())
    for (const auto set : {stability::Set::quick, stability::Set::full})
      EXPECT_NO_THROW(stability::load_map(file, set));
}

}  // namespace
}  // namespace slfb
