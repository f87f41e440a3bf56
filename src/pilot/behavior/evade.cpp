// SPDX-License-Identifier: MIT
#include "pilot/behavior/evade.hpp"

#include "model/flight/guidance.hpp"

namespace eyrie::pilot {

/// s to go: a cloud or a flare that is thrown out earlier is over before the missile is here.
constexpr double kDispenseTime = 6;

template <const Evasion& kDefault>
Status Evade<kDefault>::tick(const Tick& t, Proposal& out) const {
  const State& s = t.state;
  EvadeMemory& m = memory(t);
  if (const auto from = danger(s, against_, within_)) {
    m.until = s.time + recovery_;
    // who runs from a radar and turned after each look of the receiver would weave
    const double slack = m.side == 0 || from->call == Call::none ? 0 : kDefault.slack;
    m.bearing = from->bearing - std::clamp(angle_between(m.bearing, from->bearing), -slack, slack);
    m.call = from->call == Call::none ? kDefault.call : from->call;
  } else if (m.side == 0 || ubf::passed(s.time, m.until, 0)) {
    m = {};
    return fails(t, against_ == Against::missile ? "no missile is almost here"
                    : against_ == Against::radar ? "no missile comes and no radar tracks"
                                                 : "nobody to turn from is known");
  }
  if (m.side == 0) {
    m.began = s.own.altitude;
    m.side = angle_between(m.bearing, s.own.heading) >= 0 ? 1 : -1;
    // through its bearing, where that is not the way over the tail
    if (kDefault.across && std::fabs(angle_between(s.own.heading, m.bearing)) <= kPi / 2)
      m.side = -m.side;
  }
  out.vote = this->vote_;
  // a notch is one of the motion over the ground, which a Doppler filter sees
  const double course = m.bearing + m.side * angle_;
  out.action.heading =
      wrap_tau(&kDefault == &kNotch ? model::flight::crab(course, s.own.speed, s.wind()) : course);
  out.action.altitude = std::max(m.began - dive_, std::min(this->floor_, m.began));
  out.action.speed = this->speed_;
  out.action.load_factor = this->load(s, this->load_factor_);
  out.action.mode = model::AutopilotMode::hold;
  out.action.call = m.call;
  if (dispense_ != model::Dispense::none && inbound(s, std::min(within_, kDispenseTime)))
    out.action.dispense = dispense_;
  return Status::running;
}

template class Evade<kNotch>;
template class Evade<kDrag>;
template class Evade<kLastDitch>;

}  // namespace eyrie::pilot
