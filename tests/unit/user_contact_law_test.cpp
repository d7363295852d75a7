// A contact law from outside the suite: compiled, loaded, and the same to the engine as a law of the suite.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/runs/run_campaign.hpp"
#include "experiments/runs/run_files.hpp"
#include "solver/dem/engine.hpp"
#include "solver/dem/linear_spring_dashpot.hpp"
#include "solver/laws/make_engine.hpp"
#include "solver/laws/scene_file.hpp"
#include "solver/support/folders.hpp"
#include "tests/unit/user_law_files.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

/// A law of the suite in the user's clothes.
std::string wrapped(const std::string& type, const std::string& header, const std::string& more = "") {
  return "#include \"solver/dem/contact_law.hpp\"\n#include \"solver/dem/" + header +
         "\"\nnamespace {\nstruct Wrapped : slfb::dem::" + type + " {\n  using " + type + "::" + type +
         ";\n  static constexpr slfb::dem::ContactLawInfo info{\"wrapped\", \"\", \"\", \"mine\", {}};\n" + more +
         "};\n}\nSLFB_CONTACT_LAW(Wrapped)\n";
}

class UserContactLaw : public UserLawFiles {
 protected:
  static std::string error_of(const std::string& law) {
    try {
      find_contact_law(law);
    } catch (const UserLawError& error) {
      return error.what();
    }
    return "";
  }
};

Contact contact_of(const std::string& law) {
  Contact contact;
  contact.law = law;
  contact.stiffness = 1e3;
  contact.youngs_modulus = 8e6;
  contact.time_step = 1e-4;
  return contact;
}

/// Sixty spheres of two sizes thrown together in a box with a floor.
std::vector<double> tumble(const Contact& contact, int threads = 1) {
  std::vector<dem::Wall> walls{{dem::Wall::Kind::plane, 2, 1.0, 0.0}};
  for (const int axis : {0, 1})
    for (const double side : {-1.0, 1.0}) walls.push_back({dem::Wall::Kind::plane, axis, -side, side * 0.0105});
  dem::Engine engine = make_engine(contact, walls, {0, 0, 0}, threads);
  for (int k = 0; k < 60; ++k) {
    const double radius = k % 3 == 0 ? 0.003 : 0.0025;
    const std::size_t i = engine.add_particle(
        {0.0066 * (k % 3 - 1), 0.0066 * (k / 3 % 3 - 1) + 1e-4 * (k % 5), 0.004 + 0.0066 * (k / 9)}, radius, 2500.0, 0);
    engine.particles.velocity.x[i] = 0.2 * std::sin(3.0 * k);
    engine.particles.velocity.y[i] = 0.2 * std::cos(5.0 * k);
    engine.particles.angular_velocity.x[i] = 30.0 * std::sin(7.0 * k);
    engine.external_force.z[i] = -9.81 * engine.particles.mass[i];
  }
  engine.advance(3000);
  std::vector<double> state;
  for (const auto* field : {&engine.particles.position, &engine.particles.velocity, &engine.particles.angular_velocity})
    for (const auto* component : {&field->x, &field->y, &field->z})
      state.insert(state.end(), component->begin(), component->end());
  return state;
}

// The formula of the header, and the suite's linear law where the steps are too short for its corrections to matter.
TEST_F(UserContactLaw, TheTemplateIsALaw) {
  const auto law = find_contact_law(file("mine.cpp", law_template("contact")));
  EXPECT_EQ(law.info.name, "my-law");
  Contact contact = contact_of("linear");
  contact.time_step = 1e-12;
  const auto suite = find_contact_law("linear");
  for (const double approach : {-0.1, 0.0, 0.2}) {
    const auto mine = law.normal(contact, false, 2e-5, approach, 0.0085, 0.00125);
    const auto theirs = suite.normal(contact, false, 2e-5, approach, 0.0085, 0.00125);
    EXPECT_NEAR(mine.force, theirs.force, 1e-8 * std::abs(theirs.force));
    EXPECT_EQ(mine.stiffness, theirs.stiffness);
    EXPECT_EQ(mine.tangential_stiffness, theirs.tangential_stiffness);
    EXPECT_NEAR(mine.tangential_damping, theirs.tangential_damping, 1e-12);
  }
}

