// SPDX-License-Identifier: MIT
#include "pilot/catalog.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/yaml.hpp"
#include "pilot/state.hpp"

namespace eyrie::pilot {
namespace {

TEST(Catalog, HasThePapersBehaviors) {
  const Registry registry = make_registry();
  for (const char* name : {"navigate", "follow_lead", "pursue", "release_weapon", "break_turn",
                           "egress", "shoot_gun", "avoid_ground"}) {
    ASSERT_NE(registry.find(name), nullptr) << name;
    EXPECT_EQ(registry.find(name)->kind, ubf::Kind::behavior) << name;
  }
  for (const char* name : {"hostile_track", "in_sight", "area_clear", "bingo", "losses",
                           "winchester", "is_lead", "threatened", "near_home", "route_done"}) {
    ASSERT_NE(registry.find(name), nullptr) << name;
    EXPECT_EQ(registry.find(name)->kind, ubf::Kind::condition) << name;
  }
  for (const char* name : {"winner_takes_all", "fusion", "per_field", "paper_fusion", "sequencer"})
    EXPECT_NE(registry.find(name), nullptr) << name;
}

TEST(Catalog, TellsWhatEveryTypeAndParameterIsFor) {
  const Registry registry = make_registry();
  for (const ubf::NodeInfo& node : registry.catalog()) {
    EXPECT_FALSE(node.help.empty()) << node.name;
    std::set<std::string> names;
    for (const ParamInfo& p : node.parameters) {
      const std::string where = node.name + "." + p.name;
      EXPECT_FALSE(p.help.empty()) << where;
      EXPECT_TRUE(names.insert(p.name).second) << where << " is there twice";
      const bool ours = node.kind == ubf::Kind::behavior || node.kind == ubf::Kind::condition;
      if (!ours || (p.kind != ParamKind::number && p.kind != ParamKind::integer))
        continue;
      EXPECT_TRUE(std::isfinite(p.limits.min)) << where << " has no lower limit";
      EXPECT_TRUE(std::isfinite(p.limits.max)) << where << " has no upper limit";
      EXPECT_LT(p.limits.min, p.limits.max) << where;
      EXPECT_TRUE(p.required || !p.default_text.empty()) << where << " has no default";
    }
  }
}

TEST(Catalog, LetsEveryBehaviorVote) {
  const Registry registry = make_registry();
  for (const ubf::NodeInfo& node : registry.catalog()) {
    const bool votes = std::any_of(node.parameters.begin(), node.parameters.end(),
                                   [](const ParamInfo& p) { return p.name == "vote"; });
    // waiting proposes nothing
    EXPECT_TRUE(votes || node.kind != ubf::Kind::behavior || node.name == "wait") << node.name;
  }
}

TEST(Catalog, HasNoDefaultThatItWouldRefuse) {
  const Registry registry = make_registry();
  for (const ubf::NodeInfo& node : registry.catalog()) {
    if (node.kind != ubf::Kind::behavior && node.kind != ubf::Kind::condition)
      continue;
    if (!node.text_key.empty())
      continue;  // a condition in words has no default
    if (std::any_of(node.parameters.begin(), node.parameters.end(),
                    [](const ParamInfo& p) { return p.required; }))
      continue;  // nor has the file of a network
    // the whole node as a file would write its defaults
    std::string text = "{" + node.name + ": {";
    for (const ParamInfo& p : node.parameters)
      text += p.name + ": " + p.default_text + ", ";
    text += "}}";
    Diagnostics diagnostics;
    EXPECT_TRUE(
        registry.build_tree("test", parse_yaml(text, "test.yaml", diagnostics), diagnostics))
        << text << "\n"
        << diagnostics.text();
  }
}

TEST(Catalog, GivesGroundAvoidanceTheHighestVoteOfAll) {
  double highest = 0, ground = 0;
  const Registry registry = make_registry();
  for (const ubf::NodeInfo& node : registry.catalog())
    for (const ParamInfo& p : node.parameters)
      if (node.kind == ubf::Kind::behavior && (p.name == "vote" || p.name == "near_vote")) {
        const double vote = std::stod(p.default_text);
        (node.name == "avoid_ground" ? ground : highest) =
            std::max(node.name == "avoid_ground" ? ground : highest, vote);
      }
  EXPECT_GT(ground, highest);
}

TEST(Catalog, HelpsWithAMisspeltParameter) {
  Diagnostics diagnostics;
  const auto tree = make_registry().build_tree(
      "test", parse_yaml("{break_turn: {danger_rang: 2 nmi}}", "test.yaml", diagnostics),
      diagnostics);
  EXPECT_FALSE(tree);
  EXPECT_EQ(diagnostics.text(),
            "test.yaml:1:15: break_turn has no parameter 'danger_rang'; did you mean "
            "'danger_range'?");
}

}  // namespace
}  // namespace eyrie::pilot
