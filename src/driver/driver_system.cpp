// SPDX-License-Identifier: MIT
#include "driver/driver_system.hpp"

namespace eyrie::driver {

void Teller::changes(const Agent& before, const Proposal&, const Agent& agent) const {
  in_charge(before, agent);
  if (agent.call == Call::scatter && before.call != Call::scatter) {
    const model::Sighted* aircraft = state_.watched();
    tell(model::EventKind::scatter, aircraft ? aircraft->truth : PlayerId{}, 0,
         aircraft ? state_.range_to(*aircraft) : 0);
  }
}

}  // namespace eyrie::driver

template class eyrie::team::AgentSystem<eyrie::driver::Driving>;
