// SPDX-License-Identifier: MIT
#include "ubf/vote_curve.hpp"

#include <gtest/gtest.h>

#include "core/math.hpp"
#include "support/ubf/registry.hpp"
#include "ubf/trace.hpp"

namespace eyrie::ubf::testing {
namespace {

double score(Curve curve, double value, double from = 0, double to = 1) {
  return Consideration{.from = from, .to = to, .curve = curve}.score(value);
}

TEST(VoteCurve, RisesFromNothingToAllAsItsCurveSays) {
  for (const Curve curve : {Curve::linear, Curve::quadratic, Curve::root, Curve::logistic}) {
    EXPECT_EQ(score(curve, 0), 0);
    EXPECT_EQ(score(curve, 1), 1);
    EXPECT_EQ(score(curve, -5), 0) << "before the first end";
    EXPECT_EQ(score(curve, 9), 1) << "beyond the last one";
    EXPECT_EQ(score(curve, kNoValue), 0);
    for (double x = 0; x < 1; x += 0.125) {
      EXPECT_LT(score(curve, x), score(curve, x + 0.125));
      EXPECT_EQ(score(curve, 40 - 30 * x, 40, 10), score(curve, x)) << "falling";
    }
  }
  EXPECT_EQ(score(Curve::linear, 0.25), 0.25);
  EXPECT_EQ(score(Curve::quadratic, 0.25), 0.0625);
  EXPECT_EQ(score(Curve::root, 0.25), 0.5);
  EXPECT_NEAR(score(Curve::logistic, 0.5), 0.5, 1e-15);
  EXPECT_LT(score(Curve::logistic, 0.25), 0.1);
}

/// The vote of an arbiter over a probe that votes 10, in a state.
float vote(const std::string& text, double range, bool alarm = false) {
  Robot robot(build("{winner_takes_all: {vote: " + text + ", children: [{probe: {cue: 0}}]}}"));
  robot.state.range = range;
  robot.state.alarm = alarm;
  robot.say(0, kRunning, 10);
  robot.tick();
  return robot.out.vote;
}

TEST(VoteCurve, IsTheVoteOfAnArbiterInPlaceOfANumber) {
  const std::string text = "{most: 80, of: range, from: 40 m, to: 20 m}";
  EXPECT_EQ(vote(text, 20), 80);
  EXPECT_EQ(vote(text, 30), 40);
  EXPECT_EQ(vote(text, 50), 0);
  EXPECT_EQ(vote(text, kNoValue), 0) << "abstains without a range";
}

TEST(VoteCurve, NeverFallsBelowTheLeast) {
  const std::string text = "{most: 80, least: 20, of: range, from: 40 m, to: 20 m}";
  EXPECT_EQ(vote(text, 50), 20);
  EXPECT_EQ(vote(text, 30), 50);
}

TEST(VoteCurve, IsAShareOfTheChildsVoteWithoutMost) {
  EXPECT_EQ(vote("{of: range, from: 40 m, to: 20 m}", 30), 5);
}

TEST(VoteCurve, MultipliesSeveralConsiderations) {
  const std::string text = "{most: 80, product: [{of: range, from: 40 m, to: 20 m}, {of: alarm}]}";
  EXPECT_EQ(vote(text, 30, true), 40);
  EXPECT_EQ(vote(text, 30), 0);
}

/// Votes what its parameter says.
class Caller final : public Node {
 public:
  static constexpr std::string_view type_name = "caller";
  static constexpr std::string_view help = "votes";
  static constexpr auto params() {
    return std::tuple{param("vote", &Caller::vote, range(0, 100), "how strongly")};
  }
  Status tick(const RobotTick&, RobotProposal& out) const override {
    out.vote = vote;
    out.action.altitude = 1;
    return kRunning;
  }
  float vote = 60;
};

RobotTree with_caller(const std::string& text) {
  RobotRegistry registry;
  add_standard_nodes(registry);
  registry.add<Caller>();
  return build(text, {}, registry);
}

TEST(VoteCurve, IsThatOfABehaviorAndShownWithItsScores) {
  Robot robot(
      with_caller("{winner_takes_all: [{caller: {vote: {of: range, from: 40 m, to: 20 m, "
                  "curve: quadratic}}}, {caller: {vote: 12, name: other}}]}"));
  robot.state.range = 30;
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.vote, 15) << "a quarter of its own 60";
  EXPECT_NE(to_text(robot.tree, robot.trace).find("running 15 (range 0.25): altitude"),
            std::string::npos)
      << to_text(robot.tree, robot.trace);
  robot.state.range = 35;
  robot.tick();
  EXPECT_EQ(robot.leader(), "root/other");
  std::vector<std::byte> slab(robot.tree.memory_bytes());
  RobotProposal out;
  robot.tree.tick({.state = robot.state, .memory = slab.data()}, out);
  EXPECT_EQ(out.vote, 12) << "the same without a trace";
  EXPECT_EQ(robot.tree.node(2).vote_curve(), nullptr);
}

std::string said(const std::string& text) {
  return mistakes("{winner_takes_all: {vote: " + text + ", children: [{probe: {cue: 0}}]}}");
}

TEST(VoteCurve, MistakesAreSaid) {
  const std::string at = "test.yaml:1:";
  EXPECT_EQ(said("{of: rang, from: 1 m, to: 2 m}"),
            at + "32: there is no state field 'rang'; did you mean 'range'?");
  EXPECT_EQ(said("{of: range, from: 1 m}"), at + "27: vote needs the parameter 'to'");
  EXPECT_EQ(said("{of: range, from: 1 kt, to: 2 m}"),
            at + "45: from: expected a length such as '6000 ft', got '1 kt' (a speed)");
  EXPECT_EQ(said("{of: range, from: 2 m, to: 2 m}"), at + "27: 'from' and 'to' are the same");
  EXPECT_EQ(said("{of: phase}"),
            at + "32: of: 'phase' is one of several names; a vote follows a number or a flag");
  EXPECT_EQ(
      said("{of: alarm, curve: logistics}"),
      at + "46: curve: expected one of linear, quadratic, root, logistic, got 'logistics'; did "
           "you mean 'logistic'?");
  EXPECT_EQ(said("{of: alarm, more: 3}"),
            at + "39: vote has no parameter 'more', only of, curve, from, to, least, most");
  EXPECT_EQ(said("{most: 2000, of: alarm}"), at + "34: vote: 2000 is outside [0, 1000]");
  EXPECT_EQ(said("{most: {most: 20, of: alarm}, of: alarm}"),
            at + "34: vote: 'most' is a number such as 40, got a map");
  EXPECT_EQ(said("{most: 20, least: 30, of: alarm}"),
            at + "27: vote: 'least' is 30, above the full vote of 20");
  EXPECT_EQ(said("{least: 30, of: alarm}"), at + "27: vote: 'least' needs 'most' beside it");
  EXPECT_EQ(said("{product: []}"),
            at + "37: product: expected a list of 1 to 6 considerations such as {of: range, from: "
                 "40 nmi, to: 10 nmi}, got 0 of them");
  EXPECT_NE(mistakes("{inverter: {vote: {of: alarm}, child: {probe: {cue: 0}}}}")
                .find("inverter has no parameter 'vote'"),
            std::string::npos);
}

}  // namespace
}  // namespace eyrie::ubf::testing
