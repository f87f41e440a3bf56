// SPDX-License-Identifier: MIT
#include "pilot/behavior/break_turn.hpp"

#include "ubf/memory.hpp"

namespace eyrie::pilot {

bool BreakTurn::is_near(const State& s, const model::InboundMissile& missile, bool already) const {
  constexpr double kHysteresis = 1.5;
  if (missile.has_position)
    return missile.range < danger_range_ * (already ? kHysteresis : 1);
  return already || ubf::passed(s.time, missile.first_time, unknown_delay_);
}

void BreakTurn::defend(const State& s, const model::InboundMissile& missile, BreakMemory& m) const {
  m.until = s.time + recovery_;
  if (!is_near(s, missile, m.phase == Call::defend_near)) {
    if (m.phase != Call::defend_far)
      m.altitude = std::min(s.own.altitude + climb_, std::max(ceiling_, s.own.altitude));
    m.phase = Call::defend_far;
    m.turn = Turn::none;
    m.heading = wrap_tau(missile.bearing);
    return;
  }
  const double off_nose = angle_between(s.own.heading, missile.bearing);
  if (m.turn == Turn::none)  // it comes from the right: away is to the left
    m.turn = off_nose >= 0 ? Turn::left : Turn::right;
  if (m.phase != Call::defend_near)
    m.altitude = std::max(s.own.altitude - dive_, std::min(floor_, s.own.altitude));
  m.phase = Call::defend_near;
  // farther behind already: any turn to put it back there would be one towards it
  m.heading = wrap_tau(std::fabs(off_nose) >= turn_ ? s.own.heading
                       : m.turn == Turn::left       ? missile.bearing - turn_
                                                    : missile.bearing + turn_);
}

Status BreakTurn::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  BreakMemory& m = memory(t);
  if (const model::InboundMissile* missile = s.threat()) {
    defend(s, *missile, m);
  } else if (m.phase == Call::none || ubf::passed(s.time, m.until, 0)) {
    m = {};
    return fails(t, "no missile is known to come");
  }
  const bool near = m.phase == Call::defend_near;
  out.action.heading = m.heading;
  out.action.altitude = m.altitude;
  out.action.speed = speed_;
  out.action.load_factor = load_factor_;
  out.action.mode = model::AutopilotMode::hold;
  out.action.call = m.phase;
  out.vote = near ? near_vote_ : vote_;
  return Status::running;
}

}  // namespace eyrie::pilot
