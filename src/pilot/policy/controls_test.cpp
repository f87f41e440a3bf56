// SPDX-License-Identifier: MIT
#include "pilot/policy/controls.hpp"

#include <gtest/gtest.h>

#include "core/math.hpp"
#include "pilot/gunnery.hpp"
#include "pilot/outside.hpp"
#include "support/no_allocation.hpp"
#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;
using model::Manual;

Manual asked(std::string_view text, std::vector<float> units, const Desk& desk) {
  return Controls(text).apply(desk.state(), units);
}
Action flown(std::string_view text, std::vector<float> units, const Desk& desk) {
  const State state = desk.state();
  Action action;
  fly_by_hand(Controls(text).apply(state, units), state, action);
  return action;
}
std::vector<std::uint8_t> mask(std::string_view text, const Desk& desk) {
  const Controls controls(text);
  std::vector<std::uint8_t> mask(controls.size(), 9);
  controls.mask(controls.start(desk.state()), mask.data());
  return mask;
}

TEST(Controls, FlyFromTheOwnCourseHeightAndSpeed) {
  Desk desk;
  desk.own = model::test::flying({0, 0, -8000}, 3, 250, 0.1);
  const Action a = flown("turn -90 deg 90 deg\npull -30 deg 30 deg\nspeed_change -100 m/s 50 m/s",
                         {1, 0.5F, -1}, desk);
  EXPECT_EQ(a.mode, model::AutopilotMode::aim);
  EXPECT_NEAR(*a.heading, 3 + kPi / 2 - kTau, 1e-6);
  EXPECT_NEAR(*a.climb, 0.1 + 15 * kDegree, 1e-6);
  EXPECT_NEAR(*a.speed, 150, 1e-4);
  EXPECT_FALSE(a.altitude || a.load_factor || a.target || a.radar || a.dispense || a.release);
  EXPECT_EQ(a.trigger, false);
}

TEST(Controls, AimAtTheTargetAndInsideTheGunsReachAheadOfHim) {
  Desk desk;
  constexpr std::string_view kAim = "aim_right -180 deg 180 deg\naim_up -90 deg 90 deg";
  EXPECT_NEAR(*flown(kAim, {0.5F, 0}, desk).heading, kPi / 2, 1e-6)
      << "nobody: from the own course";
  desk.track({20e3, 20e3, -10e3});
  const Action far = flown(kAim, {0, 0}, desk);
  EXPECT_EQ(far.mode, model::AutopilotMode::aim);
  EXPECT_NEAR(*far.heading, kPi / 4, 1e-3);
  EXPECT_NEAR(*far.climb, std::atan(10 / std::hypot(20, 20)), 3e-3);
  EXPECT_NEAR(*flown(kAim, {-0.25F, 0.5F}, desk).heading, 0, 1e-3);
  EXPECT_NEAR(*flown(kAim, {-0.25F, 0.5F}, desk).climb, *far.climb + kPi / 4, 1e-6);
  // who crosses to the right within reach is led
  desk.tracks.tracks[0].position = desk.own.position + Vec3{500, 0, 0};
  desk.tracks.tracks[0].velocity = {0, 200, 0};
  const State state = desk.state();
  const auto sight = state.gun_sight(*state.target());
  EXPECT_NEAR(*flown(kAim, {0, 0}, desk).heading, bearing_of(sight->aim), 1e-6);
  EXPECT_GT(*flown(kAim, {0, 0}, desk).heading, 3 * kDegree);
}

TEST(Controls, AreFineInTheMiddleWhereTheyAreCubic) {
  const auto heading = [](float x) {
    return *flown("heading -180 deg 180 deg cubic", {x}, {}).heading;
  };
  EXPECT_EQ(heading(0), 0);
  EXPECT_NEAR(heading(0.5F), kPi / 8, 1e-6);
  EXPECT_NEAR(heading(-1), -kPi, 1e-6);
  EXPECT_EQ(Controls("speed 200 kt 600 kt cubic").text(), "speed 200 kt 600 kt cubic\n");
}

