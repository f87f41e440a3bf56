// SPDX-License-Identifier: MIT
#include "driver/behaviors.hpp"

#include "ubf/standard_nodes.hpp"

namespace eyrie::driver {

Status Scatter::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  ScatterMemory& m = memory(t);
  const model::Sighted* aircraft = s.watched();
  if (aircraft && s.range_to(*aircraft) <= range_) {
    if (m.until == 0) {
      m.from = s.own.position;
      m.heading = wrap_pi(s.own.heading + (s.rank % 2 == 1 ? angle_ : -angle_));
    }
    m.until = t.time + calm_;
  }
  if (t.time >= m.until) {
    m = {};
    return fails(t, "no unknown or hostile aircraft is near");
  }
  out.action.heading = wrap_tau(m.heading);
  out.action.speed = norm(s.own.position - m.from) < distance_ ? speed_ : 0;
  out.action.call = Call::scatter;
  out.vote = vote_;
  return Status::running;
}

Registry make_registry() {
  Registry registry;
  ubf::add_standard_nodes(registry);
  registry.add<Navigate, FollowLead, Scatter, IsLead, RouteDone>();
  return registry;
}

}  // namespace eyrie::driver
