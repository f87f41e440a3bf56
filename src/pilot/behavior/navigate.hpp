// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "team/navigate.hpp"

namespace eyrie::pilot {

/// Flies a route of the flight (team/navigate.hpp) by the autopilot's mode. Attacks nobody.
class Navigate final : public team::Navigate<Platform> {
 public:
  static constexpr std::string_view help = "flies along the waypoints of the flight's route";
  static constexpr auto params() {
    return std::tuple_cat(team::Navigate<Platform>::params(),
                          std::tuple{param("load_factor", &Navigate::load_factor_, range(1, 12),
                                           "g, the most it turns with")});
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double load_factor_ = 3;
};

}  // namespace eyrie::pilot
