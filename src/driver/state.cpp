// SPDX-License-Identifier: MIT
#include "driver/state.hpp"

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

using ubf::kNoValue;
constexpr auto number = ubf::FieldsOf<State>::number;
constexpr auto angle = ubf::FieldsOf<State>::angle;
constexpr auto flag = ubf::FieldsOf<State>::flag;

constexpr std::array kFields = std::to_array<ubf::StateField<State>>({
    number("time", "s", "of the run", [](const State& s) { return s.time; }),
    number("speed", "m/s", "own, over the ground", [](const State& s) { return s.own.speed; }),
    angle("heading", "own, true, in (-180°, 180°]", [](const State& s) { return s.own.heading; }),
    number("rank", "", "own, among the members believed alive; 1 leads",
           [](const State& s) { return double(s.rank); }),
    number("alive", "", "members of the convoy believed alive, the driver included",
           [](const State& s) { return double(s.alive); }),
    flag("leads", "the own rank is the first", [](const State& s) -> double { return s.leads(); }),
    number("gap", "m", "to the vehicle ahead",
           [](const State& s) {
             const auto ahead = s.leader();
             return ahead ? norm(ahead->position - s.own.position) : kNoValue;
           }),
    number("aircraft", "", "in sight or seen a moment ago",
           [](const State& s) { return double(s.lookout.count); }),
    number("aircraft_range", "m", "to the nearest aircraft that is no friend",
           [](const State& s) { return s.watched() ? s.range_to(*s.watched()) : kNoValue; }),
    flag("hostile", "that aircraft is recognised as hostile",
         [](const State& s) -> double {
           return s.watched() && s.watched()->identity == model::Identity::hostile;
         }),
});

constexpr std::array kLists = std::to_array<ubf::StateList<State>>({
    {"aircraft", "aircraft in sight, friends too, each in turn as the nearest",
     [](const State& s) { return std::size_t{s.lookout.count}; },
     [](State& s, std::size_t i) { s.watched_index = static_cast<std::int32_t>(i); }},
});

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

std::span<const eyrie::ubf::StateList<eyrie::driver::State>>
eyrie::ubf::StateLists<eyrie::driver::State>::all() {
  return driver::kLists;
}

std::span<const eyrie::ubf::StateField<eyrie::driver::State>>
eyrie::ubf::StateFields<eyrie::driver::State>::all() {
  return driver::kFields;
}
