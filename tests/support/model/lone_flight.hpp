// SPDX-License-Identifier: MIT
#pragma once
/// \file  For the tests of this folder: one aircraft in the air, without a World around it.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/angle.hpp"
#include "model/flight/abreast.hpp"
#include "model/flight/flight_system.hpp"

namespace eyrie::model::test {

inline constexpr double kDt = 0.02;

/// An aircraft whose closed forms fit on a napkin: everything constant over Mach and altitude.
inline flight::Airframe simple_airframe() {
  flight::Airframe a;
  a.empty_mass = 10000;
  a.internal_fuel = 3000;
  a.aerodynamics.wing_area = 30;
  a.aerodynamics.zero_lift_drag = Table1::constant(0.02);
  a.aerodynamics.induced_drag = Table1::constant(0.12);
  a.aerodynamics.max_lift = Table1::constant(1.2);
  a.aerodynamics.separation_drag = 0;
  a.engine.military = Table2::constant(60e3);
  a.engine.afterburner = Table2::constant(100e3);
  return a;
}

/// The same without drag, without thrust and with all the lift it wants: only gravity does work.
inline flight::Airframe ideal_airframe() {
  flight::Airframe a = simple_airframe();
  a.aerodynamics.zero_lift_drag = Table1::constant(0);
  a.aerodynamics.induced_drag = Table1::constant(0);
  a.aerodynamics.max_lift = Table1::constant(100);
  a.engine.idle_share = 0;
  return a;
}

struct TestFlight {
  explicit TestFlight(const flight::Airframe& airframe,
                      flight::Dynamics d = flight::Dynamics::point_mass)
      : model(airframe), dynamics(d) {
    propulsion.fuel = airframe.internal_fuel;
    start(5000, 0, 250);
  }

  /// Level flight `north` and `east` (m) of the reference; the command keeps it.
  void start(double altitude, double heading, double speed, double north = 0, double east = 0) {
    Vec3 position{north, east, 0};
    for (int i = 0; i < 4; ++i)
      position.z += reference.vertical_at(position).altitude - altitude;
    kinematics = flight::placed(reference, environment, position, heading, speed);
    command.heading = heading;
    command.altitude = altitude;
    command.speed = speed;
  }

  /// With the autopilot. True if the tanks ran dry.
  bool step() {
    const flight::Sky sky{reference, environment, kDt};
    flight::Flyer flyer{.model = &model,
                        .kinematics = &kinematics,
                        .flying = &flying,
                        .propulsion = &propulsion,
                        .command = &command,
                        .routes = routes,
                        .load = load,
                        .time = time};
    if (dynamics == flight::Dynamics::laero)
      flight::fly_laero(sky, flyer);
    else
      flight::fly(sky, std::array{&flyer});
    time += kDt;
    return flyer.ran_dry;
  }
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds / kDt)); ++i)
      static_cast<void>(step());
  }

  /// Without the autopilot.
  void step(const flight::Controls& controls) {
    flight::Equations<double>({&model}).step(kinematics, math::sin_cos(kinematics.pitch),
                                             propulsion, condition(), controls,
                                             environment.wind.at(kinematics.altitude), kDt);
    carry_to(kinematics, reference.vertical_at(kinematics.position));
    time += kDt;
  }

  [[nodiscard]] flight::FlightCondition condition() const {
    return flight::Equations<double>({&model}).condition(
        kinematics, environment.atmosphere.at(kinematics.altitude), propulsion.fuel, load);
  }
  /// J/kg over altitude 0: height and speed.
  [[nodiscard]] double energy() const {
    return kGravity * kinematics.altitude + 0.5 * kinematics.speed * kinematics.speed;
  }

  Reference reference{Geodetic{.latitude = radians(40), .longitude = radians(10)}};
  Environment environment;
  flight::PointMass model;
  flight::Dynamics dynamics;
  std::vector<flight::Route> routes;
  flight::Load load;
  Kinematics kinematics;
  flight::Flying flying;
  flight::Propulsion propulsion;
  Command command;
  double time = 0;
};

}  // namespace eyrie::model::test
