// SPDX-License-Identifier: MIT
/// \file  The arbiters that choose among candidates: vote_grid and utility.
#include "ubf/arbiter/grid.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>

#include "support/ubf/registry.hpp"

namespace eyrie::ubf::testing {
namespace {

using ByVotes = VoteGrid<State, Action>;
using ByUtility = Utility<State, Action>;

/// Judges candidates as a test says.
class Judge final : public Appraiser<State, Action> {
 public:
  static constexpr std::string_view type_name = "judge";
  static constexpr std::string_view help = "judges candidates";

  Judge(float weight, std::function<double(const Action&)> worth)
      : weight_(weight), worth_(std::move(worth)) {}

  Status tick(const RobotTick&, RobotProposal& out) const override {
    out.vote = weight_;
    return Status::running;
  }
  double appraise(const RobotTick&, const Action& candidate) const override {
    return worth_(candidate);
  }

 private:
  float weight_;
  std::function<double(const Action&)> worth_;
};

/// Headings every 10 degrees; what a probe asks for counts to 60 degrees around it.
template <class Arbiter>
std::unique_ptr<Arbiter> compass(Children children, double spread = 0) {
  auto node = make<Arbiter>(std::move(children));
  EXPECT_EQ(node->grid.add("heading", 0, kTau, 36, radians(60), spread), "");
  return node;
}
double heading_of(const Robot& robot) {
  return degrees(robot.out.action.heading.value_or(-1));
}

TEST(VoteGrid, GivesOneVoiceTheNearestCandidate) {
  Robot robot(compass<ByVotes>(probes(1)));
  robot.cue(0) = {kSuccess, 3, {.heading = radians(93)}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.out.vote, 3);
  EXPECT_NEAR(heading_of(robot), 90, 1e-9);
  robot.cue(0).action.heading = radians(357);
  robot.tick();
  EXPECT_NEAR(heading_of(robot), 0, 1e-9) << "it is a circle";
}

TEST(VoteGrid, FindsWhatManyCanLiveWith) {
  Robot robot(compass<ByVotes>(probes(3)));
  robot.cue(0) = {kRunning, 4, {.heading = radians(0)}};
  robot.cue(1) = {kRunning, 3, {.heading = radians(40)}};
  robot.cue(2) = {kRunning, 3, {.heading = radians(50)}};
  robot.tick();
  EXPECT_NEAR(heading_of(robot), 40, 1e-9);
  robot.say(2, kFailure);
  robot.tick();
  EXPECT_NEAR(heading_of(robot), 0, 1e-9) << "the stronger of two";
}

TEST(VoteGrid, TakesTheFirstOfEqualsWhereTheLastBitsDiffer) {
  // all candidates between two voices of one weight have the same sum
  Robot robot(compass<ByVotes>(probes(2)));
  for (int tenths = 0; tenths < 100; ++tenths) {
    const double off = 0.1 * tenths;
    robot.cue(0) = {kRunning, 3.3F, {.heading = radians(70 + off)}};
    robot.cue(1) = {kRunning, 3.3F, {.heading = radians(120 + off)}};
    robot.tick();
    EXPECT_NEAR(heading_of(robot), off == 0 ? 70 : 80, 1e-9) << off;
  }
}

TEST(VoteGrid, HearsAJudgeWhoCountsInSmallNumbers) {
  Children children;
  children.push_back(
      make<Judge>(1.F, [](const Action& a) { return *a.heading == radians(90) ? 2e-9 : 1e-9; }));
  Robot robot(compass<ByUtility>(std::move(children)));
  robot.tick();
  EXPECT_NEAR(heading_of(robot), 90, 1e-9);
}

TEST(VoteGrid, LetsAJudgeSpeakAgainstCandidates) {
  Children children = probes(1);
  children.push_back(make<Judge>(20.F, [](const Action& a) {
    return std::fabs(wrap_pi(*a.heading - radians(90))) < radians(25) ? -1.0 : 0.0;
  }));
  Robot robot(compass<ByVotes>(std::move(children)));
  robot.cue(0) = {kSuccess, 10, {.heading = radians(95)}};
  robot.tick();
  EXPECT_NEAR(heading_of(robot), 120, 1e-9) << "the nearest way round";
  EXPECT_EQ(robot.out.vote, 20);
  EXPECT_EQ(robot.supplier(0), "root");
}

TEST(VoteGrid, TakesOtherFieldsFromTheStrongestAndKeepsOrdersWhole) {
  Robot robot(compass<ByVotes>(probes(3)));
  robot.cue(0) = {kRunning, 5, {.heading = 1, .release = 7}};
  robot.cue(1) = {kRunning, 9, {.speed = 200.F}};
  robot.cue(2) = {kRunning, 1, {.release = 8}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.speed, 200.F);
  EXPECT_EQ(robot.out.action.release, 7u);
  EXPECT_EQ(robot.supplier(3), "root/probe[0]");
  EXPECT_EQ(robot.supplier(2), "root/probe[1]");
}

TEST(VoteGrid, DecidesNothingThatNobodyHasAnOpinionOf) {
  Robot robot(compass<ByVotes>(probes(2)));
  EXPECT_EQ(robot.tick(), kFailure);
  robot.cue(1) = {kRunning, 2, {.speed = 100.F}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_FALSE(robot.out.action.heading);
  EXPECT_EQ(robot.leader(), "root/probe[1]");
}

/// What one voice says of a candidate over two axes, written down anew.
double opinion(const Action& asked, double weight, double heading, double altitude) {
  const double turn = asked.heading ? std::fabs(wrap_pi(heading - *asked.heading)) : 0;
  const double climb = asked.altitude ? std::fabs(altitude - *asked.altitude) : 0;
  const int fields = asked.heading.has_value() + asked.altitude.has_value();
  double sum = 0;
  if (asked.heading)
    sum += 1 - 2 * std::min(1.0, turn / 1.5);
  if (asked.altitude)
    sum += 1 - 2 * std::min(1.0, climb / 3000);
  return fields ? weight * sum / fields : 0;
}

RC_GTEST_PROP(VoteGrid, NeverTakesACandidateWithLessVotesThanAnother, ()) {
  auto node = make<ByVotes>(probes(4));
  node->grid.add("heading", 0, kTau, 12, 1.5);
  node->grid.add("altitude", 1000, 9000, 5, 3000);
  Robot robot(std::move(node));
  for (std::size_t i = 0; i < 4; ++i) {
    robot.cue(i) = {*rc::gen::element(kFailure, kRunning), float(*rc::gen::inRange(0, 5)), {}};
    if (*rc::gen::arbitrary<bool>())
      robot.cue(i).action.heading = 0.1 * *rc::gen::inRange(0, 62);
    if (*rc::gen::arbitrary<bool>())
      robot.cue(i).action.altitude = *rc::gen::inRange(0, 10000);
  }
  const auto sum = [&](double heading, double altitude) {
    double total = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (const Cue& c = robot.cue(i); c.status != kFailure)
        total += opinion(c.action, static_cast<double>(c.vote), heading, altitude);
    return total;
  };
  robot.tick();
  if (!robot.out.action.heading)
    return;
  const double won = sum(*robot.out.action.heading, *robot.out.action.altitude);
  for (int h = 0; h < 12; ++h)
    for (int a = 0; a < 5; ++a)
      RC_ASSERT(sum(h * kTau / 12, 1000 + 2000 * a) <= won + 1e-9);
}

TEST(Utility, WithoutASpreadIsTheSameAsVotes) {
  for (int seed = 0; seed < 20; ++seed) {
    Robot votes(compass<ByVotes>(probes(3))), utility(compass<ByUtility>(probes(3)));
    for (std::size_t i = 0; i < 3; ++i)
      votes.cue(i) = utility.cue(i) = {
          kRunning, float(1 + (seed + 3 * i) % 5), {.heading = 0.3 * double(seed) * double(i + 1)}};
    votes.tick();
    utility.tick();
    EXPECT_EQ(votes.out.action.heading, utility.out.action.heading);
  }
}

/// A narrow best command beside a cliff, and a wide plateau that is nearly as good.
double cliff(const Action& a) {
  const double x = degrees(*a.heading);
  if (x > 88 && x < 92)
    return 10;
  if (x > 92 && x < 150)
    return -20;
  return x > 200 && x < 300 ? 9 : 0;
}
TEST(Utility, PrefersACommandWhoseOutcomesAreGoodToOneThatMustComeOutExactly) {
  const auto with_spread = [](double spread) {
    Children children;
    children.push_back(make<Judge>(1.F, cliff));
    return Robot(compass<ByUtility>(std::move(children), spread));
  };
  Robot exact = with_spread(0);
  exact.tick();
  EXPECT_NEAR(heading_of(exact), 90, 1e-9);
  Robot careful = with_spread(radians(15));
  careful.tick();
  EXPECT_GT(heading_of(careful), 230);
  EXPECT_LT(heading_of(careful), 270);
}

TEST(Utility, PutsAllThatLiesBeyondAnEndThere) {
  Grid<Action> grid;
  ASSERT_EQ(grid.add("altitude", 0, 400, 5, 500, 200), "");
  ASSERT_EQ(grid.axes()[0].spread.size(), 5u);
  Children children;
  children.push_back(make<Judge>(1.F, [](const Action& a) {
    const double worth[] = {0, 30, 0, 0, -100};
    return worth[static_cast<int>(*a.altitude / 100 + 0.5)];
  }));
  auto node = make<ByUtility>(std::move(children));
  node->grid = grid;
  Robot robot(std::move(node));
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 0) << "from 100 m it is too near to the other end";
}

TEST(Utility, SpreadsOverTheGridAndNoFurther) {
  Grid<Action> grid;
  ASSERT_EQ(grid.add("altitude", 0, 900, 10, 500, 120), "");
  double total = 0;
  const auto& spread = grid.axes()[0].spread;
  for (std::size_t k = 0; k < spread.size(); ++k)
    total += (k ? 2 : 1) * spread[k];
  EXPECT_NEAR(total, 1, 1e-12);
  EXPECT_NEAR(spread[1] / spread[0], std::exp(-0.5 * 100 * 100 / (120. * 120)), 1e-12);
  // the best outcome at an end is reached by the command at the end
  Children children;
  children.push_back(make<Judge>(1.F, [](const Action& a) { return *a.altitude; }));
  auto node = make<ByUtility>(std::move(children));
  node->grid = grid;
  Robot robot(std::move(node));
  robot.tick();
  EXPECT_EQ(robot.out.action.altitude, 900);
}

TEST(GridArbiters, MistakesAreSaid) {
  const auto said = [](const std::string& type, const std::string& grid) {
    return mistakes("{" + type + ": {grid: " + grid + ", children: [{probe: {cue: 0}}]}}");
  };
  const std::string good = "{heading: {from: 0 deg, to: 360 deg, steps: 36, reach: 60 deg}}";
  EXPECT_EQ(said("vote_grid", good), "");
  EXPECT_EQ(
      said("utility", "{altitude: {from: 0 m, to: 9 km, steps: 10, reach: 1 km, spread: 500 m}}"),
      "");
  EXPECT_EQ(said("vote_grid", "{}"), "test.yaml:1:2: a grid needs at least one field");
  EXPECT_NE(said("vote_grid", "{haeding: {from: 0 deg, to: 1 deg, steps: 2, reach: 1 deg}}")
                .find("an action has no field 'haeding'; did you mean 'heading'?"),
            std::string::npos);
  EXPECT_NE(said("vote_grid", "{release: {from: 0, to: 3, steps: 4, reach: 1}}")
                .find("'release' is not a number and has no candidates"),
            std::string::npos);
  EXPECT_NE(said("vote_grid",
                 "{heading: {from: 0 deg, to: 360 deg, steps: 36, reach: 60 deg, "
                 "spread: 5 deg}}")
                .find("'spread' is for utility"),
            std::string::npos);
  EXPECT_NE(said("vote_grid",
                 "{heading: {from: 0 deg, to: 360 deg, steps: 72, reach: 60 deg}, "
                 "altitude: {from: 0 m, to: 1 m, steps: 20, reach: 1 m}}")
                .find("the grid has 1440 candidates, the most is 1024"),
            std::string::npos);
  EXPECT_NE(said("vote_grid", "{altitude: {from: 9 m, to: 1 m, steps: 20, reach: 1 m}}")
                .find("'to' must be greater than 'from'"),
            std::string::npos);
}

TEST(Grid, RefusesNumbersOutOfRangeInCodeToo) {
  Grid<Action> grid;
  EXPECT_EQ(grid.add("altitude", 0, 100, 3, 0), "altitude.reach: 0 m is outside (0 m, 1000000 km]");
  EXPECT_EQ(grid.add("altitude", std::nan(""), 100, 3, 5), "altitude.from is nan");
  EXPECT_EQ(grid.size(), 0u);
}

}  // namespace
}  // namespace eyrie::ubf::testing
