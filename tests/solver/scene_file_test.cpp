#include "solver/laws/scene_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <regex>
#include <set>
#include <string>

#include "solver/coupling/drag_relaxation.hpp"
#include "solver/laws/user_law.hpp"

namespace slfb {
namespace {

const std::string valid_scene = R"(title = "a bed and a sphere"
seed = 7
[geometry]
shape = "cylinder"
diameter = "50 mm"
height = "1.0 m"
[liquid]
density = "998.2 kg/m3"
viscosity = "1.0 mPa s"
superficial_velocity = "0.06 m/s"
[fluid]
tier = "three-dimensional"
wall = "no-slip"
cells_across = 8
cell_height = "6.25 mm"
convection = "quick"
pressure_velocity = "projection"
time_step = "5e-4 s"
pressure_tolerance = 1e-6
simple_tolerance = 1e-5
[contact]
stiffness = "1e4 N/m"
restitution = 0.9
sliding_friction = 0.3
rolling_friction = 0.0175
tangential_stiffness_ratio = 0.28
tangential_damping_ratio = 0.5
time_step = "5e-5 s"
[coupling]
drag_law = "gidaspow-1994"
void_fraction = "exact-overlap"
meshing_pieces = 1214
smoothing_length = 0
[outlet]
particles = "lid"
[[species]]
name = "glass"
diameter = "5 mm"
density = "2230 kg/m3"
total_mass = "0.5255 kg"
[[species]]
name = "steel"
diameter = "6 mm"
density = "7800 kg/m3"
[[stage]]
kind = "settle"
duration = "1.5 s"
[[stage]]
kind = "fluidise"
duration = "20 s"
[[stage]]
kind = "drop"
species = "steel"
repetitions = 3
release_height = "0.997 m"
duration = "15 s"
relaxation = "1 s"
[recording]
bed_interval = "10 ms"
drop_interval = "1 ms"
snapshot_interval = "1 s"
checkpoint_interval = "60 s"
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

int line_of(const std::string& text, const std::string& part) {
  return 1 +
         static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(part)), '\n'));
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

// --- every rule goes red, at the line of the value -------------------------------------------------------------------

struct Mistake {
  std::string from;     ///< in valid_scene
  std::string to;       ///< what a user wrote instead
  std::string key;      ///< the key blamed
  std::string written;  ///< the value shown
  std::string message;  ///< a part of what is said
};

std::ostream& operator<<(std::ostream& out, const Mistake& mistake) { return out << mistake.to; }

class SceneRule : public testing::TestWithParam<Mistake> {};

TEST_P(SceneRule, IsReportedWithFileLineKeyAndValue) {
  const Mistake& mistake = GetParam();
  const std::string text = replaced(valid_scene, mistake.from, mistake.to);
  const std::string message = message_of([&] { parse_scene(text, "scene.toml"); });
  const std::string name = mistake.key.substr(mistake.key.rfind('.') + 1);
  const auto at = valid_scene.find(mistake.from) + mistake.to.find(name);
  const int line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  const std::string start = "scene.toml:" + std::to_string(line) + ": " + mistake.key + " = " + mistake.written + ": ";
  EXPECT_NE(message.find(start), std::string::npos) << message << "\nexpected: " << start;
  EXPECT_NE(message.find(mistake.message), std::string::npos) << message;
  EXPECT_TRUE(std::regex_search(message, std::regex("allowed|needed|belongs"))) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Keys, SceneRule,
    testing::Values(
        Mistake{"stiffness = \"1e4 N/m\"", "stifness = 1e4", "contact.stifness", "10000",
                "unknown key (did you mean \"stiffness\"?); allowed here is law, stiffness"},
        Mistake{"seed = 7", "sede = 7", "sede", "7", "did you mean \"seed\"?"},
        Mistake{"restitution = 0.9", "restitution = true", "contact.restitution", "true", "wrong type"},
        Mistake{"seed = 7", "seed = 7.5", "seed", "7.5", "wrong type"},
        Mistake{"cells_across = 8", "cells_across = \"8\"", "fluid.cells_across", "\"8\"", "wrong type"},
        Mistake{"name = \"glass\"", "name = 5", "species[0].name", "5", "wrong type; allowed is a text in quotes"},
        Mistake{"title = \"a bed and a sphere\"", "title = \"\\u001b[2J\"", "title", "\"\\u001B[2J\"",
                "control character"},
        Mistake{"time_step = \"5e-5 s\"", "time_step = 5e-5\nallow_large_time_step = \"yes\"",
                "contact.allow_large_time_step", "\"yes\"", "allowed is true or false"},
        Mistake{"shape = \"cylinder\"", "shape = \"pipe\"", "geometry.shape", "\"pipe\"",
                "allowed is \"cylinder\" | \"box\""},
        Mistake{"tier = \"three-dimensional\"", "tier = 3", "fluid.tier", "3", "none of the choices"},
        Mistake{"diameter = \"50 mm\"", "diameter = \"50 mm\"\nwidth = [1, 1]", "geometry.width", "[ 1, 1 ]",
                "has no meaning here; it belongs to shape = \"box\""},
        Mistake{"duration = \"20 s\"", "duration = \"20 s\"\nrepetitions = 2", "stage[1].repetitions", "2",
                "it belongs to kind = \"drop\""},
        Mistake{"total_mass = \"0.5255 kg\"", "count = 5\ntotal_mass = 1", "species[0].total_mass", "1",
                "stands beside count"},
        Mistake{"diameter = \"50 mm\"", "diameter = \"50 kg\"", "geometry.diameter", "\"50 kg\"",
                "measures something else; needed is a length, for example \"50 mm\", or a bare number in m"},
        Mistake{"viscosity = \"1.0 mPa s\"", "viscosity = \"1.0\"", "liquid.viscosity", "\"1.0\"", "has no unit"}));

