// The gates go red: each error is planted in the scene of the central case, small as it is, and at least one gate
// breaks.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>

#include "experiments/claims/claims.hpp"
#include "experiments/peng_2014/measure_laws.hpp"
#include "experiments/peng_2014/probes.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/measure.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/support/folders.hpp"

namespace slfb {
namespace {

std::set<std::string> broken_gates(const Overrides& planted) {
  const auto scene = source_folder() / "experiments/peng_2014/scenes/6in5W.toml";
  Measurements measurements = measure_laws();
  measurements.merge(measure_probes(load_scene(scene, planted)));
  std::set<std::string> broken;
  for (const Evaluation& evaluation : evaluate(load_claims(), measurements))
    if (evaluation.gate == Gate::broken) broken.insert(evaluation.claim.id);
  return broken;
}

TEST(PlantedErrors, WithoutOneEveryGateHolds) { EXPECT_EQ(broken_gates({}), std::set<std::string>{}); }

struct Planted {
  const char *name, *override, *gate;
};
class PlantedError : public testing::TestWithParam<Planted> {};

TEST_P(PlantedError, BreaksItsGate) {
  const auto broken = broken_gates({GetParam().override});
  EXPECT_TRUE(broken.contains(GetParam().gate)) << testing::PrintToString(broken);
}

INSTANTIATE_TEST_SUITE_P(
    Scene, PlantedError,
    testing::Values(Planted{"RestitutionHalfAPercent", "contact.restitution=0.8955", "table1.restitution"},
                    Planted{"FrictionOnePercent", "contact.sliding_friction=0.297", "table1.sliding_friction"},
                    Planted{"DensityHalfAPercent", "species[0].density=2241 kg/m3", "text.terminal_velocity"},
                    Planted{"StepTenPercent", "contact.time_step=4.5454545454545e-5", "table1.restitution"},
                    Planted{"StiffnessTenPercent", "contact.stiffness=1.1e4", "table1.restitution"},
                    Planted{"ViscosityOnePercent", "liquid.viscosity=1.01e-3", "text.frozen_bed"},
                    // The weight that a wrong sign in the buoyancy gives: (ρ_P + ρ_L) V g.
                    Planted{"SignOfBuoyancy", "species[0].density=4226.4 kg/m3", "text.terminal_velocity"}),
    [](const auto& planted) { return planted.param.name; });

// One coefficient of the drag law off by a hundredth: 150 of Ergun's, 24 of the single sphere's.
class PlantedCoefficient : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(PlantedCoefficient, BreaksTheGateOfItsBranch) {
  const auto& [branch, gate] = GetParam();
  // A file of its own: the two may be tested at the same time.
  const auto file = std::filesystem::temp_directory_path() / ("slfb_planted_" + branch + ".cpp");
  const bool dense = branch == "Ergun";
  std::ofstream(file) << R"(
#include "correlations/drag/drag_law_kernels.hpp"
#include "correlations/drag/gidaspow_1994.hpp"
namespace {
using namespace slfb;
struct Planted {
  static constexpr LawInfo info = [] {
    LawInfo info = drag::Gidaspow1994::info;
    info.name = "planted";
    return info;
  }();
  template <class Number = double>
  Number operator()(drag::SuspensionFlowOf<Number> flow) const {
    const Number drag = drag::Gidaspow1994{}(flow);
    return )" << (dense ? "flow.voidage <= 0.8" : "flow.voidage > 0.8")
                      << R"( ? 1.01 * drag : drag;
  }
};
}  // namespace
SLFB_DRAG_LAW(Planted)
)" << std::flush;
  EXPECT_TRUE(broken_gates({"coupling.drag_law=" + file.string()}).contains(gate));
}

INSTANTIATE_TEST_SUITE_P(Law, PlantedCoefficient,
                         testing::Values(std::pair<std::string, std::string>{"Ergun", "text.frozen_bed"},
                                         std::pair<std::string, std::string>{"SingleSphere", "text.terminal_velocity"}),
                         [](const auto& planted) { return planted.param.first; });

}  // namespace
}  // namespace slfb
