// SPDX-License-Identifier: MIT
#include "pilot/behavior/evade.hpp"

#include <gtest/gtest.h>

#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

/// A missile that is heard from there and is here in so many seconds.
Desk threatened(double bearing, double seconds) {
  Desk desk;
  desk.own.mach = 0.85;
  desk.threat(bearing).arrival = desk.time + seconds;
  return desk;
}
double heading(const std::string& tree, const Desk& desk) {
  return wrap_pi(*decide(tree, desk).action().heading);
}

TEST(Evade, IsSilentWithoutAMissileThatIsAlmostHere) {
  for (const char* name : {"notch", "drag", "last_ditch"}) {
    EXPECT_EQ(decide(name, Desk()).status, kFailure) << name;
    EXPECT_EQ(decide(name, threatened(0.5, 30)).status, kFailure) << name;
    Desk heard;  // nobody knows when it will be here: it may be for a mate
    heard.threat(0.5);
    EXPECT_EQ(decide(name, heard).status, kFailure) << name;
    EXPECT_EQ(decide(name, threatened(0.5, 3)).status, kRunning) << name;
  }
}

TEST(Notch, PutsTheMissileOnTheNearerBeamNoseLow) {
  EXPECT_NEAR(heading("notch", threatened(20 * kDegree, 7)), -70 * kDegree, 1e-9);
  EXPECT_NEAR(heading("notch", threatened(-20 * kDegree, 7)), 70 * kDegree, 1e-9);
  EXPECT_NEAR(heading("notch", threatened(170 * kDegree, 7)), 80 * kDegree, 1e-9);
  const Decided d = decide("{notch: {dive: 1000 m}}", threatened(0.4, 7));
  EXPECT_NEAR(*d.action().altitude, 7000, 1e-9);
  EXPECT_EQ(d.action().call, Call::notch);
  EXPECT_EQ(d.action().mode, model::AutopilotMode::hold);
}

TEST(Notch, IsOneOverTheGround) {
  Desk desk = threatened(0, 7);  // from the north, as the wind goes
  desk.models = &windy_library();
  const double heading = *decide("notch", desk).action().heading;
  // with 60 m/s from behind it turns so far the other way that none is left along the sight
  EXPECT_NEAR(250 * std::cos(heading) + 60, 0, 1e-6);
  EXPECT_NEAR(std::fabs(250 * std::sin(heading)), 242.7, 0.1);
}

TEST(Notch, KeepsItsSideWhileTheMissileCrossesTheNose) {
  Pilot pilot("notch");
  Desk desk = threatened(5 * kDegree, 7);
  EXPECT_NEAR(wrap_pi(*pilot.decide(desk).action().heading), -85 * kDegree, 1e-9);
  desk.threats.missiles[0].bearing = -5 * kDegree;
  EXPECT_NEAR(wrap_pi(*pilot.decide(desk).action().heading), -95 * kDegree, 1e-9);
}

TEST(Notch, GoesOnForAMomentWhenTheSeekerFallsSilent) {
  Pilot pilot("{notch: {recovery: 2 s}}");
  Desk desk = threatened(0.5, 7);
  pilot.decide(desk);
  desk.threats = {};
  desk.time += 1.9;
  EXPECT_EQ(pilot.decide(desk).status, kRunning);
  desk.time += 0.2;
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
}

TEST(Notch, GoesByTheMissileThatIsHereFirst) {
  Desk desk = threatened(1.0, 7);
  desk.threat(-1.0, 3900);  // seen: 3.9 s away
  EXPECT_NEAR(heading("notch", desk), -1.0 + kPi / 2, 1e-9);
}

TEST(Notch, BelievesNoSeekerThatFellSilentNorAMissileThatIsOnlySeenFromAfar) {
  Desk desk = threatened(1.0, 7);
  desk.threats.missiles[0].time = desk.time - 1.1;
  EXPECT_EQ(decide("notch", desk).status, kFailure);
  Desk seen;
  seen.threat(1.0, 4100);
  EXPECT_EQ(decide("notch", seen).status, kFailure);
}

TEST(Notch, BeamsTheRadarThatTracksWhenAskedTo) {
  Desk desk;
  desk.rwr.warnings[0] = {.bearing = 30 * kDegree, .kind = model::EmissionKind::track};
  desk.rwr.count = 1;
  EXPECT_EQ(decide("{notch: {against: missile}}", desk).status, kFailure);
  const Decided d = decide("{notch: {against: radar}}", desk);
  EXPECT_NEAR(*d.action().heading, wrap_tau(-60 * kDegree), 1e-9);
  EXPECT_EQ(d.action().call, Call::out) << "no missile is known";
  // the track of who stands there is better than the receiver's bearing
  desk.track({20e3 * std::cos(0.4), 20e3 * std::sin(0.4), 0});
  EXPECT_NEAR(heading("{notch: {against: radar}}", desk), 0.4 - kPi / 2, 1e-9);
}

