// A law from outside the suite: compiled, loaded, and the same to the solver as a law of the suite.

#include "solver/laws/user_law.hpp"

#include <gtest/gtest.h>

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
    } catch (const UserLawError& error) {
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

}  // namespace
}  // namespace slfb
