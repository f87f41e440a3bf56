// SPDX-License-Identifier: MIT
#include "pilot/pilot_system.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <stdexcept>

#include "support/no_allocation.hpp"
#include "support/pilot/war.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;
using model::EventKind;

const std::string kRoute = "navigate";
/// Everything at once, in two phases, with memory in several nodes.
const std::string kFight = R"({sequencer: {start: way, trees: {
  way: {winner_takes_all: [{break_turn: {}}, {follow_lead: {}}, {navigate: {}}]},
  fight: {per_field: [{avoid_ground: {}}, {break_turn: {}}, {release_weapon: {zone: 1.3}},
                      {shoot_gun: {}}, {pursue: {crank: 50 deg}}, {follow_lead: {}},
                      {navigate: {}}]}},
  transitions: [{from: way, to: fight, when: {hostile_track: {within: 30 nmi}}},
                {from: fight, to: way, when: {area_clear: {within: 40 nmi, for: 5 s}}}]}})";

/// Two against two, 40 nmi apart and closing.
War fight() {
  War war({kFight});
  war.add({0, 0, 8000}, 0, 0);
  war.add({-300, -1800, 7900}, 0, 0);
  while (war.world->next_id().value < 5)  // eagle3 and eagle4 stay far behind
    war.add({-300e3, 20e3 * war.world->next_id().value, 8000}, 0, 0);
  war.add({74e3, 1000, 8000}, kPi, 0);
  war.add({74e3, -1500, 8000}, kPi, 0);
  return war;
}

TEST(PilotSystem, DecidesAtItsRateAndByTurns) {
  War war({kRoute});
  for (int i = 0; i < 4; ++i)
    war.add({0, 3000.0 * i, 8000}, 0, 0);
  war.fly(2);
  for (std::uint32_t id = 1; id <= 4; ++id) {
    EXPECT_EQ(war.agent(PlayerId{id}).ticks, 20u);
    EXPECT_EQ((war.agent(PlayerId{id}).decided + id) % 5, 0u);
  }
}

TEST(PilotSystem, LeavesThoseWithoutATreeToTheAutopilot) {
  War war({kRoute});
  const PlayerId alone = war.add({0, 0, 8000}, 1, kNoTree);
  war.fly(1);
  EXPECT_EQ(war.agent(alone).ticks, 0u);
  EXPECT_EQ(war.row(war.aircraft.command, alone).heading, 1);
  EXPECT_TRUE(war.events.empty());
}

TEST(PilotSystem, TellsWhoIsInChargeWhenThatChanges) {
  War war({"{winner_takes_all: [{break_turn: {near_vote: 80}}, {navigate: {vote: 10}}]}"});
  const PlayerId eagle = war.add({0, 0, 8000}, 0, 0);
  war.fly(1);
  const auto first = war.told(EventKind::in_charge);
  ASSERT_EQ(first.size(), 1u);
  EXPECT_EQ(first[0].who, eagle);
  EXPECT_EQ(war.tree(0).node(static_cast<ubf::NodeIndex>(first[0].values[0])).label(), "navigate");
  EXPECT_EQ(first[0].values[1], 10);
  EXPECT_EQ(war.tree(0).node(war.agent(eagle).node).label(), "navigate");
  EXPECT_EQ(war.agent(eagle).vote, 10);
}

TEST(PilotSystem, TellsThePhasesOfTheSequencer) {
  War war = fight();
  war.fly(0.2);
  EXPECT_EQ(war.agent(PlayerId{1}).phase, 0);
  war.fly(60);
  EXPECT_EQ(war.agent(PlayerId{1}).phase, 1);
  std::vector<sim::Event> mine;
  for (const sim::Event& e : war.told(EventKind::phase))
    if (e.who == PlayerId{1})
      mine.push_back(e);
  ASSERT_GE(mine.size(), 2u);
  EXPECT_EQ(mine[0].values[0], -1);
  EXPECT_EQ(mine[0].values[1], 0);
  EXPECT_EQ(mine[1].values[0], 0);
  EXPECT_EQ(mine[1].values[1], 1);
  EXPECT_EQ(mine[0].values[2], 0);  // the sequencer is the root
}

TEST(PilotSystem, TellsOfCommitShotAndDefense) {
  War war = fight();
  war.fly(90);
  const auto commits = war.told(EventKind::commit);
  ASSERT_FALSE(commits.empty());
  EXPECT_LE(commits[0].values[0], 30 * kNmi);
  for (const sim::Event& e : commits)
    EXPECT_NE(e.who.value <= 4, e.whom.value <= 4) << "on an enemy";
  EXPECT_FALSE(war.told(EventKind::release).empty());
  const auto defenses = war.told(EventKind::defend);
  ASSERT_FALSE(defenses.empty());
  EXPECT_EQ(defenses[0].values[0], 1) << "far comes before near";
}

