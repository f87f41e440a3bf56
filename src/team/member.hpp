// SPDX-License-Identifier: MIT
#pragma once
/// \file  What it takes to be a member of a flight or a convoy, whatever the platform, and what
/// every member does.
#include "model/columns.hpp"
#include "model/flight/guidance.hpp"
#include "model/kinematics.hpp"
#include "model/library.hpp"
#include "ubf/behavior.hpp"

namespace eyrie::team {

/// Whom a member follows, as it believes.
struct Leader {
  Vec3 position;  ///< m, local frame, now
  Vec3 velocity;  ///< m/s over the ground, local frame
};

/// What a state must offer for the behaviors of this folder.
template <class S>
concept MemberState = requires(const S& s, const Leader& leader) {
  { s.own } -> std::convertible_to<const model::Kinematics&>;
  { s.time } -> std::convertible_to<double>;                      // s
  { s.leads() } -> std::same_as<bool>;                            // nobody to follow
  { s.leader() } -> std::same_as<std::optional<Leader>>;          // whom to follow
  { s.place() } -> std::same_as<Vec3>;                            // m forward, right, down of him
  { s.forward_of(leader) } -> std::same_as<double>;               // rad: where his forward is
  { s.routes() } -> std::same_as<std::span<const model::Route>>;  // of the flight
  { s.nav() } -> std::same_as<model::NavState>;                   // how far along them
  { s.guidance() } -> std::same_as<const model::flight::GuidanceGains&>;  // of the platform
  { s.wind() } -> std::same_as<Vec3>;                                     // m/s, north-east-down
};

/// Where a mate is now, if it has been heard of.
[[nodiscard]] inline std::optional<Leader> heard(const model::Mate& mate, double time) {
  if (!mate.reported)
    return std::nullopt;
  return Leader{position_at(mate, time), velocity_of(mate)};
}

/// The own rank among the living: the next in rank takes over when a lead dies. Before the datalink
/// has come up it is the rank at birth.
[[nodiscard]] inline std::uint32_t rank_now(const model::DatalinkState& datalink,
                                            std::uint32_t rank_at_birth) {
  if (datalink.count == 0)
    return rank_at_birth > 0 ? rank_at_birth : 1;
  return model::datalink::living_rank(datalink);
}

/// Keeps in `known` who is believed to lead. Gives who led before if `self` has just taken over.
[[nodiscard]] inline PlayerId taken_over_from(PlayerId& known, const model::DatalinkState& datalink,
                                              PlayerId self) {
  const model::Mate* lead = model::datalink::lead(datalink);
  if (!lead)
    return {};
  const PlayerId before = known;
  known = lead->id;
  return known == self && before != self ? before : PlayerId{};
}

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
    return Lines{param("route", &RouteDone::route_, range(0, 255), "which route of the flight")};
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

/// Keeps the own place behind or beside whom the state says to follow. The place follows from the
/// rank among the living, so the formation closes up. Fails for who leads, and while nothing has
/// been heard of the leader.
template <class Platform>
requires MemberState<typename Platform::State>
class FollowLead : public ubf::Behavior<typename Platform::State, typename Platform::Action> {
 public:
  static constexpr std::string_view type_name = "follow_lead";
  static constexpr auto params() {
    return Lines{param("vote", &FollowLead::vote_, range(0, 1000), "how strongly")};
  }

 protected:
  struct Slot {
    Leader leader;
    Vec3 offset;  ///< m forward, right, down of the leader
  };

  /// Recommends heading and speed towards the own place; nothing if there is nobody to follow.
  std::optional<Slot> go(const ubf::Tick<typename Platform::State>& t,
                         ubf::Proposal<typename Platform::Action>& out) const {
    const auto& s = t.state;
    const std::optional<Leader> leader = s.leads() ? std::nullopt : s.leader();
    if (!leader) {
      static_cast<void>(this->fails(t, s.leads() ? "leads" : "the leader was not heard of"));
      return std::nullopt;
    }

    const Vec3 offset = s.place();
    const model::flight::Guidance wanted =
        model::flight::follow_guidance(s.guidance(), s.own,
                                       {.position = leader->position,
                                        .velocity = leader->velocity,
                                        .lead_heading = s.forward_of(*leader),
                                        .offset = offset},
                                       s.wind());
    out.action.heading = wrap_tau(wanted.heading);
    out.action.speed = wanted.speed;
    out.vote = vote_;
    return Slot{*leader, offset};
  }

  float vote_ = 20;
};

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
    return Lines{
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
