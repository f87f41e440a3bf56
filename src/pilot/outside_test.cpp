// SPDX-License-Identifier: MIT
#include "pilot/outside.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "pilot/pilot_system.hpp"
#include "support/pilot/war.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;
using model::Manual, model::PointToFly, model::Seat, model::VoteChange;

const PlayerId kEagle{1};

sim::Order hand(const War& war, const Manual& manual, PlayerId who = kEagle) {
  return sim::order_for(war.world->step(), who, OrderKind::manual, manual);
}
template <class Payload>
void give(War& war, OrderKind kind, const Payload& payload) {
  const sim::Order order = sim::order_for(war.world->step(), kEagle, kind, payload);
  war.step({&order, 1});
}
Manual person(std::uint16_t said) {
  return {.said = said, .seat = Seat::person};
}
model::Tasking& tasking(War& war) {
  return war.row(war.aircraft.tasking, kEagle);
}
model::Command& command(War& war) {
  return war.row(war.aircraft.command, kEagle);
}

War alone() {
  War war({"navigate: {vote: 10}"});
  war.add({0, 0, 8000}, 0, 0);
  return war;
}

TEST(Outside, APersonFliesAndTheTreeGoesOnProposing) {
  War war = alone();
  Manual m = person(Manual::kHeading | Manual::kAltitude | Manual::kSpeed);
  m.heading = 1.5F, m.altitude = 6000, m.speed = 220;
  give(war, OrderKind::manual, m);
  ASSERT_EQ(war.told(model::EventKind::order).size(), 1u) << "who takes over is told";
  war.fly(0.2);
  EXPECT_EQ(command(war).mode, model::AutopilotMode::hold);
  EXPECT_FLOAT_EQ(static_cast<float>(command(war).heading), 1.5F);
  EXPECT_EQ(command(war).altitude, 6000);
  EXPECT_EQ(command(war).speed, 220);
  EXPECT_EQ(war.tree(0).node(war.agent(kEagle).node).label(), "navigate");
  war.fly(90);
  EXPECT_NEAR(war.row(war.aircraft.kinematics, kEagle).heading, 1.5, 0.02);
  EXPECT_NEAR(war.row(war.aircraft.kinematics, kEagle).altitude, 6000, 50);
  EXPECT_EQ(war.told(model::EventKind::order).size(), 1u) << "words while he flies are not";

  give(war, OrderKind::manual, Manual{});
  war.fly(0.2);
  EXPECT_EQ(command(war).mode, model::AutopilotMode::route);
  EXPECT_EQ(war.told(model::EventKind::order).size(), 2u);
}

TEST(Outside, GivesTheTreeTheRadarBack) {
  War war = alone();
  const auto silent = [&] { return war.row(war.aircraft.request, kEagle).radar_off; };
  Manual m = person(Manual::kHeading | Manual::kRadar);
  m.radar_off = 1;
  give(war, OrderKind::manual, m);
  war.fly(0.2);
  EXPECT_EQ(silent(), 1);
  give(war, OrderKind::manual, person(Manual::kHeading));
  war.fly(0.2);
  EXPECT_EQ(silent(), 1) << "what he says nothing of stays";
  give(war, OrderKind::manual, Manual{});
  war.fly(0.2);
  EXPECT_EQ(silent(), 0);
  EXPECT_EQ(tasking(war).manual.said, 0);
}

TEST(Outside, AClimbIsADirectionToFlyTo) {
  War war = alone();
  Manual m = person(Manual::kHeading | Manual::kClimb | Manual::kLoadFactor);
  m.heading = 0.5F, m.climb = 0.25F, m.load_factor = 4;
  give(war, OrderKind::manual, m);
  war.fly(10);
  EXPECT_EQ(command(war).mode, model::AutopilotMode::aim);
  const auto& own = war.row(war.aircraft.kinematics, kEagle);
  const Vec3 ned = to_ned(own, own.velocity);
  EXPECT_NEAR(bearing_of(ned), 0.5, 0.05);
  EXPECT_NEAR(std::asin(-ned.z / norm(ned)), 0.25, 0.03);
}

