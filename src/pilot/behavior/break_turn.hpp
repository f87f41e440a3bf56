// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// Which way a pilot turns in the near phase.
enum class Turn : std::uint32_t { none, left, right };

struct BreakMemory {
  double until = 0;         ///< s, when to recover if nothing is heard of a missile again
  double heading = 0;       ///< rad, last recommended
  double altitude = 0;      ///< m, to go to in this phase
  Call phase = Call::none;  ///< defend_far or defend_near while defending
  Turn turn = Turn::none;   ///< of the near phase
};

/// Defends against an inbound missile in two phases (Roberson et al., III.C.3.e). Far: turns
/// towards it and climbs. Near: a hard diving turn, away to the side that the missile does not come
/// from, until it is `turn` off the nose; one that is farther behind is left there. `running` as
/// long as it defends; fails without a threat.
///
/// The near phase begins inside `danger_range`. Where the range is not known, because a warning
/// receiver tells bearings only, it begins `unknown_delay` after the first warning: an active
/// seeker is heard from about 15 km on, which leaves a missile at 1000 m/s that long to 2 nmi. It
/// holds until the missile is half as far again as `danger_range`. The vote of the near phase is
/// its own, and higher by default. When the threat is gone it keeps its heading for `recovery`
/// before it lets go: a missile that is not heard for a moment has not missed yet.
class BreakTurn final : public ubf::WithMemory<Behavior, BreakMemory> {
 public:
  static constexpr std::string_view type_name = "break_turn";
  static constexpr std::string_view help = "turns into a far missile, breaks away from a near one";
  static constexpr auto params() {
    using B = BreakTurn;
    return Lines{
        param("vote", &B::vote_, range(0, 1000), "how strongly in the far phase"),
        param("near_vote", &B::near_vote_, range(0, 1000), "how strongly in the near phase"),
        param("danger_range", &B::danger_range_, "m", range(0, 50e3), "inside this range, break"),
        param("unknown_delay", &B::unknown_delay_, "s", range(0, 120),
              "time from the first warning to the near phase when the range is not known"),
        param("recovery", &B::recovery_, "s", range(0, 60),
              "goes on for so long after the last that was perceived of the missile"),
        param("climb", &B::climb_, "m", range(0, 10e3),
              "far phase: how much higher than where it began"),
        param("ceiling", &B::ceiling_, "m", range(0, 30e3), "far phase: climbs no higher"),
        param("dive", &B::dive_, "m", range(0, 10e3),
              "near phase: how much lower than where it began"),
        param("floor", &B::floor_, "m", range(0, 25e3), "near phase: dives no lower"),
        param("turn", &B::turn_, "rad", range(10, 179.9, "deg"),
              "near phase: how far off the nose the missile shall be; 90° beams it"),
        param("speed", &B::speed_, "m/s", range(50, 1000), "true airspeed to fly"),
        param("load_factor", &B::load_factor_, range(1, 12), "g of the hard turn")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  [[nodiscard]] bool is_near(const State& s, const model::InboundMissile& missile,
                             bool already) const;
  void defend(const State& s, const model::InboundMissile& missile, BreakMemory& m) const;

  float vote_ = 70, near_vote_ = 80;
  double danger_range_ = si(2, "nmi");
  double unknown_delay_ = 10;
  double recovery_ = 2;
  double climb_ = si(3000, "ft");
  double ceiling_ = si(50000, "ft");
  double dive_ = si(6000, "ft");
  double floor_ = si(2000, "ft");
  double turn_ = si(110, "deg");
  double speed_ = si(600, "kt");
  double load_factor_ = 8;
};

}  // namespace eyrie::pilot
