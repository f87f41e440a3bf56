// SPDX-License-Identifier: MIT
#include "sim/trail.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

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

HashTrail recorded(int steps = kSteps) {
  TrailRecorder recorder;
  fly_under(recorder, steps);
  return recorder.trail();
}

/// The steps of all marks.
std::vector<std::uint64_t> marks(const HashTrail& trail) {
  std::vector<std::uint64_t> steps;
  TrailUnpacker span(trail.spans, trail.steps_per_second);
  while (span.next())
    steps.push_back(span.mark().step);
  EXPECT_TRUE(span.ok());
  return steps;
}

TEST(TrailRecorder, MarksTheStartEverySecondAndTheEnd) {
  const HashTrail trail = recorded();
  EXPECT_EQ(trail.steps_per_second, 50u);
  EXPECT_EQ(marks(trail), (std::vector<std::uint64_t>{0, 50, 100, 120}));
  EXPECT_EQ(trail.last_step, 120u);
  EXPECT_EQ(recorded(), trail);
  EXPECT_EQ(trail_of(trail.spans, 50), trail);
}

TEST(TrailRecorder, DoesNotMarkTheEndTwice) {
  EXPECT_EQ(marks(recorded(100)).size(), 3u);
  EXPECT_EQ(marks(recorded(0)).size(), 1u);
}

TEST(TrailRecorder, MarksLessOftenAfterAnHour) {
  EXPECT_TRUE(is_mark(3599 * 50, 50));
  EXPECT_TRUE(is_mark(3600 * 50, 50));
  EXPECT_FALSE(is_mark(3601 * 50, 50));
  EXPECT_FALSE(is_mark(3600 * 50 + 5, 50));
  EXPECT_TRUE(is_mark(3610 * 50, 50));
}

/// However a run is cut into pieces that are taken away, together they are its trail.
TEST(TrailRecorder, GivesItsSpansAway) {
  const HashTrail whole = recorded();
  struct Taker final : Observer {
    void begin(const World& world, double dt) override { recorder.begin(world, dt); }
    void observe(const World& world, const StepInfo& info, std::span<const Event> events) override {
      recorder.observe(world, info, events);
      most = std::max(most, recorder.spans().size());
      if (!recorder.spans().empty())
        all += recorder.take();
    }
    void finish(const World& world) override {
      recorder.finish(world);
      all += recorder.take();
    }
    TrailRecorder recorder;
    std::string all;
    std::size_t most = 0;
  } taker;
  fly_under(taker);
  EXPECT_EQ(taker.all, whole.spans);
  EXPECT_LT(taker.most, whole.spans.size());
}

TEST(TrailChecker, IsContentWithTheSameRun) {
  const HashTrail trail = recorded();
  TrailChecker checker(trail);
  fly_under(checker);
  EXPECT_FALSE(checker.departure());
  EXPECT_FALSE(checker.done());
}

TEST(TrailChecker, NamesTheSpanOfStepsAndWhatIsWrongInTheNextDigest) {
  const HashTrail trail = recorded();
  TrailChecker checker(trail);
  fly_under(checker, kSteps, 92);
  ASSERT_TRUE(checker.departure());
  EXPECT_TRUE(checker.done());
  const Departure& departure = *checker.departure();
  EXPECT_EQ(departure.step, 95u) << "the first fold after step 92";
  EXPECT_EQ(departure.last_good, 90u);
  ASSERT_TRUE(departure.where);
  EXPECT_EQ(departure.where->step, 100u);
  EXPECT_EQ(departure.where->table, "bird");
  EXPECT_EQ(departure.where->column, "body");
  EXPECT_EQ(departure.where->field, "position.y");
  ASSERT_TRUE(departure.where->player);
  EXPECT_EQ(departure.reason,
            "the worlds part between steps 90 and 95; " + departure.where->text());
}

TEST(TrailChecker, SaysWhenWithoutDigestsAndNotWhere) {
  const HashTrail whole = recorded(), light = without_digests(whole);
  EXPECT_LT(light.spans.size(), whole.spans.size());
  EXPECT_EQ(light.last_hash, whole.last_hash);
  TrailChecker same(light);
  fly_under(same);
  EXPECT_FALSE(same.departure());
  TrailChecker checker(light);
  fly_under(checker, kSteps, 92);
  ASSERT_TRUE(checker.departure());
  EXPECT_TRUE(checker.done());
  EXPECT_EQ(checker.departure()->step, 95u);
  EXPECT_FALSE(checker.departure()->where);
  EXPECT_EQ(checker.departure()->reason, "the worlds part between steps 90 and 95");
}

TEST(TrailChecker, SeesWhatHappensBetweenTheLastFoldAndTheEnd) {
  const HashTrail trail = recorded(118);
  TrailChecker checker(trail);
  fly_under(checker, 118, 116);
  ASSERT_TRUE(checker.departure());
  EXPECT_EQ(checker.departure()->step, 118u);
  EXPECT_EQ(checker.departure()->last_good, 115u);
  EXPECT_TRUE(checker.departure()->where);
}

/// Nobody flies on to the end for a fold that somebody changed.
TEST(TrailChecker, IsDoneWhenTheWorldsAreTheSameAgain) {
  HashTrail trail = recorded();
  TrailUnpacker start(trail.spans, 50);
  ASSERT_TRUE(start.next());
  TrailRecorder first;
  fly_under(first, 0);
  const std::size_t fold = first.spans().size() + 1;  // behind the number of steps
  trail.spans[fold] = static_cast<char>(trail.spans[fold] ^ 1);
  TrailChecker checker(trail);
  fly_under(checker);
  ASSERT_TRUE(checker.departure());
  EXPECT_TRUE(checker.done());
  EXPECT_EQ(checker.departure()->reason, "the worlds part between steps 0 and 5");
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
  trail.steps_per_second = 100;
  TrailChecker checker(trail);
  fly_under(checker, 1);
  ASSERT_TRUE(checker.departure());
  EXPECT_EQ(checker.departure()->reason, "the replay makes 50 steps per second, the recording 100");
}

}  // namespace
}  // namespace eyrie::sim