TEST(Controls, FlyToNumbersAndNoFartherThanTheirRanges) {
  const Action a =
      flown("heading -180 deg 180 deg\naltitude 1 km 9 km\nspeed 100 m/s 300 m/s\nload_factor 1 9",
            {0.5F, 7, -0.5F, -7}, {});
  EXPECT_EQ(a.mode, model::AutopilotMode::hold);
  EXPECT_NEAR(*a.heading, kPi / 2, 1e-6);
  EXPECT_EQ(*a.altitude, 9000);
  EXPECT_EQ(*a.speed, 150);
  EXPECT_EQ(*a.load_factor, 1);
}

TEST(Controls, WhatIsNoNumberCommandsNothing) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(asked("turn -1 rad 1 rad\ntrigger\nradar", {kNaN, kNaN, kNaN}, {}).said, 0);
}

TEST(Controls, ReleaseTheMissileOfTheShortestReachThatReaches) {
  Desk desk;
  EXPECT_EQ(mask("release", desk), std::vector<std::uint8_t>{0}) << "nobody";
  desk.track({2e3, 0, 0}, 0);  // flies away: an infrared seeker sees it well
  const State state = desk.state();
  const auto zone = state.zone(kShort, *state.target());
  ASSERT_TRUE(zone.r_min < 2e3 && 2e3 < zone.r_max) << zone.r_min << " to " << zone.r_max;
  EXPECT_EQ(mask("release", desk), std::vector<std::uint8_t>{1});
  EXPECT_EQ(flown("release", {0.1F}, desk).release, (Release{TrackId{1}, kShort}));
  EXPECT_EQ(flown("release", {0}, desk).release, std::nullopt) << "on is above 0";
  desk.tracks.tracks[0].position = desk.own.position + Vec3{20e3, 0, 0};
  desk.tracks.tracks[0].velocity = -desk.own.velocity;
  EXPECT_EQ(flown("release", {1}, desk).release, (Release{TrackId{1}, kMedium}));
  desk.tracks.tracks[0].position = desk.own.position + Vec3{200e3, 0, 0};
  EXPECT_EQ(flown("release", {1}, desk).release, std::nullopt);
  EXPECT_EQ(mask("release", desk), std::vector<std::uint8_t>{0}) << "out of reach";
  desk.tracks.tracks[0].position = desk.own.position + Vec3{3e3, 0, 0};
  desk.stores.ready_time = desk.time + 1;
  EXPECT_EQ(mask("release", desk), std::vector<std::uint8_t>{0}) << "not yet";
}

TEST(Controls, ShootWhereTheGunBears) {
  Desk desk;
  EXPECT_EQ(mask("shoot", desk), std::vector<std::uint8_t>{0}) << "nobody";
  desk.track({500, 0, 0}, 0);
  EXPECT_EQ(mask("shoot", desk), std::vector<std::uint8_t>{1});
  EXPECT_EQ(flown("shoot", {0.1F}, desk).trigger, true);
  EXPECT_EQ(flown("shoot", {-0.1F}, desk).trigger, false);
  {
    Desk pair = desk;
    pair.in_flight(2, 1);
    pair.datalink.members[1].position = pair.own.position + Vec3{450, 5, 0};
    EXPECT_EQ(flown("shoot", {1}, pair).trigger, false) << "a friend is in the line of fire";
  }
  desk.tracks.tracks[0].position = desk.own.position + Vec3{500, 300, 0};
  EXPECT_EQ(flown("shoot", {1}, desk).trigger, false) << "beside the cone";
  desk.tracks.tracks[0].position = desk.own.position + Vec3{9e3, 0, 0};
  EXPECT_EQ(flown("shoot", {1}, desk).trigger, false) << "out of reach";
}