TEST(Outside, APersonShootsOnceAndOnlyAtWhoIsHostile) {
  War war({"navigate: {vote: 10}"});
  war.add({0, 0, 8000}, 0, 0);
  while (war.world->next_id().value < 5)
    war.add({-300e3, 20e3 * war.world->next_id().value, 8000}, 0, 0);
  war.add({30e3, 0, 8000}, kPi, 0);
  war.fly(1);
  const auto& tracks = war.row(war.aircraft.tracks, kEagle);
  TrackId enemy, friendly;
  for (std::uint32_t i = 0; i < tracks.count; ++i)
    (tracks.tracks[i].truth == PlayerId{5} ? enemy : friendly) = tracks.tracks[i].id;
  ASSERT_TRUE(enemy && friendly);
  Manual m = person(Manual::kHeading | Manual::kTarget);
  m.store = kAnyStore;
  m.target = friendly;
  give(war, OrderKind::manual, m);
  war.fly(5);
  EXPECT_TRUE(war.told(model::EventKind::release).empty()) << "at a friend";
  m.target = enemy;
  give(war, OrderKind::manual, m);
  m.store = 0;
  give(war, OrderKind::manual, m);  // the next word does not take the shot back
  war.fly(20);
  EXPECT_EQ(war.told(model::EventKind::release).size(), 1u);

  give(war, OrderKind::weapons, std::uint8_t{1});
  m.store = kAnyStore;
  give(war, OrderKind::manual, m);
  war.fly(20);
  EXPECT_EQ(war.told(model::EventKind::release).size(), 1u) << "weapons are tight";
}

TEST(Outside, FliesToPointsInsteadOfFollowingTheLead) {
  War war({"navigate: {vote: 10}", "follow_lead: {vote: 10}"});
  war.add({0, 0, 8000}, 0, 0);
  const PlayerId wingman = war.add({-500, -500, 8000}, 0, 1);
  war.fly(2);
  ASSERT_EQ(war.row(war.aircraft.command, wingman).mode, model::AutopilotMode::follow);
  const sim::Order there =
      sim::order_for(war.world->step(), wingman, OrderKind::point,
                     PointToFly{.position = {0, 50e3, -8000}, .altitude = 8500});
  war.step({&there, 1});
  war.fly(0.2);
  EXPECT_EQ(war.row(war.aircraft.command, wingman).mode, model::AutopilotMode::hold);
  EXPECT_NEAR(war.row(war.aircraft.command, wingman).heading, kPi / 2, 0.05);
}

TEST(Outside, FliesToPointsInsteadOfTheRoute) {
  War war = alone();
  give(war, OrderKind::point, PointToFly{.position = {0, 5000, -8000}, .altitude = 8500});
  give(war, OrderKind::point,
       PointToFly{.position = {5000, 9000, -8000}, .altitude = 9000, .more = 1});
  war.fly(0.2);
  EXPECT_NEAR(command(war).heading, kPi / 2, 0.05);
  EXPECT_EQ(command(war).altitude, 8500);
  double nearest = 1e9;
  for (int i = 0; i < 120 && tasking(war).points_left == 2; ++i) {
    war.fly(1);
    const auto& p = war.row(war.aircraft.kinematics, kEagle).position;
    nearest = std::hypot(p.x, p.y - 5000);
  }
  EXPECT_LT(nearest, kPointReached + 300);
  ASSERT_EQ(tasking(war).points_left, 1);
  EXPECT_EQ(tasking(war).points[0].altitude, 9000);
  give(war, OrderKind::point, PointToFly{.more = 2});
  war.fly(0.2);
  EXPECT_EQ(command(war).mode, model::AutopilotMode::route);
}

