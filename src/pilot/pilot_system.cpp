// SPDX-License-Identifier: MIT
#include "pilot/pilot_system.hpp"

#include "pilot/action.hpp"
#include "pilot/danger.hpp"
#include "team/decision.hpp"

namespace eyrie::pilot {

using model::EventKind;

void Teller::notice(Agent& agent, const model::Fit& fit) const {
  new_lead(agent, state_.datalink, fit);
  if (!agent.said_bingo && state_.bingo()) {
    agent.said_bingo = 1;
    tell(EventKind::bingo, {}, 0, state_.propulsion.fuel);
  }
}

void Teller::changes(const Agent& before, const Proposal& decided, Agent& agent) const {
  in_charge(before, agent);

  // a track that was lost and found again under another name is no new commit
  if (const Seen* target = state_.find(agent.target))
    if (agent.target != before.target && target->track->truth != agent.committed) {
      agent.committed = target->track->truth;
      tell(EventKind::commit, agent.committed, 0, target->range);
    }

  const model::InboundMissile* threat = state_.threat();
  const Call call = decided.action.call.value_or(Call::none);
  if (call == Call::none && threat)
    return;  // somebody else spoke for a moment, the defense is not over
  agent.call = call;
  if (call == before.call)
    return;
  if (call == Call::defend_far || call == Call::defend_near)
    tell(EventKind::defend, threat ? threat->truth : PlayerId{}, 0,
         call == Call::defend_far ? 1 : 2);
  if (call == Call::notch || call == Call::drag || call == Call::last_ditch) {
    // without a missile it is what goes on after the last one
    if (const model::InboundMissile* missile = inbound(state_, math::kInfinity))
      tell(EventKind::defend, missile->truth, 0,
           call == Call::notch  ? 3
           : call == Call::drag ? 4
                                : 5);
  }
  if (call == Call::out)
    tell(EventKind::defend, {}, 0, 6);
  if (call == Call::land)
    tell(EventKind::home, {}, 0);
}

std::vector<team::Perceived> perceived(const State& s) {
  std::vector<team::Perceived> all;
  const auto off_nose = [&](double bearing) {
    return team::side_value("off nose", angle_between(s.own.heading, bearing));
  };
  for (const Seen& seen : s.tracks_seen()) {
    const bool chosen = s.target() == &seen;
    all.push_back({chosen ? "target" : "track",
                   seen.id().value,
                   seen.track->truth,
                   {team::action_value("identity", {}, seen.track->identity),
                    team::number_value("range", "m", seen.range),
                    team::number_value("bearing", "rad", wrap_tau(bearing_of(seen.ned))),
                    off_nose(bearing_of(seen.ned)),
                    team::number_value("altitude", "m", altitude_of(s.own, seen.ned)),
                    team::number_value("closing", "m/s", s.closing_on(seen)),
                    team::number_value("age", "s", s.time - seen.track->time)}});
  }
  for (std::uint32_t i = 0; i < s.rwr.count; ++i) {
    const model::RwrWarning& warning = s.rwr.warnings[i];
    all.push_back({"radar",
                   i + 1,
                   warning.emitter,
                   {team::action_value("kind", {}, warning.kind),
                    team::number_value("bearing", "rad", wrap_tau(warning.bearing)),
                    off_nose(warning.bearing),
                    team::number_value("known for", "s", s.time - warning.first_time)}});
  }
  for (std::uint32_t i = 0; i < s.threats.count; ++i) {
    const model::InboundMissile& m = s.threats.missiles[i];
    all.push_back({"missile",
                   i + 1,
                   m.truth,
                   {team::number_value("bearing", "rad", wrap_tau(m.bearing)), off_nose(m.bearing),
                    team::number_value("range", "m", m.has_position ? m.range : ubf::kNoValue),
                    team::number_value("known for", "s", s.time - m.first_time)}});
  }
  return all;
}

}  // namespace eyrie::pilot

template class eyrie::team::AgentSystem<eyrie::pilot::Piloting>;
