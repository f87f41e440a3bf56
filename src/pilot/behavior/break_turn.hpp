// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

struct BreakMemory {
  std::uint32_t near = 0;  ///< 1: in the second phase
  std::uint32_t side = 0;  ///< of the second phase: 1 turns left, 2 turns right
  double heading = 0;      ///< rad, of the second phase
};

/// Defends against an inbound missile in two phases (Roberson et al., III.C.3.e). Far: turn towards
/// it and climb. Near: a hard diving turn away from the side it comes from. Near begins inside
/// `danger_range` if the range is known, and otherwise `unknown_delay` after the first warning,
/// because a warning receiver tells bearings only. The second phase stays until the threat is gone
/// or half as far again. Fails without a threat.
class BreakTurn final : public ubf::WithMemory<Behavior, BreakMemory> {
 public:
  static constexpr std::string_view type_name = "break_turn";
  static constexpr std::string_view help = "turns into a far missile, breaks away from a near one";
  static constexpr auto params() {
    return std::tuple{
        param("vote", &BreakTurn::vote_, range(0, 1000), "how strongly in the far phase"),
        param("near_vote", &BreakTurn::near_vote_, range(0, 1000),
              "how strongly in the near phase"),
        param("danger_range", &BreakTurn::danger_range_, "m", range(0, 50e3),
              "inside this range, break"),
        param("unknown_delay", &BreakTurn::unknown_delay_, "s", range(0, 120),
              "time from the first warning to the near phase when the range is not known"),
        param("climb", &BreakTurn::climb_, "m", range(0, 10e3), "far phase: how much higher"),
        param("dive", &BreakTurn::dive_, "m", range(0, 10e3), "near phase: how much lower"),
        param("turn", &BreakTurn::turn_, "rad", range(0.2, 3.2),
              "near phase: heading off the missile's bearing"),
        param("speed", &BreakTurn::speed_, "m/s", range(50, 1000), "true airspeed to fly"),
        param("load_factor", &BreakTurn::load_factor_, range(1, 12), "g of the hard turn"),
        param("floor", &BreakTurn::floor_, "m", range(0, 25e3), "dives no lower")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 70, near_vote_ = 80;
  double danger_range_ = si(2, "nmi");
  double unknown_delay_ = 10;
  double climb_ = si(3000, "ft");
  double dive_ = si(6000, "ft");
  double turn_ = si(100, "deg");
  double speed_ = si(600, "kt");
  double load_factor_ = 8;
  double floor_ = si(2000, "ft");
};

}  // namespace eyrie::pilot
