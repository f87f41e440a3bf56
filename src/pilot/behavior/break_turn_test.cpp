// SPDX-License-Identifier: MIT
#include "pilot/behavior/break_turn.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

const std::string kBreak = "{break_turn: {vote: 70, near_vote: 80}}";

TEST(BreakTurn, FailsWithoutAThreat) {
  const Decided d = decide(kBreak, Desk());
  EXPECT_EQ(d.status, kFailure);
  EXPECT_TRUE(d.proposal.is_empty());
}

TEST(BreakTurn, TurnsTowardsAFarMissileAndClimbs) {
  Desk desk;
  desk.threat(70 * kDegree, 5 * kNmi);
  const Decided d = decide("{break_turn: {vote: 70, climb: 1000 m}}", desk);
  EXPECT_EQ(d.status, kRunning);
  EXPECT_NEAR(*d.action().heading, 70 * kDegree, 1e-12);
  EXPECT_NEAR(*d.action().altitude, 9000, 1e-9);
  EXPECT_EQ(d.action().mode, model::AutopilotMode::hold);
  EXPECT_EQ(d.action().call, Call::defend_far);
  EXPECT_EQ(d.proposal.vote, 70);
}

TEST(BreakTurn, BreaksAwayNoseLowInsideTwoMiles) {
  Desk desk;
  desk.threat(70 * kDegree, 1.99 * kNmi);
  const Decided d = decide("{break_turn: {near_vote: 80, turn: 110 deg, dive: 1000 m}}", desk);
  EXPECT_NEAR(*d.action().heading, wrap_tau((70 - 110) * kDegree), 1e-12);  // to the left
  EXPECT_NEAR(*d.action().altitude, 7000, 1e-9);
  EXPECT_EQ(d.action().call, Call::defend_near);
  EXPECT_EQ(d.proposal.vote, 80);
}

TEST(BreakTurn, ChangesPhaseAtTwoMiles) {
  for (const double miles : {2.001, 1.999}) {
    Desk desk;
    desk.threat(0.5, miles * kNmi);
    EXPECT_EQ(decide(kBreak, desk).action().call, miles < 2 ? Call::defend_near : Call::defend_far)
        << miles;
  }
}

TEST(BreakTurn, StaysInTheNearPhaseUntilTheMissileIsHalfAsFarAgain) {
  Pilot pilot(kBreak);
  Desk desk;
  desk.threat(0.5, 1.9 * kNmi);
  EXPECT_EQ(pilot.decide(desk).action().call, Call::defend_near);
  desk.threats.missiles[0].range = 2.9 * kNmi;
  EXPECT_EQ(pilot.decide(desk).action().call, Call::defend_near);
  desk.threats.missiles[0].range = 3.1 * kNmi;
  EXPECT_EQ(pilot.decide(desk).action().call, Call::defend_far);
  desk.threats.missiles[0].range = 2.9 * kNmi;
  EXPECT_EQ(pilot.decide(desk).action().call, Call::defend_far);
}

TEST(BreakTurn, KeepsItsSideWhileTheMissileCrossesTheNose) {
  Pilot pilot("{break_turn: {turn: 110 deg}}");
  Desk desk;
  desk.threat(5 * kDegree, 1.5 * kNmi);
  EXPECT_NEAR(*pilot.decide(desk).action().heading, wrap_tau(-105 * kDegree), 1e-12);
  desk.threats.missiles[0].bearing = -5 * kDegree;
  EXPECT_NEAR(*pilot.decide(desk).action().heading, wrap_tau(-115 * kDegree), 1e-12);
}

TEST(BreakTurn, WaitsWithTheNearPhaseWhenOnlyTheBearingIsKnown) {
  Pilot pilot("{break_turn: {unknown_delay: 10 s}}");
  Desk desk;
  desk.threat(0.5);
  EXPECT_EQ(pilot.decide(desk).action().call, Call::defend_far);
  desk.time += 9.9;
  EXPECT_EQ(pilot.decide(desk).action().call, Call::defend_far);
  desk.time += 0.1;
  EXPECT_EQ(pilot.decide(desk).action().call, Call::defend_near);
}

TEST(BreakTurn, GoesByTheNearestMissileOfKnownRange) {
  Desk desk;
  desk.threat(1.0);
  desk.threat(2.0, 9 * kNmi);
  desk.threat(-1.0, 8 * kNmi);
  EXPECT_NEAR(*decide(kBreak, desk).action().heading, wrap_tau(-1.0), 1e-12);
}

TEST(BreakTurn, ForgetsTheNearPhaseOnceTheThreatIsGone) {
  Pilot pilot("{break_turn: {recovery: 2 s}}");
  Desk desk;
  desk.threat(0.5, kNmi);
  EXPECT_EQ(pilot.decide(desk).action().call, Call::defend_near);
  desk.threats = {};
  desk.time += 1;
  EXPECT_EQ(pilot.decide(desk).action().call, Call::defend_near);  // it may only be silent
  desk.time += 1.1;
  EXPECT_EQ(pilot.decide(desk).status, kFailure);
  desk.threat(0.5, 2.5 * kNmi);
  EXPECT_EQ(pilot.decide(desk).action().call, Call::defend_far);
}

TEST(BreakTurn, DivesToTheFloorAndNotBelow) {
  Desk desk;
  desk.own.altitude = 1000;
  desk.threat(0.5, kNmi);
  EXPECT_NEAR(*decide("{break_turn: {dive: 2000 m, floor: 600 m}}", desk).action().altitude, 600,
              1e-9);
  desk.own.altitude = 400;
  EXPECT_GE(*decide("{break_turn: {dive: 2000 m, floor: 600 m}}", desk).action().altitude, 400);
}

}  // namespace
}  // namespace eyrie::pilot
