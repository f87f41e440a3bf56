// SPDX-License-Identifier: MIT
/// \file  Every mistake that a file can make in a tree, and the words that the user reads.
#include <gtest/gtest.h>

#include "support/ubf/registry.hpp"

namespace eyrie::ubf::testing {
namespace {

TEST(RegistryErrors, AnUnknownNodeIsAnsweredWithTheNearestName) {
  EXPECT_EQ(mistakes("{winer_takes_all: []}"),
            "test.yaml:1:2: there is no node 'winer_takes_all'; did you mean 'winner_takes_all'?");
  EXPECT_EQ(mistakes("prob"), "test.yaml:1:1: there is no node 'prob'; did you mean 'probe'?");
  EXPECT_EQ(mistakes("xyzzy"), "test.yaml:1:1: there is no node 'xyzzy'");
}

TEST(RegistryErrors, ATextThatCouldNotBeReadIsNoTreeAndSaysOneThing) {
  const auto said = [](std::string_view text) {
    Diagnostics diagnostics;
    EXPECT_FALSE(standard_registry().build_tree("test", parse_yaml(text, "test.yaml", diagnostics),
                                                diagnostics));
    return diagnostics.text();
  };
  EXPECT_EQ(said("{probe: {cue: 1, cue: 2}}"),
            "test.yaml:1:18: 'cue' is given twice (first at line 1)");
  EXPECT_EQ(said(""), "test.yaml:1:1: the file is empty");
}

TEST(RegistryErrors, AnUnknownParameterIsAnsweredWithTheNearestName) {
  EXPECT_EQ(mistakes("{probe: {cue: 1, bais: 2}}"),
            "test.yaml:1:18: probe has no parameter 'bais'; did you mean 'bias'?");
}

TEST(RegistryErrors, AValueOutOfRangeAndAMissingOneAreToldWithTheirPlace) {
  EXPECT_EQ(mistakes("{probe: {bias: -4}}"),
            "test.yaml:1:9: probe needs the parameter 'cue'\n"
            "test.yaml:1:16: bias: -4 is outside [0, 100]");
  EXPECT_EQ(mistakes("{winner_takes_all: [probe]}"),
            "test.yaml:1:21: probe needs the parameter 'cue'");
  EXPECT_EQ(mistakes("{timeout: {after: 5 kg, child: {check: {cue: 1}}}}"),
            "test.yaml:1:19: after: expected a time such as '3 min', got '5 kg' (a mass)");
}

TEST(RegistryErrors, AllMistakesAreToldTogether) {
  EXPECT_EQ(mistakes("{winner_takes_all: {vote_scale: -1, children:\n"
                     "  [{prob: {cue: 1}},\n"
                     "   {inverter: {check: {cue: 99}}},\n"
                     "   {selector: []}]}}"),
            "test.yaml:1:33: vote_scale: -1 is outside [0, 1000]\n"
            "test.yaml:2:5: there is no node 'prob'; did you mean 'probe'?\n"
            "test.yaml:3:29: cue: 99 is outside [0, 31]\n"
            "test.yaml:4:15: selector needs at least one child");
}

TEST(RegistryErrors, WhatIsNoNodeIsRefused) {
  EXPECT_EQ(mistakes("[probe, probe]"),
            "test.yaml:1:1: expected a node, such as 'navigate' or {navigate: {...}}, got a list");
  EXPECT_EQ(mistakes("{}"),
            "test.yaml:1:1: expected a node, such as 'navigate' or {navigate: {...}}, got a map");
  EXPECT_EQ(mistakes("{selector: [{inverter: }]}"), "test.yaml:1:14: inverter needs 'child'");
  EXPECT_EQ(mistakes("{inverter: {child: }}"),
            "test.yaml:1:13: expected a node, such as 'navigate' or {navigate: {...}}, got "
            "nothing");
}

TEST(RegistryErrors, ParametersThatAreNotIndentedAreRecognised) {
  EXPECT_EQ(mistakes("{probe: , cue: 3}"),
            "test.yaml:1:11: a node is one name with its parameters below it, but beside 'probe' "
            "there is 'cue'; a parameter must be indented further than its node");
}

TEST(RegistryErrors, ALeafTakesNoChildren) {
  EXPECT_EQ(mistakes("{probe: [{check: {cue: 1}}]}"),
            "test.yaml:1:2: probe is a behavior and takes no children");
  EXPECT_EQ(mistakes("{check: {cue: 1, children: [probe]}}"),
            "test.yaml:1:28: check is a condition and takes no children");
  EXPECT_EQ(mistakes("{probe: 5}"), "test.yaml:1:9: probe: expected a map, got '5'");
}

TEST(RegistryErrors, ACompositeNeedsChildrenAsAList) {
  EXPECT_EQ(mistakes("winner_takes_all"),
            "test.yaml:1:1: winner_takes_all needs at least one child");
  EXPECT_EQ(mistakes("{winner_takes_all: probe}"),
            "test.yaml:1:20: winner_takes_all: write children as a list: [probe]");
  EXPECT_EQ(mistakes("{fusion: {children: {probe: {cue: 1}}}}"),
            "test.yaml:1:21: children: expected a list of nodes, got a map");
  EXPECT_EQ(mistakes("{selector: {probe: {cue: 1}, check: {cue: 2}}}"),
            "test.yaml:1:13: 'probe' is a node, not a parameter of selector; write children as a "
            "list: selector: [probe, ...]");
}

TEST(RegistryErrors, ADecoratorTakesExactlyOneChild) {
  EXPECT_EQ(mistakes("{inverter: [{check: {cue: 1}}, {check: {cue: 2}}]}"),
            "test.yaml:1:2: inverter takes exactly one 'child'; put several nodes under an arbiter "
            "or a control node");
  EXPECT_EQ(mistakes("{timeout: {after: 1 s, children: [{check: {cue: 1}}]}}"),
            "test.yaml:1:2: timeout takes exactly one 'child'; put several nodes under an arbiter "
            "or a control node");
  EXPECT_EQ(mistakes("{suppress: [probe, probe]}"),
            "test.yaml:1:2: suppress takes its children by name: suppress: {by: ..., child: ...}");
  EXPECT_EQ(mistakes("{cooldown: {check: {cue: 1}}}"),
            "test.yaml:1:2: cooldown needs the parameter 'duration'");
  EXPECT_EQ(mistakes("{inverter: {chek: {cue: 1}}}"),
            "test.yaml:1:13: there is no node 'chek'; did you mean 'check'?");
  EXPECT_EQ(mistakes("{guard: {child: {probe: {cue: 1}}}}"), "test.yaml:1:2: guard needs 'when'");
}

TEST(RegistryErrors, NamesOfOtherLibrariesAreKnown) {
  const auto meant = [](const std::string& name) {
    const std::string said = mistakes("{" + name + ": [{probe: {cue: 1}}]}");
    const std::string begin = "test.yaml:1:2: there is no node '" + name + "'; did you mean ";
    return said.starts_with(begin) ? said.substr(begin.size()) : said;
  };
  EXPECT_EQ(meant("ReactiveFallback"), "'selector'?");
  EXPECT_EQ(meant("fallback"), "'selector'?");
  EXPECT_EQ(meant("keep_running_until_failure"), "'repeat'?");
  EXPECT_EQ(meant("OneShot"), "'run_once'?");
  EXPECT_EQ(meant("Success"), "'always_success'?");
  EXPECT_EQ(meant("SubTree"), "'tree'?");
  EXPECT_EQ(meant("Sequence"), "'sequence', or, as in BehaviorTree.CPP, 'sequence_with_memory'?");
  EXPECT_EQ(meant("sequense"), "'sequence'?");
  EXPECT_EQ(mistakes("{repeat: {count: -1, child: {probe: {cue: 1}}}}"),
            "test.yaml:1:18: count: -1 is outside [1, 1000000000]; null: repeats for ever");
}

TEST(RegistryErrors, CommitmentTakesOneFormOfChildren) {
  EXPECT_EQ(mistakes("{commitment: {margin: 1, child: {probe: {cue: 1}}, children: []}}"),
            "test.yaml:1:33: commitment has either 'child' or 'children'");
  EXPECT_EQ(mistakes("{selector: {child: {probe: {cue: 1}}}}"),
            "test.yaml:1:20: selector has 'children', a list, and no 'child'");
  EXPECT_EQ(mistakes("{commitment: [{probe: {cue: 1}}]}"),
            "test.yaml:1:2: commitment needs 'margin', 'min_time' or 'hold' above 0, or it commits "
            "to nothing");
}

TEST(RegistryErrors, ContradictingParametersAreRefused) {
  EXPECT_EQ(mistakes("{parallel: {success_count: 3, children: [{probe: {cue: 1}}]}}"),
            "test.yaml:1:2: success_count is 3, but there is 1 child");
  EXPECT_EQ(mistakes("{selector: {vote: 3, vote_scale: 2, children: [{probe: {cue: 1}}]}}"),
            "test.yaml:1:2: give either 'vote' or 'vote_scale', not both");
}

TEST(RegistryErrors, ALabelIsATextThatAPathCanHold) {
  EXPECT_EQ(mistakes("{probe: {cue: 1, name: [a]}}"),
            "test.yaml:1:24: name: expected a text, got a list");
  EXPECT_EQ(mistakes("{probe: {cue: 1, name: a/b}}"),
            "test.yaml:1:24: name: 'a/b' must not contain '/', '[' or ']'");
  EXPECT_EQ(mistakes("{probe: {cue: 1, name: ''}}"), "test.yaml:1:24: name: must not be empty");
}

TEST(RegistryErrors, AReferenceNamesATreeThatExists) {
  const NamedTrees others = NamedTrees().with("ingress", "{probe: {cue: 1}}");
  EXPECT_EQ(mistakes("{tree: ingres}", others),
            "test.yaml:1:8: there is no tree 'ingres'; did you mean 'ingress'?");
  EXPECT_EQ(mistakes("{tree: patrol}", others),
            "test.yaml:1:8: there is no tree 'patrol', only ingress");
  EXPECT_EQ(mistakes("tree"),
            "test.yaml:1:1: a reference names its tree, as in {tree: ingress}, or with arguments "
            "{tree: {ingress: {vote: 40}}}");
  EXPECT_EQ(mistakes("{tree: {name: ingress}}", others),
            "test.yaml:1:15: tree 'name': expected its arguments as a map, got 'ingress'");
}

TEST(RegistryErrors, ATreeThatRefersToItselfIsRefusedWithTheWayRound) {
  const NamedTrees others = NamedTrees()
                                .with("a", "{selector: [{tree: b}]}")
                                .with("b", "{selector: [{tree: c}]}")
                                .with("c", "{selector: [{tree: a}]}");
  EXPECT_EQ(mistakes("{selector: [{tree: a}]}", others),
            "c.yaml:1:20: tree 'a' refers to itself: a -> b -> c -> a");

  const std::string self = "{selector: [{tree: test}]}";
  EXPECT_EQ(mistakes(self, NamedTrees().with("test", self)),
            "test.yaml:1:20: tree 'test' refers to itself: test -> test");
}

TEST(RegistryErrors, MistakesInASharedTreeAreToldOnce) {
  EXPECT_EQ(mistakes("{selector: [{tree: bad}, {tree: bad}]}",
                     NamedTrees().with("bad", "{probe: {cue: 99}}")),
            "bad.yaml:1:15: cue: 99 is outside [0, 31]");
}

TEST(RegistryErrors, NobodyReadsOnWhereMoreIsWrongThanAnybodyReads) {
  std::string list;
  for (int i = 0; i < 3000; ++i)
    list += "prob, ";
  Diagnostics diagnostics;
  for (int tree = 0; tree < 3; ++tree) {
    const std::size_t before = diagnostics.count();
    EXPECT_FALSE(standard_registry().build_tree(
        "test", document("{selector: [" + list + "{inverter: prob}]}"), diagnostics));
    EXPECT_LE(diagnostics.count(), Diagnostics::kKept) << before;
  }
}

TEST(RegistryErrors, AConditionThatIsTooLongIsNotReadAsOne) {
  std::string words = "rang < 1 m";
  for (int i = 0; i < 100; ++i)
    words += " and alarm";
  EXPECT_EQ(
      mistakes("{holds: " + words + "}"),
      "test.yaml:1:9: that: 'rang < 1 m and alarm and alarm and alarm and alarm and alarm...' "
      "has 1010 characters, at most 1000 fit");
}

TEST(RegistryErrors, DepthIsLimited) {
  std::string text = "{check: {cue: 1}}";
  for (std::size_t i = 1; i < kMaxDepth; ++i)
    text = "{inverter: " + text + "}";
  EXPECT_EQ(mistakes(text), "");
  EXPECT_EQ(mistakes("{inverter: " + text + "}"),
            "test.yaml:1:706: nodes are nested more than 64 deep");
}

/// Each tree refers twice to the next: 2^40 nodes from 40 lines.
TEST(RegistryErrors, TreesThatMultiplyAreStoppedAtTheNodeLimit) {
  NamedTrees others;
  for (int i = 0; i < 40; ++i) {
    const std::string next = "{tree: t" + std::to_string(i + 1) + "}";
    others.with("t" + std::to_string(i), "{selector: [" + next + ", " + next + "]}");
  }
  others.with("t40", "{check: {cue: 1}}");
  EXPECT_EQ(mistakes("{tree: t0}", others), "t39.yaml:1:2: the tree has more than 65535 nodes");
}

TEST(RegistryErrors, AChainOfReferencesIsLimited) {
  NamedTrees others;
  for (int i = 0; i < 100; ++i)
    others.with("t" + std::to_string(i), "{tree: t" + std::to_string(i + 1) + "}");
  EXPECT_EQ(mistakes("{tree: t0}", others),
            "t62.yaml:1:2: trees refer to one another more than 64 deep");
}

TEST(RegistryErrors, MemoryIsLimited) {
  const NamedTrees others =
      NamedTrees().with("holder", "{commitment: {hold: 1 s, child: {probe: {cue: 1}}}}");
  std::string text = "{selector: [";
  for (int i = 0; i < 20'000; ++i)
    text += "{tree: holder},";
  EXPECT_EQ(mistakes(text + "]}", others),
            "test.yaml:1:1: tree 'test' needs 1600008 bytes of memory per agent, the most is "
            "1048576");
}

/// A node whose own range does not hold its default.
struct Loud final : Node {
  static constexpr std::string_view type_name = "loud", help = "votes too much";
  static constexpr auto params() {
    return std::tuple{param("vote", &Loud::vote, range(0, 1000), "how strongly")};
  }
  Status tick(const Tick<State>&, Proposal<Action>& out) const override {
    out.vote = vote;
    return Status::running;
  }
  float vote = 2000;
};

TEST(RegistryErrors, ADefaultOutOfItsRangeIsRefusedWithItsNode) {
  Registry<State, Action> registry = standard_registry();
  try {
    registry.add<Loud>();
    FAIL() << "it was taken";
  } catch (const std::logic_error& refused) {
    EXPECT_STREQ(refused.what(),
                 "node 'loud' has a default that is none: vote: 2000 is outside [0, 1000]");
  }
}

TEST(RegistryErrors, ADefaultThatContainsItselfIsRefusedWithTheWayRound) {
  EXPECT_EQ(mistakes("{tree: rec}",
                     NamedTrees().with(
                         "rec", "{parameters: {a: {inverter: $a}}, root: {selector: [$a]}}")),
            "rec.yaml:1:29: parameter 'a' contains itself: a -> a");
  EXPECT_EQ(
      mistakes("{tree: rec}", NamedTrees().with("rec",
                                                "{parameters: {a: [$b], b: {inverter: $a}}, root: "
                                                "{selector: $a}}")),
      "rec.yaml:1:38: parameter 'a' contains itself: a -> b -> a");
}

struct NeedsANumber final : Node {
  static constexpr std::string_view type_name = "needs_a_number";
  static constexpr std::string_view help = "cannot be made by a file";
  explicit NeedsANumber(int) {}
  Status tick(const RobotTick&, RobotProposal&) const override { return kFailure; }
};

TEST(RegistryErrors, ATypeThatOnlyCodeCanMakeIsNotAdded) {
  RobotRegistry registry;
  EXPECT_THROW(registry.add<NeedsANumber>(), std::logic_error);
}

TEST(RegistryErrors, AnExpressionThatBreaksOffIsStillOne) {
  EXPECT_EQ(mistakes("{guard: {when: alarm and, child: {probe: {cue: 1}}}}"),
            "test.yaml:1:25: expected a state field or a quantity, got the end");
}

}  // namespace
}  // namespace eyrie::ubf::testing
