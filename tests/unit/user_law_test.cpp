// A law from outside the suite: compiled, loaded, and the same to the solver as a law of the suite.

#include "solver/laws/user_law.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "correlations/drag/wen_yu_1966.hpp"
#include "experiments/runs/run_campaign.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/support/folders.hpp"
#include "tests/unit/user_law_files.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

class UserLaw : public UserLawFiles {
 protected:
  static std::string error_of(const std::string& law) {
    try {
      find_drag_law(law);
    } catch (const std::runtime_error& error) {  // UserLawError is one
      return error.what();
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }
};

// Below Re = 1000 the template is Wen and Yu's law, written by other hands; the derivative is that of its formula.
TEST_F(UserLaw, TheTemplateIsALaw) {
  const auto law = find_drag_law(file("mine.cpp", law_template("drag")));
  EXPECT_EQ(law.info.name, "my-law");
  const drag::WenYu1966 same;
  for (const double voidage : {0.4, 0.7, 1.0}) {
    for (const double reynolds : {0.0, 0.3, 40.0, 900.0}) {
      const drag::SuspensionFlow flow{voidage, reynolds};
      EXPECT_NEAR(law(flow), same(flow), 1e-12 * same(flow));
      double slope = 0.0;
      law.slip_derivative(&voidage, &reynolds, &slope, 1);
      const double exact = (1.0 + 1.687 * 0.15 * std::pow(reynolds, 0.687)) * std::pow(voidage, -3.65);
      EXPECT_NEAR(slope, exact, 1e-12 * exact);
    }
  }
}

TEST_F(UserLaw, ALawForDoublesOnlyHasItsDerivativeFromDifferences) {
  std::string text = replaced(law_template("drag"), "template <class Number = double>", "");
  text = replaced(text, "Number operator()(drag::SuspensionFlowOf<Number> flow)",
                  "double operator()(drag::SuspensionFlow flow)");
  text = replaced(text, "const Number one_sphere", "const double one_sphere");
  text = replaced(text, "Number(1.0)", "1.0");
  const auto law = find_drag_law(file("mine.cpp", text));
  for (const double reynolds : {0.3, 900.0}) {
    const double voidage = 0.6;
    double slope = 0.0;
    law.slip_derivative(&voidage, &reynolds, &slope, 1);
    const double exact = (1.0 + 1.687 * 0.15 * std::pow(reynolds, 0.687)) * std::pow(voidage, -3.65);
    EXPECT_NEAR(slope, exact, 1e-8 * exact);
  }
}

TEST_F(UserLaw, ABrokenFileGivesTheCompilersMessageAndAHint) {
  const std::string broken =
      file("broken.cpp", replaced(law_template("drag"), "return one_sphere", "return one_spehre"));
  const std::string message = error_of(broken);
  EXPECT_NE(message.find("broken.cpp does not compile"), std::string::npos) << message;
  EXPECT_NE(message.find("one_spehre"), std::string::npos) << message;
  EXPECT_NE(message.find("Hint: "), std::string::npos) << message;
  EXPECT_NE(message.find("slfb compare --template drag"), std::string::npos) << message;
}

TEST_F(UserLaw, AFormulaThatDualsCannotFollowIsExplained) {
  const std::string stiff = file("stiff.cpp", replaced(law_template("drag"), "0.15 * pow(flow.reynolds",
                                                       "0.15 * std::tanh(flow.reynolds) * pow(flow.reynolds"));
  EXPECT_NE(error_of(stiff).find("carry their derivative"), std::string::npos);
}

TEST_F(UserLaw, AFileThatHandsNoLawOverIsRefused) {
  const std::string message = error_of(file("silent.cpp", replaced(law_template("drag"), "SLFB_DRAG_LAW(MyLaw)", "")));
  EXPECT_NE(message.find("SLFB_DRAG_LAW"), std::string::npos) << message;
  EXPECT_NE(error_of((folder_ / "none.cpp").string()).find("cannot be read"), std::string::npos);
}

TEST_F(UserLaw, ItsNameIsItsOwn) {
  EXPECT_NE(
      error_of(file("twin.cpp", replaced(law_template("drag"), "my-law", "wen-yu-1966"))).find("law of the suite"),
      std::string::npos);
  EXPECT_NE(error_of(file("loud.cpp", replaced(law_template("drag"), "my-law", "My Law"))).find("lower-case"),
            std::string::npos);
}

class UserLawInAScene : public UserLaw {
 protected:
  static Scene sphere(const std::string& law) {
    return load_run_scene(
        {"sphere", 0.0, "", source_folder() / "experiments/scenes/single_sphere.toml", {"coupling.drag_law=" + law}});
  }
};

TEST_F(UserLawInAScene, TheNameOfTheRunIsThatOfTheFormula) {
  const std::string here = file("here.cpp", law_template("drag")), there = file("there.cpp", law_template("drag"));
  const std::string changed = file("changed.cpp", replaced(law_template("drag"), "0.15 *", "0.16 *"));
  EXPECT_EQ(scene_hash(sphere(here)), scene_hash(sphere(there)));
  EXPECT_NE(scene_hash(sphere(here)), scene_hash(sphere(changed)));
}

TEST_F(UserLawInAScene, AnIncludedFileCounts) {
  const std::string text =
      replaced(law_template("drag"), "#include <cmath>", "#include <cmath>\n#include \"constant.hpp\"");
  const std::string law = file("mine.cpp", replaced(text, "0.15 *", "constant *"));
  const std::string constant = file("constant.hpp", "inline constexpr double constant = 0.15;\n");
  const std::string before = scene_hash(sphere(law));
  EXPECT_EQ(file("constant.hpp", "inline constexpr double constant = 0.16;\n"), constant);
  EXPECT_NE(scene_hash(sphere(law)), before);
}

TEST_F(UserLawInAScene, ABrokenFileIsAnErrorOfTheScene) {
  const std::string broken = file("broken.cpp", "int main() { return }\n");
  try {
    sphere(broken);
    FAIL() << "the scene was taken";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("coupling.drag_law"), std::string::npos) << message;
    EXPECT_NE(message.find("does not compile"), std::string::npos) << message;
  }
}