INSTANTIATE_TEST_SUITE_P(
    Ranges, SceneRule,
    testing::Values(
        Mistake{"density = \"998.2 kg/m3\"", "density = \"-998.2 kg/m3\"", "liquid.density", "\"-998.2 kg/m3\"",
                "out of range; allowed is greater than zero"},
        Mistake{"density = \"2230 kg/m3\"", "density = 0", "species[0].density", "0", "greater than zero"},
        Mistake{"diameter = \"5 mm\"", "diameter = -5e-3", "species[0].diameter", "-0.005", "greater than zero"},
        Mistake{"diameter = \"50 mm\"", "diameter = nan", "geometry.diameter", "nan", "greater than zero"},
        Mistake{"height = \"1.0 m\"", "height = inf", "geometry.height", "inf", "greater than zero"},
        Mistake{"viscosity = \"1.0 mPa s\"", "viscosity = 0.0", "liquid.viscosity", "0", "greater than zero"},
        Mistake{"superficial_velocity = \"0.06 m/s\"", "superficial_velocity = \"-6 cm/s\"",
                "liquid.superficial_velocity", "\"-6 cm/s\"", "zero or greater"},
        Mistake{"cells_across = 8", "cells_across = 0", "fluid.cells_across", "0", "a whole number from 1"},
        Mistake{"cell_height = \"6.25 mm\"", "cell_height = 0", "fluid.cell_height", "0", "greater than zero"},
        Mistake{"time_step = \"5e-4 s\"", "time_step = 0", "fluid.time_step", "0", "greater than zero"},
        Mistake{"pressure_tolerance = 1e-6", "pressure_tolerance = 1", "fluid.pressure_tolerance", "1",
                "between 0 and 1"},
        Mistake{"simple_tolerance = 1e-5", "simple_tolerance = 0", "fluid.simple_tolerance", "0", "between 0 and 1"},
        Mistake{"stiffness = \"1e4 N/m\"", "stiffness = 0", "contact.stiffness", "0", "greater than zero"},
        Mistake{"restitution = 0.9", "restitution = 0", "contact.restitution", "0", "greater than 0 and at most 1"},
        Mistake{"restitution = 0.9", "restitution = 1.01", "contact.restitution", "1.01",
                "greater than 0 and at most 1"},
        Mistake{"sliding_friction = 0.3", "sliding_friction = -0.1", "contact.sliding_friction", "-0.1",
                "zero or greater"},
        Mistake{"rolling_friction = 0.0175", "rolling_friction = -1", "contact.rolling_friction", "-1",
                "zero or greater"},
        Mistake{"tangential_stiffness_ratio = 0.28", "tangential_stiffness_ratio = -1",
                "contact.tangential_stiffness_ratio", "-1", "greater than zero"},
        Mistake{"restitution = 0.9", "youngs_modulus = \"5e7 Pa\"", "contact.youngs_modulus", "\"5e7 Pa\"",
                "it belongs to law = \"hertz\""},
        Mistake{"restitution = 0.9", "integrator = \"leapfrog\"", "contact.integrator", "\"leapfrog\"",
                "\"velocity-verlet\""},
        Mistake{"tangential_damping_ratio = 0.5", "tangential_damping_ratio = -1", "contact.tangential_damping_ratio",
                "-1", "zero or greater"},
        Mistake{"time_step = \"5e-5 s\"", "time_step = \"-5e-5 s\"", "contact.time_step", "\"-5e-5 s\"",
                "greater than zero"},
        Mistake{"meshing_pieces = 1214", "meshing_pieces = 0", "coupling.meshing_pieces", "0", "a whole number from 1"},
        Mistake{"smoothing_length = 0", "smoothing_length = \"-1 mm\"", "coupling.smoothing_length", "\"-1 mm\"",
                "zero or greater"},
        Mistake{"total_mass = \"0.5255 kg\"", "count = -1", "species[0].count", "-1", "a whole number from 0"},
        Mistake{"total_mass = \"0.5255 kg\"", "total_mass = \"0.01 g\"", "species[0].total_mass", "\"0.01 g\"",
                "is 0 spheres"},
        Mistake{"duration = \"20 s\"", "duration = 0", "stage[1].duration", "0", "greater than zero"},
        Mistake{"repetitions = 3", "repetitions = 0", "stage[2].repetitions", "0", "a whole number from 1"},
        Mistake{"relaxation = \"1 s\"", "relaxation = -1", "stage[2].relaxation", "-1", "zero or greater"},
        Mistake{"bed_interval = \"10 ms\"", "bed_interval = 0", "recording.bed_interval", "0", "greater than zero"},
        Mistake{"drop_interval = \"1 ms\"", "drop_interval = -1", "recording.drop_interval", "-1", "greater than zero"},
        Mistake{"snapshot_interval = \"1 s\"", "snapshot_interval = -1", "recording.snapshot_interval", "-1",
                "zero or greater"},
        Mistake{"checkpoint_interval = \"60 s\"", "checkpoint_interval = 0", "recording.checkpoint_interval", "0",
                "greater than zero"},
        Mistake{"seed = 7", "seed = -7", "seed", "-7", "a whole number below 2^63"}));

