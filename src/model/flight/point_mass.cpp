// SPDX-License-Identifier: MIT
#include "model/flight/point_mass.hpp"

#include <initializer_list>

namespace eyrie::model::flight {
namespace {

Axis common(std::initializer_list<std::span<const double>> axes) {
  std::vector<double> all;
  for (const auto& axis : axes)
    all.insert(all.end(), axis.begin(), axis.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return Axis(std::move(all));
}

/// sin and cos of an angle a little further, for |turn| < 0.1: series to the fifth order.
math::SinCos turned(const math::SinCos& from, double turn) {
  const double t2 = turn * turn;
  const double sine = turn * (1 - t2 * (1.0 / 6) * (1 - t2 * (1.0 / 20)));
  const double cosine = 1 - t2 * 0.5 * (1 - t2 * (1.0 / 12));
  return {from.sin * cosine + from.cos * sine, from.cos * cosine - from.sin * sine};
}

/// Keeps the heading rate finite at the vertical.
double away_from_zero(double cosine) {
  constexpr double kLeast = 1e-3;
  return std::fabs(cosine) < kLeast ? std::copysign(kLeast, cosine) : cosine;
}

double towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

constexpr double kLeastSpeed = 1;  // m/s: a direction of flight must exist

}  // namespace

PointMass::PointMass(const Airframe& airframe)
    : airframe_(airframe),
      steepest_climb_(math::sin(airframe.autopilot.max_climb_angle)),
      steepest_dive_(math::sin(airframe.autopilot.max_dive_angle)) {
  const Aerodynamics& a = airframe_.aerodynamics;
  const Engine& e = airframe_.engine;
  mach_ = common({a.zero_lift_drag.breakpoints(), a.induced_drag.breakpoints(),
                  a.max_lift.breakpoints(), e.military.rows().breakpoints(),
                  e.afterburner.rows().breakpoints()});
  altitude_ = common({e.military.columns().breakpoints(), e.afterburner.columns().breakpoints()});
  for (const double mach : mach_.breakpoints()) {
    by_mach_.push_back({a.zero_lift_drag(mach), a.induced_drag(mach), a.max_lift(mach)});
    for (const double altitude : altitude_.breakpoints()) {
      const Thrust thrust = e.thrust_at(mach, altitude);
      power_.push_back({thrust.military, thrust.afterburner});
    }
  }
}

Thrust PointMass::thrust_at(const TableCell& mach, double altitude) const {
  const TableCell cell = altitude_.cell(altitude);
  const std::size_t right = altitude_.size() > 1 ? 1 : 0;
  const std::size_t down = mach_.size() > 1 ? altitude_.size() : 0;
  const Power* at = power_.data() + mach.index * altitude_.size() + cell.index;
  const auto blend = [&](double Power::*of) {
    const double slower = at[0].*of + cell.fraction * (at[right].*of - at[0].*of);
    const double faster = at[down].*of + cell.fraction * (at[down + right].*of - at[down].*of);
    return slower + mach.fraction * (faster - slower);
  };
  const double military = blend(&Power::military);
  return {.idle = airframe_.engine.idle_share * military,
          .military = military,
          .afterburner = blend(&Power::afterburner)};
}

FlightCondition PointMass::condition(const Kinematics& k, const Air& air, double fuel,
                                     const Load& load) const {
  const double speed = std::max(k.speed, kLeastSpeed);
  FlightCondition c;
  c.mass = airframe_.empty_mass + fuel + load.mass;
  c.mach = speed / air.speed_of_sound;
  c.temperature = air.temperature;
  c.speed_of_sound = air.speed_of_sound;
  c.density_root = std::sqrt(air.density * (1 / kSeaLevelDensity));

  const TableCell cell = mach_.cell(c.mach);
  const ByMach& below = by_mach_[cell.index];
  const ByMach& above = by_mach_[std::min(cell.index + 1, by_mach_.size() - 1)];
  const auto blend = [&](double ByMach::*of) {
    return below.*of + cell.fraction * (above.*of - below.*of);
  };
  const double pressure = 0.5 * air.density * speed * speed;
  const double lift = pressure * airframe_.aerodynamics.wing_area;  // per lift coefficient
  const double weight = c.mass * kGravity;
  c.zero_lift_drag = lift * blend(&ByMach::zero_lift_drag) + pressure * load.drag_area;
  c.induced_drag = blend(&ByMach::induced_drag) * weight * weight / lift;
  c.separation = airframe_.aerodynamics.separation_lift * lift / weight;
  c.separation_drag = airframe_.aerodynamics.separation_drag * weight * weight / lift;
  c.lift_limit = blend(&ByMach::max_lift) * lift / weight;
  c.thrust = fuel > 0 ? thrust_at(cell, k.altitude) : Thrust{};
  return c;
}

Energy PointMass::energy(const FlightCondition& c, double speed) const {
  const double most = airframe_.limits.max_load_factor;
  const double excess = c.thrust.afterburner - c.zero_lift_drag;
  // n at which the drag is the thrust: below the separation D = D0 + D1 n2, beyond it
  // D0 + D1 n2 + D2 (n - ns)2
  double sustained = std::sqrt(std::max(excess, 0.0) / c.induced_drag);
  if (sustained > c.separation) {
    const double a = c.induced_drag + c.separation_drag, b = c.separation_drag * c.separation;
    sustained = (b + std::sqrt(std::max(b * b - a * (b * c.separation - excess), 0.0))) / a;
  }
  const auto lift_at = [&](double mach) {
    const TableCell cell = mach_.cell(mach);
    const double low = by_mach_[cell.index].max_lift;
    return low +
           cell.fraction * (by_mach_[std::min(cell.index + 1, by_mach_.size() - 1)].max_lift - low);
  };
  // V2 C_L(M) is proportional to the lift limit: a few rounds of a fixed point are within 1 %
  const double here = speed * speed * lift_at(c.mach) / c.lift_limit;
  double corner = speed * std::sqrt(most / c.lift_limit);
  for (int round = 0; round < 3; ++round)
    corner = std::sqrt(most * here / lift_at(corner / c.speed_of_sound));
  const double available = std::min(most, c.lift_limit);
  return {.available = static_cast<float>(available),
          .sustained = static_cast<float>(std::min(sustained, available)),
          .corner_speed = static_cast<float>(corner),
          .excess_power =
              static_cast<float>((c.thrust.afterburner - c.drag(1)) * speed / (c.mass * kGravity))};
}

void PointMass::step(Kinematics& k, Propulsion& engines, const FlightCondition& condition,
                     const Controls& controls, const Vec3& wind_ned, double dt) const {
  const FlightLimits& limits = airframe_.limits;

  // load factor: what structure and wing allow of what is asked
  const double most = std::min(limits.max_load_factor, condition.lift_limit);
  const double least = std::max(limits.min_load_factor, -condition.lift_limit);
  const double wanted = towards(k.load_factor, controls.load_factor, limits.load_factor_rate * dt);
  k.load_factor = std::clamp(wanted, least, most);
  k.roll = wrap_pi(k.roll + std::clamp(angle_between(k.roll, controls.bank), -limits.roll_rate * dt,
                                       limits.roll_rate * dt));

  // thrust and fuel flow; without fuel both are zero
  if (engines.fuel > 0) {
    engines.throttle = airframe_.engine.spool(engines.throttle, controls.throttle, dt);
    engines.thrust = Engine::thrust_of(condition.thrust, engines.throttle);
    engines.flow = airframe_.engine.flow_of(condition.thrust, engines.throttle, condition.mach,
                                            condition.temperature);
  } else {
    engines.throttle = engines.thrust = engines.flow = 0;
  }
  const double along = (engines.thrust - condition.drag(k.load_factor)) / condition.mass;  // m/s2

  // half a step to find the climb angle in its middle
  const auto [roll, climb] = math::sin_cos(k.roll, k.pitch);
  const double upward = kGravity * k.load_factor * roll.cos;  // m/s2, across the path
  const double sideward = kGravity * k.load_factor * roll.sin;
  const double speed = std::max(k.speed, kLeastSpeed);
  const double start_rate = (upward - kGravity * climb.cos) / speed;
  const auto climb_middle = turned(climb, 0.5 * dt * start_rate);

  // the whole step with the rates of its middle
  const double new_speed =
      std::max(speed + dt * (along - kGravity * climb_middle.sin), kLeastSpeed);
  const double speed_middle = 0.5 * (speed + new_speed);
  const double climb_turn = dt * (upward - kGravity * climb_middle.cos) / speed_middle;
  const double heading_turn = dt * sideward / (speed_middle * away_from_zero(climb_middle.cos));
  const auto [heading_middle, heading] =
      math::sin_cos(k.heading + 0.5 * heading_turn, k.heading + heading_turn);
  const auto climb_end = turned(climb, climb_turn);

  const auto ground_velocity = [&](double v, const math::SinCos& c, const math::SinCos& h) {
    return (v * c.cos * h.cos + wind_ned.x) * k.north + (v * c.cos * h.sin + wind_ned.y) * k.east +
           (-v * c.sin) * k.down;
  };
  k.position += dt * ground_velocity(speed_middle, climb_middle, heading_middle);
  k.velocity = ground_velocity(new_speed, climb_end, heading);
  k.speed = new_speed;
  k.mach = new_speed / condition.speed_of_sound;
  k.pitch += climb_turn;
  k.heading = wrap_pi(k.heading + heading_turn);

  // over the top of a loop: the same direction, said the other way round
  if (std::fabs(k.pitch) > kPi / 2) {
    k.pitch = std::copysign(kPi, k.pitch) - k.pitch;
    k.heading = wrap_pi(k.heading + kPi);
    k.roll = wrap_pi(k.roll + kPi);
  }
}

}  // namespace eyrie::model::flight
