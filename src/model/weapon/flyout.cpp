// SPDX-License-Identifier: MIT
#include "model/weapon/flyout.hpp"

namespace eyrie::model::weapon {

namespace {

constexpr double kTurnCosine = 0.70710678118654752;  // of 45 degrees
constexpr double kTurnRate = 2;                      // rad/s per unit of cosine beyond that

}  // namespace

Vec3 steer(const MissileGuidance& guidance, const LineOfSight& los, const Vec3& velocity,
           const Vec3& down) {
  const double speed = norm(velocity);
  const double closing = std::max(los.closing, speed / 2);
  Vec3 wanted = proportional_navigation(guidance.navigation_gain, closing, los) - kGravity * down;

  // over the shoulder: proportional navigation alone would leave the turn for later
  const double ahead = dot(velocity, los.direction);
  if (ahead < kTurnCosine * speed) {
    const Vec3 across = perpendicular(los.direction, velocity / std::max(speed, 1.0));
    const double excess = kTurnCosine * speed - ahead;
    wanted += (kTurnRate * excess) * normalized(across, Vec3{});
  }
  return wanted;
}

Vec3 lofted(const Loft& loft, const Vec3& relative_position, const Vec3& down, double altitude) {
  const double beyond = norm(relative_position) - loft.end_range;
  if (beyond <= 0)
    return relative_position;
  const double target_altitude = altitude - dot(down, relative_position);
  const double room = std::max(loft.ceiling - target_altitude, 0.0);
  return relative_position - std::min(beyond * math::tan(loft.angle), room) * down;
}

namespace {

/// 1 - exp(-x) for x >= 0 by its (1,2) Pade form: within 3e-5 below 0.4, never beyond 1. How much
/// of the way to its input a first-order lag goes in one step.
double lag_share(double x) {
  x = std::min(x, 1e6);  // whose square is a number
  return (x + x * x / 6) / (1 + x * (2.0 / 3) + x * x / 6);
}

}  // namespace

double autopilot_lag(const MissileGuidance& guidance, const Air& air, double speed) {
  if (!guidance.lag_speed)
    return guidance.autopilot_lag;
  const double equivalent = speed * std::sqrt(air.density / kSeaLevelDensity);
  return guidance.autopilot_lag * std::max(*guidance.lag_speed / std::max(equivalent, 1.0), 1.0);
}

FlyoutForces flyout_forces(const MissileType& type, const Air& air, double speed, double age) {
  const Motor& motor = type.motor;
  const MissileAero& aero = type.aero;
  const bool burning = age < motor.burn_time();
  const double mass = motor.mass(age);
  const double mach = speed / air.speed_of_sound;
  const double pressure_force = 0.5 * air.density * speed * speed * aero.reference_area;

  // thrust in thinner air: Sutton & Biblarz, Rocket Propulsion Elements, 9th ed., eq. 2-13
  const double thrust =
      burning ? motor.thrust(age) + (kSeaLevelPressure - air.pressure) * motor.nozzle_area : 0;
  const double drag =
      pressure_force * (burning ? aero.drag_power_on(mach) : aero.drag_power_off(mach));
  const double lift = pressure_force * aero.greatest_lift(mach) / mass;
  return {.along = (thrust - drag) / mass,
          .lift_limit = std::min(lift, aero.greatest_load_factor * kGravity),
          // k C_L^2 q S / m with C_L = m a / (q S)
          .induced = pressure_force > 0 ? aero.induced_drag(mach) * mass / pressure_force : 0};
}

void fly(const MissileType& type, const Air& air, const Vec3& wind, const Vec3& down, double age,
         double dt, const Vec3& wanted, Flyout& state) {
  const Vec3 through_air = state.velocity - wind;
  const double speed = norm(through_air);
  if (!(speed > 1e-3))
    return;
  const Vec3 ahead = through_air / speed;
  const FlyoutForces forces = flyout_forces(type, air, speed, age + dt / 2);

  // autopilot: first-order lag towards what the airframe can give
  const Vec3 possible = limited(perpendicular(wanted, ahead), forces.lift_limit);
  const Vec3 before = perpendicular(state.lift, ahead);
  const double share = lag_share(dt / autopilot_lag(type.guidance, air, speed));
  state.lift = limited(before + share * (possible - before), forces.lift_limit);

  // along the path: thrust, drag, weight; across it: lift and weight turn it
  const double along =
      forces.along - forces.induced * norm2(state.lift) + kGravity * dot(down, ahead);
  const Vec3 across = state.lift + kGravity * perpendicular(down, ahead);
  const Vec3 turned = ahead + across * (dt / speed);
  const double new_speed = std::max(speed + along * dt, 1.0);
  const Vec3 velocity = wind + turned * (new_speed / norm(turned));
  state.position += (dt / 2) * (state.velocity + velocity);
  state.velocity = velocity;
}

}  // namespace eyrie::model::weapon
