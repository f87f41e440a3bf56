// SPDX-License-Identifier: MIT
#include "model/vehicle/vehicle.hpp"

#include <algorithm>

namespace eyrie::model::vehicle {
namespace {

/// m/s; slower, the wheels are turned as if for this.
constexpr double kCreep = 1;

/// m/s; nobody drives slower, it is asked to stand.
constexpr double kSlowest = 0.1;

/// Level, on the surface, with the velocity along the heading.
void put_down(Kinematics& k, const Reference& reference) {
  carry_to(k, reference.vertical_at(k.position));
  k.position = k.position + k.altitude * k.down;
  k.altitude = 0;
  const auto [sine, cosine] = math::sin_cos(k.heading);
  k.velocity = k.speed * cosine * k.north + k.speed * sine * k.east;
}

double towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

}  // namespace

double VehicleType::turn_radius() const {
  return wheelbase / math::tan(steering_angle);
}

void VehicleType::prepare() {
  guidance = {.follow_forward = gap_gain,
              .follow_across = gap_gain,
              .follow_min_speed = 0,
              .follow_max_speed = top_speed,
              .lookahead_time = lookahead_time,
              .capture_radius = capture_radius,
              .follow_least_along = 0};
}

Kinematics parked(const Reference& reference, const Vec3& position, double heading, double speed) {
  Kinematics k;
  k.position = position;
  k.heading = wrap_pi(heading);
  k.speed = speed;
  put_down(k, reference);
  return k;
}

void drive(const VehicleType& type, const Reference& reference,
           std::span<const flight::Route> routes, const DriveCommand& command, double dt,
           Kinematics& k, Driving& driving) {
  const double turn_rate = angle_between(k.heading, command.heading) / type.heading_time;
  const double wanted = math::atan(type.wheelbase * turn_rate / std::max(k.speed, kCreep));
  // sideways acceleration: speed^2 tan(steering) / wheelbase
  const double safe =
      std::min(type.steering_angle, math::atan(type.side_acceleration * type.wheelbase /
                                               std::max(k.speed * k.speed, kCreep * kCreep)));
  driving.steering =
      std::clamp(towards(driving.steering, wanted, type.steering_rate * dt), -safe, safe);

  // brakes for the turn that is wanted, not only for the one begun
  const double bend = math::tan(std::min(std::fabs(wanted), type.steering_angle)) / type.wheelbase;
  const double in_turn = std::sqrt(type.side_acceleration / std::max(bend, 1e-6));
  const double asked =
      command.speed < kSlowest ? 0 : std::min({command.speed, type.top_speed, in_turn});
  k.speed = asked > k.speed ? std::min(asked, k.speed + type.acceleration * dt)
                            : std::max(asked, k.speed - type.braking * dt);

  const double turned = k.speed * math::tan(driving.steering) / type.wheelbase * dt;
  const auto [sine, cosine] = math::sin_cos(k.heading + turned / 2);
  k.position = k.position + k.speed * dt * (cosine * k.north + sine * k.east);
  k.heading = wrap_pi(k.heading + turned);
  put_down(k, reference);

  if (driving.nav.route < routes.size())
    driving.nav = flight::advance_leg(type.guidance, k, routes[driving.nav.route], driving.nav,
                                      std::max(type.turn_radius(), k.speed * type.heading_time));
}

}  // namespace eyrie::model::vehicle