INSTANTIATE_TEST_SUITE_P(
    Physics, SceneRule,
    testing::Values(
        // 3600 spheres of 5 mm fill 0.2356 litres; at a solid fraction of 0.64 they stand 0.1875 m high in 50 mm.
        Mistake{"height = \"1.0 m\"", "height = \"0.18 m\"", "geometry.height", "\"0.18 m\"",
                "the bed does not fit into the column; packed as densely as spheres go (solid fraction 0.64) it is "
                "0.1875 m high"},
        Mistake{"diameter = \"6 mm\"", "diameter = \"50 mm\"", "species[1].diameter", "\"50 mm\"",
                "does not fit between the walls; allowed is less than 0.05 m"},
        // A slip of a unit: 1e14 s in steps of 5e-5 s.
        Mistake{"duration = \"20 s\"", "duration = 1e14", "stage[1].duration", "100000000000000",
                "takes 2e+18 steps of contact.time_step = 5e-05 s; allowed are 5e+09"},
        Mistake{"name = \"steel\"", "name = \"glass\"", "species[1].name", "\"glass\"",
                "the name of an earlier species"},
        Mistake{"name = \"steel\"", "name = \"steel/2\"", "species[1].name", "\"steel/2\"", "letters, digits"},
        Mistake{"total_mass = \"0.5255 kg\"", "count = 0", "species[0].count", "0", "neither in the bed nor dropped"},
        Mistake{"wall = \"no-slip\"", "wall = \"periodic\"", "fluid.wall", "\"periodic\"",
                "a cylinder has no opposite sides"},
        // √(m_eff/k_n) with m_eff = ½ · 2230 · π/6 · 0.005³ = 7.297e-5 kg and 1e4 N/m
        Mistake{"time_step = \"5e-5 s\"", "time_step = \"1e-4 s\"", "contact.time_step", "\"1e-4 s\"",
                "is above the bound 1/ω_0 = sqrt(m_eff/k_n) = 8.543e-05 s of the stiffest pair"},
        Mistake{"time_step = \"5e-4 s\"", "time_step = \"5.1e-4 s\"", "fluid.time_step", "\"5.1e-4 s\"",
                "allowed is a whole multiple of contact.time_step = 5e-05 s"},
        Mistake{"time_step = \"5e-4 s\"", "time_step = \"2.5e-5 s\"", "fluid.time_step", "\"2.5e-5 s\"",
                "is 0.5 contact steps"},
        Mistake{"cell_height = \"6.25 mm\"", "cell_height = \"2.4 mm\"", "fluid.cell_height", "\"2.4 mm\"",
                "smaller than half the smallest sphere"},
        Mistake{"cell_height = \"6.25 mm\"", "cell_height = \"2 m\"", "fluid.cell_height", "\"2 m\"",
                "more than the column"},
        Mistake{"cells_across = 8", "cells_across = 21", "fluid.cells_across", "21",
                "gives cells of 0.002381 m, smaller than half the smallest sphere, so that a cell could hold no liquid "
                "at all; allowed are cells of 0.0025 m or more"},
        Mistake{"drag_law = \"gidaspow-1994\"", "drag_law = \"gidaspow\"", "coupling.drag_law", "\"gidaspow\"",
                "unknown drag law; allowed is ergun-1952"},
        Mistake{"drag_law = \"gidaspow-1994\"", "drag_law = \"gidaspow-1994:viscos=180\"", "coupling.drag_law",
                "\"gidaspow-1994:viscos=180\"", "allowed are viscous (0 to 1000, 150 of the source)"},
        Mistake{"smoothing_length = 0", "void_fraction_interval = \"0.15 ms\"", "coupling.void_fraction_interval",
                "\"0.15 ms\"", "allowed is 0 or a whole multiple of fluid.time_step"},
        Mistake{"smoothing_length = 0", "smoothing_length = \"6 cm\"", "coupling.smoothing_length", "\"6 cm\"",
                "spreads a sphere over the whole section; allowed is at most the column's width, 0.05 m"},
        Mistake{"species = \"steel\"", "species = \"lead\"", "stage[2].species", "\"lead\"",
                "no species of that name; allowed is \"glass\", \"steel\""},
        Mistake{"release_height = \"0.997 m\"", "release_height = \"1.0 m\"", "stage[2].release_height", "\"1.0 m\"",
                "would stick out of the column; allowed is 0.003 m to 0.997 m"},
        Mistake{"release_height = \"0.997 m\"", "release_height = \"1 mm\"", "stage[2].release_height", "\"1 mm\"",
                "would stick out of the column"},
        Mistake{"release_height = \"0.997 m\"", "release_height = \"0.19 m\"", "stage[2].release_height", "\"0.19 m\"",
                "would start inside the bed"},
        Mistake{"kind = \"fluidise\"", "kind = \"settle\"", "stage[1].kind", "\"settle\"", "at most one settle"},
        Mistake{"kind = \"fluidise\"", "kind = \"fluidise\"\nsuperficial_velocity = \"0.2 m/s\"",
                "stage[1].superficial_velocity", "\"0.2 m/s\"", "another fluidise stage after this one"},
        Mistake{"drop_interval = \"1 ms\"", "drop_interval = \"1e-5 s\"", "recording.drop_interval", "\"1e-5 s\"",
                "is 0.02 liquid steps; allowed is a whole multiple of fluid.time_step"}));

// --- rules that blame a line other than the one changed --------------------------------------------------------------

/// Message for valid_scene with one change; `{}` of the expectation is the line of `blamed`.
void expect_blame(const std::string& text, const std::string& blamed, const std::string& rest) {
  const std::string message = message_of([&] { parse_scene(text, "scene.toml"); });
  const std::string start = "scene.toml:" + std::to_string(line_of(text, blamed)) + ": " + rest;
  EXPECT_NE(message.find(start), std::string::npos) << message << "\nexpected: " << start;
}

TEST(SceneRules, FluidisationNeedsFlow) {
  expect_blame(replaced(valid_scene, "\"0.06 m/s\"", "0"), "kind = \"fluidise\"",
               "stage[1].kind = \"fluidise\": nothing flows; needed is liquid.superficial_velocity");
}

TEST(SceneRules, DropFollowsFluidisation) {
  expect_blame(replaced(valid_scene, "[[stage]]\nkind = \"fluidise\"\nduration = \"20 s\"\n", ""), "kind = \"drop\"",
               "stage[1].kind = \"drop\": nothing has fluidised the bed yet; needed is a stage of kind = \"fluidise\"");
}

