// SPDX-License-Identifier: MIT
/// \file  Behaviors in the air: an F-15 that does what one of them says, by the point-mass model.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "support/data_file.hpp"
#include "support/model/lone_flight.hpp"
#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

/// The F-15 of data/.
const model::Airframe& f15() {
  static const auto airframe = eyrie::test::load<model::Airframe>("data/airframes/f15c.yaml");
  return airframe;
}

/// One aircraft and its pilot, who decides ten times per second.
struct Flown : model::test::TestFlight {
  explicit Flown(const std::string& tree) : TestFlight(f15()), pilot(tree) {
    reference = library().reference;
    propulsion.fuel = 4000;
  }
  Decided decide() {
    desk.own = kinematics;
    desk.flying = flying;
    desk.propulsion = propulsion;
    desk.command = command;
    desk.time = time;
    const Decided decision = pilot.fly(desk);
    command = desk.command;
    return decision;
  }
  /// Until `done(decision)`, at most so many seconds; whether it came to that.
  template <class Done>
  bool fly_until(double seconds, Done done) {
    const auto decisions = static_cast<int>(seconds * 10 + 0.5);
    for (int i = 0; i < decisions; ++i) {
      if (done(decide()))
        return true;
      for (int n = 0; n < 5; ++n)
        static_cast<void>(step());
    }
    return false;
  }
  void fly_for(double seconds) {
    fly_until(seconds, [](const Decided&) { return false; });
  }

  Desk desk;
  Pilot pilot;
};

TEST(AvoidGround, KeepsAnAircraftThatDivesOnAndOnOffTheGround) {
  for (const double speed : {200.0, 260.0, 320.0})
    for (const double altitude : {1000.0, 3000.0, 6000.0}) {
      Flown f("{avoid_ground: {floor: 457 m}}");
      f.start(altitude, 0.3, speed);
      double lowest = altitude;
      f.fly_until(400, [&](const Decided& d) {
        if (d.status == kFailure)
          f.command = {.heading = 0.3, .altitude = -5000, .speed = speed, .load_factor = 5};
        lowest = std::min(lowest, f.kinematics.altitude);
        return false;
      });
      EXPECT_GT(lowest, 300) << speed << " m/s from " << altitude << " m";
      EXPECT_LT(lowest, 700) << "pulls up too early: " << speed << " m/s from " << altitude;
    }
}