// The suite's own law in the user's clothes: the fall is the same to the last bit.
TEST_F(UserLawInAScene, ASimulationCannotTellItFromTheSuitesLaw) {
  const std::string wrapped = file("wrapped.cpp",
                                   "#include \"correlations/drag/drag_law_kernels.hpp\"\n"
                                   "#include \"correlations/drag/wen_yu_1966.hpp\"\n"
                                   "namespace {\n"
                                   "struct Wrapped : slfb::drag::WenYu1966 {\n"
                                   "  static constexpr slfb::LawInfo info = [] {\n"
                                   "    slfb::LawInfo changed = slfb::drag::WenYu1966::info;\n"
                                   "    changed.name = \"wrapped\";\n"
                                   "    return changed;\n"
                                   "  }();\n"
                                   "};\n"
                                   "}\n"
                                   "SLFB_DRAG_LAW(Wrapped)\n");
  const Scene ours = sphere("wen-yu-1966"), theirs = sphere(wrapped);
  const CampaignOutcome outcome = run_scenes({{"ours", ours}, {"theirs", theirs}},
                                             {.out = folder_, .jobs = 1, .threads_per_run = 1, .progress = false});
  ASSERT_EQ(outcome.finished, 2);
  const RunResult one = load_result(result_file(folder_, scene_hash(ours)));
  const RunResult other = load_result(result_file(folder_, scene_hash(theirs)));
  ASSERT_FALSE(one.drops.empty());
  EXPECT_EQ(one.drops[0].z, other.drops[0].z);
  EXPECT_EQ(one.drops[0].bottom_time, other.drops[0].bottom_time);
  EXPECT_TRUE(fs::exists(run_directory(folder_, scene_hash(theirs)) / "drag_law.cpp"));
}

/// What a run with this law fails with.
std::string failure_with(const Scene& scene, const fs::path& out) {
  const CampaignOutcome outcome =
      run_scenes({{"run", scene}}, {.out = out, .jobs = 1, .threads_per_run = 2, .progress = false});
  return outcome.failures.empty() ? "finished" : outcome.failures.front();
}

TEST_F(UserLawInAScene, WhatALawDoesWrongIsSaidOfTheLaw) {
  const std::string law = "#include <stdexcept>\n" + law_template("drag"),
                    formula = "return one_sphere * pow(flow.voidage, -exponent);";
  const auto expect = [&](const std::string& name, const std::string& body, const std::string& part) {
    const std::string source = file(name, replaced(law, formula, body));
    const std::string message = failure_with(sphere(source), folder_);
    EXPECT_NE(message.find("my-law (" + source + ")"), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find("time_step"), std::string::npos) << message;
  };
  expect("log.cpp", "return one_sphere + (1.0 - flow.voidage) * std::log(1.0 - flow.voidage);",
         "nan times Stokes drag at a voidage of 1 ");
  expect("negative.cpp", "return -1.0 * one_sphere;", "gives -");
  expect("throws.cpp", "if (flow.voidage > 0.1) throw std::runtime_error(\"no drag here\"); return one_sphere;",
         "fails: no drag here");
  expect("number.cpp", "if (flow.voidage > 0.1) throw 1; return one_sphere;", "throws something");
}

// F of the template is (1 + 0.15 Re^0.687) ε^−n with n = 3.65, which it declares as a parameter.
TEST_F(UserLaw, DeclaresParametersOfItsOwn) {
  const std::string source = file("mine.cpp", law_template("drag"));
  const drag::DragLawKernels usual = find_drag_law(source), other = find_drag_law(source + ":exponent=2.65");
  EXPECT_EQ(other.info.name, "my-law:exponent=2.65");
  for (const double voidage : {0.4, 0.7, 1.0})
    EXPECT_NEAR(other({voidage, 50.0}) / usual({voidage, 50.0}), voidage, 1e-14);
  EXPECT_NE(error_of(source + ":power=2").find("exponent (0 to 10, 3.65 of the source)"), std::string::npos);
}

