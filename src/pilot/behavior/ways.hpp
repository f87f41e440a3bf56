// SPDX-License-Identifier: MIT
#pragma once
/// \file  Where to fly when nobody disturbs: along a route, beside the lead, home, and off the
/// ground.
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "team/member.hpp"

namespace eyrie::pilot {

/// Flies a route of the flight (team/member.hpp) by the autopilot's mode. Attacks nobody.
class Navigate final : public team::Navigate<Platform> {
 public:
  static constexpr std::string_view help = "flies along the waypoints of the flight's route";
  static constexpr auto params() {
    return joined(team::Navigate<Platform>::params(),
                  Lines{param("load_factor", &Navigate::load_factor_, range(1, 12),
                              "g, the most it turns with")});
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double load_factor_ = 3;
};

/// Keeps the own place in the flight's wall formation (team/member.hpp, pilot/geometry.hpp),
/// as the datalink tells where the lead is. Attacks nobody.
class FollowLead final : public team::FollowLead<Platform> {
 public:
  static constexpr std::string_view help = "keeps the own place in the wall formation";
  static constexpr auto params() {
    return joined(
        team::FollowLead<Platform>::params(),
        Lines{param("load_factor", &FollowLead::load_factor_, range(1, 12),
                    "g, the most it turns with"),
              param("floor", &FollowLead::floor_, "m", range(0, 25e3), "follows no lower")});
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double load_factor_ = 5;
  double floor_ = si(2000, "ft");
};

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
    return Lines{
        param("vote", &Egress::vote_, range(0, 1000), "how strongly"),
        param("route", &Egress::route_, range(0, 255),
              "which route of the flight leads home, the first: 0; null, or a route that the "
              "flight does not have: goes directly"),
        param("speed", &Egress::speed_, "m/s", range(50, 1000), "true airspeed to fly"),
        param("altitude", &Egress::altitude_, "m", range(0, 25e3), "altitude of the way home"),
        param("descent", &Egress::descent_, "rad", range(0.25, 40, "deg"),
              "slope of the way down, below the horizontal"),
        param("landing_altitude", &Egress::landing_altitude_, "m", range(0, 10e3),
              "altitude over home at which it is low enough to land"),
        param("arrival", &Egress::arrival_, "m", range(100, 100e3),
              "distance from home that counts as home; no less than what the circle over it takes"),
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

/// Pulls up, wings level, when at the present sink rate the floor would be reached within
/// `warning_time`, less the height that a pull-out of `pull` g still costs. Fails otherwise. The
/// ground is the ellipsoid. Its vote is the highest of all by default.
///
/// Of n g, n - 1 are left at the bottom of a pull-out to bend the path: an arc of the radius
/// V^2 / (g (n - 1)), which from a dive angle c costs V^2 (1 - cos c) / (g (n - 1)) of height.
class AvoidGround final : public Behavior {
 public:
  static constexpr std::string_view type_name = "avoid_ground";
  static constexpr std::string_view help = "pulls up before the ground comes too near";
  static constexpr auto params() {
    using A = AvoidGround;
    return Lines{
        param("vote", &A::vote_, range(0, 1000), "how strongly"),
        param("floor", &A::floor_, "m", range(0, 10e3), "altitude to stay above"),
        param("warning_time", &A::warning_time_, "s", range(0, 60), "how far ahead it looks"),
        param("pull", &A::pull_, range(1.5, 12), "g of the pull-up"),
        param("climb", &A::climb_, "m", range(0, 10e3), "how much higher it asks for")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 100;
  double floor_ = si(1500, "ft");
  double warning_time_ = 3;
  double pull_ = 6;
  double climb_ = 500;
};

}  // namespace eyrie::pilot
