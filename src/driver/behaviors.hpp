// SPDX-License-Identifier: MIT
#pragma once
/// \file  What drivers do: as all platforms do (src/team), with nothing added, and of their own.
#include "driver/state.hpp"
#include "team/member.hpp"

namespace eyrie::driver {

/// Drives along a route of the convoy (team/member.hpp).
class Navigate final : public team::Navigate<Platform> {
 public:
  static constexpr std::string_view help = "drives along the waypoints of the convoy's route";
  Status tick(const Tick& t, Proposal& out) const override { return go(t, out).status; }
};

/// Keeps its distance behind the vehicle ahead (team/member.hpp).
class FollowLead final : public team::FollowLead<Platform> {
 public:
  static constexpr std::string_view help = "keeps its distance behind the vehicle ahead";
  Status tick(const Tick& t, Proposal& out) const override {
    return go(t, out) ? Status::running : Status::failure;
  }
};

using IsLead = team::IsLead<Platform>;
using RouteDone = team::RouteDone<Platform>;

struct ScatterMemory {
  double until = 0;    ///< s, when to come back if nothing more is seen; 0: not scattering
  double heading = 0;  ///< rad, away from the way
  Vec3 from = {};      ///< m, where it left the way
};

/// Leaves the way when an aircraft that is no friend comes near: odd ranks to the right and even
/// ones to the left, so that one attack does not meet them all, then stands. `running` until no
/// such aircraft was near for `calm`; fails without one.
class Scatter final : public ubf::WithMemory<Behavior, ScatterMemory> {
 public:
  static constexpr std::string_view type_name = "scatter";
  static constexpr std::string_view help = "leaves the way and stands while aircraft are near";
  static constexpr auto params() {
    using S = Scatter;
    return Lines{
        param("vote", &S::vote_, range(0, 1000), "how strongly"),
        param("range", &S::range_, "m", range(0, 50e3), "an aircraft this near is too near"),
        param("distance", &S::distance_, "m", range(0, 5e3), "how far off the way it drives"),
        param("angle", &S::angle_, "rad", range(5, 179.9, "deg"), "off its course, to drive there"),
        param("speed", &S::speed_, "m/s", range(0.5, 50), "at which it drives there"),
        param("calm", &S::calm_, "s", range(0, 3600),
              "comes back so long after the last aircraft was near")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 70;
  double range_ = si(8, "km");
  double distance_ = 250;
  double angle_ = si(70, "deg");
  double speed_ = si(40, "km/h");
  double calm_ = 60;
};

/// Everything that a driver's tree may be made of: the standard nodes and the above.
[[nodiscard]] Registry make_registry();

}  // namespace eyrie::driver
