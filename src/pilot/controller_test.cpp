// SPDX-License-Identifier: MIT
#include "pilot/controller.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;
using model::AutopilotMode;
using model::Identity;

/// Carries an action out at a desk.
void carry_out(Desk& desk, const Action& action) {
  execute(action, desk.state(), desk.command, desk.request, desk.agent);
}

TEST(Controller, FliesTheNumbers) {
  Desk desk;
  desk.command.mode = AutopilotMode::route;
  Action action;
  action.heading = 6;
  action.altitude = 5000;
  action.speed = 280;
  action.load_factor = 7;
  carry_out(desk, action);
  EXPECT_EQ(desk.command.mode, AutopilotMode::hold);  // numbers without a mode are held
  EXPECT_NEAR(desk.command.heading, 6 - kTau, 1e-12);
  EXPECT_EQ(desk.command.altitude, 5000);
  EXPECT_EQ(desk.command.speed, 280);
  EXPECT_EQ(desk.command.load_factor, 7);
}

TEST(Controller, LeavesTheLastCommandWhereAFieldIsEmpty) {
  Desk desk;
  desk.command = {.heading = 1, .altitude = 2000, .speed = 200, .load_factor = 4};
  desk.command.mode = AutopilotMode::route;
  const model::Command before = desk.command;
  carry_out(desk, {});
  EXPECT_EQ(desk.command.mode, AutopilotMode::route);
  Action faster;
  faster.speed = 300;
  carry_out(desk, faster);
  EXPECT_EQ(desk.command.mode, AutopilotMode::route);
  EXPECT_EQ(desk.command.speed, 300);
  EXPECT_EQ(desk.command.heading, before.heading);
  EXPECT_EQ(desk.command.altitude, before.altitude);
}

TEST(Controller, HandsAFollowToTheAutopilot) {
  Desk desk;
  Action action;
  action.mode = AutopilotMode::follow;
  action.altitude = 7000;
  action.follow = Follow{{1, 2, 3}, {4, 5, 6}, 7, {8, 9, 10}};
  carry_out(desk, action);
  EXPECT_EQ(desk.command.mode, AutopilotMode::follow);
  EXPECT_EQ(desk.command.reference_position, (Vec3{1, 2, 3}));
  EXPECT_EQ(desk.command.reference_velocity, (Vec3{4, 5, 6}));
  EXPECT_EQ(desk.command.reference_time, 7);
  EXPECT_EQ(desk.command.offset, (Vec3{8, 9, 10}));
  EXPECT_EQ(desk.command.altitude, 7000);
}

TEST(Controller, FliesTheNumbersWhenNobodyIsGivenToFollow) {
  for (const AutopilotMode mode : {AutopilotMode::follow, AutopilotMode::loiter}) {
    Desk desk;
    Action action;
    action.mode = mode;
    action.heading = 1;
    carry_out(desk, action);
    EXPECT_EQ(desk.command.mode, AutopilotMode::hold);
    EXPECT_EQ(desk.command.heading, 1);
  }
}

TEST(Controller, PicksTheRoute) {
  Desk desk;
  Action action;
  action.mode = AutopilotMode::route;
  action.route = 1;
  carry_out(desk, action);
  EXPECT_EQ(desk.command.route, 1);
  EXPECT_EQ(desk.command.mode, AutopilotMode::route);
}

TEST(Controller, KeepsTheTargetUntilItIsDroppedOrLost) {
  Desk desk;
  desk.track({20e3, 0, 0});
  Action attack;
  attack.target = TrackId{1};
  carry_out(desk, attack);
  EXPECT_EQ(desk.request.target, TrackId{1});
  EXPECT_EQ(desk.agent.target, TrackId{1});
  carry_out(desk, {});  // a break turn says nothing about it
  EXPECT_EQ(desk.request.target, TrackId{1});
  Action drop;
  drop.target = TrackId{};
  carry_out(desk, drop);
  EXPECT_EQ(desk.request.target, TrackId{});
  carry_out(desk, attack);
  desk.tracks = {};
  carry_out(desk, {});
  EXPECT_EQ(desk.request.target, TrackId{});
  EXPECT_EQ(desk.agent.target, TrackId{});
}

TEST(Controller, DropsATargetThatTurnsOutToBeAFriend) {
  Desk desk;
  desk.track({20e3, 0, 0});
  Action attack;
  attack.target = TrackId{1};
  carry_out(desk, attack);
  desk.tracks.tracks[0].identity = Identity::friendly;
  carry_out(desk, {});
  EXPECT_EQ(desk.request.target, TrackId{});
}

