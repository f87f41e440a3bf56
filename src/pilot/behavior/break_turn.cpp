// SPDX-License-Identifier: MIT
#include "pilot/behavior/break_turn.hpp"

namespace eyrie::pilot {
namespace {

/// The most urgent one: the nearest of known range, or else the one heard of first.
const model::InboundMissile* most_urgent(const model::Threats& threats) {
  const model::InboundMissile* worst = nullptr;
  for (std::uint32_t i = 0; i < threats.count; ++i) {
    const model::InboundMissile& m = threats.missiles[i];
    const bool worse =
        !worst || (m.has_position && (!worst->has_position || m.range < worst->range));
    if (worse)
      worst = &m;
  }
  return worst;
}

}  // namespace

Status BreakTurn::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  BreakMemory& m = memory(t);
  const model::InboundMissile* missile = most_urgent(s.threats);
  if (!missile) {
    m = {};
    return Status::failure;
  }
  const bool near = missile->has_position
                        ? missile->range < danger_range_ * (m.near ? 1.5 : 1)
                        : s.time - missile->first_time >= unknown_delay_ || m.near;
  if (near && !m.near) {
    const double relative = wrap_pi(missile->bearing - s.own.heading);
    m.side = relative >= 0 ? 1 : 2;  // it comes from the right: away is to the left
  }
  m.near = near;

  out.action.mode = model::AutopilotMode::hold;
  out.action.load_factor = load_factor_;
  out.action.speed = speed_;
  if (near) {
    m.heading = wrap_tau(missile->bearing + (m.side == 1 ? -turn_ : turn_));
    out.action.heading = m.heading;
    out.action.altitude = std::max(s.own.altitude - dive_, floor_);
    out.action.call = Call::defend_near;
    out.vote = near_vote_;
  } else {
    out.action.heading = wrap_tau(missile->bearing);
    out.action.altitude = s.own.altitude + climb_;
    out.action.call = Call::defend_far;
    out.vote = vote_;
  }
  return Status::running;
}

}  // namespace eyrie::pilot