TEST(Drag, PutsTheFighterToWhomItIsMostExposedOnTheTail) {
  Desk desk;
  desk.track({0, 60e3, 0}, -kPi / 2);
  desk.track({0, -20e3, 0}, kPi / 2);
  const Decided d = decide("{drag: {against: fighter}}", desk);
  EXPECT_NEAR(*d.action().heading, kPi / 2, 1e-9);
  EXPECT_EQ(d.action().call, Call::out);
}

TEST(Drag, WeavesNotAfterTheNoiseOfAReceiver) {
  Pilot dragging("{drag: {against: radar}}"), beaming("{notch: {against: radar}}");
  Desk desk;
  desk.rwr.count = 1;
  const auto hear = [&](Pilot& pilot, double bearing) {
    desk.rwr.warnings[0] = {.bearing = bearing * kDegree, .kind = model::EmissionKind::track};
    return wrap_tau(*pilot.decide(desk).action().heading) / kDegree;
  };
  EXPECT_NEAR(hear(dragging, 90), 270, 1e-9);
  for (const double noisy : {104, 76, 95, 105, 75})
    EXPECT_NEAR(hear(dragging, noisy), 270, 1e-9) << noisy;
  EXPECT_NEAR(hear(dragging, 120), 285, 1e-9) << "he has moved, or it was worse than 15 degrees";
  EXPECT_NEAR(hear(dragging, 91), 285, 1e-9);
  EXPECT_NEAR(hear(beaming, 90), 0, 1e-9);
  EXPECT_NEAR(hear(beaming, 94), 4, 1e-9) << "a notch is narrow";
  desk.threat(94 * kDegree).arrival = desk.time + 3;
  EXPECT_NEAR(hear(dragging, 91), 274, 1e-9) << "of a missile each degree counts";
}

TEST(LastDitch, BreaksThroughTheBearingOfTheMissile) {
  const Decided d = decide("last_ditch", threatened(20 * kDegree, 3));
  EXPECT_NEAR(*d.action().heading, 110 * kDegree, 1e-9);
  EXPECT_EQ(d.action().call, Call::last_ditch);
  EXPECT_EQ(*d.action().load_factor, 9);
  EXPECT_NEAR(*decide("last_ditch", threatened(110 * kDegree, 3)).action().heading, 20 * kDegree,
              1e-9)
      << "from behind the wings, the near way";
}

TEST(Evade, ThrowsOutChaffAndFlaresWhenTheMissileIsNear) {
  using model::Dispense;
  EXPECT_FALSE(decide("notch", threatened(0.5, 7)).action().dispense);
  EXPECT_EQ(decide("notch", threatened(0.5, 5)).action().dispense, Dispense::chaff);
  EXPECT_EQ(decide("last_ditch", threatened(0.5, 3)).action().dispense, Dispense::both);
  EXPECT_FALSE(decide("drag", threatened(0.5, 3)).action().dispense);
  EXPECT_EQ(decide("{drag: {dispense: flares}}", threatened(0.5, 3)).action().dispense,
            Dispense::flares);
}

TEST(Evade, TurnsWithTheEnergyItHasAndForItsLifeWithAll) {
  Desk desk = threatened(0.5, 3);  // 4 g sustained
  desk.own.speed = speed_of(desk.state(), 0.7);
  const auto load = [&](const char* tree) { return *decide(tree, desk).action().load_factor; };
  EXPECT_NEAR(load("notch"), 4, 1e-9) << "at its least Mach number";
  EXPECT_GT(load("{notch: {least_mach: 0.6}}"), 4);
  EXPECT_EQ(load("last_ditch"), 9);
  EXPECT_NEAR(load("{last_ditch: {least_mach: 0.7}}"), 4, 1e-9);
}

TEST(Evade, GoesNoLowerThanItsFloor) {
  Desk desk = threatened(0.5, 3);
  desk.own.altitude = 1200;
  EXPECT_EQ(decide("{last_ditch: {floor: 1000 m}}", desk).action().altitude, 1000);
}

}  // namespace
}  // namespace eyrie::pilot