TEST(Controls, PressWhatThereIs) {
  Desk desk;
  desk.track({3e3, 0, 0});
  EXPECT_EQ(mask("trigger\nturn -1 rad 1 rad", desk), (std::vector<std::uint8_t>{1, 1}));
  desk.gun.rounds = 0;
  EXPECT_EQ(mask("trigger", desk), std::vector<std::uint8_t>{0});
  const Action a = flown("trigger\nradar\nchaff\nflares", {1, -1, 1, 1}, desk);
  EXPECT_EQ(a.trigger, true);
  EXPECT_EQ(a.radar, false);
  EXPECT_EQ(a.dispense, model::Dispense::both);
  EXPECT_EQ(a.target, TrackId{1});
  const Action b = flown("radar\nchaff\nflares", {1, -1, 1}, desk);
  EXPECT_EQ(b.radar, true);
  EXPECT_EQ(b.dispense, model::Dispense::flares);
  EXPECT_EQ(flown("dispense", {-1}, desk).dispense, std::nullopt);
  const auto cartridges = [&] {
    std::vector<std::uint8_t> all = mask("chaff\nflares", desk);
    all.push_back(mask("dispense", desk)[0]);
    return all;
  };
  desk.decoys.flares = 1;
  EXPECT_EQ(cartridges(), (std::vector<std::uint8_t>{0, 1, 1}));
  desk.decoys = {.chaff = 1};
  EXPECT_EQ(cartridges(), (std::vector<std::uint8_t>{1, 0, 1}));
  desk.decoys.chaff = 0;
  EXPECT_EQ(cartridges(), (std::vector<std::uint8_t>{0, 0, 0}));
}

TEST(Controls, ReadBackTheirText) {
  const Controls controls("turn -1.5707963267948966 rad 90 deg\n\nspeed 200 kt 600 kt\nrelease");
  EXPECT_EQ(controls.text(), "turn -90 deg 90 deg\nspeed 200 kt 600 kt\nrelease\n");
  EXPECT_EQ(Controls(controls.text()).hash(), controls.hash());
  EXPECT_NE(Controls("trigger").hash(), Controls("release").hash());
}

TEST(Controls, SayWhereAndWhatIsWrong) {
  const auto mistakes = [](std::string_view text) -> std::string {
    try {
      Controls(text, {"asked.txt", 3, 1});
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(mistakes("trun -1 rad 1 rad"),
            "asked.txt:3:1: there is no control 'trun'; did you mean 'turn'?");
  EXPECT_EQ(mistakes("turn -1 rad 1 rad\nheading 0 rad 1 rad\nrelease\nrelease"),
            "asked.txt:4:20: heading commands what turn commands\n"
            "asked.txt:6:8: release commands what release commands");
  EXPECT_EQ(mistakes("speed 0 m/s 300 m/s"),
            "asked.txt:3:13: speed: the range must be within 50 m/s to 1000 m/s");
  EXPECT_EQ(mistakes("speed 60 m/s 300 m/s square"),
            "asked.txt:3:22: expected 'cubic' or the end of the line, got 'square'");
  EXPECT_EQ(mistakes("trigger 0 1"), "asked.txt:3:9: expected the end of the line, got '0'");
}

TEST(Controls, HaveDistinctNamesAndHelpAndAreSaneAtTheirEnds) {
  std::set<std::string_view> names;
  for (const ControlType& type : control_types()) {
    EXPECT_TRUE(names.insert(type.name).second) << type.name;
    EXPECT_FALSE(type.help.empty()) << type.name;
    for (const float end : {-1.0F, 1.0F}) {
      std::string text(type.name);
      if (!type.is_flag())
        text += fmt::format(" {} {}", exact_quantity(type.least, type.unit.dimension),
                            exact_quantity(type.most, type.unit.dimension));
      const Manual manual = asked(text, {end}, {});
      model::Tasking tasking;
      const auto order = sim::order_for(1, PlayerId{1}, OrderKind::manual, manual);
      EXPECT_EQ(Outside::obey(order, tasking, {.nodes = 1}), team::Obeyed::told) << text;
    }
  }
}

TEST(Controls, AllocateNothing) {
  Desk desk;
  desk.track({5e3, 0, 0});
  const Controls controls("turn -1 rad 1 rad\nclimb -1 rad 1 rad\ntrigger\nrelease\nflares");
  const std::vector<float> units(5, 0.5F);
  std::vector<std::uint8_t> mask(5);
  const State state = desk.state();
  const NoAllocation guard;
  controls.mask(controls.start(state), mask.data());
  const Manual manual = controls.apply(state, units);
  EXPECT_NE(manual.store, 0);
}

}  // namespace
}  // namespace eyrie::pilot
