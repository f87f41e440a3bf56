// SPDX-License-Identifier: MIT
#pragma once
#include <tuple>

#include "core/angle.hpp"
#include "core/describe.hpp"
#include "team/member.hpp"
#include "ubf/behavior.hpp"

namespace eyrie::team {

/// Goes along a route of the flight: `running` on the way, `success` once the last waypoint is
/// behind (it goes on recommending how the route ends). Fails if the flight has no such route.
/// Every member knows the routes, so that whoever takes the lead can go on (Roberson et al.,
/// III.C.3.a); a wingman does this as a last resort, since follow_lead outvotes it.
///
/// `Platform` has State, Action, a usual `cruise` (m/s), the range of `speeds` and what speed is.
template <class Platform>
requires MemberState<typename Platform::State>
class Navigate : public ubf::Behavior<typename Platform::State, typename Platform::Action> {
 public:
  static constexpr std::string_view type_name = "navigate";
  static constexpr auto params() {
    return std::tuple{
        param("vote", &Navigate::vote_, range(0, 1000), "how strongly"),
        param("route", &Navigate::route_, range(0, 255), "which route of the flight, the first: 0"),
        param("speed", &Navigate::speed_, "m/s", Platform::speeds, Platform::speed_help)};
  }

 protected:
  /// Where to go, and how far that has come.
  struct Way {
    ubf::Status status = ubf::Status::failure;
    model::flight::Guidance wanted = {};
  };

  /// Recommends heading and speed, unless the way has failed.
  Way go(const ubf::Tick<typename Platform::State>& t,
         ubf::Proposal<typename Platform::Action>& out) const {
    const auto& s = t.state;
    const std::span<const model::Route> routes = s.routes();
    if (route_ >= routes.size() || routes[route_].waypoints.empty())
      return {this->fails(t, "there is no such route")};
    const model::Route& route = routes[route_];
    model::NavState nav = s.nav();
    if (nav.route != route_)
      nav = {.leg = 0, .route = route_};

    const model::flight::GuidanceGains& gains = s.guidance();
    const model::flight::Guidance wanted = model::flight::route_guidance(
        gains, s.own, route, nav, speed_, gains.loiter_radius, s.wind());
    out.action.heading = wrap_tau(wanted.heading);
    out.action.speed = wanted.speed;
    out.vote = vote_;
    const bool done = nav.leg >= route.waypoints.size();
    return {done ? ubf::Status::success : ubf::Status::running, wanted};
  }

  float vote_ = 10;
  std::uint8_t route_ = 0;
  double speed_ = Platform::cruise;
};

}  // namespace eyrie::team