TEST(Outside, AnotherVoteLetsAnotherBehaviorWin) {
  War war({"winner_takes_all: [{navigate: {vote: 5}}, {navigate: {vote: 10}}]"});
  war.add({0, 0, 8000}, 0, 0);
  const auto leader = [&] { return war.agent(kEagle).node; };
  war.fly(0.2);
  ASSERT_EQ(leader(), 2);
  give(war, OrderKind::vote, VoteChange{.vote = 50, .number = 2});
  war.fly(0.2);
  EXPECT_EQ(leader(), 1);
  EXPECT_EQ(war.agent(kEagle).vote, 50);
  give(war, OrderKind::vote, VoteChange{.vote = -1, .number = 2});
  war.fly(0.2);
  EXPECT_EQ(leader(), 2);

  give(war, OrderKind::vote, VoteChange{.vote = 50, .number = 2});
  const sim::Order swap = PilotSystem::swap_tree_order(war.world->step(), kEagle, 0);
  war.step({&swap, 1});
  war.fly(0.2);
  EXPECT_EQ(leader(), 2) << "votes belong to the tree";
}

TEST(Outside, WhatWasDecidedAndDoneIsFoundAgain) {
  War war = alone();
  Manual m = person(Manual::kHeading);
  m.heading = 2;
  give(war, OrderKind::manual, m);
  int decisions = 0;
  for (int i = 0; i < 10; ++i) {
    const sim::World before = *war.world;
    war.step();
    war.system->look_again(before, *war.world, kEagle, {}, [&](const team::AnyMoment& moment) {
      const team::Decision d = moment.decision();
      ++decisions;
      ASSERT_FALSE(d.overruled.empty());
      EXPECT_EQ(d.overruled[0].name, "heading");
      EXPECT_EQ(d.overruled[0].other, "115°");
      EXPECT_EQ(d.nodes[d.leader].label, "navigate");
    });
  }
  EXPECT_EQ(decisions, 2);
}

TEST(Outside, WhatMakesNoSenseIsIgnored) {
  War war = alone();
  const std::uint64_t before = war.world->hash();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<sim::Order> orders;
  const auto add = [&](OrderKind kind, const auto& payload) {
    orders.push_back(sim::order_for(war.world->step(), kEagle, kind, payload));
  };
  Manual m = person(Manual::kHeading);
  m.heading = nan;
  add(OrderKind::manual, m);
  m = person(0), m.speed = -1;
  add(OrderKind::manual, m);
  m = person(0), m.seat = static_cast<Seat>(7);
  add(OrderKind::manual, m);
  m = person(0), m.trigger = 2;
  add(OrderKind::manual, m);
  add(OrderKind::vote, VoteChange{.vote = 5, .number = 9});
  add(OrderKind::vote, VoteChange{.vote = nan, .number = 1});
  add(OrderKind::vote, VoteChange{.vote = 5, .number = 1, .tree = 2});  // it flies by another
  add(OrderKind::point, PointToFly{.position = {nan, 0, 0}});
  add(OrderKind::point, PointToFly{.more = 3});
  orders.push_back(hand(war, person(0), PlayerId{99}));
  sim::World with = *war.world;
  war.simulation->step(with, *war.work, orders);
  war.step();
  EXPECT_EQ(with.hash(), war.world->hash());
  EXPECT_NE(before, with.hash());
  for (const model::VoteChange& vote : tasking(war).votes)
    EXPECT_EQ(vote.number, 0);

  // no room for a ninth vote of eight, nor for a fifth point
  War wide(
      {"winner_takes_all: [navigate: {}, navigate: {}, navigate: {}, navigate: {}, navigate: "
       "{}, navigate: {}, navigate: {}, navigate: {}, navigate: {}]"});
  wide.add({0, 0, 8000}, 0, 0);
  for (std::uint16_t n = 1; n <= 10; ++n)
    give(wide, OrderKind::vote, VoteChange{.vote = 1, .number = n});
  EXPECT_EQ(tasking(wide).votes.back().number, 8);
  for (int n = 0; n < 6; ++n)
    give(wide, OrderKind::point, PointToFly{.more = 1});
  EXPECT_EQ(tasking(wide).points_left, 4);
}

TEST(Outside, AWorldWithoutItHasTheHashOfOneThatKnowsNothingOfIt) {
  War war = alone();
  const std::uint64_t plain = war.world->hash();
  tasking(war).tight = 1;
  EXPECT_NE(war.world->hash(), plain);
  tasking(war).tight = 0;
  EXPECT_EQ(war.world->hash(), plain);
}

}  // namespace
}  // namespace eyrie::pilot
