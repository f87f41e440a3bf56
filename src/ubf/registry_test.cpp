// SPDX-License-Identifier: MIT
/// \file  What a file may say of a tree. What it may not say: registry_errors_test.cpp.
#include "ubf/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/ubf/registry.hpp"

namespace eyrie::ubf::testing {
namespace {

/// The tree as an outline: "type" or "type:label", children in parentheses.
std::string outline(const AnyNode& node) {
  std::string text(node.type());
  if (node.label() != node.type())
    text += ":" + std::string(node.label());
  if (node.children().empty())
    return text;
  text += "(";
  for (const auto& child : node.children())
    text += (text.ends_with('(') ? "" : " ") + outline(*child);
  return text + ")";
}

std::string built(std::string_view text) {
  return outline(build(text).root());
}

template <class B>
const B& root_as(const RobotTree& tree) {
  return dynamic_cast<const B&>(tree.root());
}

TEST(Registry, ReadsALeafByNameOrWithParameters) {
  EXPECT_EQ(built("{probe: {cue: 3}}"), "probe");
  const RobotTree tree = build("{probe: {cue: 3, bias: 2.5, name: left}}");
  EXPECT_EQ(root_as<Probe>(tree).cue, 3u);
  EXPECT_EQ(root_as<Probe>(tree).bias, 2.5F);
  EXPECT_EQ(tree.root().label(), "left");
}

/// Needs no parameters.
class Rest final : public Node {
 public:
  static constexpr std::string_view type_name = "rest";
  static constexpr std::string_view help = "does nothing";
  Status tick(const RobotTick&, RobotProposal&) const override { return Status::running; }
};

TEST(Registry, ReadsANodeWithoutParametersInEveryWayAFileMayWriteIt) {
  RobotRegistry registry = standard_registry();
  registry.add<Rest>();
  for (const char* text : {"rest", "{rest: }", "{rest: {}}"})
    EXPECT_EQ(outline(build(text, {}, registry).root()), "rest");
}

/// A type that knows more than its nodes' class, as one has that a script made.
struct NamedRest : NodeType {
  std::string its_name;
};
class Resting final : public Node {
 public:
  static constexpr std::string_view type_name = "resting";
  explicit Resting(const NodeType& type) : named(static_cast<const NamedRest&>(type).its_name) {}
  Status tick(const RobotTick&, RobotProposal&) const override { return Status::running; }
  std::string named;
  double depth = 3;
};

TEST(Registry, TakesTypesThatAreMadeAtRunTime) {
  static const std::array kLines{
      Parameter{param("depth", &Resting::depth, at_least(0), "how deep"),
                &eyrie::detail::TypeOf<double>::value,
                [](void* node) -> void* { return &static_cast<Resting*>(node)->depth; }}};
  static const Description kParameters{.type_name = "of a script", .parameters = kLines};
  NamedRest sleep, nap;
  for (NamedRest* type : {&sleep, &nap}) {
    type->its_name = type == &sleep ? "sleep" : "nap";
    type->name = type->its_name;
    type->parameters = &kParameters;
    type->object = [](AnyNode& node) -> void* { return &static_cast<Resting&>(node); };
    type->make = [](const NodeType& self) -> std::unique_ptr<AnyNode> {
      return std::make_unique<Resting>(self);
    };
  }
  RobotRegistry registry = standard_registry();
  registry.add_type(sleep, "a script");
  registry.add_type(nap, "a script");
  EXPECT_EQ(root_as<Resting>(build("sleep", {}, registry)).named, "sleep");
  EXPECT_EQ(root_as<Resting>(build("{nap: {depth: 2}}", {}, registry)).named, "nap");
  EXPECT_EQ(root_as<Resting>(build("{nap: {depth: 2}}", {}, registry)).depth, 2);
  EXPECT_EQ(registry.find("nap")->parameters.at(0).default_text, "3");
  EXPECT_EQ(registry.find("nap")->origin, "a script");
  EXPECT_THROW(registry.add_type(nap, "another"), std::logic_error);
}

TEST(Registry, ReadsChildrenAsAListOrUnderTheirKey) {
  EXPECT_EQ(built("{winner_takes_all: [{probe: {cue: 0}}, {check: {cue: 1}}]}"),
            "winner_takes_all(probe check)");
  const RobotTree tree =
      build("{winner_takes_all: {vote_scale: 2, name: engage, children: [{probe: {cue: 0}}]}}");
  EXPECT_EQ(outline(tree.root()), "winner_takes_all:engage(probe)");
  EXPECT_EQ(root_as<Wta>(tree).vote_scale, 2.0F);
}

TEST(Registry, ReadsADecoratorsChildAloneOrUnderItsKey) {
  EXPECT_EQ(built("{inverter: {probe: {cue: 0}}}"), "inverter(probe)");
  EXPECT_EQ(built("{inverter: {child: {probe: {cue: 0}}, name: not}}"), "inverter:not(probe)");
  const RobotTree tree = build("{timeout: {after: 5 s, child: {probe: {cue: 0}}}}");
  using Timer = Timeout<State, Action>;
  EXPECT_EQ(root_as<Timer>(tree).after, 5);
}

TEST(Registry, ReadsAGuardAndACommitment) {
  EXPECT_EQ(built("{guard: {when: {check: {cue: 0}}, child: {probe: {cue: 1}}}}"),
            "guard(check probe)");
  EXPECT_EQ(built("{commitment: {hold: 2 s, child: {probe: {cue: 1}}}}"), "commitment(probe)");
  EXPECT_EQ(built("{commitment: {margin: 2, children: [{probe: {cue: 1}}, {probe: {cue: 2}}]}}"),
            "commitment(probe probe)");
}

TEST(Registry, TakesAFlagOfTheStateAsACondition) {
  const RobotTree tree = build("guard: {when: alarm, child: {probe: {cue: 1}}}");
  EXPECT_EQ(tree.node(1).type(), "holds");
}

TEST(Registry, ReadsTheBranchesOfAConditionInAnyOrder) {
  EXPECT_EQ(built("{if_then_else: {else: {probe: {cue: 2}}, then: {inverter: {check: {cue: 1}}},"
                  " if: {check: {cue: 0}}, vote: 3}}"),
            "if_then_else(check inverter(check) probe)");
  EXPECT_EQ(built("{while: {do: {probe: {cue: 1}}, when: {check: {cue: 0}}, else: {sequence:"
                  " [{check: {cue: 1}}]}}}"),
            "while(check probe sequence(check))");
}

TEST(Registry, ReadsTheParametersOfTheLaterNodes) {
  const RobotTree tree = build(
      "{priority: {interruptible: [true, false],"
      " children: [{probe: {cue: 0}}, {run_once: {then: failure, child:"
      " {random_selector: {weights: [1, 2.5], children: [{repeat: {count:"
      " 3, child: {probe: {cue: 1}}}}, {retry: {probe: {cue: 2}}}]}}}}]}}");
  const auto& root = root_as<Priority<State, Action>>(tree);
  EXPECT_EQ(root.interruptible, (std::vector<bool>{true, false}));
  const auto& once = dynamic_cast<const RunOnce<State, Action>&>(*root.children()[1]);
  EXPECT_EQ(once.then, Afterwards::failure);
  const auto& random = dynamic_cast<const RandomSelector<State, Action>&>(*once.children()[0]);
  EXPECT_EQ(random.weights, (std::vector<double>{1, 2.5}));
  EXPECT_EQ((dynamic_cast<const Repeat<State, Action>&>(*random.children()[0]).count), 3u);
  EXPECT_EQ((dynamic_cast<const Retry<State, Action>&>(*random.children()[1]).attempts),
            std::nullopt);
  const RobotTree fusion =
      build("{fusion: {top: 2, conflicts: drop, children: [{probe: {cue: 0}}]}}");
  EXPECT_EQ((root_as<Fusion<State, Action>>(fusion).top), 2u);
  EXPECT_EQ((root_as<Fusion<State, Action>>(fusion).conflicts), Conflicts::drop);
}

TEST(Registry, ReadsTheParametersOfEveryStandardNode) {
  EXPECT_EQ(built("{parallel: {success_count: 1, failure_count: 2, vote: 3,"
                  " children: [{cooldown: {duration: 1 min, child: {probe: {cue: 0}}}},"
                  " {force_success: {force_failure: {probe: {cue: 1}}}}]}}"),
            "parallel(cooldown(probe) force_success(force_failure(probe)))");
  EXPECT_EQ(built("{selector: [{sequence: [{check: {cue: 0}}]},"
                  " {selector_with_memory: [{sequence_with_memory: [{check: {cue: 0}}]}]}]}"),
            "selector(sequence(check) selector_with_memory(sequence_with_memory(check)))");
  EXPECT_EQ(built("{per_field: [{fusion: [{paper_fusion: {high_vote: 50,"
                  " children: [{probe: {cue: 0}}]}}]}]}"),
            "per_field(fusion(paper_fusion(probe)))");
}

constexpr std::string_view kMission =
    "{sequencer: {start: out, name: mission,"
    " trees: {out: {probe: {cue: 0}}, home: {winner_takes_all: [{probe: {cue: 1}}]}},"
    " transitions: [{from: out, to: home, when: {check: {cue: 2}}},"
    "               {from: any, to: out, when: {inverter: {check: {cue: 2}}}}]}}";

TEST(Registry, ReadsASequencer) {
  const RobotTree tree = build(kMission);
  EXPECT_EQ(outline(tree.root()),
            "sequencer:mission(probe:out winner_takes_all:home(probe) check inverter(check))");
  using Modes = Sequencer<State, Action>;
  const auto& sequencer = root_as<Modes>(tree);
  EXPECT_EQ(sequencer.tree_count(), 2u);
  EXPECT_EQ(sequencer.start(), 0);
  EXPECT_EQ(sequencer.rules()[0].to, 1);
  EXPECT_EQ(sequencer.rules()[1].from, kNone);
}

TEST(Registry, ASequencerFromAFileWorks) {
  Robot robot(build(kMission));
  robot.say(2, kSuccess);
  robot.tick();
  EXPECT_EQ(phase(robot), "home");
  robot.say(2, kFailure);
  robot.tick();
  EXPECT_EQ(phase(robot), "out");
}

TEST(Registry, CopiesNamedTreesWhereTheyAreReferredTo) {
  const NamedTrees others =
      NamedTrees()
          .with("attack", "{winner_takes_all: [{tree: shoot}, {probe: {cue: 1}}]}")
          .with("shoot", "{probe: {cue: 0}}")
          .with("home", "{probe: {cue: 2, name: back}}");
  const RobotTree tree = build("{selector: [{tree: attack}, {tree: shoot}, {tree: home}]}", others);
  EXPECT_EQ(outline(tree.root()),
            "selector(winner_takes_all:attack(probe:shoot probe) probe:shoot probe:back)");
  EXPECT_EQ(tree.path(2), "root/attack/shoot");
}

TEST(Registry, LetsAnyNodeStandUnderAnyOther) {
  const RobotRegistry& registry = standard_registry();
  const auto with_child = [](const NodeInfo& info, const std::string& child) {
    static const std::map<std::string, std::string> kRequired{
        {"paper_fusion", "high_vote: 1, "},
        {"commitment", "margin: 1, "},
        {"timeout", "after: 1 s, "},
        {"cooldown", "duration: 1 s, "},
        {"delay", "duration: 1 s, "},
        {"rate_limit", "period: 1 s, "},
        {"verify", "bounds: {altitude: {min: 0 m}}, "},
        {"vote_grid", "grid: {altitude: {from: 0 m, to: 9 m, steps: 9, reach: 3 m}}, "},
        {"utility", "grid: {altitude: {from: 0 m, to: 9 m, steps: 9, reach: 3 m}}, "},
        {"motor_schema", "direction: heading, magnitude: speed, unit_vote: 1, "},
        {"suppress", "by: {check: {cue: 0}}, "},
        {"inhibit", "by: {check: {cue: 0}}, "},
        {"if_then_else", "if: {check: {cue: 0}}, then: {check: {cue: 1}}, "},
        {"while", "when: {check: {cue: 0}}, do: {check: {cue: 1}}, "},
        {"guard", "when: {check: {cue: 0}}, "}};
    if (info.name == "sequencer")
      return "{sequencer: {start: a, trees: {a: " + child + "}}}";
    if (info.name == "switch")
      return "{switch: {on: alarm, cases: {true: " + child + "}}}";
    const auto required = kRequired.find(info.name);
    const std::string parameters = required == kRequired.end() ? "" : required->second;
    const std::string& key = info.child_keys.back();
    return "{" + info.name + ": {" + parameters + key + ": " +
           (key == "children" ? "[" + child + "]" : child) + "}}";
  };
  int pairs = 0;
  for (const NodeInfo& outer : registry.catalog())
    for (const NodeInfo& inner : registry.catalog()) {
      if (outer.child_keys.empty() || inner.child_keys.empty())
        continue;
      if (outer.name == "for_each" || inner.name == "for_each")
        continue;  // takes nothing that remembers: for_each_test.cpp
      const std::string text = with_child(outer, with_child(inner, "{probe: {cue: 0}}"));
      ASSERT_EQ(mistakes(text), "") << text;
      ++pairs;
    }
  EXPECT_EQ(pairs, 35 * 35);
}

TEST(Registry, CatalogTellsEverythingAboutEachType) {
  const RobotRegistry& registry = standard_registry();
  const NodeInfo* timeout = registry.find("timeout");
  ASSERT_TRUE(timeout);
  EXPECT_EQ(timeout->kind, Kind::decorator);
  EXPECT_EQ(timeout->help, "fails and halts a child that runs for too long");
  EXPECT_EQ(timeout->child_keys, std::vector<std::string>{"child"});
  EXPECT_EQ(timeout->origin, "eyrie");
  ASSERT_EQ(timeout->parameters.size(), 1u);
  EXPECT_EQ(timeout->parameters[0].name, "after");
  EXPECT_EQ(timeout->parameters[0].unit.si_symbol, "s");
  EXPECT_TRUE(timeout->parameters[0].required);
  EXPECT_EQ(registry.find("probe")->kind, Kind::behavior);
  EXPECT_EQ(registry.find("check")->kind, Kind::condition);
  EXPECT_EQ(registry.find("fusion")->kind, Kind::arbiter);
  EXPECT_EQ(registry.find("selector")->kind, Kind::control);
  EXPECT_EQ(registry.find("nothing"), nullptr);
  for (const NodeInfo& info : registry.catalog()) {
    EXPECT_FALSE(info.help.empty()) << info.name;
    for (const ParamInfo& parameter : info.parameters)
      EXPECT_FALSE(parameter.help.empty()) << info.name << "." << parameter.name;
  }
}

TEST(Registry, KnowsWhoRegisteredAType) {
  RobotRegistry registry;
  registry.add<Rest>("libmine.so");
  EXPECT_EQ(registry.find("rest")->origin, "libmine.so");
}

TEST(Registry, RefusesANameThatIsTaken) {
  RobotRegistry registry = standard_registry();
  EXPECT_THROW(registry.add<Probe>(), std::logic_error);
}

TEST(Registry, BuildsAThousandNodesTheSameFromOneValueEveryTime) {
  std::string text = "{winner_takes_all: [";
  for (int i = 0; i < 250; ++i)
    text += "{selector: [{inverter: {check: {cue: 1}}}, {probe: {cue: 2}}]},";
  const RobotTree tree = build(text + "]}");
  EXPECT_EQ(tree.size(), 1001u);
  EXPECT_EQ(outline(build(text + "]}").root()), outline(tree.root()));
}

}  // namespace
}  // namespace eyrie::ubf::testing
