// SPDX-License-Identifier: MIT
#include "model/flight/fly.hpp"

#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "core/math.hpp"

namespace eyrie::model::flight {
namespace {

void set_vertical(Kinematics& k, const Vertical& vertical) {
  k.north = vertical.north;
  k.east = vertical.east;
  k.down = vertical.down;
  k.altitude = vertical.altitude;
}

/// m: of a level turn, with the distance flown while rolling into it.
double turn_radius(double speed, double rate, double lag) {
  return speed / std::max(rate, 1e-3) + speed * lag;
}

double level_turn_rate(double load_factor, double speed) {
  return kGravity * std::sqrt(std::max(load_factor * load_factor - 1, 0.0)) / std::max(speed, 1.0);
}

}  // namespace

Kinematics placed(const Reference& reference, const Environment& environment, const Vec3& position,
                  double heading, double speed) {
  Kinematics k;
  k.position = position;
  set_vertical(k, reference.vertical_at(position));
  const Vec3 wind = environment.wind.at(k.altitude);
  const auto [sine, cosine] = math::sin_cos(heading);
  k.heading = wrap_pi(heading);
  k.speed = speed;
  k.velocity = (speed * cosine + wind.x) * k.north + (speed * sine + wind.y) * k.east;
  k.mach = speed / environment.atmosphere.at(k.altitude).speed_of_sound;
  return k;
}

bool fly(const PointMass& model, Dynamics dynamics, const FlightContext& context, FlightRows rows) {
  const Airframe& airframe = model.airframe();
  const Command& command = rows.command;
  Kinematics& k = rows.kinematics;
  const Air air = context.environment.atmosphere.at(k.altitude);
  const Vec3 wind = context.environment.wind.at(k.altitude);
  const double load_factor = std::max(command.load_factor, 1.0);
  RouteToFly plan{.routes = context.routes};

  if (dynamics == Dynamics::laero) {
    const Laero& laero = airframe.laero;
    const double turn_limit = laero.turn_rate_limit(k.speed, load_factor);
    plan.turn_radius = turn_radius(k.speed, turn_limit, laero.heading_time);
    const Guidance wanted =
        guide(airframe.autopilot, k, command, plan, rows.flying, wind, context.time, context.dt);
    laero.step(k, rows.flying, wanted, turn_limit, rows.propulsion, air, wind, context.dt);
    rows.propulsion.flow = rows.propulsion.fuel > 0 ? laero.fuel_flow : 0;
  } else {
    const FlightCondition condition = model.condition(k, air, rows.propulsion.fuel, context.load);
    const double most = std::min(load_factor, condition.lift_limit);
    plan.turn_radius =
        turn_radius(k.speed, level_turn_rate(most, k.speed), airframe.autopilot.heading_time);
    const Guidance wanted =
        guide(airframe.autopilot, k, command, plan, rows.flying, wind, context.time, context.dt);
    const Controls controls =
        steer(model, k, condition, wanted, load_factor, rows.flying.afterburner);
    model.step(k, rows.propulsion, condition, controls, wind, context.dt);
  }
  set_vertical(k, context.reference.vertical_at(k.position));
  return burn(rows.propulsion, context.dt);
}

}  // namespace eyrie::model::flight
