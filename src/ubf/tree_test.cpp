// SPDX-License-Identifier: MIT
#include "ubf/tree.hpp"

#include <gtest/gtest.h>

#include "support/ubf/testing.hpp"

namespace eyrie::ubf::testing {
namespace {

using Select = Selector<State, Action>;

Child labelled(std::string label, Child node) {
  node->set_label(std::move(label));
  return node;
}

RobotTree engage() {
  return RobotTree("engage",
                   make<Wta>(labelled("attack", make<Select>(probe(0), probe(1))), check(2),
                             labelled("attack", make<Select>(labelled("last", probe(3))))));
}

TEST(Tree, NumbersItsNodesInPreOrder) {
  const RobotTree tree = engage();
  ASSERT_EQ(tree.size(), 7u);
  const std::vector<std::string_view> labels{
      "winner_takes_all", "attack", "probe", "probe", "check", "attack", "last"};
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const auto& node = tree.node(static_cast<NodeIndex>(i));
    EXPECT_EQ(node.label(), labels[i]);
    EXPECT_EQ(node.index(), i);
  }
  EXPECT_EQ(tree.node(1).end_index(), 4);
  EXPECT_EQ(tree.parent(3), 1);
  EXPECT_EQ(tree.parent(0), kNone);
  EXPECT_EQ(tree.depth(6), 2u);
}

TEST(Tree, NamesEachNodeByAPathThatFindsIt) {
  const RobotTree tree = engage();
  EXPECT_EQ(tree.path(0), "root");
  EXPECT_EQ(tree.path(3), "root/attack[0]/probe[1]");
  EXPECT_EQ(tree.path(4), "root/check");
  EXPECT_EQ(tree.path(6), "root/attack[1]/last");
  for (std::size_t i = 0; i < tree.size(); ++i)
    EXPECT_EQ(tree.find(tree.path(static_cast<NodeIndex>(i))), i);
  EXPECT_EQ(tree.find("root/nowhere"), std::nullopt);
}

TEST(Tree, GivesEachNodeMemoryOfItsOwn) {
  Robot robot(make<Wta>(probes(3)));
  EXPECT_EQ(robot.tree.memory_bytes(), 3 * slab_bytes(sizeof(ProbeMemory)));
  robot.tick();
  robot.tick();
  for (const char* path : {"root/probe[0]", "root/probe[1]", "root/probe[2]"})
    EXPECT_EQ(robot.asked(path), 2u);
}

TEST(Tree, OfOneLeafIsATree) {
  Robot robot(probe(0));
  robot.cue(0) = {kSuccess, 2, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kSuccess);
  EXPECT_EQ(robot.out.action.heading, 1);
  EXPECT_EQ(robot.supplier(0), "root");
}

TEST(Tree, EmptiesTheProposalAfterAFailure) {
  Robot robot(probe(0));
  robot.out = {{.altitude = 5}, 3};
  robot.cue(0) = {kFailure, 2, {.heading = 1}};
  EXPECT_EQ(robot.tick(), kFailure);
  EXPECT_TRUE(robot.out.is_empty());
}

TEST(Tree, IsSharedByManyAgents) {
  const RobotTree tree("pair", make<Wta>(probes(2)));
  State state;
  state.cues[0] = {kRunning, 1, {}};
  std::vector<std::byte> one(tree.memory_bytes()), two(tree.memory_bytes());
  RobotProposal out;
  tree.tick({.state = state, .memory = one.data()}, out);
  tree.tick({.state = state, .memory = one.data()}, out);
  tree.tick({.state = state, .memory = two.data()}, out);
  const auto& probe = static_cast<const Probe&>(tree.node(1));
  EXPECT_EQ(probe.asked(one.data()), 2u);
  EXPECT_EQ(probe.asked(two.data()), 1u);
}

template <class Make>
std::string refusal(Make make_root) {
  try {
    const RobotTree tree("bad", make_root());
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "accepted";
}

template <class Make>
::testing::AssertionResult refused(Make make_root, std::string_view words) {
  const std::string said = refusal(make_root);
  if (said.find(words) != std::string::npos)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "it said: " << said;
}

TEST(Tree, RefusesNodesSetUpWronglyWithTheirPathsAndAllReasons) {
  const auto bad = []() -> Child {
    auto fusion = make<Fusion<State, Action>>(probe(0), probe(99));
    fusion->top = 100;
    fusion->vote = -1;
    auto timeout = make<Timeout<State, Action>>(make<Wta>());
    auto scaled = make<Wta>(probe(1));
    scaled->vote_scale = std::numeric_limits<float>::quiet_NaN();
    return make<Wta>(std::move(fusion), std::move(timeout), std::move(scaled));
  };
  EXPECT_EQ(refusal(bad),
            "tree 'bad' cannot be made\n"
            "  root/fusion: fusion: top: 100 is outside [1, 8]\n"
            "  root/fusion: fusion: vote: -1 is outside [0, 1000]\n"
            "  root/fusion/probe[1]: probe: cue: 99 is outside [0, 31]\n"
            "  root/timeout: timeout: after: 0 s is outside (0 s, 1000000 s]\n"
            "  root/timeout/winner_takes_all: winner_takes_all: needs at least one child\n"
            "  root/winner_takes_all: winner_takes_all: vote_scale is nan");
}

TEST(Tree, RefusesNodesThatNobodyMadeAndVotesThatFollowNothing) {
  EXPECT_EQ(
      refusal([]() -> Child { return std::make_unique<Inverter<State, Action>>(); }),
      "tree 'bad' cannot be made\n  root: behavior: has no type: nodes are made by make<...>()");
  const auto following = [](VoteCurve curve) {
    return refusal([&]() -> Child {
      auto node = probe(0);
      node->set_vote_curve(std::move(curve));
      return node;
    });
  };
  VoteCurve curve;
  curve.product.resize(7);
  EXPECT_NE(following(curve).find("7 considerations, expected 1 to 6"), std::string::npos);
  curve.product = {{.field = 0, .from = 5, .to = 5}};
  EXPECT_NE(following(curve).find("'from' and 'to' are 5 and 5"), std::string::npos);
  curve.product = {{.field = 1'000'000}};
  EXPECT_NE(following(curve).find("a field that its state does not have"), std::string::npos);
  curve = {.product = {{}}, .least = -5};
  EXPECT_NE(following(curve).find("the least share is -5"), std::string::npos);
  curve.least = 0;
  EXPECT_EQ(following(curve), "accepted");
}

TEST(Tree, StaysAsItWasIfANodeCannotBePutIntoIt) {
  RobotTree tree("t", make<Wta>(probe(0)));
  EXPECT_THROW(
      static_cast<void>(std::move(tree).replace("root/probe", make<Inverter<State, Action>>())),
      std::logic_error);
  Robot robot(std::move(tree));
  robot.say(0, kRunning, 3);
  EXPECT_EQ(robot.tick(), kRunning);
  EXPECT_EQ(robot.leader(), "root/probe");
}

TEST(Tree, RefusesWhatWouldReadBeyondItsChildren) {
  using Choice = Switch<State, Action>;
  const auto phase = [](const State& s) { return static_cast<double>(s.phase); };
  EXPECT_TRUE(refused([]() -> Child { return make<Choice>(probe(0), probe(1)); },
                      "a switch needs a field to look at"));
  EXPECT_TRUE(refused(
      [&]() -> Child {
        auto choice = make<Choice>(probe(0));
        choice->look_at(phase, {1, 2, 3, 4});
        return choice;
      },
      "here are 1 for 4 values"));
  EXPECT_TRUE(refused([]() -> Child { return make<ForEach<State, Action>>(nullptr); },
                      "a child is missing"));
  EXPECT_TRUE(refused([]() -> Child { return make<ForEach<State, Action>>(make<Wta>(Child())); },
                      "root/winner_takes_all: winner_takes_all: a child is missing"));
  EXPECT_TRUE(refused([]() -> Child { return make<ForEach<State, Action>>(check(0)); },
                      "for_each needs a list to go over"));
  EXPECT_TRUE(refused([]() -> Child { return make<Holds<State, Action>>(); },
                      "holds needs a condition to look at"));
  EXPECT_TRUE(refused(
      []() -> Child {
        auto parallel = make<Parallel<State, Action>>(probe(0));
        parallel->success_count = 0;
        return parallel;
      },
      "success_count: 0 is outside [1, 64]"));
}

TEST(Tree, RefusesASequencersTreeThatNoTransitionLeadsTo) {
  EXPECT_TRUE(refused(
      []() -> Child {
        Children trees;
        trees.push_back(probe(0));
        trees.push_back(probe(1));
        return make<Sequencer<State, Action>>(
            std::move(trees), std::vector<Sequencer<State, Action>::Rule>{}, Children{});
      },
      "no transition leads to tree 1"));
}

TEST(Tree, RefusesWhatIsNoTree) {
  EXPECT_TRUE(refused([] { return Child(); }, "a tree needs a root"));
  EXPECT_TRUE(
      refused([]() -> Child { return make<Wta>(probe(0), Child()); }, "a child is missing"));
  EXPECT_TRUE(refused([]() -> Child { return make<Inverter<State, Action>>(); },
                      "takes exactly 'child', but has 0 children"));
}

Child chain(std::size_t length) {
  Child node = probe(0);
  for (std::size_t i = 1; i < length; ++i)
    node = make<Select>(std::move(node));
  return node;
}

TEST(Tree, RefusesMoreThan64Levels) {
  EXPECT_EQ(refusal([] { return chain(kMaxDepth); }), "accepted");
  EXPECT_TRUE(refused([] { return chain(kMaxDepth + 1); }, "deeper than 64 levels"));
}

Child many_checks(std::size_t count) {
  Children children;
  for (std::size_t i = 0; i < count; ++i)
    children.push_back(check(0));
  return make<Wta>(std::move(children));
}

TEST(Tree, RefusesMoreThan65535Nodes) {
  EXPECT_EQ(refusal([] { return many_checks(kMaxNodes - 1); }), "accepted");
  EXPECT_TRUE(refused([] { return many_checks(kMaxNodes); }, "more than 65535 nodes"));
}

/// Remembers a quarter of what one agent may remember.
class Elephant final : public Node {
 public:
  static constexpr std::string_view type_name = "elephant";
  std::size_t memory_bytes() const noexcept override { return kMaxMemory / 4; }
  Status tick(const RobotTick&, RobotProposal&) const override { return Status::failure; }
};

TEST(Tree, RefusesMoreThanAMebibyteOfMemory) {
  EXPECT_EQ(refusal([]() -> Child {
              return make<Wta>(make<Elephant>(), make<Elephant>(), make<Elephant>(),
                               make<Elephant>());
            }),
            "accepted");
  EXPECT_TRUE(refused(
      []() -> Child {
        return make<Wta>(make<Elephant>(), make<Elephant>(), make<Elephant>(), make<Elephant>(),
                         probe(0));
      },
      "more than 1 MiB"));
}

TEST(Tree, PutsAnotherNodeInPlaceOfOne) {
  auto tree = [] {
    return RobotTree("t", make<Wta>(probe(0), make<Selector<State, Action>>(probe(1), probe(2))));
  };
  Robot leaf(tree().replace("root/selector/probe[1]", probe(5)));
  leaf.say(5, kRunning, 3);
  EXPECT_EQ(leaf.tick(), kRunning);
  EXPECT_EQ(leaf.leader(), "root/selector/probe[1]");
  Robot branch(tree().replace("root/selector", probe(6)));
  branch.say(6, kRunning, 4);
  EXPECT_EQ(branch.tick(), kRunning);
  EXPECT_EQ(branch.leader(), "root/selector") << "the path stays";
  EXPECT_EQ(branch.tree.size(), 3u);
  Robot root(tree().replace("root", probe(7)));
  root.say(7, kSuccess, 1);
  EXPECT_EQ(root.tick(), kSuccess);
  EXPECT_EQ(root.tree.size(), 1u);
}

TEST(Tree, SaysWhichNodeIsNotThereToBeReplaced) {
  try {
    static_cast<void>(RobotTree("t", make<Wta>(probe(0))).replace("root/prob", probe(1)));
    ADD_FAILURE();
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "tree 't' has no node 'root/prob'; did you mean 'root/probe'?");
  }
}

TEST(Tree, RefusesInPlaceOfANodeWhatItRefusesFromTheStart) {
  Child node = probe(1);
  VoteCurve curve;
  curve.product = {{99, 40, 10, Curve::linear}};  // no such field
  node->set_vote_curve(curve);
  RobotTree tree("t", make<Wta>(probe(0)));
  EXPECT_THROW(static_cast<void>(std::move(tree).replace("root/probe", std::move(node))),
               std::logic_error);
}

TEST(Tree, RefusesLabelsThatNoPathCanName) {
  for (const char* label : {"a/b", "p[1]", "]"})
    EXPECT_TRUE(refused(
        [&]() -> Child {
          Child leaf = probe(0);
          leaf->set_label(label);
          return make<Wta>(std::move(leaf));
        },
        "must not contain"))
        << label;
}

}  // namespace
}  // namespace eyrie::ubf::testing