TEST(SceneRules, StagesStandInOrder) {
  const std::string text = replaced(replaced(valid_scene, "\"settle\"", "\"fluidise\""),
                                    "kind = \"fluidise\"\nduration = \"20 s\"", "kind = \"settle\"\nduration = 1");
  expect_blame(text, "kind = \"settle\"",
               "stage[1].kind = \"settle\": comes after \"fluidise\"; allowed is at most one");
}

TEST(SceneRules, CentroidSchemeNeedsCellsOfTheLargestSphere) {
  std::string text = replaced(valid_scene, "exact-overlap", "centroid");
  EXPECT_NO_THROW(parse_scene(text, "scene.toml"));
  text = replaced(text, "cells_across = 8", "cells_across = 10");
  expect_blame(text, "cells_across",
               "fluid.cells_across = 10: gives cells of 0.005 m, smaller than the largest sphere, which the centroid "
               "scheme puts into one cell as a whole; allowed are cells of 0.006 m or more");
}

TEST(SceneRules, PeriodicBoxHasRoomForTwoSpheres) {
  std::string text = replaced(valid_scene, "shape = \"cylinder\"\ndiameter = \"50 mm\"",
                              "shape = \"box\"\nwidth = [\"200 mm\", \"11 mm\"]");
  text = replaced(text, "cells_across = 8", "cells_across = 20");
  EXPECT_NO_THROW(parse_scene(text, "scene.toml"));
  expect_blame(
      replaced(text, "no-slip", "periodic"), "diameter = \"6 mm\"",
      "species[1].diameter = \"6 mm\": the sphere does not fit between the walls; allowed is less than 0.0055 m "
      "(half of geometry.width)");
}

TEST(SceneRules, MissingKeysAreReportedAtTheirTable) {
  expect_blame(replaced(valid_scene, "height = \"1.0 m\"\n", ""), "[geometry]",
               "geometry.height: missing; needed is a length, for example \"50 mm\", or a bare number in m");
  expect_blame(replaced(valid_scene, "density = \"7800 kg/m3\"\n", ""), "[[species]]\nname = \"steel\"",
               "species[1].density: missing");
  expect_blame(replaced(valid_scene, "species = \"steel\"\n", ""), "[[stage]]\nkind = \"drop\"",
               "stage[2].species: missing");
}

