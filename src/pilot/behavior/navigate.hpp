// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Flies the route of the flight. Fails if the flight has none. Every member knows the route, so
/// that whoever takes the lead can go on (Roberson et al., III.C.3.b).
class Navigate final : public Behavior {
 public:
  static constexpr std::string_view type_name = "navigate";
  static constexpr std::string_view help = "flies along the waypoints of the flight's route";
  static constexpr auto params() {
    return std::tuple{param("vote", &Navigate::vote_, range(0, 1000), "how strongly"),
                      param("speed", &Navigate::speed_, "m/s", range(50, 1000),
                            "true airspeed on legs that give none")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 10;
  double speed_ = si(480, "kt");
};

}  // namespace eyrie::pilot
