// SPDX-License-Identifier: MIT
#include "ubf/sequencer.hpp"

#include <gtest/gtest.h>

#include "support/ubf/registry.hpp"

namespace eyrie::ubf {
namespace {

std::string sequencer_mistakes(std::string_view text) {
  const Value body = testing::document(text);
  Diagnostics diagnostics;
  static_cast<void>(read_sequencer({"sequencer", body.where, &body}, diagnostics));
  return diagnostics.text();
}

TEST(SequencerSpec, ResolvesNamesToPositionsInFileOrder) {
  const Value body = testing::document(
      "{start: b, trees: {a: x, b: y, c: z}, transitions:"
      " [{from: b, to: c, when: p}, {from: any, to: a, when: q}]}");
  Diagnostics diagnostics;
  const SequencerSpec read = read_sequencer({"sequencer", body.where, &body}, diagnostics);
  EXPECT_EQ(diagnostics.text(), "");
  EXPECT_EQ(read.start, 1);
  ASSERT_EQ(read.trees.size(), 3u);
  EXPECT_EQ(read.trees[2].first, "c");
  EXPECT_EQ(read.trees[2].second->text, "z");
  ASSERT_EQ(read.transitions.size(), 2u);
  EXPECT_EQ(read.transitions[0].from, 1);
  EXPECT_EQ(read.transitions[0].to, 2);
  EXPECT_EQ(read.transitions[1].from, kNone);
  EXPECT_EQ(read.transitions[1].when->text, "q");
}

TEST(SequencerSpec, NeedsTreesAndAStart) {
  EXPECT_EQ(sequencer_mistakes("{}"),
            "test.yaml:1:1: sequencer needs 'trees', a map from names to nodes\n"
            "test.yaml:1:1: sequencer needs 'start', the name of its first tree");
  EXPECT_EQ(sequencer_mistakes("{start: a, trees: [x, y]}"),
            "test.yaml:1:9: the sequencer has no tree 'a'\n"
            "test.yaml:1:19: sequencer needs 'trees', a map from names to nodes");
}

TEST(SequencerSpec, AnswersUnknownTreesWithTheNearestName) {
  EXPECT_EQ(sequencer_mistakes("{start: ingres, trees: {ingress: x, bvr: y}, transitions:\n"
                               " [{from: ingress, to: brv, when: c},\n"
                               "  {from: wvr, to: bvr, when: c}]}"),
            "test.yaml:1:9: the sequencer has no tree 'ingres'; did you mean 'ingress'?\n"
            "test.yaml:2:23: the sequencer has no tree 'brv'; did you mean 'bvr'?\n"
            "test.yaml:3:10: the sequencer has no tree 'wvr'; did you mean 'bvr'?");
  EXPECT_EQ(sequencer_mistakes("{start: patrol, trees: {ingress: x}}"),
            "test.yaml:1:9: the sequencer has no tree 'patrol', only ingress");
}

TEST(SequencerSpec, RefusesNamesOfTreesThatDoNotWork) {
  EXPECT_EQ(sequencer_mistakes("{start: any, trees: {any: x}}"),
            "test.yaml:1:22: a tree cannot be called 'any'");
  EXPECT_EQ(sequencer_mistakes("{start: a/b, trees: {a/b: x}}"),
            "test.yaml:1:22: the name of a tree 'a/b' must not contain '/', '[' or ']'");
}

TEST(SequencerSpec, RefusesAnotherNameOfATree) {
  EXPECT_EQ(
      sequencer_mistakes("{start: a, trees: {a: {x: {cue: 1, name: lead_in}}}}"),
      "test.yaml:1:36: a tree of a sequencer is called by its key, 'a', and has no other name");
  EXPECT_EQ(sequencer_mistakes("{start: a, trees: {a: {tree: {x: {name: 3}}}}}"), "");
}

TEST(SequencerSpec, RefusesATransitionThatIsIncomplete) {
  EXPECT_EQ(sequencer_mistakes("{start: a, trees: {a: x}, transitions: [{form: a}]}"),
            "test.yaml:1:41: transition needs the parameter 'from'\n"
            "test.yaml:1:41: transition needs the parameter 'to'\n"
            "test.yaml:1:42: transition has no parameter 'form'; did you mean 'from'?");
  EXPECT_EQ(sequencer_mistakes("{start: a, trees: {a: x, b: y}, transitions: [{from: a, to: b}]}"),
            "test.yaml:1:47: transition needs the parameter 'when'");
  EXPECT_EQ(sequencer_mistakes("{start: a, trees: {a: x}, transitions: {from: a}}"),
            "test.yaml:1:40: transitions: expected a list, got a map");
}

TEST(SequencerSpec, RefusesATransitionFromATreeToItself) {
  EXPECT_EQ(
      sequencer_mistakes("{start: a, trees: {a: x}, transitions: [{from: a, to: a, when: c}]}"),
      "test.yaml:1:41: a transition from 'a' to itself");
}

TEST(SequencerSpec, RefusesATreeThatCanNeverBeEntered) {
  EXPECT_EQ(sequencer_mistakes("{start: a, trees: {a: x, b: y, c: z, d: z}, transitions:"
                               " [{from: c, to: d, when: p}, {from: a, to: b, when: q}]}"),
            "test.yaml:1:32: tree 'c' can never be entered: no transition leads to it\n"
            "test.yaml:1:38: tree 'd' can never be entered: no transition leads to it");
}

TEST(SequencerSpec, EntersEveryTreeThatATransitionFromAnyLeadsTo) {
  EXPECT_EQ(sequencer_mistakes("{start: a, trees: {a: x, b: y}, transitions:"
                               " [{from: any, to: b, when: p}]}"),
            "");
}

}  // namespace
}  // namespace eyrie::ubf
