// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Flies a route of the flight: `running` on the way, `success` once the last waypoint is behind
/// (it goes on recommending how the route ends). Fails if the flight has no such route. Every
/// member knows the routes, so that whoever takes the lead can go on (Roberson et al., III.C.3.a);
/// a wingman does this as a last resort, since follow_lead outvotes it. Attacks nobody.
class Navigate final : public Behavior {
 public:
  static constexpr std::string_view type_name = "navigate";
  static constexpr std::string_view help = "flies along the waypoints of the flight's route";
  static constexpr auto params() {
    return std::tuple{
        param("vote", &Navigate::vote_, range(0, 1000), "how strongly"),
        param("route", &Navigate::route_, range(0, 255), "which route of the flight, the first: 0"),
        param("speed", &Navigate::speed_, "m/s", range(50, 1000),
              "true airspeed on legs that give none"),
        param("load_factor", &Navigate::load_factor_, range(1, 12), "g, the most it turns with")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 10;
  std::uint8_t route_ = 0;
  double speed_ = si(480, "kt");
  double load_factor_ = 3;
};

}  // namespace eyrie::pilot
