// A contact law declares which keys of [contact] it takes; scenes follow.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>

#include "solver/dem/contact_laws.hpp"
#include "solver/laws/scene_file.hpp"

namespace slfb {
namespace {

/// A sphere in a box with the contact law of that name and every key that the law requires.
std::string scene_with(const dem::ContactLawInfo& law, const std::string& contact_keys = "") {
  std::string text = R"([geometry]
shape = "box"
width = [0.1, 0.1]
height = 0.1
[liquid]
density = 1000
viscosity = 1e-3
superficial_velocity = 0
[fluid]
tier = "quiescent"
[[species]]
name = "glass"
diameter = 0.005
density = 2230
count = 2
[[stage]]
kind = "settle"
duration = 1
[contact]
time_step = 1e-6
)";
  text += "law = \"" + std::string(law.name) + "\"\n" + contact_keys;
  for (const dem::ContactKey& key : law.keys)
    if (key.required) text += std::string(key.name) + " = 1e4\n";
  return text;
}

/// A key that is not written while it has its default.
bool left_out_at_default(const dem::ContactKey& key) { return key.name == "tangential_model"; }

std::set<std::string> keys_of_contact(const std::string& canonical) {
  std::set<std::string> keys;
  std::istringstream lines(canonical.substr(canonical.find("[contact]")));
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line) && line.front() != '[';)
    keys.insert(line.substr(0, line.find(' ')));
  return keys;
}

TEST(ContactLawKeys, AreThoseThatItsScenesHave) {
  for (const dem::ContactLawKernels& own : dem::contact_laws()) {
    const auto keys = keys_of_contact(canonical_toml(parse_scene(scene_with(own.info), "scene")));
    for (const dem::ContactLawKernels& law : dem::contact_laws())
      for (const dem::ContactKey& key : law.info.keys) {
        if (left_out_at_default(key)) continue;
        EXPECT_EQ(keys.contains(std::string(key.name)), own.info.key(key.name) != nullptr)
            << own.info.name << ": " << key.name;
      }
    EXPECT_TRUE(keys.contains("sliding_friction")) << "a key of every law";
    EXPECT_NE(own.info.key(own.info.stiffness_key), nullptr) << own.info.name;
  }
}

std::string error_of(const std::string& scene) {
  try {
    parse_scene(scene, "scene");
  } catch (const SceneError& error) {
    return error.what();
  }
  return "the scene was taken";
}

TEST(ContactLawKeys, AKeyOfAnotherLawIsAnErrorThatNamesThatLaw) {
  for (const dem::ContactLawKernels& own : dem::contact_laws())
    for (const dem::ContactLawKernels& law : dem::contact_laws())
      for (const dem::ContactKey& key : law.info.keys) {
        if (own.info.key(key.name) != nullptr) continue;
        const std::string error = error_of(scene_with(own.info, std::string(key.name) + " = 0.2\n"));
        EXPECT_NE(error.find("contact." + std::string(key.name)), std::string::npos) << error;
        EXPECT_NE(error.find("it belongs to law = \"" + std::string(law.info.name) + "\""), std::string::npos) << error;
      }
}

TEST(ContactLawKeys, ARequiredKeyThatIsMissingIsAnError) {
  for (const dem::ContactLawKernels& law : dem::contact_laws())
    for (const dem::ContactKey& key : law.info.keys) {
      if (!key.required) continue;
      std::string scene = scene_with(law.info);
      const std::string line = std::string(key.name) + " = 1e4\n";
      const std::string error = error_of(scene.erase(scene.find(line), line.size()));
      EXPECT_NE(error.find("contact." + std::string(key.name) + ": missing"), std::string::npos) << error;
    }
}

TEST(ContactLawKeys, ErrorsAboutTheStepAdviseTheLawsOwnStiffness) {
  for (const dem::ContactLawKernels& law : dem::contact_laws()) {
    std::string scene = scene_with(law.info);
    const std::string step = "time_step = 1e-6";
    const std::string error = error_of(scene.replace(scene.find(step), step.size(), "time_step = 10"));
    EXPECT_NE(error.find("a softer contact." + std::string(law.info.stiffness_key)), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace slfb
