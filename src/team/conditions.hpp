// SPDX-License-Identifier: MIT
#pragma once
/// \file  Conditions about the own place in the flight and on the way.
#include <tuple>

#include "core/describe.hpp"
#include "team/member.hpp"
#include "ubf/behavior.hpp"

namespace eyrie::team {

template <class Platform>
requires MemberState<typename Platform::State>
class IsLead final : public ubf::Condition<typename Platform::State, typename Platform::Action> {
 public:
  static constexpr std::string_view type_name = "is_lead";
  static constexpr std::string_view help = "the own rank among the living is the first";
  [[nodiscard]] bool holds(const ubf::Tick<typename Platform::State>& t) const override {
    return t.state.leads();
  }
};

template <class Platform>
requires MemberState<typename Platform::State>
class RouteDone final : public ubf::Condition<typename Platform::State, typename Platform::Action> {
 public:
  static constexpr std::string_view type_name = "route_done";
  static constexpr std::string_view help = "the last waypoint of a route is behind";
  static constexpr auto params() {
    return std::tuple{
        param("route", &RouteDone::route_, range(0, 255), "which route of the flight")};
  }
  [[nodiscard]] bool holds(const ubf::Tick<typename Platform::State>& t) const override {
    const std::span<const model::Route> routes = t.state.routes();
    const model::NavState nav = t.state.nav();
    return route_ < routes.size() && nav.route == route_ &&
           nav.leg >= routes[route_].waypoints.size();
  }

 private:
  std::uint8_t route_ = 0;
};

}  // namespace eyrie::team
