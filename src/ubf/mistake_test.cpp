// SPDX-License-Identifier: MIT
/// \file  An answer that means nothing is, in every build and under every node, that of a child
/// which failed, and whoever listens is told of it.
#include <gtest/gtest.h>

#include "support/ubf/registry.hpp"
#include "ubf/behavior.hpp"

namespace eyrie::ubf::testing {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Cues that mean nothing, with what is said of them.
struct Wrong {
  Cue cue;
  const char *what, *why;
};
std::vector<Wrong> wrong_cues() {
  const char* vote = "its vote is no finite number from 0 up";
  return {{{kRunning, kNan, {.altitude = 1}}, "votes what means nothing: vote is nan", vote},
          {{kRunning, kInfinity, {.altitude = 1}}, "votes what means nothing: vote is inf", vote},
          {{kSuccess, -3, {.altitude = 1}}, "votes what means nothing: vote is -3", vote},
          {{kRunning, 90, {.altitude = std::nan("")}},
           "recommends what means nothing: altitude is nan m",
           "altitude is no plausible number"},
          {{kSuccess, 90, {.heading = 1, .speed = -kInfinity}},
           "recommends what means nothing: speed is -inf m/s",
           "speed is no plausible number"}};
}

/// Decides the same as if the child that answers `cue` had failed, with and without a trace.
void expect_failure(const std::string& tree, std::size_t child, const Wrong& wrong) {
  SCOPED_TRACE(tree + ": " + wrong.what);
  Robot failing(build(tree)), robot(build(tree));
  for (Robot* r : {&failing, &robot})
    for (std::size_t i = 0; i < 3; ++i)
      r->cue(i) = {kRunning, 10.0F + static_cast<float>(i), {.heading = 1, .speed = 100}};
  failing.say(child, kFailure);
  robot.cue(child) = wrong.cue;
  EXPECT_EQ(robot.tick(), failing.tick());
  EXPECT_TRUE(equal(robot.out.action, failing.out.action));
  EXPECT_EQ(robot.out.vote, failing.out.vote);
  EXPECT_EQ(robot.leader(), failing.leader());
  const std::string path = fmt::format("root/probe[{}]", child);
  if (robot.asked_now(path)) {
    EXPECT_EQ(robot.row(path).status, kFailure);
    EXPECT_STREQ(robot.trace.why(robot.node(path)), wrong.why);
    if (wrong.cue.status == kRunning) {
      EXPECT_EQ(robot.asked(path), 0u) << "what went on in it forgets";
    }
  }

  Robot unwatched(build(tree));
  unwatched.state = robot.state;
  Mistake mistake;
  const Status status = unwatched.tree.tick({.state = unwatched.state,
                                             .time = 0.1,
                                             .dt = 0.1,
                                             .step = 1,
                                             .memory = unwatched.slab.data(),
                                             .mistake = &mistake},
                                            unwatched.out);
  EXPECT_EQ(status, robot.status);
  EXPECT_TRUE(equal(unwatched.out.action, robot.out.action));
  if (robot.asked_now(path)) {
    EXPECT_EQ(mistake.what, wrong.what);
    EXPECT_EQ(mistake.node, robot.node(path));
  }
}

TEST(Mistake, IsAFailureUnderEveryNodeWithSeveralChildren) {
  for (const char* node :
       {"winner_takes_all: {", "per_field: {", "fusion: {", "fusion: {top: 2, ",
        "paper_fusion: {high_vote: 5, ", "priority: {", "commitment: {margin: 1, ",
        "commitment: {hold: 1 s, ", "verify: {bounds: {speed: {min: 0 kt}}, ",
        "motor_schema: {direction: heading, magnitude: speed, unit_vote: 10, ",
        "vote_grid: {grid: {heading: {from: 0 deg, to: 360 deg, steps: 12, reach: 60 deg}}, ",
        "weighted_random: {", "selector: {", "sequence: {", "selector_with_memory: {",
        "sequence_with_memory: {", "parallel: {failure_count: 2, ", "parallel_all: {",
        "random_selector: {"})
    for (std::size_t child = 0; child < 3; ++child)
      for (const Wrong& wrong : wrong_cues())
        expect_failure(fmt::format("{{{}children: [{{probe: {{cue: 0}}}}, {{probe: {{cue: 1}}}}, "
                                   "{{probe: {{cue: 2}}}}]}}}}",
                                   node),
                       child, wrong);
}

TEST(Mistake, IsAFailureOfTheRootToo) {
  for (const Wrong& wrong : wrong_cues()) {
    Robot robot(probe(0));
    robot.cue(0) = wrong.cue;
    EXPECT_EQ(robot.tick(), kFailure);
    EXPECT_TRUE(robot.out.is_empty());
    EXPECT_EQ(robot.row("root").status, kFailure);
    EXPECT_STREQ(robot.trace.why(0), wrong.why);
    EXPECT_EQ(robot.asked("root"), 0u);
  }
}

/// Of Eyrie's own nodes nobody asks.
TEST(Mistake, IsAStatusThatIsNoneFromAStranger) {
  RobotRegistry registry;
  add_standard_nodes(registry);
  registry.add<Probe>("a plug-in");
  for (const char* node : {"winner_takes_all", "selector", "priority", "fusion"}) {
    Robot robot(build(fmt::format("{{{}: [{{probe: {{cue: 0}}}}, {{probe: {{cue: 1}}}}]}}", node),
                      {}, registry));
    const auto decide = [&](Mistake& mistake) {
      return robot.tree.tick(
          {.state = robot.state, .memory = robot.slab.data(), .mistake = &mistake}, robot.out);
    };
    robot.cue(0) = {kFailure};
    robot.cue(1) = {kRunning, 1, {.heading = 2}};
    Mistake none, one;
    const Status failing = decide(none);
    EXPECT_EQ(none.node, kNone);
    robot.cue(0) = {static_cast<Status>(7), 90, {.heading = 1}};
    EXPECT_EQ(decide(one), failing) << node;
    EXPECT_EQ(one.node, 1);
    EXPECT_EQ(one.what, "answers what means nothing: status is 7");
    EXPECT_EQ(robot.tick(), failing);
    EXPECT_EQ(robot.row("root/probe[0]").status, kFailure);
    EXPECT_STREQ(robot.trace.why(1), "its status is none of failure, running and success");
  }
}

TEST(Mistake, IsAVoteThatAScaleMakesInfinite) {
  Robot robot(
      build("{priority: [{winner_takes_all: {vote_scale: 1000, children: [{probe: {cue: "
            "0}}]}}, {probe: {cue: 1}}]}"));
  robot.cue(0) = {kRunning, 3e38F, {.heading = 1}};
  robot.cue(1) = {kRunning, 1, {.heading = 2}};
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.heading, 2);
  EXPECT_EQ(robot.row("root/winner_takes_all").status, kFailure);
  EXPECT_EQ(robot.row("root/winner_takes_all/probe").status, kRunning) << "its vote is one";
}

