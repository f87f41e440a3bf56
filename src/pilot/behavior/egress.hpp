// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Goes straight home, comes down on the way and ends the flight there: within `arrival` of home
/// and below `landing_altitude` it asks to land. Fails without a home.
class Egress final : public Behavior {
 public:
  static constexpr std::string_view type_name = "egress";
  static constexpr std::string_view help = "goes home by the direct way and lands";
  static constexpr auto params() {
    return std::tuple{
        param("vote", &Egress::vote_, range(0, 1000), "how strongly"),
        param("speed", &Egress::speed_, "m/s", range(50, 1000), "true airspeed to fly"),
        param("altitude", &Egress::altitude_, "m", range(0, 25e3), "altitude of the way home"),
        param("descent_range", &Egress::descent_range_, "m", range(0, 500e3),
              "distance from home at which it begins to come down"),
        param("landing_altitude", &Egress::landing_altitude_, "m", range(0, 10e3),
              "altitude over home at which it is down to land"),
        param("arrival", &Egress::arrival_, "m", range(100, 100e3),
              "distance from home that counts as home")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 30;
  double speed_ = si(480, "kt");
  double altitude_ = si(25000, "ft");
  double descent_range_ = si(25, "nmi");
  double landing_altitude_ = si(5000, "ft");
  double arrival_ = si(4, "nmi");
};

}  // namespace eyrie::pilot
