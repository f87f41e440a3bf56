// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where to fly: routes, circles, a place beside a lead.
#include "core/describe.hpp"
#include "model/flight/flying.hpp"
#include "model/kinematics.hpp"

namespace eyrie::model::flight {

/// What to do after the last waypoint.
enum class RouteEnd : std::uint8_t {
  loiter,    ///< circle around it
  straight,  ///< keep flying as the last leg went
  repeat,    ///< start again with the first
  stop,      ///< stand there; for who is on the ground
};
constexpr auto names_of(RouteEnd) {
  return names_from_zero<RouteEnd>("loiter", "straight", "repeat", "stop");
}

/// A place to fly over. Positions are in the scenario's local frame.
struct Waypoint {
  Vec3 position;                     ///< m; only its place on the ground counts
  double altitude = 0;               ///< m above the ellipsoid, flown on the leg towards it
  std::optional<double> speed = {};  ///< m/s true airspeed on that leg; none: as the command says
};

/// Waypoints in order. The first leg leads from wherever the aircraft is to the first one.
struct Route {
  std::string name;
  std::vector<Waypoint> waypoints;
  RouteEnd end = RouteEnd::loiter;
};

/// What the inner loops of the autopilot fly.
struct Guidance {
  double heading = 0;                ///< rad, true, through the air: wind is allowed for
  double altitude = 0;               ///< m
  double speed = 0;                  ///< m/s true airspeed
  double turn_rate = 0;              ///< rad/s that the wanted heading itself turns by
  std::optional<double> climb = {};  ///< rad: fly this direction, and no altitude
};

/// Gains of guidance. Const and shared.
struct GuidanceGains {
  double follow_forward = 0.05;            ///< Hz
  double follow_across = 0.05;             ///< Hz
  double follow_min_speed = 150;           ///< m/s
  double follow_max_speed = 350;           ///< m/s
  double lead_heading_time = 2;            ///< s
  double lookahead_time = 15;              ///< s
  double capture_radius = si(0.5, "nmi");  ///< m
  double loiter_convergence = 2;
  double loiter_radius = si(3, "nmi");  ///< m
  /// m/s, follow: never asks for less along the leader's course; who is on the ground waits for its
  /// place instead of turning back to it. No parameter: aircraft turn back.
  double follow_least_along = -math::kInfinity;

  static constexpr std::string_view type_name = "guidance";
  static constexpr std::string_view help = "gains of route, follow and loiter guidance";
  static constexpr auto params() {
    using G = GuidanceGains;
    return Lines{
        param("follow_forward", &G::follow_forward, "Hz", range(0.001, 1),
              "follow: closing speed per distance behind the place in formation"),
        param("follow_across", &G::follow_across, "Hz", range(0.001, 1),
              "follow: closing speed per distance beside the place in formation"),
        param("follow_min_speed", &G::follow_min_speed, "m/s", range(1, 1000), "follow: no slower"),
        param("follow_max_speed", &G::follow_max_speed, "m/s", range(1, 2000), "follow: no faster"),
        param("lead_heading_time", &G::lead_heading_time, "s", range(0, 60),
              "follow: time constant of the lead's low-passed heading"),
        param("lookahead_time", &G::lookahead_time, "s", range(1, 120),
              "route: aims at the leg this far ahead"),
        param("capture_radius", &G::capture_radius, "m", range(10, 100e3),
              "route: a waypoint this near counts as reached"),
        param("loiter_convergence", &G::loiter_convergence, range(0.1, 20),
              "loiter: how steeply to close in on the circle"),
        param("loiter_radius", &G::loiter_radius, "m", range(100, 200e3),
              "loiter: radius where the command gives none")};
  }
};

/// Whom to follow, and where.
struct FollowOrder {
  Vec3 position = {};       ///< m, local frame: where the lead is now
  Vec3 velocity = {};       ///< m/s, over the ground
  double lead_heading = 0;  ///< rad: frame of `offset`, low-passed
  Vec3 offset = {};         ///< m, forward and right of the lead (its `z` is not used)
  double altitude = 0;      ///< m, to hold
};

/// The velocity over the ground (V + kf dx, ka dy) in the frame of the lead's heading, where dx, dy
/// lead from here to the place in formation; its size within the speed limits.
[[nodiscard]] Guidance follow_guidance(const GuidanceGains& gains, const Kinematics& own,
                                       const FollowOrder& order, const Vec3& wind_ned = {});

/// A heading that follows `raw` with a time constant (s), the short way round.
[[nodiscard]] double low_pass_heading(double smooth, double raw, double dt, double time_constant);

/// A circle around a center (local frame, m), clockwise seen from above; `radius` (m), or the usual
/// one if it is 0. Joins it along a field of
/// headings: tangent + atan(convergence * (distance - radius) / radius). Nelson, Barber, McLain &
/// Beard, Vector field path following for small unmanned air vehicles, IEEE TCST 15 (2007).
[[nodiscard]] Guidance loiter_guidance(const GuidanceGains& gains, const Kinematics& own,
                                       const Vec3& center, double radius, double altitude,
                                       double speed, const Vec3& wind_ned = {});

/// Along the leg that `nav` is on. `speed` (m/s) is flown where the waypoint has none, and
/// `loiter_radius` (m) around the last one if the route ends with a circle. Without waypoints:
/// straight on.
[[nodiscard]] Guidance route_guidance(const GuidanceGains& gains, const Kinematics& own,
                                      const Route& route, const NavState& nav, double speed,
                                      double loiter_radius, const Vec3& wind_ned = {});

/// The leg to fly after this moment: past a waypoint that is within the capture radius, or nearer
/// than the place where a turn of `turn_radius` (m) onto the next leg has to begin, or passed abeam
/// within ten capture radii.
[[nodiscard]] NavState advance_leg(const GuidanceGains& gains, const Kinematics& own,
                                   const Route& route, NavState nav, double turn_radius);

/// The heading at which a true airspeed makes good a course over the ground.
[[nodiscard]] double crab(double course, double speed, const Vec3& wind_ned);

}  // namespace eyrie::model::flight