TEST(Mistake, IsNotWhatAFailureLeaves) {
  Robot robot(make<Wta>(probes(2)));
  robot.cue(0) = {kFailure, kNan, {.heading = std::nan("")}};
  robot.say(1, kRunning, 1);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.trace.why(1), nullptr);
}

TEST(Mistake, TheFirstOfATickIsTold) {
  Robot robot(build("{per_field: [{probe: {cue: 0}}, {probe: {cue: 1}}]}"));
  robot.say(0, kRunning, -1);
  robot.say(1, kRunning, kNan);
  Mistake mistake;
  EXPECT_EQ(
      robot.tree.tick({.state = robot.state, .memory = robot.slab.data(), .mistake = &mistake},
                      robot.out),
      kFailure);
  EXPECT_EQ(mistake.node, 1);
  EXPECT_EQ(mistake.what, "votes what means nothing: vote is -1");
}

/// Changes what its child proposes: the state says how.
class Shifted final : public Decorator<State, Action> {
 public:
  static constexpr std::string_view type_name = "shifted";
  using Decorator::Decorator;
  Status tick(const RobotTick& t, RobotProposal& out) const override {
    const Status status = ask_child(t, out);
    if (out.action.altitude)
      *out.action.altitude += t.state.range;
    return status;
  }
};

