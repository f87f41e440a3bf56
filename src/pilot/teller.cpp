// SPDX-License-Identifier: MIT
#include "pilot/teller.hpp"

namespace eyrie::pilot {

using model::EventKind;

void Teller::tell(EventKind kind, PlayerId whom, std::uint16_t aux, double a, double b,
                  double c) const {
  out_.emit({.kind = kind,
             .aux = aux,
             .who = who_,
             .whom = whom,
             .place = state_.own.position,
             .values = {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)}});
}

void Teller::notice(Agent& agent, const model::Fit& fit) const {
  const model::Mate* lead = state_.lead();
  const PlayerId now = lead ? lead->id : PlayerId{};
  if (agent.lead && now == who_ && agent.lead != now)
    tell(EventKind::lead_change, agent.lead, 0, fit.flight);
  if (now)
    agent.lead = now;
  if (!agent.said_bingo && state_.bingo()) {
    agent.said_bingo = 1;
    tell(EventKind::bingo, {}, 0, state_.propulsion.fuel);
  }
}

void Teller::transitions(const ubf::TransitionLog& log, ubf::NodeIndex outermost,
                         Agent& agent) const {
  for (const ubf::Transition& t : log.entries()) {
    tell(EventKind::phase, {}, agent.tree, t.from == ubf::kNone ? -1.0 : t.from, t.to, t.node);
    if (t.node == outermost)
      agent.phase = t.to;
  }
}

void Teller::changes(const Agent& before, const Proposal& decided, Agent& agent) const {
  if (agent.node != before.node || before.ticks == 0)
    tell(EventKind::in_charge, {}, agent.tree, agent.node == ubf::kNone ? -1.0 : agent.node,
         static_cast<double>(decided.vote));

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
  if (call == Call::land)
    tell(EventKind::home, {}, 0);
}

}  // namespace eyrie::pilot
