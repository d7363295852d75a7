#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "experiments/claims/claims.hpp"
#include "experiments/peng_2014/measure_laws.hpp"
#include "experiments/peng_2014/work.hpp"
#include "experiments/runs/measure.hpp"

namespace slfb {
namespace {

bool needs_no_run(const Claim& claim) { return !claim.measures.empty() && !claim.needs_run(); }

TEST(Gates, EveryClaimThatNeedsNoRunHasAGateAndItHolds) {
  std::size_t gates = 0;
  for (const Evaluation& evaluation : evaluate(load_claims(), measure_without_runs())) {
    if (!needs_no_run(evaluation.claim)) continue;
    ++gates;
    EXPECT_EQ(evaluation.gate, Gate::holds) << evaluation.claim.id << ": " << evaluation.reason;
  }
  EXPECT_GE(gates, 40u);
}

}  // namespace
}  // namespace slfb
