// SPDX-License-Identifier: MIT
#include "sim/trail.hpp"

#include <gtest/gtest.h>

#include "sim/run.hpp"
#include "sim/swarm_test.hpp"

namespace eyrie::sim {
namespace {

using swarm::Swarm;

constexpr int kSteps = 120;  // two simulated seconds and a bit

/// Flies a run under an observer. `spoil_at`: the step before which one bird is pushed.
void fly_under(Observer& observer, int steps = kSteps, int spoil_at = -1, std::uint64_t seed = 1) {
  static const Swarm swarm(300, 400);
  World world = swarm.world(257, seed);
  Workspace work(*swarm.simulation);
  observer.begin(world, swarm.simulation->dt());
  for (int i = 0; i < steps; ++i) {
    if (i == spoil_at)
      world.rows(swarm.keys.body)[100].velocity.y += 1e-9;
    const StepInfo info{world.step(), world.seed(), swarm.simulation->dt()};
    const auto events = swarm.simulation->step(world, work);
    observer.observe(world, info, events);
  }
  observer.finish(world);
}

HashTrail recorded(TrailDetail detail = TrailDetail::every_step) {
  TrailRecorder recorder(detail);
  fly_under(recorder);
  return recorder.trail();
}

TEST(TrailRecorder, MarksTheStartEverySecondAndTheEnd) {
  const HashTrail trail = recorded();
  EXPECT_EQ(trail.first_step, 0u);
  EXPECT_EQ(trail.steps_per_mark, 50u);
  EXPECT_EQ(trail.folds.size(), static_cast<std::size_t>(kSteps));
  ASSERT_EQ(trail.marks.size(), 4u);
  EXPECT_EQ(trail.marks[0].step, 0u);
  EXPECT_EQ(trail.marks[1].step, 50u);
  EXPECT_EQ(trail.marks[2].step, 100u);
  EXPECT_EQ(trail.marks[3].step, 120u);
  EXPECT_EQ(fold(trail.marks[1].hash), trail.folds[49]);
  EXPECT_EQ(recorded(), trail);
}

TEST(TrailRecorder, DoesNotMarkTheEndTwice) {
  TrailRecorder recorder;
  fly_under(recorder, 100);
  EXPECT_EQ(recorder.trail().marks.size(), 3u);
}

TEST(TrailRecorder, CanLeaveTheStepsOut) {
  const HashTrail trail = recorded(TrailDetail::marks_only);
  EXPECT_TRUE(trail.folds.empty());
  EXPECT_EQ(trail.marks, recorded().marks);
}

TEST(TrailChecker, IsContentWithTheSameRun) {
  for (const TrailDetail detail : {TrailDetail::every_step, TrailDetail::marks_only}) {
    const HashTrail trail = recorded(detail);
    TrailChecker checker(trail);
    fly_under(checker);
    EXPECT_FALSE(checker.departure());
    EXPECT_FALSE(checker.done());
  }
}

TEST(TrailChecker, NamesTheFirstWrongStepAndWhatIsWrongInTheNextDigest) {
  const HashTrail trail = recorded();
  TrailChecker checker(trail);
  fly_under(checker, kSteps, 98);
  ASSERT_TRUE(checker.departure());
  EXPECT_TRUE(checker.done());
  const Departure& departure = *checker.departure();
  EXPECT_EQ(departure.step, 99u) << "the world after step 98";
  EXPECT_EQ(departure.last_good, 98u);
  ASSERT_TRUE(departure.where);
  EXPECT_EQ(departure.where->step, 100u);
  EXPECT_EQ(departure.where->table, "bird");
  EXPECT_EQ(departure.where->column, "body");
  EXPECT_EQ(departure.where->field, "position.y");
  ASSERT_TRUE(departure.where->player);
  EXPECT_EQ(departure.reason, "the worlds part at step 99; " + departure.where->text());
}

TEST(TrailChecker, KnowsOnlyTheSecondWithoutAHashPerStep) {
  const HashTrail trail = recorded(TrailDetail::marks_only);
  TrailChecker checker(trail);
  fly_under(checker, kSteps, 60);
  ASSERT_TRUE(checker.departure());
  EXPECT_EQ(checker.departure()->step, 100u);
  EXPECT_EQ(checker.departure()->last_good, 50u);
  EXPECT_TRUE(checker.departure()->reason.starts_with("the worlds part between steps 50 and 100"));
}

TEST(TrailChecker, SeesAWrongStart) {
  const HashTrail trail = recorded();
  TrailChecker checker(trail);
  fly_under(checker, 1, -1, 2);
  ASSERT_TRUE(checker.departure());
  EXPECT_EQ(checker.departure()->step, 0u);
  EXPECT_EQ(checker.departure()->last_good, std::nullopt);
  EXPECT_EQ(checker.departure()->reason,
            "the worlds differ from the start; step 0: header differs");
}

TEST(TrailChecker, SeesARunThatIsShorterOrLonger) {
  const HashTrail trail = recorded();
  TrailChecker shorter(trail);
  fly_under(shorter, kSteps - 1);
  ASSERT_TRUE(shorter.departure());
  EXPECT_EQ(shorter.departure()->reason,
            "the replay ends at step 119, the recording goes on to 120");
  TrailChecker longer(trail);
  fly_under(longer, kSteps + 1);
  ASSERT_TRUE(longer.departure());
  EXPECT_EQ(longer.departure()->reason, "the recording ends at step 120, the replay goes on");
}

TEST(TrailChecker, SeesAnotherStepLength) {
  HashTrail trail = recorded();
  trail.steps_per_mark = 100;
  TrailChecker checker(trail);
  fly_under(checker, 1);
  ASSERT_TRUE(checker.departure());
  EXPECT_EQ(checker.departure()->reason, "the replay makes 50 steps per second, the recording 100");
}

}  // namespace
}  // namespace eyrie::sim
