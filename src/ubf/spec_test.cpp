// SPDX-License-Identifier: MIT
#include "ubf/spec.hpp"

#include <gtest/gtest.h>

#include "support/ubf/registry.hpp"

namespace eyrie::ubf::testing {
namespace {

/// The vote of a tree in a state, -1 for a failure.
float vote(const RobotTree& tree, const State& state) {
  std::vector<std::byte> slab(tree.memory_bytes());
  RobotProposal out;
  const Status status = tree.tick({.state = state, .memory = slab.data()}, out);
  return status == kFailure ? -1 : out.vote;
}

const char* const kEngage =
    "{parameters: {vote: 5, near: , what: {probe: {cue: 1}}}, root: {guard: {when: range < $near, "
    "child: {winner_takes_all: {vote: $vote, children: [$what]}}}}}";

TEST(Subtree, TakesArgumentsAndDefaultsAsNumbersPiecesOfATextAndNodes) {
  const NamedTrees trees = NamedTrees().with("engage", kEngage);
  State state;
  state.cues[1] = {kRunning, 1, {.heading = 1}};
  state.cues[2] = {kSuccess, 1, {}};
  const RobotTree far = build("{tree: {engage: {near: 10 nmi}}}", trees);
  state.range = 18000;
  EXPECT_EQ(vote(far, state), 5);
  state.range = 19000;
  EXPECT_EQ(vote(far, state), -1);
  const RobotTree near =
      build("{tree: {engage: {near: 1 nmi, vote: 7, what: {probe: {cue: 2}}}}}", trees);
  state.range = 1000;
  EXPECT_EQ(vote(near, state), 7);
  state.range = 2000;
  EXPECT_EQ(vote(near, state), -1);
}

TEST(Subtree, HandsItsArgumentsOnToOthers) {
  const NamedTrees trees =
      NamedTrees()
          .with("inner",
                "{parameters: {n: }, root: {winner_takes_all: {vote: $n, children: "
                "[{probe: {cue: 1}}]}}}")
          .with("outer", "{parameters: {m: 3}, root: {tree: {inner: {n: $m}}}}");
  State state;
  state.cues[1] = {kRunning, 1, {.heading = 1}};
  EXPECT_EQ(vote(build("{tree: outer}", trees), state), 3);
  EXPECT_EQ(vote(build("{tree: {outer: {m: 9}}}", trees), state), 9);
}

TEST(Subtree, RefersToATreeThatItsArgumentNames) {
  const NamedTrees trees =
      NamedTrees()
          .with("wrap", "{parameters: {name: }, root: {winner_takes_all: [!tree $name]}}")
          .with("plain", "{probe: {cue: 1}}");
  State state;
  state.cues[1] = {kRunning, 4, {}};
  EXPECT_EQ(vote(build("{tree: {wrap: {name: plain}}}", trees), state), 4);
  EXPECT_EQ(vote(build("!tree {wrap: {name: plain}}", trees), state), 4) << "the other way";
}

TEST(Subtree, TakesADollarBeforeNoNameAsItIs) {
  const NamedTrees trees =
      NamedTrees().with("cheap", "{parameters: {n: 1}, root: {probe: {cue: $n, name: US$ 5 $}}}");
  EXPECT_EQ(build("{tree: cheap}", trees).root().label(), "US$ 5 $");
}

TEST(Subtree, LeavesItsArgumentsAsTheyAreButPutsParametersIntoDefaults) {
  const NamedTrees trees = NamedTrees().with(
      "t",
      "{parameters: {cue: 1, what: {probe: {cue: $cue}}}, root: {winner_takes_all: [{probe: {cue: "
      "$cue}}, $what]}}");
  State state;
  state.cues[1] = {kRunning, 4, {}};
  state.cues[2] = {kRunning, 5, {}};
  EXPECT_EQ(vote(build("{tree: {t: {cue: 2}}}", trees), state), 5);
  EXPECT_EQ(mistakes("{tree: {t: {what: {probe: {cue: $cue}}}}}", trees),
            "test.yaml:1:33: cue: expected a whole number, got '$cue'");
}

TEST(Subtree, ReadsStateFieldsUnderTheNamesOfItsReference) {
  const NamedTrees trees =
      NamedTrees()
          .with("close", "{guard: {when: distance < 1 km and not busy, child: {probe: {cue: 1}}}}")
          .with("pack", "{tree: {close: {fields: {distance: way}}}}");
  State state;
  state.cues[1] = {kRunning, 4, {}};
  const RobotTree direct =
      build("{tree: {close: {fields: {distance: range, busy: alarm}}}}", trees);
  state.range = 500;
  EXPECT_EQ(vote(direct, state), 4);
  state.alarm = true;
  EXPECT_EQ(vote(direct, state), -1);
  // through two references: the outer one names what the inner one left
  const RobotTree nested = build("{tree: {pack: {fields: {way: altitude, busy: alarm}}}}", trees);
  state.alarm = false;
  state.range = 5000;
  state.altitude = 999;
  EXPECT_EQ(vote(nested, state), 4);
  // a renamed name does not hang on behind the reference
  EXPECT_EQ(
      mistakes("{winner_takes_all: [{tree: {close: {fields: {distance: range, busy: alarm}}}}, "
               "{holds: not busy}]}",
               trees),
      "test.yaml:1:92: there is no state field 'busy', only range, altitude, count, alarm, phase");
  EXPECT_EQ(mistakes("{tree: {close: {fields: {distance: rnge, busy: alarm}}}}", trees),
            "close.yaml:1:16: 'distance' means 'rnge' here, and there is no state field 'rnge'; "
            "did you mean 'range'?");
}

TEST(Subtree, MistakesAreSaidWithTheirPlace) {
  const NamedTrees trees = NamedTrees()
                               .with("engage", kEngage)
                               .with("idle", "{parameters: {pace: 3}, root: {probe: {cue: 1}}}")
                               .with("nested",
                                     "{parameters: {pace: 3, what: {probe: {cue: $pace}}}, root: "
                                     "{winner_takes_all: [$what]}}")
                               .with("typo",
                                     "{parameters: {vote: 3}, root: {winner_takes_all: {vote: "
                                     "$vot, children: [{probe: {cue: 1}}]}}}")
                               .with("plain", "{probe: {cue: 1}}");
  EXPECT_EQ(mistakes("{tree: engage}", trees),
            "test.yaml:1:8: tree 'engage' needs the argument 'near'");
  EXPECT_EQ(mistakes("{tree: {engage: {near: 1 m, voet: 3}}}", trees),
            "test.yaml:1:29: tree 'engage' has no parameter 'voet'; did you mean 'vote'?");
  EXPECT_EQ(mistakes("{tree: {engage: {near: 1 m, vote: many}}}", trees),
            "test.yaml:1:35: vote: expected a plain number such as '0.5', got 'many'");
  EXPECT_EQ(
      mistakes("{tree: {engage: {near: 1 s}}}", trees),
      "engage.yaml:1:87: range: expected a length such as '6000 ft', got '1 s' (a time) (with "
      "the arguments at test.yaml:1:9)")
      << "there may be several references";
  EXPECT_EQ(mistakes("{tree: {plain: {vote: 3}}}", trees),
            "test.yaml:1:17: tree 'plain' has no parameter 'vote'");
  EXPECT_EQ(mistakes("{tree: idle}", trees),
            "idle.yaml:1:15: tree 'idle' never uses its parameter 'pace'");
  EXPECT_EQ(mistakes("{tree: {nested: {what: {probe: {cue: 2}}}}}", trees), "")
      << "the default that is not taken names 'pace'";
  EXPECT_EQ(mistakes("{tree: typo}", trees),
            "typo.yaml:1:57: tree 'typo' has no parameter 'vot'; did you mean 'vote'?");
  EXPECT_EQ(mistakes("{tree: {plain: {fields: {far: range}}}}", trees),
            "test.yaml:1:17: fields: nothing in tree 'plain' reads 'far'");
  EXPECT_EQ(mistakes("{tree: {plain: {}, idle: {}}}", trees),
            "test.yaml:1:2: a reference names its tree, as in {tree: ingress}, or with arguments "
            "{tree: {ingress: {vote: 40}}}");
}

TEST(Subtree, ArgumentsThatMultiplyAreStoppedBeforeTheyFillTheMemory) {
  NamedTrees trees;
  trees.with("t0", "{parameters: {a: }, root: {winner_takes_all: [$a, $a]}}");
  for (int i = 1; i < 30; ++i)
    trees.with(fmt::format("t{}", i),
               fmt::format("{{parameters: {{a: }}, root: {{tree: {{t{}: {{a: {{winner_takes_all: "
                           "[$a, $a, $a, $a]}}}}}}}}}}",
                           i - 1));
  const std::string said = mistakes("{tree: {t29: {a: {probe: {cue: 1}}}}}", trees);
  EXPECT_NE(said.find("larger than 100000 values"), std::string::npos) << said;
}

TEST(Subtree, ATagIsTheSameAsTheKey) {
  const NamedTrees trees = NamedTrees().with("plain", "{probe: {cue: 1}}");
  Value tagged = Value::scalar("plain");
  tagged.tag = "!tree";
  Diagnostics diagnostics;
  const auto spec = read_spec(tagged, diagnostics);
  ASSERT_TRUE(spec);
  EXPECT_EQ(spec->type, kTreeReference);
  EXPECT_EQ(spec->body->text, "plain");
}

}  // namespace
}  // namespace eyrie::ubf::testing