TEST(Egress, LandsFromWhereverItBegins) {
  const Vec3 home = *library().flights[0].home;
  for (const double miles : {0.5, 4.0, 20.0, 60.0})
    for (const double altitude : {1000.0, 8000.0, 12'000.0})
      for (const double heading : {0.0, 1.6, -1.6}) {
        Flown f("egress");
        f.start(altitude, heading, 250, home.x, miles * kNmi);
        const double in_time = miles * kNmi / 200 + 400;
        EXPECT_TRUE(
            f.fly_until(in_time, [](const Decided& d) { return d.action().call == Call::land; }))
            << miles << " nmi, " << altitude << " m, heading " << heading;
        EXPECT_LT(*f.desk.state().home_distance(), 5.01 * kNmi);
        EXPECT_LT(f.kinematics.altitude, si(6000, "ft"));
      }
}

TEST(FollowLead, ReachesItsPlaceInTheWall) {
  // the lead flies east at 240 m/s; the wingman begins 3 km behind and 1 km too high
  Flown f("follow_lead");
  f.start(8500, kPi / 2, 240, -1000, -4000);
  f.desk.in_flight(2, 2);
  model::test::TestFlight lead(f15());
  lead.reference = library().reference;
  lead.propulsion.fuel = 4000;
  lead.start(7500, kPi / 2, 240);
  const auto listen = [&] {
    for (int n = 0; n < 50; ++n)
      static_cast<void>(lead.step());
    model::Mate& mate = f.desk.datalink.members[0];
    mate.position = lead.kinematics.position;
    mate.velocity = {static_cast<float>(lead.kinematics.velocity.x),
                     static_cast<float>(lead.kinematics.velocity.y),
                     static_cast<float>(lead.kinematics.velocity.z)};
    mate.time = mate.heard_time = lead.time;
  };
  for (int second = 0; second < 240; ++second) {
    listen();
    f.time = lead.time - 1;  // it hears of the second that it flies, like a datalink extrapolates
    f.fly_for(1);
  }
  const Vec3 apart = to_ned(lead.kinematics, f.kinematics.position - lead.kinematics.position);
  EXPECT_NEAR(apart.x, si(6000, "ft"), 60);   // heading east, left is north
  EXPECT_NEAR(apart.y, -si(1000, "ft"), 60);  // behind is west
  EXPECT_NEAR(f.kinematics.altitude, lead.kinematics.altitude - si(500, "ft"), 30);
}

TEST(Pursue, CatchesAFlyingTarget) {
  Flown f("{pursue: {mode: intercept, speed: 300 m/s}}");
  f.start(8000, 0, 280);
  Vec3 place{40e3, 30e3, f.kinematics.position.z};
  const Vec3 velocity{-100, -150, 0};
  double nearest = 1e9;
  for (int i = 0; i < 200; ++i) {
    f.desk.tracks = {};
    f.desk.own = f.kinematics;
    f.desk.time = f.time;
    f.desk.track(place - f.kinematics.position).velocity = velocity;
    f.fly_for(1);
    place += velocity;
    nearest = std::min(nearest, norm(place - f.kinematics.position));
  }
  EXPECT_LT(nearest, 600);
}

/// A target that flies straight on at `altitude` from a place north-east of the pilot.
struct Chase : Flown {
  Chase(const std::string& tree, double own_altitude, double own_heading, double north, double east,
        double altitude)
      : Flown(tree) {
    start(own_altitude, own_heading, 250);
    place = kinematics.position + Vec3{north, east, own_altitude - altitude};
  }
  /// The lowest that it comes in that time (m).
  double lowest_in(double seconds) {
    double lowest = kinematics.altitude;
    for (int i = 0; i < static_cast<int>(seconds * 10); ++i) {
      desk.tracks = {};
      desk.own = kinematics;
      desk.time = time;
      model::Track& track = desk.track(place - kinematics.position);
      track.velocity = velocity;
      track.id = desk.agent.target = TrackId{1};
      fly_for(0.1);
      place += 0.1 * velocity;
      lowest = std::min(lowest, kinematics.altitude);
    }
    return lowest;
  }
  Vec3 place, velocity{220, 0, 0};
};

TEST(Maneuver, KeepsItsFloorWhereverTheTargetIs) {
  for (const std::string name :
       {"lead_pursuit: {", "pure_pursuit: {", "lag_pursuit: {", "extend: {",
        "pursue: {mode: lead, ", "extend: {dive: 60 deg, ", "pure_pursuit: {least_mach: 0, "})
    for (const double load_factor : {2.0, 7.0})
      for (const double own_altitude : {1500.0, 3000.0, 7500.0})
        for (const double north : {-4000.0, 1500.0, 5000.0})
          for (const double own_heading : {0.0, 2.5}) {
            Chase c("{" + name + "floor: 600 m, load_factor: " + std::to_string(load_factor) + "}}",
                    own_altitude, own_heading, north, 300, 150);
            EXPECT_GT(c.lowest_in(90), 570)
                << name << " " << load_factor << " g from " << own_altitude << " m, he is " << north
                << " m north, own heading " << own_heading;
          }
}

TEST(Maneuver, ComesBackFromBelowItsFloor) {
  for (const std::string name : {"lead_pursuit", "extend", "pursue"}) {
    Chase c("{" + name + ": {floor: 1000 m}}", 500, 0, 6000, 0, 150);
    EXPECT_GT(c.lowest_in(40), 480) << name;
    EXPECT_GT(c.kinematics.altitude, 950) << name;
  }
}

TEST(Gun, BearsOnATargetThatTurnsAndStaysBehindIt) {
  // he flies a level circle at 7 degrees a second, the pilot begins half a kilometer behind on it
  const double rate = 7 * kDegree, his_speed = 200, radius = his_speed / rate;
  for (const std::string tree :
       {"{lead_pursuit: {overtake: 10 m/s}}", "{pursue: {mode: lead, overtake: 10 m/s}}",
        "{winner_takes_all: [{shoot_gun: {vote: 60, overtake: 10 m/s}}, {lead_pursuit: "
        "{overtake: 10 m/s}}]}"}) {
    Flown f(tree);
    f.start(4000, 0, 210);
    const double level = f.kinematics.position.z;
    int bears = 0, nearest = 1e6;
    for (int i = 0; i < 150; ++i) {
      const double turned = rate * f.time + 500 / radius;
      const Vec3 place{radius * std::sin(turned), radius * (1 - std::cos(turned)), level};
      f.desk.tracks = {};
      f.desk.own = f.kinematics;
      f.desk.time = f.time;
      model::Track& track = f.desk.track(place - f.kinematics.position);
      track.velocity = his_speed * Vec3{std::cos(turned), std::sin(turned), 0};
      track.id = f.desk.agent.target = TrackId{1};
      const State s = f.desk.state();
      nearest = std::min(nearest, static_cast<int>(s.seen[0].range));
      bears += i >= 50 && s.gun_sight(s.seen[0])->off_nose <= library().guns[0].aim_cone;
      f.fly_for(0.1);
    }
    EXPECT_GT(bears, 90) << tree;
    EXPECT_GT(nearest, 150) << tree;
  }
}

TEST(Egress, LandsEvenIfHomeIsSmallerThanItsTurn) {
  Flown f("{egress: {arrival: 100 m}}");
  f.start(3000, 0.4, 250, library().flights[0].home->x, 20 * kNmi);
  EXPECT_TRUE(f.fly_until(700, [](const Decided& d) { return d.action().call == Call::land; }));
}

TEST(BreakTurn, PutsTheMissileBehindTheWingAndLosesHeight) {
  Flown f("{break_turn: {turn: 110 deg}}");
  f.start(6000, 0, 280);
  f.desk.threat(0.5, 3000);
  EXPECT_TRUE(f.fly_until(20, [&](const Decided&) {
    return std::fabs(angle_between(f.kinematics.heading, 0.5)) > si(105, "deg");
  }));
  EXPECT_LT(angle_between(0, f.kinematics.heading), 0);  // it came from the right
  EXPECT_LT(f.kinematics.altitude, 5900);
}

TEST(Defense, GoesDownAndUpBySoMuchFromWhereItBegan) {
  const auto altitude_after = [](const std::string& tree, double range) {
    Flown f(tree);
    f.start(7000, 0, 280);
    f.desk.threat(0.5, range);
    for (int second = 0; second < 60; ++second) {
      f.desk.threats.missiles[0].arrival = f.time + 3;
      f.fly_for(1);
    }
    return f.kinematics.altitude;
  };
  for (const std::string name : {"notch", "drag", "last_ditch", "break_turn"})
    EXPECT_NEAR(altitude_after("{" + name + ": {dive: 1000 m, load_factor: 4}}", 2000), 6000, 60)
        << name;
  EXPECT_NEAR(altitude_after("{break_turn: {climb: 500 m}}", 30e3), 7500, 60);
}

}  // namespace
}  // namespace eyrie::pilot