TEST(Controller, EndsTriggerAndReleaseWhenNobodyAsksAgain) {
  Desk desk;
  desk.track({5e3, 0, 0});
  Action shoot;
  shoot.release = Release{TrackId{1}, kShort};
  shoot.trigger = true;
  carry_out(desk, shoot);
  EXPECT_EQ(desk.request.shoot_at, TrackId{1});
  EXPECT_EQ(desk.request.store, kShort + 1);
  EXPECT_EQ(desk.request.trigger, 1);
  carry_out(desk, {});
  EXPECT_EQ(desk.request.shoot_at, TrackId{});
  EXPECT_EQ(desk.request.store, 0);
  EXPECT_EQ(desk.request.trigger, 0);
}

TEST(Controller, KeepsTheRadarAsItIs) {
  Desk desk;
  Action silent;
  silent.radar = false;
  carry_out(desk, silent);
  EXPECT_EQ(desk.request.radar_off, 1);
  carry_out(desk, {});
  EXPECT_EQ(desk.request.radar_off, 1);
  Action on;
  on.radar = true;
  carry_out(desk, on);
  EXPECT_EQ(desk.request.radar_off, 0);
}

RC_GTEST_PROP(ControllerLaw, RefusesAReleaseAtAnybodyButAConfirmedHostile, ()) {
  Desk desk;
  model::Track& track = desk.track({9e3, 0, 0});
  track.identity = static_cast<Identity>(*rc::gen::inRange(0, 3));
  track.confirmed = *rc::gen::inRange<std::uint8_t>(0, 2);
  const TrackId at{*rc::gen::inRange(0u, 3u)};
  Action shoot;
  shoot.release = Release{at, kMedium};
  carry_out(desk, shoot);
  const bool right = at == track.id && track.confirmed && track.identity == Identity::hostile;
  RC_ASSERT(desk.request.shoot_at == (right ? at : TrackId{}));
  RC_ASSERT((desk.request.store == 0) == !right);
}

TEST(Shots, CountWhenTheMissileHasLeft) {
  Desk desk;
  desk.track({20e3, 0, 0});
  const auto decide = [&](const Action& action) {
    account_for_shots(desk.state(), desk.agent);
    ++desk.agent.ticks;
    carry_out(desk, action);
  };
  Action shoot;
  shoot.release = Release{TrackId{1}, kMedium};
  decide(shoot);
  decide({});
  EXPECT_EQ(desk.agent.flying_at(TrackId{1}, desk.time), 0u) << "only asked for";
  desk.stores.stations[0].count = 0;
  decide({});
  EXPECT_EQ(desk.agent.flying_at(TrackId{1}, desk.time), 1u);
  EXPECT_EQ(desk.agent.flying_at(TrackId{2}, desk.time), 0u);
  EXPECT_EQ(desk.agent.flying_at(TrackId{}, desk.time), 0u);
  EXPECT_EQ(desk.agent.shots[0].store, kMedium);
  decide({});
  EXPECT_EQ(desk.agent.flying_at(TrackId{1}, desk.time), 1u) << "counted once";
  EXPECT_EQ(desk.agent.flying_at(TrackId{1}, desk.agent.shots[0].until), 0u);
}

TEST(Shots, FollowATrackIntoTheOneThatItIsMergedWith) {
  Desk desk;
  desk.track({20e3, 0, 0});
  model::Track& newer = desk.track({20e3, 0, 0});
  newer.sources = newer.fresh = model::kFromDatalink;
  desk.agent.target = newer.id;
  desk.agent.shots[0] = {.until = desk.time + 30, .track = newer.id, .store = kMedium};
  model::track::TrackNewsList news;
  const model::track::Tracker tracker;
  model::track::upkeep(desk.tracks, {tracker, {}, desk.time, 3, news});
  ASSERT_EQ(desk.tracks.count, 1u);
  ASSERT_NE(desk.state().target(), nullptr);
  account_for_shots(desk.state(), desk.agent);
  EXPECT_EQ(desk.agent.flying_at(TrackId{1}, desk.time), 1u);
  EXPECT_EQ(desk.agent.target, TrackId{1});
}

TEST(Shots, RememberAsManyAsFit) {
  Desk desk;
  desk.stores.stations[0] = {.store = kMedium + 1, .count = 6};
  for (std::uint32_t i = 0; i < 6; ++i) {
    desk.track({20e3 + 3000.0 * i, 0, 0});
    account_for_shots(desk.state(), desk.agent);
    ++desk.agent.ticks;
    Action shoot;
    shoot.release = Release{TrackId{i + 1}, kMedium};
    carry_out(desk, shoot);
    --desk.stores.stations[0].count;
  }
  account_for_shots(desk.state(), desk.agent);
  std::uint32_t remembered = 0;
  for (std::uint32_t i = 1; i <= 6; ++i)
    remembered += desk.agent.flying_at(TrackId{i}, desk.time);
  EXPECT_EQ(remembered, Agent::kShots);
  EXPECT_EQ(desk.agent.flying_at(TrackId{6}, desk.time), 1u) << "the earliest arrival makes room";
}

}  // namespace
}  // namespace eyrie::pilot
