#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "experiments/peng_2014/reference.hpp"

namespace slfb {
namespace {

TEST(ReferenceData, EveryNumberHasUnitQuantityAndSource) {
  ASSERT_GE(peng_2014().values().size(), 100u);
  for (const auto& [id, value] : peng_2014().values()) {
    EXPECT_FALSE(value.unit.empty()) << id;
    EXPECT_FALSE(value.quantity.empty()) << id;
    EXPECT_FALSE(value.source.empty()) << id;
    EXPECT_TRUE(std::isfinite(value.value)) << id;
    EXPECT_GE(value.uncertainty, 0.0) << id;
  }
}

TEST(ReferenceData, Table2IsComplete) {
  const auto& table = peng_2014().table2();
  ASSERT_EQ(table.size(), 18u);
  double previous = 0.0;
  for (const Table2Row& row : table) {
    EXPECT_GT(row.superficial_velocity, previous) << "in the order of the velocities";
    previous = row.superficial_velocity;
    EXPECT_GE(row.r_squared, peng_2014().value("r_squared_minimum"));
    EXPECT_LE(row.r_squared, 1.0);
  }
  EXPECT_DOUBLE_EQ(table.front().superficial_velocity, 0.06);
  EXPECT_DOUBLE_EQ(table.back().superficial_velocity, 0.24);
}

TEST(ReferenceData, Table2LinesPassTheWindowWithinTheFrameOfFigure9) {
  // Fig. 9 shows the window 0.1-0.2 m between 21.2 and 22.7 s. Only the copied intercept of 0.17 m/s falls outside.
  for (const Table2Row& row : peng_2014().table2()) {
    const double enters = (row.intercept - 0.2) / row.classification_velocity;
    const double leaves = (row.intercept - 0.1) / row.classification_velocity;
    const bool inside = enters > 21.1 && leaves < 22.8;
    EXPECT_EQ(inside, std::abs(row.superficial_velocity - 0.17) > 1e-9)
        << row.superficial_velocity << ": " << enters << " to " << leaves << " s";
  }
}

TEST(ReferenceData, AnUnknownIdIsNamed) {
  try {
    static_cast<void>(peng_2014().at("no_such_number"));
    FAIL();
  } catch (const std::out_of_range& error) {
    EXPECT_NE(std::string(error.what()).find("no_such_number"), std::string::npos);
  }
}

/// A copy of the data with one file replaced.
class ChangedData : public testing::Test {
 protected:
  void SetUp() override {
    // Tests run side by side, each in its own folder.
    folder_ = std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
    std::filesystem::copy(reference_data_folder() / "peng_2014", folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string error_with(const std::string& file, const std::string& text) {
    std::ofstream(folder_ / file) << text;
    try {
      Peng2014 data(folder_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }

  std::filesystem::path folder_;
};

TEST_F(ChangedData, AWrongNumberInATableIsNamedWithItsLine) {
  EXPECT_NE(error_with("table2.csv", "header\n0.06,fast,1,1\n").find("table2.csv:2: \"fast\""), std::string::npos);
  EXPECT_NE(error_with("table2.csv", "header\n0.06,1,1\n").find("3 columns instead of 4"), std::string::npos);
}

TEST_F(ChangedData, AnUnknownKeyIsNamedWithItsLine) {
  const std::string message =
      error_with("table1.toml",
                 "[[value]]\nid = \"a\"\nquantity = \"q\"\nvalue = 1.0\nunit = \"m\"\nuncertainty = 0.1\nsource = "
                 "\"p. 1\"\ncolour = \"red\"\n");
  EXPECT_NE(message.find("table1.toml:8: colour: "), std::string::npos) << message;
}

TEST_F(ChangedData, AMissingUnitIsNamed) {
  const std::string message = error_with("table1.toml", "[[value]]\nid = \"a\"\nquantity = \"q\"\nvalue = 1.0\n");
  EXPECT_NE(message.find("unit: is missing"), std::string::npos) << message;
}

}  // namespace
}  // namespace slfb
