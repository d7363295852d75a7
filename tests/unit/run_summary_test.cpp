#include "experiments/quantities/run_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace slfb {
namespace {

std::filesystem::path file_named(const char* name) { return std::filesystem::temp_directory_path() / name; }

TEST(RunSummary, ComesBackFromItsFileBitForBit) {
  RunSummary written;
  written.bed["pressure_drop"] = {1450.1, 3.0 / 7.0, 12.5, 80.0, 5};
  written.bed["fluctuating_energy"] = {4e-4, std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0, 0};
  written.run = {{"packed_voidage", 0.4 + 1e-16}, {"wall_seconds", 100.0}};
  written.drops = {{{"classification_velocity", 0.1}, {"bottom_fraction", 1.0}}, {{"bottom_fraction", 0.0}}};
  const auto file = file_named("slfb_run_summary.json");
  save_summary(written, file);
  const RunSummary read = load_summary(file);
  EXPECT_EQ(read.run, written.run);
  EXPECT_EQ(read.drops, written.drops);
  EXPECT_EQ(read.bed.at("pressure_drop").half_width, 3.0 / 7.0);
  EXPECT_EQ(read.bed.at("pressure_drop").discarded, 5U);
  EXPECT_TRUE(std::isnan(read.bed.at("fluctuating_energy").half_width));
}

TEST(RunSummary, ADamagedFileIsNamed) {
  const auto file = file_named("slfb_damaged_summary.json");
  std::ofstream(file) << R"({"bed": {}, "run": )";
  try {
    load_summary(file);
    FAIL() << "a damaged file was read";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("slfb_damaged_summary.json"), std::string::npos);
  }
}

}  // namespace
}  // namespace slfb
