// SPDX-License-Identifier: MIT
#include <array>

#include "core/angle.hpp"
#include "driver/state.hpp"
#include "driver/trees.hpp"

namespace eyrie::driver {
namespace {

using ubf::kNoValue;
constexpr auto number = ubf::FieldsOf<State>::number;
constexpr auto flag = ubf::FieldsOf<State>::flag;

constexpr std::array kFields = std::to_array<ubf::StateField<State>>({
    number("time", "s", "of the run", [](const State& s) { return s.time; }),
    number("speed", "m/s", "own, over the ground", [](const State& s) { return s.own.speed; }),
    number("heading", "rad", "own, true, in (-180 deg, 180 deg]",
           [](const State& s) { return s.own.heading; }),
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
}  // namespace eyrie::driver

std::span<const eyrie::ubf::StateList<eyrie::driver::State>>
eyrie::ubf::StateLists<eyrie::driver::State>::all() {
  return driver::kLists;
}

std::span<const eyrie::ubf::StateField<eyrie::driver::State>>
eyrie::ubf::StateFields<eyrie::driver::State>::all() {
  return driver::kFields;
}
