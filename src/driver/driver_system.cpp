// SPDX-License-Identifier: MIT
#include "driver/driver_system.hpp"

#include "team/decision.hpp"

namespace eyrie::driver {

std::vector<team::Perceived> perceived(const State& s) {
  std::vector<team::Perceived> all;
  std::uint32_t number = 0;
  for (const model::Sighted& seen : s.lookout.all())
    all.push_back({"aircraft",
                   ++number,
                   seen.truth,
                   {team::action_value("identity", {}, seen.identity),
                    team::number_value("range", "m", s.range_to(seen)),
                    team::number_value("bearing", "rad", wrap_tau(s.bearing_to(seen.position))),
                    team::number_value("age", "s", s.time - seen.time)}});
  return all;
}

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