TEST_F(UserLaw, WhatCannotBeALawIsSaidSoon) {
  const std::string law = law_template("drag"), formula = "return one_sphere * pow(flow.voidage, -exponent);";
  const auto expect = [&](const std::string& source, const std::string& part) {
    const std::string message = error_of(source);
    EXPECT_NE(message.find(source), std::string::npos) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  };
  expect(file("endless.cpp", replaced(law, formula, "for (volatile int k = 0;; k = k) {} return one_sphere;")),
         "does not end within");
  expect(file("crash.cpp", replaced(law, formula, "__builtin_abort(); return one_sphere;")), "ends with signal");
  // A line as long as no pattern matcher likes it.
  EXPECT_EQ(error_of(file("blanks.cpp", law + "//" + std::string(400'000, ' ') + "#include \n")), "");
  const fs::path pipe = folder_ / "pipe.cpp";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  expect(pipe.string(), "cannot be read");
  expect(folder_.string() + "/none.cpp", "cannot be read");
  fs::create_directories(folder_ / "folder.cpp");
  expect((folder_ / "folder.cpp").string(), "cannot be read");
  ASSERT_EQ(setenv("CXX", "/bin/true", 1), 0);
  expect(file("other.cpp", law + "// compiled by nobody\n"), "made nothing of it");
  unsetenv("CXX");
}

// Loading alone would run the constructors of a file.
TEST_F(UserLaw, ALookAtASceneRunsNoCodeOfIt) {
  const fs::path trace = folder_ / "trace";
  const std::string source =
      file("mine.cpp", law_template("drag") + "#include <fstream>\nstatic const bool ran = (std::ofstream(\"" +
                           trace.string() + "\"), true);\n");
  {
    const NoForeignCode guard;
    EXPECT_NE(error_of(source).find("neither compiled nor run"), std::string::npos);
    EXPECT_FALSE(fs::exists(trace));
  }
  EXPECT_EQ(error_of(source), "");
  EXPECT_TRUE(fs::exists(trace));
}

TEST_F(UserLawInAScene, AFileBesideTheSceneIsFoundAndTheArchivedSceneRunsAgain) {
  fs::create_directories(folder_ / "scenes");
  (void)file("scenes/factor.hpp", "#pragma once\nconstexpr double factor = 1.5;\n");
  (void)file("scenes/mine.cpp", "#include \"factor.hpp\"\n" + replaced(law_template("drag"), "return one_sphere *",
                                                                       "return factor * one_sphere *"));
  const Scene outline = sphere("wen-yu-1966");
  std::string text = canonical_toml(outline);
  text = replaced(text, "\"wen-yu-1966\"", "\"mine.cpp\"");
  (void)file("scenes/scene.toml", text);
  const Scene scene = load_scene(folder_ / "scenes/scene.toml");
  EXPECT_EQ(failure_with(scene, folder_ / "out"), "finished");
  const std::string hash = scene_hash(scene);  // reads the law, which goes now
  const fs::path run = run_directory(folder_ / "out", hash);
  fs::remove_all(folder_ / "scenes");
  const Scene again = load_scene(run / "scene.toml");
  EXPECT_EQ(scene_hash(again), hash);
  EXPECT_EQ(failure_with(again, folder_ / "other"), "finished");
}

TEST_F(UserLawInAScene, APlantedLinkIsNotFollowed) {
  const Scene scene = sphere("wen-yu-1966");
  const fs::path precious = folder_ / "precious", run = run_directory(folder_, scene_hash(scene));
  (void)file("precious", "kept");
  fs::create_directories(run);
  for (const char* name : {"scene.toml", "result.h5.part", "checkpoint.h5"}) fs::create_symlink(precious, run / name);
  fs::remove(run / "checkpoint.h5");
  EXPECT_EQ(failure_with(scene, folder_), "finished");
  EXPECT_EQ(fs::file_size(precious), 4U);
  EXPECT_FALSE(fs::is_symlink(run / "scene.toml"));
  // In the place of the run's folder it is refused.
  const fs::path elsewhere = folder_ / "elsewhere", link = run_directory(folder_ / "out", scene_hash(scene));
  fs::create_directories(elsewhere);
  fs::create_directories(link.parent_path());
  fs::create_directory_symlink(elsewhere, link);
  EXPECT_NE(failure_with(scene, folder_ / "out").find("is a link"), std::string::npos);
  fs::create_directories(folder_ / "planted");
  fs::create_directory_symlink(elsewhere, folder_ / "planted/runs");
  EXPECT_NE(failure_with(scene, folder_ / "planted").find("is a link"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(elsewhere));
}

}  // namespace
}  // namespace slfb
