// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Recommends the release of a missile at the chosen target once it is inside the employment zone
/// of a missile on board. Never at a track that is not identified as hostile. One shooter per
/// target first: while a mate has a missile on its way, or a better-ranked mate has the same target
/// and has not shot yet, it holds fire outside the no-escape range. Fails when there is nothing to
/// shoot.
class ReleaseWeapon final : public Behavior {
 public:
  static constexpr std::string_view type_name = "release_weapon";
  static constexpr std::string_view help = "releases a missile inside its employment zone";
  static constexpr auto params() {
    return std::tuple{
        param("vote", &ReleaseWeapon::vote_, range(0, 1000), "how strongly"),
        param("zone", &ReleaseWeapon::zone_, range(0, 1),
              "0: shoots inside the no-escape range; 1: as soon as the missile can reach a target "
              "that keeps its course"),
        param("off_boresight", &ReleaseWeapon::off_boresight_, "rad", range(0, 3.2),
              "largest angle between nose and target"),
        param("salvo", &ReleaseWeapon::salvo_, range(1, 4),
              "missiles on their way to one target at a time"),
        param("max_age", &ReleaseWeapon::max_age_, "s", range(0, 60),
              "a track that nobody has updated for longer is not shot at")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  [[nodiscard]] bool hold_fire(const State& s, const Seen& target) const;
  /// The largest range at which that store is released at the target; 0: not at all.
  [[nodiscard]] bool in_zone(const State& s, const Seen& target, std::uint16_t store) const;

  float vote_ = 60;
  double zone_ = 0.4;
  double off_boresight_ = si(40, "deg");
  std::uint8_t salvo_ = 1;
  double max_age_ = 6;
};

}  // namespace eyrie::pilot
