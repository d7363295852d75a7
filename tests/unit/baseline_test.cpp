// Results of another code: what decides nothing is no success, and its own accepted results can be the gates.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "experiments/commands/commands.hpp"
#include "solver/support/files.hpp"
#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

class Baseline : public testing::Test {
 protected:
  /// A file with one result, a classification velocity [m/s]; without a half width it is a single sample.
  std::string result(double value, const std::string& half_width) {
    const auto file = folder_.path() / "results.toml";
    write_file(file, fmt::format("[[measured]]\nmeasure = \"classification_velocity/6in5W/0.10\"\nvalue = {}\n{}unit = "
                                 "\"m/s\"\n",
                                 value, half_width.empty() ? "" : "half_width = " + half_width + "\n"));
    return file.string();
  }
  [[nodiscard]] std::string accepted() const { return (folder_.path() / "accepted.toml").string(); }

  static int check(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "check");
    std::ranges::reverse(arguments);  // as CLI11 takes a vector
    CLI::App app;
    add_check_command(app);
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    int status = 0;
    try {
      app.parse(arguments);
    } catch (const CLI::Error& error) {
      status = error.get_exit_code();
    }
    testing::internal::GetCapturedStdout();
    said_ = testing::internal::GetCapturedStderr();
    return status;
  }

  static inline std::string said_;
  Folder folder_;
};

TEST_F(Baseline, WhatDecidesNothingIsNoSuccess) {
  EXPECT_EQ(check({"--measured", result(0.214, "0.001")}), 0);
  EXPECT_EQ(check({"--measured", result(0.214, "")}), 1) << "a single sample";
  EXPECT_NE(said_.find("decides none of the"), std::string::npos) << said_;
  EXPECT_EQ(check({"fig05", "--measured", result(0.214, "0.001")}), 1) << "claims that it does not meet";
}

TEST_F(Baseline, GatesAgainstWhatWasAccepted) {
  // Far from the paper's 0.214 m/s, which is not asked for.
  ASSERT_EQ(check({"--measured", result(0.10, "0.01"), "--baseline", accepted(), "--accept"}), 0);
  EXPECT_EQ(check({"--measured", result(0.10, "0.01")}), 1) << "the paper's band";
  EXPECT_EQ(check({"--measured", result(0.10, "0.01"), "--baseline", accepted()}), 0);
  EXPECT_EQ(check({"--measured", result(0.115, "0.01"), "--baseline", accepted()}), 0) << "the intervals meet";
  EXPECT_EQ(check({"--measured", result(0.125, "0.01"), "--baseline", accepted()}), 1) << "they do not";
}

TEST_F(Baseline, AnExactResultMayNotChange) {
  ASSERT_EQ(check({"--measured", result(0.10, "0"), "--baseline", accepted(), "--accept"}), 0);
  EXPECT_EQ(check({"--measured", result(0.10, "0"), "--baseline", accepted()}), 0);
  EXPECT_EQ(check({"--measured", result(0.100001, "0"), "--baseline", accepted()}), 1);
}

TEST_F(Baseline, WhatWasNotAcceptedIsNoSuccess) {
  write_file(accepted(),
             "[[measured]]\nmeasure = \"classification_velocity/6in5W/0.12\"\nvalue = 0.2\nhalf_width = "
             "0.01\nunit = \"m/s\"\n");
  EXPECT_EQ(check({"--measured", result(0.10, "0.01"), "--baseline", accepted()}), 1);
}

}  // namespace
}  // namespace slfb