TEST(SceneRules, MissingTablesAreReported) {
  const std::string message = message_of([] { parse_scene("title = \"nothing\"\n", "scene.toml"); });
  for (const char* part : {"scene.toml: geometry.shape: missing", "scene.toml: liquid.density: missing",
                           "scene.toml: fluid.tier: missing", "scene.toml: contact.stiffness: missing",
                           "scene.toml: species: missing; needed is at least one table, written [[species]]",
                           "scene.toml: stage: missing; needed is at least one table, written [[stage]]"}) {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
}

TEST(SceneRules, AllProblemsOfAKindAreReportedAtOnce) {
  const std::string text =
      replaced(replaced(valid_scene, "restitution = 0.9", "restitution = 2"), "seed = 7", "seed = 7\nsede = 8");
  EXPECT_NE(message_of([&] { parse_scene(text, "scene.toml"); }).find("sede"), std::string::npos);
  const std::string ranges = replaced(replaced(valid_scene, "restitution = 0.9", "restitution = 2"),
                                      "density = \"7800 kg/m3\"", "density = -1");
  const std::string message = message_of([&] { parse_scene(ranges, "scene.toml"); });
  EXPECT_NE(message.find("contact.restitution = 2"), std::string::npos) << message;
  EXPECT_NE(message.find("species[1].density = -1"), std::string::npos) << message;
}

TEST(SceneRules, BrokenTomlIsReportedWithLineAndColumn) {
  const std::string text = replaced(valid_scene, "seed = 7", "seed = = 7");
  EXPECT_EQ(message_of([&] { parse_scene(text, "scene.toml"); }).rfind("scene.toml:2:8: not valid TOML", 0), 0U);
}

TEST(SceneRules, DuplicateKeyIsAnError) {
  const std::string text = replaced(valid_scene, "seed = 7", "seed = 7\nseed = 8");
  EXPECT_EQ(message_of([&] { parse_scene(text, "scene.toml"); }).rfind("scene.toml:3:", 0), 0U);
}

TEST(SceneRules, UnreadableFileIsNamed) {
  EXPECT_NE(message_of([] { load_scene("no/such/scene.toml"); }).find("no/such/scene.toml: cannot be read"),
            std::string::npos);
}

// A slip of a unit: 8 x 8 cells by 1.6e9 layers.
TEST(SceneRules, GridBeyondMemoryIsReportedAtItsCells) {
  const std::string message = message_of([] { parse_scene(valid_scene, "scene.toml", {"geometry.height=1e7"}); });
  EXPECT_NE(message.find("fluid.cell_height = \"6.25 mm\": makes 1.02e+11 cells of the column; allowed are 1e+08"),
            std::string::npos)
      << message;
}

TEST(SceneRules, EmptyFileIsNamed) {
  const auto file = std::filesystem::path(testing::TempDir()) / "slfb_empty_scene.toml";
  std::ofstream(file).close();
  EXPECT_NE(message_of([&] { load_scene(file); }).find("slfb_empty_scene.toml: is empty"), std::string::npos);
  std::filesystem::remove(file);
}

// Editors of other systems: line ends of two characters, a byte order mark.
TEST(SceneFile, LineEndsAndByteOrderMarkChangeNothing) {
  std::string text = "\xef\xbb\xbf";
  for (const char character : valid_scene) text += character == '\n' ? std::string("\r\n") : std::string(1, character);
  EXPECT_EQ(scene_hash(parse_scene(text, "scene.toml")), scene_hash(parse_scene(valid_scene, "scene.toml")));
}

TEST(SceneRules, LargeContactStepCanBeAllowed) {
  std::string text = replaced(valid_scene, "time_step = \"5e-5 s\"", "time_step = \"1e-4 s\"");
  EXPECT_THROW(parse_scene(text, "scene.toml"), SceneError);
  text = replaced(text, "[coupling]", "allow_large_time_step = true\n[coupling]");
  EXPECT_NO_THROW(parse_scene(text, "scene.toml"));
}

TEST(SceneRules, HoldForScenesChangedInMemory) {
  Scene scene = parse_scene(valid_scene, "scene.toml");
  EXPECT_NO_THROW(validate_scene(scene));
  scene.species[1].density = -1.0;
  EXPECT_EQ(message_of([&] { validate_scene(scene); }),
            "scene: species[1].density = -1 kg/m3: out of range; allowed is greater than zero");
  scene.species.clear();
  EXPECT_NE(message_of([&] { validate_scene(scene); }).find("scene: species = []: is missing"), std::string::npos);
}

// --- values ----------------------------------------------------------------------------------------------------------

TEST(SceneFile, ReadsEveryValueInSi) {
  const Scene scene = parse_scene(valid_scene, "scene.toml");
  EXPECT_EQ(scene.title, "a bed and a sphere");
  EXPECT_EQ(scene.seed, 7U);
  EXPECT_EQ(scene.geometry.diameter, 0.05);
  EXPECT_EQ(scene.liquid.viscosity, 1e-3);
  EXPECT_EQ(scene.fluid.tier, FluidTier::three_dimensional);
  EXPECT_EQ(scene.fluid.cells_across, 8);
  EXPECT_EQ(scene.contact.stiffness, 1e4);
  EXPECT_EQ(scene.coupling.void_fraction, VoidFractionScheme::exact_overlap);
  ASSERT_EQ(scene.species.size(), 2U);
  EXPECT_EQ(scene.species[1].diameter, 6e-3);
  EXPECT_EQ(scene.species[1].count, 0);
  ASSERT_EQ(scene.stages.size(), 3U);
  EXPECT_EQ(scene.stages[2].kind, StageKind::drop);
  EXPECT_EQ(scene.stages[2].release_height, 0.997);
  EXPECT_EQ(scene.recording.drop_interval, 1e-3);
}

// Runs from before coupling.own_volume had their spheres' volume counted: the text in their results says so by saying
// nothing, and their names stay. A scene of today that says nothing has its lone spheres' volume spread.
TEST(SceneFile, OwnVolumeOfRunsFromBeforeTheKeyIsCounted) {
  const Scene today = parse_scene(valid_scene, "scene.toml"), before = parse_archived_scene(valid_scene, "result"),
              said = parse_scene(valid_scene, "scene.toml", {"coupling.own_volume=counted"});
  EXPECT_EQ(today.coupling.own_volume, OwnVolume::spread_where_alone);
  EXPECT_EQ(before.coupling.own_volume, OwnVolume::counted);
  EXPECT_EQ(scene_hash(before), scene_hash(said));
  EXPECT_NE(scene_hash(before), scene_hash(today));
  for (const Scene& scene : {today, before})
    EXPECT_EQ(scene_hash(parse_scene(canonical_toml(scene), "canonical")), scene_hash(scene));
}

// The numbers of particles of Peng 2014: 0.5255 kg at 2230 kg/m³ is 16 668 spheres of 3 mm and 3600 of 5 mm.
TEST(SceneFile, TotalMassIsTheWholeSpheresItPaysFor) {
  EXPECT_EQ(parse_scene(valid_scene, "scene.toml").species[0].count, 3600);
  const Overrides three_millimetres{"species[0].diameter=3 mm", "contact.time_step=2.5e-5 s"};
  EXPECT_EQ(parse_scene(valid_scene, "scene.toml", three_millimetres).species[0].count, 16668);
}

TEST(SceneFile, BoundIsThatOfTheLightestPair) {
  const double glass = 2230.0 * std::numbers::pi / 6.0 * std::pow(5e-3, 3);
  const double steel = 7800.0 * std::numbers::pi / 6.0 * std::pow(6e-3, 3);
  Scene scene = parse_scene(valid_scene, "scene.toml");
  EXPECT_DOUBLE_EQ(contact_time_step_bound(scene), std::sqrt(glass / 2.0 / 1e4));
  scene.species[0].count = 1;  // one glass sphere meets only the steel sphere and the walls
  EXPECT_DOUBLE_EQ(contact_time_step_bound(scene), std::sqrt(glass * steel / (glass + steel) / 1e4));
  scene.species[0].count = 0;  // the steel sphere alone meets only the walls
  EXPECT_DOUBLE_EQ(contact_time_step_bound(scene), std::sqrt(steel / 1e4));
}

// At rest in a packed bed Gidaspow's law is the viscous part of Ergun's, β = 150 (1-ε)² μ/(ε d²), and
// ρ dv/dt = -β v/(1-ε).
TEST(PackedRelaxationTime, IsThatOfErgunsPackedBed) {
  const Scene scene =
      parse_scene(valid_scene, "scene.toml", {"liquid.viscosity=1.4", "coupling.drag_law=gidaspow-1994"});
  const double expected = 2230.0 * 0.4 * 0.005 * 0.005 / (150.0 * 0.6 * 1.4);
  EXPECT_NEAR(coupling::packed_relaxation_time(scene, find_drag_law(scene.coupling.drag_law)), expected,
              1e-4 * expected);
}

TEST(SceneFile, QuiescentTierNeedsNoFluidNumerics) {
  const Scene scene = parse_scene(R"(
geometry = {shape = "box", width = ["50 mm", "50 mm"], height = 0.5}
liquid = {density = 1000, viscosity = 1e-3, superficial_velocity = 0}
fluid = {tier = "quiescent"}
contact = {stiffness = 1e3, time_step = 1e-4}
species = [{name = "steel", diameter = "6 mm", density = 7800}]
stage = [{kind = "drop", species = "steel", duration = 5, release_height = 0.4}]
)",
                                  "scene.toml");
  EXPECT_EQ(scene.fluid.time_step, scene.contact.time_step);
  EXPECT_EQ(scene.fluid.cell_height, 0.012);
}

