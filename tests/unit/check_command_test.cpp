#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"

namespace slfb {
namespace {

struct Outcome {
  int status = 0;
  std::string output;
  std::string error;
};

/// `slfb check …` with a folder that holds no runs.
Outcome check(std::vector<std::string> arguments) {
  const auto empty = std::filesystem::path(testing::TempDir()) / "slfb_no_runs";
  std::filesystem::create_directories(empty);
  arguments.insert(arguments.begin(), {"check", "--out", empty.string()});
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes a vector
  CLI::App app;
  add_check_command(app);
  Outcome outcome;
  testing::internal::CaptureStdout();
  try {
    app.parse(arguments);
  } catch (const CLI::Error& error) {
    outcome.status = error.get_exit_code();
    outcome.error = error.what();
  }
  outcome.output = testing::internal::GetCapturedStdout();
  return outcome;
}

TEST(CheckCommand, TableEndsWithASummary) {
  const Outcome outcome = check({});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.output.find("table2.classification_velocity_0.24"), std::string::npos);
  EXPECT_NE(outcome.output.find(" claims: "), std::string::npos);
}

TEST(CheckCommand, PrefixChoosesClaims) {
  const Outcome outcome = check({"fig22"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_NE(outcome.output.find("fig22.buoyancy"), std::string::npos);
  EXPECT_EQ(outcome.output.find("fig05"), std::string::npos);
}

TEST(CheckCommand, UnknownNameListsCloseOnes) {
  const Outcome outcome = check({"fig05.u_mf"});
  EXPECT_NE(outcome.status, 0);
  EXPECT_NE(outcome.error.find("no claim begins with \"fig05.u_mf\""), std::string::npos) << outcome.error;
  EXPECT_NE(outcome.error.find("fig05"), std::string::npos);
  EXPECT_NE(check({"plateau"}).error.find("fig05.plateau"), std::string::npos);
}

TEST(CheckCommand, JsonGoesToStandardOutput) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"fig05", "--json"}, std::vector<std::string>{"--json", "-", "fig05"}}) {
    const Outcome outcome = check(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    const auto json = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(json.at("claims").at(0).at("figure"), "fig05");
  }
}

TEST(CheckCommand, JsonAndJunitGoToFiles) {
  const auto folder = std::filesystem::path(testing::TempDir());
  const auto json_file = folder / "slfb_claims.json", junit_file = folder / "slfb_gates.xml";
  const Outcome outcome = check({"fig22", "--json", json_file.string(), "--junit", junit_file.string()});
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_NE(outcome.output.find(" claims: "), std::string::npos) << "the table is still shown";
  std::ifstream stream(json_file);
  EXPECT_GT(nlohmann::json::parse(stream).at("claims").size(), 5u);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_file(junit_file.c_str()));
  EXPECT_GT(document.child("testsuite").attribute("tests").as_int(), 3);
  std::filesystem::remove(json_file);
  std::filesystem::remove(junit_file);
}

}  // namespace
}  // namespace slfb