TEST(PilotSystem, TellsACommitOncePerEnemy) {
  War war = fight();
  war.fly(60);
  std::map<PlayerId, PlayerId> last;
  for (const sim::Event& e : war.told(EventKind::commit)) {
    EXPECT_NE(last[e.who], e.whom);
    last[e.who] = e.whom;
  }
}

TEST(PilotSystem, TellsWhoTakesTheLead) {
  War war({kRoute});
  const PlayerId lead = war.add({0, 0, 8000}, 0, 0);
  const PlayerId second = war.add({0, 3000, 8000}, 0, 0);
  war.add({0, 6000, 8000}, 0, 0);
  war.fly(2);
  EXPECT_TRUE(war.told(EventKind::lead_change).empty());
  war.world->remove(war.aircraft.table, 0);
  war.fly(2);
  const auto changes = war.told(EventKind::lead_change);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].who, second);
  EXPECT_EQ(changes[0].whom, lead);
}

TEST(PilotSystem, TellsBingoOnce) {
  War war({kRoute});
  const PlayerId eagle = war.add({0, 0, 8000}, 0, 0);
  war.fly(1);
  EXPECT_TRUE(war.told(EventKind::bingo).empty());
  war.row(war.aircraft.propulsion, eagle).fuel = 499;
  war.fly(2);
  ASSERT_EQ(war.told(EventKind::bingo).size(), 1u);
  EXPECT_NEAR(war.told(EventKind::bingo)[0].values[0], 499, 1);
}

TEST(PilotSystem, LandsAndLeaves) {
  War war({"egress"});
  const Vec3 home = *testing::library().flights[0].home;
  war.add({home.x + 2000, home.y, 1000}, 0, 0);
  war.fly(1);
  ASSERT_EQ(war.told(EventKind::home).size(), 1u);
  EXPECT_EQ(war.world->rows(war.aircraft.table), 0u);
}

TEST(PilotSystem, AsksForAReleaseForOneStepOnly) {
  War war({"{release_weapon: {zone: 5}}"});
  war.add({0, 0, 8000}, 0, 0);
  while (war.world->next_id().value < 5)
    war.add({-300e3, 20e3 * war.world->next_id().value, 8000}, 0, kNoTree);
  war.add({25e3, 0, 8000}, kPi, kNoTree);
  int asked = 0;
  for (int i = 0; i < 100; ++i) {
    war.step();
    asked += war.row(war.aircraft.request, PlayerId{1}).shoot_at ? 1 : 0;
  }
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(war.told(EventKind::release).size(), 1u);
  EXPECT_EQ(war.told(EventKind::launch).size(), 1u);
}

TEST(SwapTree, StartsTheOtherTreeWithNothingRemembered) {
  War war({kFight, "{area_clear: {within: 10 nmi, for: 100 s}}"});
  const PlayerId eagle = war.add({0, 0, 8000}, 0, 0);
  war.fly(1);
  const auto memory = war.world->bytes(war.pilots.brain, 0);
  EXPECT_TRUE(
      std::any_of(memory.begin(), memory.end(), [](std::byte b) { return b != std::byte{}; }));
  const std::uint64_t before = war.world->hash();
  sim::World other = *war.world;
  war.step(std::array{PilotSystem::swap_tree_order(war.world->step(), eagle, 1)});
  EXPECT_EQ(war.agent(eagle).tree, 1);
  EXPECT_EQ(war.agent(eagle).phase, ubf::kNone);
  EXPECT_NE(war.world->hash(), before);
  static_cast<void>(war.simulation->step(other, *war.work));
  EXPECT_NE(war.world->hash(), other.hash()) << "it is in the hash";
  const auto told = war.told(EventKind::order);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].who, eagle);
  EXPECT_EQ(told[0].aux, 1);
}

TEST(SwapTree, ForgetsEvenWhenItIsTheSameTree) {
  War war({"{area_clear: {within: 10 nmi, for: 3 s}}"});
  const PlayerId eagle = war.add({0, 0, 8000}, 0, 0);
  war.fly(2);
  const auto since = [&] {
    double time;
    std::memcpy(&time, war.world->bytes(war.pilots.brain, 0).data(), sizeof time);
    return time;
  };
  const double first = since();
  war.step(std::array{PilotSystem::swap_tree_order(war.world->step(), eagle, 0)});
  war.fly(0.2);
  EXPECT_GT(since(), first + 1);
}

TEST(SwapTree, IgnoresWhatCannotBe) {
  War war({kRoute});
  const PlayerId eagle = war.add({0, 0, 8000}, 0, 0);
  war.fly(1);
  sim::World other = *war.world;
  war.step(std::array{PilotSystem::swap_tree_order(war.world->step(), eagle, 1),
                      PilotSystem::swap_tree_order(war.world->step(), PlayerId{77}, 0)});
  static_cast<void>(war.simulation->step(other, *war.work));
  EXPECT_TRUE(war.told(EventKind::order).empty());
  EXPECT_TRUE(war.world->same_bytes(other));
}

