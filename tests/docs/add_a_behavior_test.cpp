// SPDX-License-Identifier: MIT
/// \file  The code of docs/howto/add-a-behavior.md, word for word (pages_test.cpp compares), so
/// that the page is compiled and run.
#include <gtest/gtest.h>

#include "core/yaml.hpp"
#include "pilot/catalog.hpp"
#include "support/pilot/testing.hpp"
#include "ubf/memory.hpp"

namespace eyrie::pilot {
namespace {

/// Climbs to a safe altitude, as long as it is lower.
class ClimbAway final : public Behavior {
 public:
  static constexpr std::string_view type_name = "climb_away";
  static constexpr std::string_view help = "climbs to a safe altitude";
  static constexpr auto params() {
    return std::tuple{param("vote", &ClimbAway::vote_, range(0, 1000), "how strongly"),
                      param("altitude", &ClimbAway::altitude_, "m", range(0, 20e3), "how high")};
  }

  Status tick(const Tick& t, Proposal& out) const override {
    if (t.state.own.altitude >= altitude_)
      return Status::failure;
    out.action.heading = t.state.own.heading;
    out.action.altitude = altitude_;
    out.action.mode = model::AutopilotMode::hold;
    out.vote = vote_;
    return Status::running;
  }

 private:
  float vote_ = 15;
  double altitude_ = si(30000, "ft");
};

struct ClimbMemory {
  double end = 0;  ///< s, when the climb is over; 0: not climbing
};

/// The same, but for a limited time.
class ClimbForAWhile final : public ubf::WithMemory<Behavior, ClimbMemory> {
 public:
  static constexpr std::string_view type_name = "climb_for_a_while";
  static constexpr std::string_view help = "climbs for a limited time";
  static constexpr auto params() {
    return std::tuple{param("patience", &ClimbForAWhile::patience_, "s", positive(), "how long")};
  }

  Status tick(const Tick& t, Proposal& out) const override {
    auto& m = memory(t);
    if (m.end == 0)
      m.end = t.time + patience_;
    if (ubf::passed(t.time, m.end, 0)) {
      m = {};
      return Status::success;
    }
    out.action.altitude = t.state.own.altitude + 1000;
    out.vote = 15;
    return Status::running;
  }

 private:
  double patience_ = 20;
};

const Registry& registry_with_new_behaviors() {
  static const Registry kRegistry = [] {
    Registry registry = make_registry();
    registry.add<ClimbAway>();
    registry.add<ClimbForAWhile>();
    return registry;
  }();
  return kRegistry;
}

using testing::Decided;
using testing::Desk;

Tree build(const char* text) {
  Diagnostics diagnostics;
  auto tree = registry_with_new_behaviors().build_tree(
      "test", parse_yaml(text, "test.yaml", diagnostics), diagnostics);
  EYRIE_DEMAND(tree.has_value(), "the page's tree has a mistake");
  return std::move(*tree);
}

/// Chosen before pilot::testing::decide, whose registry does not know the page's behaviors.
template <std::size_t N>
Decided decide(const char (&text)[N], const Desk& desk) {
  const Tree tree = build(text);
  std::vector<std::byte> slab(tree.memory_bytes());
  const State state = desk.state();
  Decided decision;
  decision.status =
      tree.tick({.state = state, .time = desk.time, .memory = slab.data()}, decision.proposal);
  return decision;
}

TEST(ClimbAway, ClimbsOnItsHeadingUntilItIsHighEnough) {
  Desk desk;
  desk.own.altitude = 5000;
  const Decided low = decide("{climb_away: {altitude: 9000 m}}", desk);
  EXPECT_EQ(low.status, Status::running);
  EXPECT_EQ(low.action().altitude, 9000);
  EXPECT_EQ(low.action().heading, desk.own.heading);
  desk.own.altitude = 9000;
  EXPECT_EQ(decide("{climb_away: {altitude: 9000 m}}", desk).status, Status::failure);
}

TEST(AddABehavior, WithMemoryEndsAfterItsTime) {
  const Tree tree = build("{climb_for_a_while: {patience: 5 s}}");
  std::vector<std::byte> slab(tree.memory_bytes());
  const Desk desk;
  const State state = desk.state();
  Proposal out;
  const auto at = [&](double time) {
    return tree.tick({.state = state, .time = time, .memory = slab.data()}, out);
  };
  EXPECT_EQ(at(10), Status::running);
  EXPECT_EQ(at(14.9), Status::running);
  EXPECT_EQ(at(15), Status::success);
}

TEST(AddABehavior, ItsUseInAScenarioIsRead) {
  const Tree tree = build(
      "{winner_takes_all: [{climb_away: {vote: 20, altitude: 35000 ft}}, {navigate: {vote: 10}}]}");
  EXPECT_EQ(tree.size(), 3u);
}

}  // namespace
}  // namespace eyrie::pilot
