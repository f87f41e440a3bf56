// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Goes home and ends the flight there. On the way: along a route of the flight if `route` names
/// one and it is not yet flown, else directly; at `altitude`, and from where `descent` leads down
/// to the landing altitude over home, along that slope. Within `arrival` of home it circles down,
/// and asks to land once it is there and low: that tick answers `success`. Fails without a home.
/// Attacks nobody.
class Egress final : public Behavior {
 public:
  static constexpr std::string_view type_name = "egress";
  static constexpr std::string_view help = "goes home, comes down and lands";
  static constexpr auto params() {
    return std::tuple{
        param("vote", &Egress::vote_, range(0, 1000), "how strongly"),
        param("route", &Egress::route_, range(0, 255),
              "which route of the flight leads home, the first: 0; null, or a route that the "
              "flight does not have: goes directly"),
        param("speed", &Egress::speed_, "m/s", range(50, 1000), "true airspeed to fly"),
        param("altitude", &Egress::altitude_, "m", range(0, 25e3), "altitude of the way home"),
        param("descent", &Egress::descent_, "rad", range(0.005, 0.7),
              "slope of the way down, below the horizontal"),
        param("landing_altitude", &Egress::landing_altitude_, "m", range(0, 10e3),
              "altitude over home at which it is low enough to land"),
        param("arrival", &Egress::arrival_, "m", range(100, 100e3),
              "distance from home that counts as home"),
        param("load_factor", &Egress::load_factor_, range(1, 12), "g, the most it turns with")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 30;
  std::optional<std::uint8_t> route_;
  double speed_ = si(480, "kt");
  double altitude_ = si(25000, "ft");
  double descent_ = si(3, "deg");
  double landing_altitude_ = si(5000, "ft");
  double arrival_ = si(5, "nmi");
  double load_factor_ = 3;
};

}  // namespace eyrie::pilot
