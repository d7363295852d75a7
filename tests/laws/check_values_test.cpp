// Every law against numbers from outside this code: printed ones, those of another library, those of a second program.

#include "correlations/check_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

const std::filesystem::path folder = SLFB_SOURCE_DIR "/reference-data/law_checks";

TEST(CheckValues, EveryLawGivesItsCheckValues) {
  for (const CheckValue& check : read_check_values(folder)) {
    const LawAnswer answer = find_law(check.law).evaluate(arguments_of(check));
    std::string at;
    for (const auto& [name, value] : check.arguments) at += " " + name + "=" + std::to_string(value);
    EXPECT_NEAR(answer.at(check.quantity).value, check.number(), check.tolerance())
        << check.law << at << " (" << check.origin << ")";
  }
}

TEST(CheckValues, EveryLawHasSome) {
  std::map<std::string, int> count;
  for (const CheckValue& check : read_check_values(folder)) ++count[check.law];
  for (const CatalogueEntry& entry : catalogue()) EXPECT_GE(count[std::string(entry.info.name)], 2) << entry.info.name;
}

TEST(CheckValues, TheToleranceIsALittleOverHalfTheLastDigit) {
  const auto tolerance = [](const char* value) { return CheckValue{"", {}, "", value, "", ""}.tolerance(); };
  EXPECT_NEAR(tolerance("0.0423"), 0.6e-4, 1e-18);
  EXPECT_NEAR(tolerance("37937"), 0.6, 1e-12);
  EXPECT_NEAR(tolerance("1.2300e-05"), 0.6e-9, 1e-20);
}

class CheckValuesFile : public testing::Test {
 protected:
  Folder own_folder_;
  std::filesystem::path folder_ = own_folder_.path();

  std::string error_of(const std::string& line) const {
    std::ofstream(folder_ / "bad.csv") << "# remark\n" << line << '\n';
    try {
      read_check_values(folder_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(CheckValuesFile, AnErrorNamesTheLineAndTheKey) {
  EXPECT_EQ(error_of("ergun-1952,voidage=0.5 re=1,beta,1.0,hand"), "");
  EXPECT_NE(error_of("ergun-1952,voidage=0.5,beta").find("bad.csv:2:"), std::string::npos);
  const std::string unknown = error_of("ergun-1952,porosity=0.5,beta,1.0,hand");
  EXPECT_NE(unknown.find("porosity"), std::string::npos);
  EXPECT_NE(unknown.find("voidage"), std::string::npos);
  EXPECT_NE(error_of("ergun-1952,voidage=0.5,beta,one,hand"), "");
}

}  // namespace
}  // namespace slfb