TEST(PilotSystem, DecidesTheSameFromASnapshot) {
  War war = fight();
  war.fly(40);
  sim::World copy = *war.world;
  for (int i = 0; i < 1000; ++i) {
    war.step();
    static_cast<void>(war.simulation->step(copy, *war.work));
  }
  EXPECT_TRUE(war.world->same_bytes(copy));
}

TEST(PilotSystem, AllocatesNothing) {
  War war = fight();
  war.fly(20);
  war.events.reserve(10'000);
  NoAllocation guard;
  for (int i = 0; i < 2000; ++i)
    static_cast<void>(war.simulation->step(*war.world, *war.work));
}

TEST(PilotSystem, RefusesToBeBuiltWithoutWhatItNeeds) {
  EXPECT_THROW(PilotSystem(PilotSetup{}), std::logic_error);
  const auto library = std::make_shared<const model::Library>(testing::library());
  const auto trees = std::make_shared<const Trees>();
  EXPECT_THROW(PilotSystem({.library = library, .trees = trees}), std::logic_error);
  EXPECT_NO_THROW(PilotSystem({.library = library, .trees = trees, .plans = {{}, {}}}));
  EXPECT_THROW(PilotSystem({.library = library, .trees = trees, .plans = {{}, {}}, .period = 0}),
               std::logic_error);
}

TEST(TraceDecision, IsTheDecisionThatWasMade) {
  War war = fight();
  Trace trace(war.trees().max_size());
  std::size_t compared = 0, orders_seen = 0;
  for (int i = 0; i < 4500; ++i) {
    const sim::World before = *war.world;
    std::vector<sim::Order> orders;
    if (i % 1000 == 999)
      orders.push_back(PilotSystem::swap_tree_order(before.step(), PlayerId{1}, 0));
    war.step(orders);
    for (const PlayerId id : {PlayerId{1}, PlayerId{2}, PlayerId{5}, PlayerId{6}}) {
      if (!war.world->row(war.aircraft.table, id) || war.agent(id).decided != before.step() ||
          war.agent(id).ticks == 0)
        continue;
      const auto again = war.trace_decision(before, id, trace, orders);
      ASSERT_TRUE(again) << "step " << i;
      ASSERT_EQ(again->leader, war.agent(id).node) << "step " << i;
      ASSERT_EQ(again->vote, war.agent(id).vote) << "step " << i;
      ASSERT_EQ(trace.row(0).proposal.leader, again->leader);
      if (again->action.heading) {
        ASSERT_EQ(wrap_pi(*again->action.heading), war.row(war.aircraft.command, id).heading);
      }
      if (again->action.altitude) {
        ASSERT_EQ(*again->action.altitude, war.row(war.aircraft.command, id).altitude);
      }
      ++compared;
      orders_seen += orders.size();
    }
  }
  EXPECT_GT(compared, 1000u);
  EXPECT_GT(orders_seen, 0u);
}

TEST(TraceDecision, LeavesTheWorldAlone) {
  War war = fight();
  war.fly(45);
  Trace trace(war.trees().max_size());
  std::optional<Proposal> decided;
  while (!decided) {
    const sim::World before = *war.world;
    war.step();
    const sim::World after = *war.world;
    decided = war.trace_decision(before, PlayerId{1}, trace);
    EXPECT_TRUE(after.same_bytes(*war.world));
  }
  EXPECT_TRUE(trace.row(0).ticked);
  EXPECT_EQ(trace.rows().size(), war.tree(0).size());
  // whose heading it is can be read off
  ASSERT_TRUE(decided->action.heading);
  const ubf::NodeIndex source = trace.row(0).supplier[0];
  EXPECT_TRUE(trace.row(source).ticked);
  EXPECT_EQ(*trace.row(source).proposal.action.heading, *decided->action.heading);
}

TEST(TraceDecision, HasNothingToSayWhenNobodyDecided) {
  War war({kRoute});
  const PlayerId eagle = war.add({0, 0, 8000}, 0, 0);
  const PlayerId idle = war.add({0, 5000, 8000}, 0, kNoTree);
  Trace trace(war.trees().max_size());
  for (int i = 0; i < 10; ++i) {
    const sim::World before = *war.world;
    war.step();
    EXPECT_EQ(war.trace_decision(before, eagle, trace).has_value(), (before.step() + 1) % 5 == 0);
    EXPECT_FALSE(war.trace_decision(before, idle, trace));
    EXPECT_FALSE(war.trace_decision(before, PlayerId{99}, trace));
  }
}

}  // namespace
}  // namespace eyrie::pilot
