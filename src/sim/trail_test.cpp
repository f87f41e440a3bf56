// SPDX-License-Identifier: MIT
#include "sim/trail.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "sim/run.hpp"
#include "sim/swarm_test.hpp"

namespace eyrie::sim {
namespace {

constexpr std::uint32_t kRate = 50;

/// A second of a run: most of its fields stay, some rows come and go.
struct Second {
  Mark mark;
  std::vector<std::uint16_t> folds;
};

std::vector<Second> seconds() {
  std::vector<Second> all(1);
  all[0].mark.digest.fields =
      *rc::gen::container<std::vector<std::uint16_t>>(rc::gen::arbitrary<std::uint16_t>());
  const auto count = *rc::gen::inRange(0, 8);
  for (int i = 0; i < count; ++i) {
    Second next;
    next.mark = all.back().mark;
    const auto steps = *rc::gen::inRange<std::uint64_t>(1, 4 * kRate);
    for (std::uint64_t s = next.mark.step + 1; s <= next.mark.step + steps; ++s)
      if (TrailPacker(kRate).is_fold(s))
        next.folds.push_back(*rc::gen::arbitrary<std::uint16_t>());
    next.mark.step += steps;
    next.mark.digest.step = next.mark.step;
    next.mark.hash = *rc::gen::arbitrary<std::uint64_t>();
    next.mark.digest.header = *rc::gen::arbitrary<std::uint16_t>();
    for (std::uint16_t& field : next.mark.digest.fields)
      if (*rc::gen::inRange(0, 4) == 0)
        field = *rc::gen::arbitrary<std::uint16_t>();
    if (*rc::gen::inRange(0, 2) == 0)
      next.mark.digest.rows.resize(*rc::gen::inRange<std::size_t>(0, 5));
    for (Digest::Row& row : next.mark.digest.rows)
      row = {.table = *rc::gen::inRange(1U, 4U),
             .player = PlayerId{*rc::gen::inRange(1U, 1000U)},
             .hash = *rc::gen::arbitrary<std::uint16_t>()};
    all.push_back(next);
  }
  return all;
}

std::string packed(const std::vector<Second>& all) {
  TrailPacker packer(kRate);
  for (const Second& one : all) {
    for (const std::uint16_t fold : one.folds)
      packer.fold(fold);
    packer.mark(one.mark);
  }
  return packer.take();
}

RC_GTEST_PROP(PackedTrail, ComesBackAsItWas, ()) {
  const std::vector<Second> all = seconds();
  const std::string bytes = packed(all);
  TrailUnpacker span(bytes, kRate);
  std::uint64_t step = 0;
  for (const Second& one : all) {
    RC_ASSERT(span.next());
    RC_ASSERT(span.mark() == one.mark);
    std::size_t next = 0;
    for (; step <= one.mark.step; ++step)
      if (span.has_fold(step))
        RC_ASSERT(span.fold(step) == one.folds.at(next++));
    RC_ASSERT(next == one.folds.size());
  }
  RC_ASSERT(!span.next());
  RC_ASSERT(span.ok());
}

RC_GTEST_PROP(PackedTrail, NoticesWhenItIsCut, ()) {
  const std::vector<Second> all = seconds();
  const std::string bytes = packed(all);
  const auto size = *rc::gen::inRange<std::size_t>(0, bytes.size());
  TrailUnpacker span(std::string_view(bytes).substr(0, size), kRate);
  std::size_t whole = 0;
  while (span.next())
    ++whole;
  RC_ASSERT(whole < all.size());
}

/// Whatever the bytes are; the sanitizers see what goes over an edge.
RC_GTEST_PROP(PackedTrail, SurvivesDamage, ()) {
  std::string bytes = packed(seconds());
  bytes[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::arbitrary<char>();
  TrailUnpacker span(bytes, kRate);
  std::uint64_t last = 0;
  while (span.next()) {
    RC_ASSERT(span.mark().step >= last);
    last = span.mark().step;
    for (std::uint64_t step = last > 5 ? last - 5 : 0; step <= last; ++step)
      if (span.has_fold(step))
        static_cast<void>(span.fold(step));
  }
}

TEST(PackedTrail, RefusesNumbersThatTheBytesCannotHold) {
  const auto refused = [](std::initializer_list<int> numbers) {
    std::string bytes;
    for (const int number : numbers)
      bytes.push_back(static_cast<char>(number));
    TrailUnpacker span(bytes, kRate);
    while (span.next()) {
    }
    return !span.ok();
  };
  EXPECT_FALSE(refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 0})) << "a start without fields";
  EXPECT_TRUE(refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 3, 0})) << "three fields";
  EXPECT_TRUE(refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 1, 2})) << "two rows";
  EXPECT_TRUE(refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 2})) << "neither the same nor other";
  EXPECT_TRUE(refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 0, 127, 0, 0})) << "127 steps";
  EXPECT_TRUE(
      refused({0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 1, 2, 0, 0}))
      << "a second without steps";
  EXPECT_TRUE(refused({255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 1})) << "2^70 steps";
}

/// What changes seldom costs little: a digest of a thousand fields of which two change is small.
TEST(PackedTrail, KeepsOnlyWhatChanged) {
  TrailPacker packer(kRate);
  Mark mark;
  mark.digest.fields.resize(1000);
  packer.mark(mark);
  EXPECT_GT(packer.take().size(), 2000u);
  for (int second = 1; second <= 10; ++second) {
    mark.step += kRate;
    mark.digest.fields[7] = static_cast<std::uint16_t>(second);
    mark.digest.fields[900] = static_cast<std::uint16_t>(-second);
    for (int i = 0; i < 10; ++i)
      packer.fold(0);
    packer.mark(mark);
  }
  EXPECT_LT(packer.take().size(), 10 * 45u);
}

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

/// Asks for the trail after a step.
struct SoFar final : Observer {
  TrailRecorder recorder;
  std::map<std::uint64_t, HashTrail> trails;
  void begin(const World& world, double dt) override { recorder.begin(world, dt); }
  void observe(const World& world, const StepInfo& info, std::span<const Event> events) override {
    recorder.observe(world, info, events);
    trails[world.step()] = recorder.trail_to(world);
  }
};

TEST(TrailRecorder, GivesTheTrailSoFarAndGoesOn) {
  SoFar so_far;
  fly_under(so_far);
  for (const int step : {1, 49, 50, 51, 100, 117})
    EXPECT_EQ(so_far.trails[static_cast<std::uint64_t>(step)], recorded(step)) << step;
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
  TrailRecorder without(false);
  fly_under(without);
  EXPECT_EQ(without.trail(), light);
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