// --- overrides -------------------------------------------------------------------------------------------------------

TEST(SceneOverride, ReplacesAValueOfAnyType) {
  const Scene scene =
      parse_scene(valid_scene, "scene.toml",
                  {"contact.stiffness=1e3 N/m", "stage[2].repetitions=5", "species[0].density = 2300 kg/m3",
                   "coupling.drag_law=di-felice-1994", "fluid.convection=\"upwind\"",
                   "contact.allow_large_time_step=true", "recording.bed_interval=0.02"});
  EXPECT_EQ(scene.contact.stiffness, 1e3);
  EXPECT_EQ(scene.stages[2].repetitions, 5);
  EXPECT_EQ(scene.species[0].density, 2300.0);
  EXPECT_EQ(scene.species[0].count, 3490);  // the mass stays, its spheres are heavier
  EXPECT_EQ(scene.coupling.drag_law, "di-felice-1994");
  EXPECT_EQ(scene.fluid.convection, ConvectionScheme::upwind);
  EXPECT_TRUE(scene.contact.allow_large_time_step);
  EXPECT_EQ(scene.recording.bed_interval, 0.02);
}

TEST(SceneOverride, AWholeNumberMayBeWrittenWithAnExponent) {
  EXPECT_EQ(parse_scene(valid_scene, "scene.toml", {"seed=1e3"}).seed, 1000U);
  EXPECT_EQ(scene_hash(parse_scene(valid_scene, "scene.toml", {"seed=8.0"})),
            scene_hash(parse_scene(valid_scene, "scene.toml", {"seed=8"})));
}

TEST(SceneOverride, LastOneHolds) { EXPECT_EQ(parse_scene(valid_scene, "scene.toml", {"seed=3", "seed=4"}).seed, 4U); }

TEST(SceneOverride, OfTheNumberReplacesTheMass) {
  EXPECT_EQ(parse_scene(valid_scene, "scene.toml", {"species[0].count=100"}).species[0].count, 100);
}

struct WrongOverride {
  std::string text;
  std::string message;
};

std::ostream& operator<<(std::ostream& out, const WrongOverride& change) { return out << change.text; }

class WrongOverrides : public testing::TestWithParam<WrongOverride> {};

TEST_P(WrongOverrides, AreNamed) {
  const std::string message = message_of([&] { parse_scene(valid_scene, "scene.toml", {GetParam().text}); });
  EXPECT_EQ(message.rfind("--set " + GetParam().text + ": ", 0), 0U) << message;
  EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Scene, WrongOverrides,
    testing::Values(WrongOverride{"contact.stifness=1e3", "unknown key (did you mean \"stiffness\"?)"},
                    WrongOverride{"contacts.stiffness=1e3", "unknown key (did you mean \"contact\"?)"},
                    WrongOverride{"contact.stiffness=1e3 kg", "needed is a stiffness"},
                    WrongOverride{"contact.restitution=1.5", "contact.restitution = 1.5: out of range"},
                    WrongOverride{"geometry.height=0.1", "the bed does not fit into the column"},
                    WrongOverride{"stage[3].duration=1", "the scene has 3 [[stage]], counted from 0"},
                    WrongOverride{"stage.duration=1", "\"stage\" is not a table"},
                    WrongOverride{"stage[x].duration=1", "the index in the key is not [0], [1]"},
                    WrongOverride{"stage[2]=1", "the key names a whole table"},
                    WrongOverride{"geometry=5", "wrong type; allowed is a table"},
                    WrongOverride{"contact.stiffness", "no \"=\""}, WrongOverride{"=5", "an empty part"},
                    WrongOverride{"contact..stiffness=1", "an empty part"},
                    WrongOverride{"contact.=1", "an empty part"}));

// --- canonical text and hash -----------------------------------------------------------------------------------------

TEST(CanonicalToml, ReadsBackAsTheSameScene) {
  Scene scene = parse_scene(valid_scene, "scene.toml");
  scene.title = "\"quoted\"\n'both', µ and \\";
  scene.liquid.superficial_velocity = 0.1 + 0.2;  // seventeen digits
  scene.contact.tangential_stiffness_ratio = 2.0 / 7.0;
  const std::string text = canonical_toml(scene);
  const Scene back = parse_scene(text, "canonical");
  EXPECT_EQ(canonical_toml(back), text);
  EXPECT_EQ(back.title, scene.title);
  EXPECT_EQ(back.liquid.superficial_velocity, scene.liquid.superficial_velocity);
  EXPECT_EQ(scene_hash(back), scene_hash(scene));
}

TEST(CanonicalToml, ReadsBackForABox) {
  const Scene scene = parse_scene(replaced(valid_scene, "shape = \"cylinder\"\ndiameter = \"50 mm\"",
                                           "shape = \"box\"\nwidth = [\"50 mm\", \"40 mm\"]"),
                                  "scene.toml");
  EXPECT_EQ(scene.geometry.width, (std::array{0.05, 0.04}));
  EXPECT_EQ(canonical_toml(parse_scene(canonical_toml(scene), "canonical")), canonical_toml(scene));
}

TEST(SceneHash, IsSixteenHexadecimalDigits) {
  EXPECT_TRUE(std::regex_match(scene_hash(parse_scene(valid_scene, "a")), std::regex("[0-9a-f]{16}")));
}

TEST(SceneHash, DoesNotDependOnWording) {
  std::string text = replaced(valid_scene, "\"a bed and a sphere\"", "\"another title\"  # and a comment");
  text = replaced(text, "\"50 mm\"", "0.05");
  text = replaced(text, "\"1.0 mPa s\"", "\"0.01 poise\"");
  text = replaced(text, "\"998.2 kg/m3\"", "\"0.9982 g/cm3\"");
  text = replaced(text, "\"6.25 mm\"", "\"6250 µm\"");
  text = replaced(text, "\"5e-5 s\"", "\"0.05 ms\"");
  text = replaced(text, "total_mass = \"0.5255 kg\"", "count = 3600");
  text = replaced(text, "meshing_pieces = 1214\nsmoothing_length = 0\n", "");  // the defaults
  EXPECT_EQ(scene_hash(parse_scene(text, "b.toml")), scene_hash(parse_scene(valid_scene, "a.toml")));
}

