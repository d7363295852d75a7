#include "experiments/peng_2014/inconsistencies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace slfb {
namespace {

TEST(Inconsistencies, EveryRowDisagreesAndSaysWhere) {
  const auto rows = inconsistencies();
  EXPECT_GE(rows.size(), 20u);
  std::set<std::string> ids;
  for (const reports::InconsistencyRow& row : rows) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_FALSE(row.source.empty()) << row.id;
    EXPECT_FALSE(row.unit.empty()) << row.id;
    EXPECT_TRUE(row.explanation.ends_with(".")) << row.id;
    EXPECT_TRUE(std::isfinite(row.recomputed)) << row.id;
    EXPECT_NE(row.paper, row.recomputed) << row.id;
  }
}

double recomputed(const std::string& id) {
  const auto rows = inconsistencies();
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const reports::InconsistencyRow& row) { return row.id == id; });
  return found == rows.end() ? std::nan("") : found->recomputed;
}

TEST(Inconsistencies, NumbersComputedByHand) {
  EXPECT_NEAR(recomputed("particle_density"), 2230.1, 0.1);
  EXPECT_NEAR(recomputed("umf_packing"), 0.0497, 0.0001);
  EXPECT_NEAR(recomputed("drag_factor"), 0.069, 0.001);
  EXPECT_NEAR(recomputed("settling_time"), 3.39, 0.01);
  EXPECT_NEAR(recomputed("pressure_force"), 0.213, 0.001);
  EXPECT_NEAR(recomputed("mean_drag"), 2.01, 0.01);
  EXPECT_NEAR(recomputed("maximum_overlap"), 0.0144, 0.0001);
  EXPECT_NEAR(recomputed("force_balance"), 0.916 + 0.10 + 0.11, 0.001);
  EXPECT_NEAR(recomputed("drag_switch"), 8.0, 0.0) << "0.06 to 0.13 m/s";
}

}  // namespace
}  // namespace slfb
