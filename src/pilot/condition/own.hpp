// SPDX-License-Identifier: MIT
#pragma once
/// \file  Conditions about the own side: fuel, weapons, losses, the way home.
#include "model/weapon/stores.hpp"
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "team/conditions.hpp"

namespace eyrie::pilot {

class Bingo final : public Condition {
 public:
  static constexpr std::string_view type_name = "bingo";
  static constexpr std::string_view help = "fuel is down to what the way home needs";
  [[nodiscard]] bool holds(const Tick& t) const override { return t.state.bingo(); }
};

class Winchester final : public Condition {
 public:
  static constexpr std::string_view type_name = "winchester";
  static constexpr std::string_view help = "no missile is left, and no round if the gun counts";
  static constexpr auto params() {
    return std::tuple{param("gun", &Winchester::gun_, "true: with rounds left it does not hold")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    return model::weapon::missiles_left(t.state.stores) == 0 && (!gun_ || t.state.gun.rounds == 0);
  }

 private:
  bool gun_ = false;
};

/// As the datalink tells: a mate that is not heard any more counts as lost.
class Losses final : public Condition {
 public:
  static constexpr std::string_view type_name = "losses";
  static constexpr std::string_view help = "so many of the flight are believed lost";
  static constexpr auto params() {
    return std::tuple{
        param("at_least", &Losses::at_least_, range(1, 8), "members of the own flight")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override { return t.state.lost >= at_least_; }

 private:
  std::uint32_t at_least_ = 2;
};

class NearHome final : public Condition {
 public:
  static constexpr std::string_view type_name = "near_home";
  static constexpr std::string_view help = "home is within a range";
  static constexpr auto params() {
    return std::tuple{param("within", &NearHome::within_, "m", range(0, 1e6), "along the ground")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    const auto distance = t.state.home_distance();
    return distance && *distance <= within_;
  }

 private:
  double within_ = si(10, "nmi");
};

using IsLead = team::IsLead<Platform>;
using RouteDone = team::RouteDone<Platform>;

}  // namespace eyrie::pilot