TEST(SceneHash, DependsOnEveryValue) {
  const std::vector<std::string> changes{"seed=8",
                                         "geometry.diameter=51 mm",
                                         "geometry.height=1.1 m",
                                         "liquid.density=998.3",
                                         "liquid.viscosity=1.1e-3",
                                         "liquid.superficial_velocity=0.07",
                                         "fluid.tier=one-dimensional",
                                         "fluid.wall=slip",
                                         "fluid.cells_across=7",
                                         "fluid.cell_height=7 mm",
                                         "fluid.convection=upwind",
                                         "fluid.pressure_velocity=simple",
                                         "fluid.time_step=1e-3",
                                         "fluid.pressure_tolerance=1e-7",
                                         "fluid.simple_tolerance=1e-6",
                                         "contact.stiffness=1.1e4",
                                         "contact.restitution=0.91",
                                         "contact.sliding_friction=0.31",
                                         "contact.rolling_friction=0.02",
                                         "contact.tangential_stiffness_ratio=0.3",
                                         "contact.tangential_damping_ratio=0.6",
                                         "contact.time_step=2.5e-5",
                                         "coupling.drag_law=wen-yu-1966",
                                         "coupling.drag_law=gidaspow-1994:viscous=180",
                                         "coupling.void_fraction=particle-meshing",
                                         "coupling.meshing_pieces=1000",
                                         "coupling.void_fraction_interval=2 ms",
                                         "coupling.smoothing_length=3 mm",
                                         "contact.tangential_model=dashpot",
                                         "contact.tangential_model=spring",
                                         "wall.stiffness=9e3",
                                         "wall.restitution=0.9",
                                         "wall.sliding_friction=0.3",
                                         "wall.rolling_friction=0.0175",
                                         "outlet.particles=remove",
                                         "start.arrangement=random",
                                         "start.arrangement=random-close",
                                         "stage[0].dry=true",
                                         "species[0].diameter=4.9 mm",
                                         "species[0].density=2300",
                                         "species[0].count=3599",
                                         "species[1].diameter=5 mm",
                                         "species[1].density=7801",
                                         "stage[0].duration=1",
                                         "stage[1].duration=1",
                                         "stage[2].species=glass",
                                         "stage[2].repetitions=2",
                                         "stage[2].release_height=0.9",
                                         "stage[2].duration=1",
                                         "stage[2].relaxation=2",
                                         "recording.bed_interval=0.02",
                                         "recording.drop_interval=0.002",
                                         "recording.snapshot_interval=2",
                                         R"(recording.fluctuation_window=["0.1 m", "0.3 m"])"};
  std::set<std::string> hashes{scene_hash(parse_scene(valid_scene, "scene.toml"))};
  for (const std::string& change : changes) {
    Overrides overrides{change};
    if (change == "stage[2].species=glass") overrides.emplace_back("species[1].count=1");
    EXPECT_TRUE(hashes.insert(scene_hash(parse_scene(valid_scene, "scene.toml", overrides))).second) << change;
  }
}

// A key that is newer than the runs that are kept leaves their names as they are.
TEST(SceneHash, KeysThatAreLeftOutAtTheirDefaultsKeepTheName) {
  const Scene before = parse_scene(valid_scene, "scene.toml");
  const auto with = [](const std::string& heights) {
    return parse_scene(valid_scene, "scene.toml", {"recording.fluctuation_window=" + heights});
  };
  EXPECT_EQ(canonical_toml(before).find("fluctuation_window"), std::string::npos);
  EXPECT_EQ(canonical_toml(with(R"(["10 cm", "20 cm"])")), canonical_toml(before));
  const Scene higher = with(R"(["0.3 m", "0.4 m"])");
  EXPECT_EQ(higher.recording.fluctuation_window, (std::array{0.3, 0.4}));
  EXPECT_EQ(parse_scene(canonical_toml(higher), "canonical").recording.fluctuation_window, (std::array{0.3, 0.4}));
  EXPECT_THROW(with(R"(["0.2 m", "0.1 m"])"), SceneError);
  EXPECT_THROW(with(R"(["-0.1 m", "0.1 m"])"), SceneError);
}

TEST(SceneHash, KeysOfTheStartAreLeftOutAtTheirDefaults) {
  const Scene before = parse_scene(valid_scene, "scene.toml");
  const Scene same = parse_scene(valid_scene, "scene.toml", {"start.arrangement=lattice", "stage[0].dry=false"});
  EXPECT_EQ(canonical_toml(same), canonical_toml(before));
  EXPECT_EQ(canonical_toml(before).find("start"), std::string::npos);
  EXPECT_EQ(canonical_toml(before).find("dry"), std::string::npos);
  const Scene random = parse_scene(valid_scene, "scene.toml", {"start.arrangement=random-close", "stage[0].dry=true"});
  const Scene back = parse_scene(canonical_toml(random), "canonical");
  EXPECT_EQ(back.start.arrangement, Arrangement::random_close);
  EXPECT_TRUE(back.stages[0].dry);
}

