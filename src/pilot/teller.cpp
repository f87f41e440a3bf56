// SPDX-License-Identifier: MIT
#include "pilot/teller.hpp"

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
  if (call == Call::land)
    tell(EventKind::home, {}, 0);
}

}  // namespace eyrie::pilot
