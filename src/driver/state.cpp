// SPDX-License-Identifier: MIT
#include "driver/state.hpp"

#include "core/angle.hpp"
#include "core/math.hpp"

namespace eyrie::driver {
namespace {

/// The nearest aircraft that is no friend, as an index into the lookout; -1 if there is none.
std::int32_t nearest_stranger(const State& s) {
  std::int32_t nearest = -1;
  for (std::uint32_t i = 0; i < s.lookout.count; ++i) {
    const model::Sighted& one = s.lookout.sighted[i];
    if (one.identity == model::Identity::friendly)
      continue;
    if (nearest < 0 ||
        s.range_to(one) < s.range_to(s.lookout.sighted[static_cast<std::size_t>(nearest)]))
      nearest = static_cast<std::int32_t>(i);
  }
  return nearest;
}

}  // namespace

State::State(const Cab& cab, const model::Library& models, const model::Fit& fit,
             const Spacing& driven_in, double now)
    : Cab(cab),
      type(models.vehicles[fit.type]),
      convoy(models.flights[fit.flight]),
      spacing(driven_in),
      time(now) {
  rank = team::rank_now(datalink, fit.rank);
  for (std::uint32_t i = 0; i < datalink.count; ++i)
    alive += i != datalink.self && datalink.members[i].alive ? 1 : 0;
  watched_index = nearest_stranger(*this);
}

double State::bearing_to(const Vec3& place) const {
  const Vec3 sight = place - own.position;
  return wrap_pi(math::atan2(dot(own.east, sight), dot(own.north, sight)));
}

std::optional<team::Leader> State::leader() const {
  for (std::uint32_t i = datalink.self; i-- > 0;)
    if (datalink.members[i].alive)
      return team::heard(datalink.members[i], time);
  return std::nullopt;
}

void execute(const Action& action, model::DriveCommand& command, Agent& agent) {
  if (action.heading)
    command.heading = wrap_pi(*action.heading);
  if (action.speed)
    command.speed = *action.speed;
  agent.call = action.call.value_or(Call::none);
}

}  // namespace eyrie::driver