// Walls of their own.
TEST(SceneHash, WallsAreWrittenWhereTheyDiffer) {
  const Scene before = parse_scene(valid_scene, "scene.toml");
  EXPECT_EQ(canonical_toml(before).find("[wall]"), std::string::npos);
  EXPECT_EQ(canonical_toml(before).find("tangential_model"), std::string::npos);
  const Scene walls = parse_scene(valid_scene, "scene.toml",
                                  {"wall.stiffness=5e3 N/m", "wall.restitution=0.5", "wall.sliding_friction=0",
                                   "wall.rolling_friction=0.01", "contact.tangential_model=dashpot"});
  const Scene back = parse_scene(canonical_toml(walls), "canonical");
  const Contact at_wall = back.contact.at_wall();
  EXPECT_EQ(at_wall.stiffness, 5e3);
  EXPECT_EQ(at_wall.restitution, 0.5);
  EXPECT_EQ(at_wall.sliding_friction, 0.0);
  EXPECT_EQ(at_wall.rolling_friction, 0.01);
  EXPECT_EQ(at_wall.time_step, before.contact.time_step);
  EXPECT_EQ(back.contact.stiffness, 1e4);
  EXPECT_EQ(back.contact.tangential_model, TangentialModel::dashpot);
  EXPECT_EQ(scene_hash(back), scene_hash(walls));
}

TEST(SceneRules, WallsTakeTheKeysOfTheLaw) {
  const auto blame = [](const Overrides& overrides) {
    return message_of([&] { parse_scene(valid_scene, "scene.toml", overrides); });
  };
  EXPECT_NE(blame({"wall.youngs_modulus=1e9"})
                .find("wall.youngs_modulus = 1000000000: has no meaning here; it belongs to law = "
                      "\"hertz\""),
            std::string::npos)
      << blame({"wall.youngs_modulus=1e9"});
  EXPECT_NE(blame({"wall.restitution=1.5"}).find("wall.restitution = 1.5: out of range"), std::string::npos);
  EXPECT_NE(blame({"wall.sliding_friction=nan"}).find("wall.sliding_friction = nan: out of range"), std::string::npos)
      << blame({"wall.sliding_friction=nan"});
  const Overrides hertz{"contact.law=hertz", "contact.youngs_modulus=1e7", "contact.time_step=1e-5"};
  Overrides stiff_wall = hertz, rigid = hertz;
  stiff_wall.emplace_back("wall.youngs_modulus=2e7");
  EXPECT_NO_THROW(parse_scene(valid_scene, "scene.toml", stiff_wall));
  rigid.insert(rigid.end(), {"contact.rigid_walls=true", "wall.poisson_ratio=0.3"});
  EXPECT_NE(blame(rigid).find("wall.poisson_ratio = 0.3: has no meaning here; contact.rigid_walls = true"),
            std::string::npos)
      << blame(rigid);
}

// One sphere that meets nothing but walls: 1/ω_0 = sqrt(m/k).
TEST(SceneRules, AStiffWallBoundsTheContactStep) {
  Scene scene = parse_scene(valid_scene, "scene.toml");
  scene.species.resize(1);
  scene.species[0].count = 1;
  scene.stages.resize(1);
  const double mass = scene.species[0].mass();
  EXPECT_NEAR(contact_time_step_bound(scene), std::sqrt(mass / 1e4), 1e-15);
  scene.contact.wall.stiffness = 1e6;
  EXPECT_NEAR(contact_time_step_bound(scene), std::sqrt(mass / 1e6), 1e-15);
  const std::string message = message_of([] {
    parse_scene(valid_scene, "scene.toml", {"wall.stiffness=1e6", "species[0].count=1"});
  });
  EXPECT_NE(message.find("allowed is at most that, a softer contact.stiffness or wall.stiffness"), std::string::npos)
      << message;
}

TEST(SceneRules, OnlyOneTangentialElementHasOneRatio) {
  const std::string spring = replaced(valid_scene, "tangential_damping_ratio = 0.5", "tangential_model = \"spring\"");
  EXPECT_EQ(parse_scene(spring, "scene.toml").contact.tangential_model, TangentialModel::spring);
  const std::string both = replaced(valid_scene, "tangential_damping_ratio = 0.5",
                                    "tangential_damping_ratio = 0.5\ntangential_model = \"spring\"");
  EXPECT_NE(message_of([&] {
              parse_scene(both, "scene.toml");
            }).find("contact.tangential_damping_ratio = 0.5: has no meaning here; there is no dashpot"),
            std::string::npos);
  // An override takes the other's ratio out of the file.
  EXPECT_NO_THROW(parse_scene(valid_scene, "scene.toml", {"contact.tangential_model=spring"}));
}

TEST(SceneRules, ABedThatFloatsIsNotFluidised) {
  const Overrides light{"species[0].density=600"};
  const std::string message = message_of([&] { parse_scene(valid_scene, "scene.toml", light); });
  EXPECT_NE(message.find("stage[1].kind = \"fluidise\": the bed is lighter than the liquid"), std::string::npos)
      << message;
}

TEST(SceneRules, OnlySettlingIsDry) {
  EXPECT_NE(message_of([] {
              parse_scene(valid_scene, "scene.toml", {"stage[1].dry=true"});
            }).find("stage[1].dry = true: has no meaning here; it belongs to kind = \"settle\""),
            std::string::npos);
}

// A column of which more is solid than a lattice or random addition can fill.
TEST(SceneRules, AStartNeedsRoom) {
  const std::vector<std::string> crowded{"geometry.height=0.31 m", "stage[2].release_height=0.3 m"};
  EXPECT_NE(message_of([&] {
              parse_scene(valid_scene, "scene.toml", crowded);
            }).find("geometry.height = \"0.31 m\": 3600 spheres do not fit loosely into the column"),
            std::string::npos);
  std::vector<std::string> random = crowded;
  random.emplace_back("start.arrangement=random");
  EXPECT_NE(message_of([&] { parse_scene(valid_scene, "scene.toml", random); })
                .find("start.arrangement=random: start.arrangement = \"random\": spheres put at random into the column "
                      "end at a solid fraction of 0.38, and the bed needs 0.387"),
            std::string::npos)
      << message_of([&] { parse_scene(valid_scene, "scene.toml", random); });
}

}  // namespace
}  // namespace slfb