/// Asks, forgets what was proposed, and proposes something itself.
class Replaced final : public Decorator<State, Action> {
 public:
  static constexpr std::string_view type_name = "replaced";
  using Decorator::Decorator;
  Status tick(const RobotTick& t, RobotProposal& out) const override {
    const Status status = ask_child(t, out);
    out.clear();
    out.action.heading = t.state.range;
    return status;
  }
};

TEST(Mistake, IsNotToTakeAStrangersFieldForItsChilds) {
  RobotRegistry registry;
  add_standard_nodes(registry);
  registry.add<Probe>();
  registry.add<Replaced>("a plug-in");
  Robot robot(build("{selector: [{replaced: {probe: {cue: 0}}}]}", {}, registry));
  robot.cue(0) = {kRunning, 9, {.heading = 1}};
  robot.state.range = 2;
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.heading, 2);
  EXPECT_EQ(robot.row("root").supplier[0], robot.node("root/replaced"));
}

TEST(Mistake, IsWhatAStrangerMakesOfItsChildsProposal) {
  RobotRegistry registry;
  add_standard_nodes(registry);
  registry.add<Probe>();
  registry.add<Shifted>("a plug-in");
  Robot robot(build("{priority: [{shifted: {probe: {cue: 0}}}, {probe: {cue: 1}}]}", {}, registry));
  robot.cue(0) = {kRunning, 9, {.heading = 1, .altitude = 100}};
  robot.cue(1) = {kRunning, 1, {.altitude = 7}};
  for (const double by : {std::nan(""), static_cast<double>(kInfinity)}) {
    robot.state.range = by;
    EXPECT_EQ(robot.tick(), kRunning);
    EXPECT_EQ(robot.out.action.altitude, 7);
    EXPECT_EQ(robot.row("root/shifted").status, kFailure);
    EXPECT_STREQ(robot.trace.why(1), "altitude is no plausible number");
    EXPECT_EQ(robot.asked("root/shifted/probe"), 0u) << "what went on in it forgets";
    Mistake mistake;
    robot.tree.tick({.state = robot.state, .memory = robot.slab.data(), .mistake = &mistake},
                    robot.out);
    EXPECT_EQ(mistake.node, 1);
  }
  robot.state.range = 50;
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.out.action.altitude, 150);
  const auto& row = robot.row("root");
  EXPECT_EQ(row.supplier[0], robot.node("root/shifted/probe")) << "it left the heading alone";
  EXPECT_EQ(row.supplier[1], robot.node("root/shifted"));
}

TEST(Mistake, IsWhatGoesOutOfATreeInCodeToo) {
  Robot robot(make<Shifted>(probe(0)));
  robot.cue(0) = {kRunning, 9, {.altitude = 100}};
  robot.state.range = std::nan("");
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
}

/// Judges the second candidate with what is no number.
class Dizzy final : public Appraiser<State, Action> {
 public:
  static constexpr std::string_view type_name = "dizzy";
  explicit Dizzy(double worth) : worth_(worth) {}
  Status tick(const RobotTick&, RobotProposal& out) const override {
    out.vote = 99;
    return kRunning;
  }
  double appraise(const RobotTick&, const Action& candidate) const override {
    return *candidate.altitude > 0 ? worth_ : 1;
  }

 private:
  double worth_;
};

TEST(Mistake, IsWhatAnAppraiserSaysOfACandidate) {
  for (const double worth : {std::nan(""), static_cast<double>(kInfinity)}) {
    auto grid = make<VoteGrid<State, Action>>(make<Dizzy>(worth), probe(0));
    EXPECT_EQ(grid->grid.add("altitude", 0, 100, 3, 100), "");
    Robot robot(std::move(grid));
    robot.cue(0) = {kSuccess, 5, {.altitude = 100}};
    EXPECT_EQ(robot.tick(), kSuccess);
    EXPECT_EQ(robot.out.action.altitude, 100);
    EXPECT_EQ(robot.out.vote, 5);
    EXPECT_EQ(robot.row("root/dizzy").status, kFailure);
    EXPECT_STREQ(robot.trace.why(1), "what it says of a candidate is no finite number");
  }
}

}  // namespace
}  // namespace eyrie::ubf::testing
