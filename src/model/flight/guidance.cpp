// SPDX-License-Identifier: MIT
#include "model/flight/guidance.hpp"

#include <algorithm>

namespace eyrie::model::flight {
namespace {

/// A horizontal vector in the geodetic axes of the aircraft.
struct Flat {
  double north = 0, east = 0;

  friend Flat operator+(Flat a, Flat b) { return {a.north + b.north, a.east + b.east}; }
  friend Flat operator*(double s, Flat a) { return {s * a.north, s * a.east}; }
  [[nodiscard]] double size() const { return std::sqrt(north * north + east * east); }
  [[nodiscard]] Flat right() const { return {-east, north}; }
};

double dot(Flat a, Flat b) {
  return a.north * b.north + a.east * b.east;
}

Flat flat(const Kinematics& own, const Vec3& local) {
  return {dot(own.north, local), dot(own.east, local)};
}

double bearing(Flat v) {
  return math::atan2(v.east, v.north);
}

Flat unit(Flat v) {
  const double size = v.size();
  return size > 0 ? (1 / size) * v : Flat{1, 0};
}

/// Direction of the leg that ends at waypoint `leg`, as seen from here.
Flat leg_direction(const Kinematics& own, const Route& route, std::size_t leg) {
  const Vec3& to = route.waypoints[leg].position;
  const Vec3& from = leg == 0 ? own.position : route.waypoints[leg - 1].position;
  return unit(flat(own, to - from));
}

/// Whether waypoint `leg`, so far away, is behind who flies to it, or near enough to turn onwards.
bool reached(const GuidanceGains& gains, const Kinematics& own, const Route& route, std::size_t leg,
             Flat to_target, double turn_radius) {
  const double distance = to_target.size();
  const double wide = 10 * gains.capture_radius, near = wide + 3 * turn_radius;
  if (distance < gains.capture_radius || !(distance < near))
    return distance < gains.capture_radius;
  const Flat along = leg > 0 ? leg_direction(own, route, leg) : unit(to_target);
  const double to_go = dot(to_target, along), beside = dot(to_target, along.right());

  // abeam; on the first leg, which has no direction, behind the wings
  const double passed = leg > 0 ? to_go : dot(to_target, flat(own, own.velocity));
  if (passed <= 0 && distance < wide)
    return true;

  // where the turn onto the next leg begins: radius * tan(half the turn), at most 3 radii
  const std::size_t count = route.waypoints.size(), next = leg + 1 < count ? leg + 1 : 0;
  const bool is_near = to_go < 3 * turn_radius && std::fabs(beside) < wide;
  if (!is_near || (next == 0 && route.end != RouteEnd::repeat) || count == 1)
    return false;
  const Flat onward =
      unit(flat(own, route.waypoints[next].position - route.waypoints[leg].position));
  const double cosine = std::clamp(dot(along, onward), -1.0, 1.0);
  const double half = std::sqrt((1 - cosine) / std::max(1 + cosine, 1e-9));
  return to_go < turn_radius * std::min(half, 3.0);
}

[[gnu::noinline]] NavState next_leg(const GuidanceGains& gains, const Kinematics& own,
                                    const Route& route, NavState nav, Flat to_target,
                                    double turn_radius) {
  if (!reached(gains, own, route, nav.leg, to_target, turn_radius))
    return nav;
  ++nav.leg;
  if (nav.leg == route.waypoints.size() && route.end == RouteEnd::repeat)
    nav.leg = 0;
  return nav;
}

}  // namespace

double crab(double course, double speed, const Vec3& wind_ned) {
  if (wind_ned.x == 0 && wind_ned.y == 0)
    return wrap_pi(course);
  const auto [sine, cosine] = math::sin_cos(course);
  const double from_left = wind_ned.y * cosine - wind_ned.x * sine;
  return wrap_pi(course - math::asin(std::clamp(from_left / speed, -1.0, 1.0)));
}

double low_pass_heading(double smooth, double raw, double dt, double time_constant) {
  return wrap_pi(smooth + angle_between(smooth, raw) * dt / (time_constant + dt));
}

Guidance follow_guidance(const GuidanceGains& gains, const Kinematics& own,
                         const FollowOrder& order, const Vec3& wind_ned) {
  const auto [sine, cosine] = math::sin_cos(order.lead_heading);
  const Flat forward{cosine, sine};
  const Flat to_place = flat(own, order.position - own.position) + order.offset.x * forward +
                        order.offset.y * forward.right();
  const double along =
      std::max(flat(own, order.velocity).size() + gains.follow_forward * dot(to_place, forward),
               gains.follow_least_along);
  const double across = gains.follow_across * dot(to_place, forward.right());
  const Flat ground = along * forward + across * forward.right();

  const Flat air{ground.north - wind_ned.x, ground.east - wind_ned.y};
  return {.heading = air.size() > 0 ? bearing(air) : own.heading,
          .altitude = order.altitude,
          .speed = std::clamp(air.size(), gains.follow_min_speed, gains.follow_max_speed)};
}

Guidance loiter_guidance(const GuidanceGains& gains, const Kinematics& own, const Vec3& center,
                         double radius, double altitude, double speed, const Vec3& wind_ned) {
  if (radius <= 0)
    radius = gains.loiter_radius;
  const Flat outward = flat(own, own.position - center);
  const double distance = std::max(outward.size(), 1.0);
  const Flat radial = (1 / distance) * outward;

  // tangent, turned towards the circle by the arc tangent of `slope`
  const double slope = gains.loiter_convergence * (distance - radius) / radius;
  const double course = bearing(radial.right() + -slope * radial);

  // time derivative of that course for somebody who flies it
  const double cosine = 1 / std::sqrt(1 + slope * slope);
  const double turn_rate =
      speed * cosine * (1 / distance - gains.loiter_convergence / radius * slope * cosine * cosine);
  return {.heading = crab(course, speed, wind_ned),
          .altitude = altitude,
          .speed = speed,
          .turn_rate = turn_rate};
}

Guidance route_guidance(const GuidanceGains& gains, const Kinematics& own, const Route& route,
                        const NavState& nav, double speed, double loiter_radius,
                        const Vec3& wind_ned) {
  const std::size_t count = route.waypoints.size();
  if (count == 0)
    return {.heading = own.heading, .altitude = own.altitude, .speed = speed};

  const std::size_t leg = std::min<std::size_t>(nav.leg, count - 1);
  const Waypoint& target = route.waypoints[leg];
  speed = target.speed.value_or(speed);

  // past the last waypoint
  if (nav.leg >= count && route.end == RouteEnd::loiter)
    return loiter_guidance(gains, own, target.position, loiter_radius, target.altitude, speed,
                           wind_ned);
  if (nav.leg >= count && route.end == RouteEnd::stop)
    return {.heading = own.heading, .altitude = target.altitude, .speed = 0};
  if (nav.leg >= count)
    return {.heading = count > 1 ? crab(bearing(leg_direction(own, route, leg)), speed, wind_ned)
                                 : own.heading,
            .altitude = target.altitude,
            .speed = speed};

  // to a point of the leg some way ahead; without a leg, or behind its end, to the waypoint itself
  const Flat to_target = flat(own, target.position - own.position);
  Flat aim = to_target;
  const Flat along = leg > 0 ? leg_direction(own, route, leg) : Flat{};
  if (dot(to_target, along) > 0) {
    aim = speed * gains.lookahead_time * along + dot(to_target, along.right()) * along.right();
  }
  return {
      .heading = crab(bearing(aim), speed, wind_ned), .altitude = target.altitude, .speed = speed};
}

NavState advance_leg(const GuidanceGains& gains, const Kinematics& own, const Route& route,
                     NavState nav, double turn_radius) {
  if (nav.leg >= route.waypoints.size())
    return nav;
  // too far away, as nearly always: without a root
  const Flat to_target = flat(own, route.waypoints[nav.leg].position - own.position);
  const double wide = 10 * gains.capture_radius, turns = 3 * turn_radius;
  const double far = nav.leg > 0 ? wide + turns : std::max(wide, turns);
  if (dot(to_target, to_target) > 1.001 * far * far)
    return nav;
  return next_leg(gains, own, route, nav, to_target, turn_radius);
}

}  // namespace eyrie::model::flight
