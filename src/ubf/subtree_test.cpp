// SPDX-License-Identifier: MIT
/// \file  Trees with parameters, their references, and state fields under other names.
#include "ubf/subtree.hpp"

#include <gtest/gtest.h>

#include "ubf/testing.hpp"
#include "ubf/testing_document.hpp"

namespace eyrie::ubf::testing {
namespace {

/// Named trees as a file has them.
struct Trees {
  std::vector<std::pair<std::string, Value>> values;

  Trees& with(std::string name, std::string_view text) {
    values.emplace_back(name, Document::parse(text, name));
    return *this;
  }
  [[nodiscard]] std::vector<NamedSpec> named() const {
    std::vector<NamedSpec> specs;
    for (const auto& [name, value] : values)
      specs.push_back({name, &value});
    return specs;
  }
};
struct Built {
  std::optional<RobotTree> tree;
  std::string mistakes;
};
Built build(std::string_view text, const Trees& trees) {
  static const RobotRegistry kRegistry = [] {
    RobotRegistry made;
    add_standard_nodes(made);
    made.add<Probe>();
    return made;
  }();
  Diagnostics diagnostics;
  const std::vector<NamedSpec> named = trees.named();
  Built built{kRegistry.build_tree("test", Document::parse(text), diagnostics, named), {}};
  built.mistakes = diagnostics.text();
  return built;
}
/// The vote of the tree in a state.
float vote(const Built& built, const State& state) {
  std::vector<std::byte> slab(built.tree->memory_bytes());
  RobotProposal out;
  const Status status = built.tree->tick({.state = state, .memory = slab.data()}, out);
  return status == kFailure ? -1 : out.vote;
}

const char* const kEngage =
    "{parameters: {vote: 5, near: , what: {probe: {cue: 1}}}, root: {guard: {when: range < $near, "
    "child: {winner_takes_all: {vote: $vote, children: [$what]}}}}}";

TEST(Subtree, TakesArgumentsAndDefaultsAsNumbersPiecesOfATextAndNodes) {
  const Trees trees = Trees().with("engage", kEngage);
  State state;
  state.cues[1] = {kRunning, 1, {.heading = 1}};
  state.cues[2] = {kSuccess, 1, {}};
  const Built far = build("{tree: {engage: {near: 10 nmi}}}", trees);
  ASSERT_TRUE(far.tree) << far.mistakes;
  state.range = 18000;
  EXPECT_EQ(vote(far, state), 5);
  state.range = 19000;
  EXPECT_EQ(vote(far, state), -1);
  const Built near =
      build("{tree: {engage: {near: 1 nmi, vote: 7, what: {probe: {cue: 2}}}}}", trees);
  ASSERT_TRUE(near.tree) << near.mistakes;
  state.range = 1000;
  EXPECT_EQ(vote(near, state), 7);
  state.range = 2000;
  EXPECT_EQ(vote(near, state), -1);
}

TEST(Subtree, HandsItsArgumentsOnToOthers) {
  const Trees trees = Trees()
                          .with("inner",
                                "{parameters: {n: }, root: {winner_takes_all: {vote: $n, children: "
                                "[{probe: {cue: 1}}]}}}")
                          .with("outer", "{parameters: {m: 3}, root: {tree: {inner: {n: $m}}}}");
  State state;
  state.cues[1] = {kRunning, 1, {.heading = 1}};
  EXPECT_EQ(vote(build("{tree: outer}", trees), state), 3);
  EXPECT_EQ(vote(build("{tree: {outer: {m: 9}}}", trees), state), 9);
}

TEST(Subtree, ReadsStateFieldsUnderTheNamesOfItsReference) {
  const Trees trees =
      Trees()
          .with("close", "{guard: {when: distance < 1 km and not busy, child: {probe: {cue: 1}}}}")
          .with("pack", "{tree: {close: {fields: {distance: way}}}}");
  State state;
  state.cues[1] = {kRunning, 4, {}};
  const Built direct = build("{tree: {close: {fields: {distance: range, busy: alarm}}}}", trees);
  ASSERT_TRUE(direct.tree) << direct.mistakes;
  state.range = 500;
  EXPECT_EQ(vote(direct, state), 4);
  state.alarm = true;
  EXPECT_EQ(vote(direct, state), -1);
  // through two references: the outer one names what the inner one left
  const Built nested = build("{tree: {pack: {fields: {way: altitude, busy: alarm}}}}", trees);
  ASSERT_TRUE(nested.tree) << nested.mistakes;
  state.alarm = false;
  state.range = 5000;
  state.altitude = 999;
  EXPECT_EQ(vote(nested, state), 4);
  // a renamed name does not hang on behind the reference
  EXPECT_EQ(build("{winner_takes_all: [{tree: {close: {fields: {distance: range, busy: alarm}}}}, "
                  "{holds: not busy}]}",
                  trees)
                .mistakes,
            "test.yaml:1:92: there is no state field 'busy'");
}

TEST(Subtree, MistakesAreSaidWithTheirPlace) {
  const Trees trees = Trees()
                          .with("engage", kEngage)
                          .with("idle", "{parameters: {pace: 3}, root: {probe: {cue: 1}}}")
                          .with("typo",
                                "{parameters: {vote: 3}, root: {winner_takes_all: {vote: "
                                "$vot, children: [{probe: {cue: 1}}]}}}")
                          .with("plain", "{probe: {cue: 1}}");
  EXPECT_EQ(build("{tree: engage}", trees).mistakes,
            "test.yaml:1:8: tree 'engage' needs the argument 'near'");
  EXPECT_EQ(build("{tree: {engage: {near: 1 m, voet: 3}}}", trees).mistakes,
            "test.yaml:1:29: tree 'engage' has no parameter 'voet'; did you mean 'vote'?");
  EXPECT_EQ(build("{tree: {engage: {near: 1 m, vote: many}}}", trees).mistakes,
            "test.yaml:1:35: vote: expected a plain number such as '0.5', got 'many'");
  EXPECT_EQ(build("{tree: {engage: {near: 1 m, near: 2 m}}}", trees).mistakes,
            "test.yaml:1:29: 'near' is given twice");
  EXPECT_EQ(build("{tree: {plain: {vote: 3}}}", trees).mistakes,
            "test.yaml:1:17: tree 'plain' has no parameter 'vote'");
  EXPECT_EQ(build("{tree: idle}", trees).mistakes,
            "idle:1:15: tree 'idle' never uses its parameter 'pace'");
  EXPECT_EQ(build("{tree: typo}", trees).mistakes,
            "typo:1:57: tree 'typo' has no parameter 'vot'; did you mean 'vote'?");
  EXPECT_EQ(build("{tree: {plain: {fields: {far: range}}}}", trees).mistakes,
            "test.yaml:1:17: fields: nothing in tree 'plain' reads 'far'");
  EXPECT_EQ(build("{tree: {plain: {}, idle: {}}}", trees).mistakes,
            "test.yaml:1:2: a reference names its tree, as in {tree: ingress}, or with arguments "
            "{tree: {ingress: {vote: 40}}}");
}

TEST(Subtree, ArgumentsThatMultiplyAreStoppedBeforeTheyFillTheMemory) {
  Trees trees;
  trees.with("t0", "{parameters: {a: }, root: {winner_takes_all: [$a, $a]}}");
  for (int i = 1; i < 30; ++i)
    trees.with(fmt::format("t{}", i),
               fmt::format("{{parameters: {{a: }}, root: {{tree: {{t{}: {{a: {{winner_takes_all: "
                           "[$a, $a, $a, $a]}}}}}}}}}}",
                           i - 1));
  const std::string mistakes = build("{tree: {t29: {a: {probe: {cue: 1}}}}}", trees).mistakes;
  EXPECT_NE(mistakes.find("larger than 100000 values"), std::string::npos) << mistakes;
}

TEST(Subtree, ATagIsTheSameAsTheKey) {
  Trees trees = Trees().with("plain", "{probe: {cue: 1}}");
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