// To the last bit, with every rolling resistance, at walls and between spheres, on one thread and on two.
TEST_F(UserContactLaw, TheEngineCannotTellItFromTheSuitesLaw) {
  const std::string linear = file("linear.cpp", wrapped("LinearSpringDashpot", "linear_spring_dashpot.hpp"));
  const std::string hertz = file("hertz.cpp", wrapped("HertzMindlin", "hertz_mindlin.hpp"));
  for (const auto& [ours, theirs] : {std::pair<std::string, std::string>{"linear", linear}, {"hertz", hertz}})
    for (const auto& [friction, model] : {std::pair{0.0, RollingModel::constant_torque},
                                          {0.02, RollingModel::constant_torque},
                                          {0.02, RollingModel::elastic_plastic}}) {
      Contact contact = contact_of(ours);
      contact.rolling_friction = friction;
      contact.rolling_model = model;
      const std::vector<double> expected = tumble(contact);
      contact.law = theirs;
      EXPECT_EQ(tumble(contact), expected) << ours << ", rolling friction " << friction;
      EXPECT_EQ(tumble(contact, 2), expected) << ours << ", two threads";
    }
}

TEST_F(UserContactLaw, ItsOwnFrictionTakesThePlaceOfCoulombs) {
  const std::string smooth = file("smooth.cpp", wrapped("LinearSpringDashpot", "linear_spring_dashpot.hpp",
                                                        "  struct Friction {\n"
                                                        "    double friction, phase;\n"
                                                        "    slfb::Vec3 operator()(const slfb::dem::NormalContact&, "
                                                        "slfb::Vec3, slfb::Vec3, double, slfb::Vec3&) "
                                                        "const { return {}; }\n"
                                                        "  };\n"));
  Contact contact = contact_of("linear");
  contact.sliding_friction = 0.0;
  const std::vector<double> expected = tumble(contact);
  contact.law = smooth;
  contact.sliding_friction = 0.3;
  EXPECT_EQ(tumble(contact), expected);
}

TEST_F(UserContactLaw, ABrokenFileGivesTheCompilersMessageAndAHint) {
  const std::string message =
      error_of(file("broken.cpp", replaced(law_template("contact"), "stiffness_ * overlap", "stiffnes_ * overlap")));
  EXPECT_NE(message.find("broken.cpp does not compile"), std::string::npos) << message;
  EXPECT_NE(message.find("stiffnes_"), std::string::npos) << message;
  EXPECT_NE(message.find("slfb compare --template contact"), std::string::npos) << message;
}

TEST_F(UserContactLaw, AFileThatHandsNoContactLawOverIsRefused) {
  const std::string drag = error_of(file("drag.cpp", law_template("drag")));
  EXPECT_NE(drag.find("SLFB_CONTACT_LAW"), std::string::npos) << drag;
  const std::string twin = error_of(file("twin.cpp", replaced(law_template("contact"), "my-law", "hertz")));
  EXPECT_NE(twin.find("law of the suite"), std::string::npos) << twin;
  EXPECT_THROW(find_contact_law("hertzian"), std::invalid_argument);
}

