#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "solver/laws/user_law.hpp"
#include "solver/support/folders.hpp"

/// What the tests of laws from outside the suite share: a folder of their own and the templates in it.
namespace slfb {

/// The file that `slfb compare --template KIND` prints.
inline std::string law_template(const std::string& kind) {
  std::ifstream stream(source_folder() / "experiments/compare/templates" / (kind + "_law.cpp"));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto found = text.find(from);
  if (found == std::string::npos) ADD_FAILURE() << "the template holds no \"" << from << '"';
  return found == std::string::npos ? text : text.replace(found, from.size(), to);
}

class UserLawFiles : public testing::Test {
 protected:
  UserLawFiles() : folder_(std::filesystem::path(testing::TempDir()) / ("slfb_user_law_" + test_name())) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~UserLawFiles() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string file(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }

  std::filesystem::path folder_;

 private:
  static std::string test_name() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    return std::string(info->test_suite_name()) + "_" + info->name();
  }
};

}  // namespace slfb
