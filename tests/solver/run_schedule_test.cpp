// Stages and drops in the order and for the times that a scene asks for, without spheres or liquid.
#include <gtest/gtest.h>

#include <vector>

#include "solver/run/drop_protocol.hpp"
#include "solver/run/schedule.hpp"

namespace slfb::simulation {
namespace {

std::vector<Stage> three_stages() {
  Stage settle, fluidise, drop;
  settle.kind = StageKind::settle;
  settle.duration = 0.3;
  fluidise.kind = StageKind::fluidise;
  fluidise.duration = 0.5;
  drop.kind = StageKind::drop;
  drop.duration = 1.0;
  drop.relaxation = 0.2;
  drop.repetitions = 2;
  return {settle, fluidise, drop};
}

constexpr double time_step = 0.1;  // [s]

TEST(Schedule, CountsTheStepsOfEachStageAndTheTimeAfterSettling) {
  const auto stages = three_stages();
  Schedule schedule(stages, time_step);
  std::vector<std::int64_t> steps;
  for (; !schedule.finished(); schedule.next_stage()) {
    if (schedule.stage().kind == StageKind::drop) continue;
    while (!schedule.duration_is_over()) schedule.count_step();
    steps.push_back(schedule.steps());
  }
  EXPECT_EQ(steps, (std::vector<std::int64_t>{3, 5}));  // 0.3/0.1 is less than 3 in binary numbers
  EXPECT_DOUBLE_EQ(schedule.fluidised_seconds(), 0.5);
}

TEST(Schedule, WhatIsDueMoreOftenThanStepsIsDueInEachOfThem) {
  const auto stages = three_stages();
  Schedule schedule(stages, time_step);
  schedule.next_stage();
  std::vector<bool> every_second, every;
  for (int k = 0; k < 4; ++k) {
    schedule.count_step();
    every_second.push_back(schedule.due(0.2));
    every.push_back(schedule.due(0.01));
  }
  EXPECT_EQ(every_second, (std::vector<bool>{false, true, false, true}));
  EXPECT_EQ(every, (std::vector<bool>{true, true, true, true}));
}

TEST(Schedule, PlansDropsByTheFallThatIsKnown) {
  auto stages = three_stages();
  EXPECT_DOUBLE_EQ(Schedule(stages, time_step).planned_seconds({}), 0.3 + 0.5 + 2 * (1.0 + 0.2));
  EXPECT_DOUBLE_EQ(Schedule(stages, time_step).planned_seconds(0.4), 0.3 + 0.5 + 2 * (0.4 + 0.2));
  stages[2].duration = 1000.0;  // waiting so long is not what one expects
  EXPECT_LT(Schedule(stages, time_step).planned_seconds({}), 20.0);
}

class DropProtocolTest : public testing::Test {
 protected:
  DropProtocolTest() {
    schedule_.next_stage();
    schedule_.next_stage();
    drops_.begin();
  }
  /// Steps until a release is due, at most ten.
  int steps_until_release() {
    int steps = 0;
    for (; steps < 10 && !drops_.release_is_due(); ++steps) drops_.count_step();
    return steps;
  }

  std::vector<Stage> stages_ = three_stages();
  Schedule schedule_{stages_, time_step};
  DropProtocol drops_{schedule_};
};

TEST_F(DropProtocolTest, ReleasesFollowARelaxationAndTheLastOneEndsTheStage) {
  EXPECT_EQ(steps_until_release(), 0);
  for (int drop = 0; drop < 2; ++drop) {
    EXPECT_EQ(drops_.repetition(), drop);
    drops_.released();
    EXPECT_TRUE(drops_.falling());
    for (int k = 0; k < 4; ++k) drops_.count_step();
    EXPECT_DOUBLE_EQ(drops_.fall_seconds(), 0.4);
    EXPECT_FALSE(drops_.release_is_due());
    drops_.taken_out();
    EXPECT_FALSE(drops_.finished());
    if (drop == 0) {
      EXPECT_EQ(steps_until_release(), 2);
    }
  }
  drops_.count_step();
  EXPECT_FALSE(drops_.finished()) << "the bed relaxes after the last sphere too";
  drops_.count_step();
  EXPECT_TRUE(drops_.finished());
  EXPECT_FALSE(drops_.release_is_due());
}

TEST_F(DropProtocolTest, AFallEndsAfterTheDuration) {
  drops_.released();
  for (int k = 0; k < 9; ++k) drops_.count_step();
  EXPECT_FALSE(drops_.fall_is_over());
  drops_.count_step();
  EXPECT_TRUE(drops_.fall_is_over());
}

TEST_F(DropProtocolTest, WaitsForRoomAsLongAsADropMayTake) {
  for (int k = 0; k < 9; ++k) {
    drops_.count_step();
    EXPECT_TRUE(drops_.release_is_due());
    EXPECT_FALSE(drops_.waited_too_long());
  }
  drops_.count_step();
  EXPECT_TRUE(drops_.waited_too_long());
  EXPECT_EQ(drops_.repetition(), 0) << "no sphere has fallen";
  drops_.give_up();
  EXPECT_TRUE(drops_.finished());
}

}  // namespace
}  // namespace slfb::simulation