class UserContactLawInAScene : public UserContactLaw {
 protected:
  static Scene sphere(const std::string& law) {
    return load_run_scene(
        {"sphere", 0.0, "", source_folder() / "experiments/scenes/single_sphere.toml", {"contact.law=" + law}});
  }
  static std::string message_of(const std::string& law) {
    try {
      sphere(law);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "the scene was taken";
  }
};

TEST_F(UserContactLawInAScene, TheNameOfTheRunIsThatOfTheFormula) {
  const std::string here = file("here.cpp", law_template("contact")),
                    there = file("there.cpp", law_template("contact"));
  const std::string changed = file("changed.cpp", replaced(law_template("contact"), "2.0 * dem::", "1.9 * dem::"));
  EXPECT_EQ(scene_hash(sphere(here)), scene_hash(sphere(there)));
  EXPECT_NE(scene_hash(sphere(here)), scene_hash(sphere(changed)));
  EXPECT_NE(scene_hash(sphere(here)), scene_hash(sphere("linear")));
}

TEST_F(UserContactLawInAScene, ItsCanonicalTextReadsBack) {
  const Scene scene = sphere(file("mine.cpp", law_template("contact")));
  EXPECT_EQ(canonical_toml(parse_scene(canonical_toml(scene), "canonical")), canonical_toml(scene));
}

TEST_F(UserContactLawInAScene, ErrorsNameTheKey) {
  const std::string broken = message_of(file("broken.cpp", "int main() { return }\n"));
  EXPECT_NE(broken.find("contact.law"), std::string::npos) << broken;
  EXPECT_NE(broken.find("does not compile"), std::string::npos) << broken;
  const std::string unknown = message_of("hertzian");
  EXPECT_NE(unknown.find("allowed is \"linear\", \"hertz\", or a file"), std::string::npos) << unknown;
  // It asks for a modulus that the scene does not give.
  const std::string missing =
      message_of(file("modulus.cpp", replaced(law_template("contact"), "stiffness_(contact.stiffness)",
                                              "stiffness_(contact.youngs_modulus)")));
  EXPECT_NE(missing.find("no stiffness above zero"), std::string::npos) << missing;
}

// What the file says of the linear law has no meaning beside another; what the command line says of it is an error.
TEST(ContactLawOverride, SpeaksForTheWholeChoice) {
  const auto load = [](std::vector<std::string> overrides) {
    return load_run_scene({"slice", 0.0, "",
                           source_folder() / "experiments/peng_2014/scenes/6in5W_one-dimensional.toml",
                           std::move(overrides)});
  };
  const Scene scene = load({"contact.law=hertz", "contact.youngs_modulus=8e6 Pa"});
  EXPECT_EQ(scene.contact.law, "hertz");
  EXPECT_EQ(scene.contact.stiffness, 0.0);
  EXPECT_EQ(load({"contact.law=linear"}).contact.stiffness, 1e3);
  EXPECT_THROW(load({"contact.law=hertz"}), SceneError);
  EXPECT_THROW(load({"contact.law=hertz", "contact.youngs_modulus=8e6 Pa", "contact.stiffness=1e3 N/m"}), SceneError);
}

TEST_F(UserContactLawInAScene, ARunKeepsACopyOfTheFile) {
  const Scene scene = sphere(file("mine.cpp", law_template("contact")));
  const CampaignOutcome outcome =
      run_scenes({{"sphere", scene}}, {.out = folder_, .jobs = 1, .threads_per_run = 1, .progress = false});
  ASSERT_EQ(outcome.finished, 1);
  EXPECT_TRUE(fs::exists(run_directory(folder_, scene_hash(scene)) / "contact_law.cpp"));
}

TEST_F(UserContactLawInAScene, ALawThatThrowsIsNamedBeforeTheRun) {
  const auto throws = [](const std::string& what) {
    return replaced("#include <stdexcept>\n" + law_template("contact"),
                    "const double damping =", "if (overlap > 0) throw " + what + "; const double damping =");
  };
  for (const auto& [source, part] : {std::pair{file("one.cpp", throws("std::runtime_error(\"no\")")), ": no"},
                                     std::pair{file("two.cpp", throws("1")), "throws something"}})
    try {
      sphere(source);
      ADD_FAILURE() << "the scene was taken";
    } catch (const SceneError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("contact.law = \"" + source), std::string::npos) << message;
      EXPECT_NE(message.find(part), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace slfb
