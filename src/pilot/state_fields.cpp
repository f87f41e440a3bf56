// SPDX-License-Identifier: MIT

#include "model/weapon/stores.hpp"
#include "pilot/fight.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {
namespace {

using ubf::kNoValue;
constexpr auto number = ubf::FieldsOf<State>::number;
constexpr auto flag = ubf::FieldsOf<State>::flag;

/// What `of` says of the chosen target; no value without one.
template <auto of>
double of_target(const State& s) {
  const Seen* target = s.target();
  return target ? of(s, *target) : kNoValue;
}
constexpr auto kTargetRange = [](const State&, const Seen& t) { return t.range; };
constexpr auto kTargetClosing = [](const State& s, const Seen& t) { return s.closing_on(t); };
constexpr auto kTargetOffNose = [](const State& s, const Seen& t) { return s.off_nose(t.ned); };
constexpr auto kTargetOffTail = [](const State& s, const Seen& t) {
  return angles_of(s, t).off_tail;
};
constexpr auto kTargetCrossing = [](const State& s, const Seen& t) {
  return angles_of(s, t).crossing;
};
constexpr auto kTargetUnseen = [](const State& s, const Seen& t) {
  const double seen = t.track->seen_time;
  return seen == model::kNever ? std::numeric_limits<double>::infinity() : s.time - seen;
};
constexpr auto kTargetHeight = [](const State&, const Seen& t) { return -t.ned.z; };

template <bool (Seen::*is)() const>
std::size_t count(const State& s) {
  const auto seen = s.tracks_seen();
  return static_cast<std::size_t>(
      std::count_if(seen.begin(), seen.end(), [](const Seen& one) { return (one.*is)(); }));
}

constexpr std::array kFields = std::to_array<ubf::StateField<State>>({
    number("time", "s", "of the scenario", [](const State& s) { return s.time; }),
    number("altitude", "m", "own, above the ellipsoid",
           [](const State& s) { return s.own.altitude; }),
    number("speed", "m/s", "own, through the air", [](const State& s) { return s.own.speed; }),
    number("mach", "", "own", [](const State& s) { return s.own.mach; }),
    number("heading", "rad", "own, true, in (-180°, 180°]",
           [](const State& s) { return s.own.heading; }),
    number("pitch", "rad", "own, positive up", [](const State& s) { return s.own.pitch; }),
    number("load_factor", "", "own, in g", [](const State& s) { return s.own.load_factor; }),
    number("available", "", "g that wing and structure give now",
           [](const State& s) { return double(s.flying.energy.available); }),
    number("sustained", "", "g that full power holds without losing speed",
           [](const State& s) { return double(s.flying.energy.sustained); }),
    number("corner_speed", "m/s", "slowest airspeed at which the structure's limit is had",
           [](const State& s) { return double(s.flying.energy.corner_speed); }),
    number("excess_power", "m/s", "of climb at full power in straight flight",
           [](const State& s) { return double(s.flying.energy.excess_power); }),
    number("fuel", "kg", "own", [](const State& s) { return s.propulsion.fuel; }),
    flag("bingo", "fuel is down to what the way home needs",
         [](const State& s) -> double { return s.bingo(); }),
    number(
        "missiles", "", "left on the stations",
        [](const State& s) { return static_cast<double>(model::weapon::missiles_left(s.stores)); }),
    number("rounds", "", "left in the gun", [](const State& s) { return double(s.gun.rounds); }),
    number("home_range", "m", "to the home of the flight, along the ground",
           [](const State& s) { return s.home_distance().value_or(kNoValue); }),
    number("rank", "", "own, among the members believed alive; 1 leads",
           [](const State& s) { return double(s.rank); }),
    number("alive", "", "members of the flight believed alive, the pilot included",
           [](const State& s) { return double(std::popcount(s.alive)); }),
    number("lost", "", "members of the flight believed lost",
           [](const State& s) { return double(s.lost); }),
    flag("leads", "the own rank is the first", [](const State& s) -> double { return s.leads(); }),
    number("tracks", "", "that this pilot knows",
           [](const State& s) { return double(s.seen_count); }),
    number("hostiles", "", "tracks identified as hostile",
           [](const State& s) { return double(count<&Seen::hostile>(s)); }),
    number("suspects", "", "confirmed tracks that are no friends",
           [](const State& s) { return double(count<&Seen::suspect>(s)); }),
    flag("has_target", "a target is chosen",
         [](const State& s) -> double { return s.target() != nullptr; }),
    flag("hostile", "the chosen target is identified as hostile",
         [](const State& s) -> double { return s.target() && s.target()->hostile(); }),
    number("range", "m", "to the chosen target", of_target<kTargetRange>),
    number("closing", "m/s", "of the chosen target, positive if the range shrinks",
           of_target<kTargetClosing>),
    number("off_nose", "rad",
           "between the nose and the chosen target, up and down too: without a side, in [0, 180°]",
           of_target<kTargetOffNose>),
    number("off_tail", "rad", "of the chosen target, in [0, 180°]: 0 right behind him",
           of_target<kTargetOffTail>),
    number("crossing", "rad", "of the chosen target's path and the own one, in [0, 180°]",
           of_target<kTargetCrossing>),
    number("unseen", "s", "since an own eye saw the chosen target; none did: infinite",
           of_target<kTargetUnseen>),
    number("target_above", "m", "height of the chosen target over the own",
           of_target<kTargetHeight>),
    flag("threatened", "a missile is believed to come for this aircraft",
         [](const State& s) -> double { return s.threats.count > 0; }),
    number("missile_range", "m", "to the missile to worry about, if its range is known",
           [](const State& s) {
             const model::InboundMissile* m = s.threat();
             return m && m->has_position ? m->range : kNoValue;
           }),
});

/// The position in `seen` of the i-th hostile.
std::int32_t hostile_number(const State& s, std::size_t i) {
  for (std::uint32_t k = 0; k < s.seen_count; ++k)
    if (s.seen[k].hostile() && i-- == 0)
      return static_cast<std::int32_t>(k);
  return -1;
}

constexpr std::array kLists = std::to_array<ubf::StateList<State>>({
    {"hostiles", "tracks identified as hostile, each in turn as the target", count<&Seen::hostile>,
     [](State& s, std::size_t i) { s.target_index = hostile_number(s, i); }},
    {"tracks", "all tracks, friends and unknown ones too, each in turn as the target",
     [](const State& s) { return std::size_t{s.seen_count}; },
     [](State& s, std::size_t i) { s.target_index = static_cast<std::int32_t>(i); }},
});

}  // namespace
}  // namespace eyrie::pilot

std::span<const eyrie::ubf::StateList<eyrie::pilot::State>>
eyrie::ubf::StateLists<eyrie::pilot::State>::all() {
  return pilot::kLists;
}

std::span<const eyrie::ubf::StateField<eyrie::pilot::State>>
eyrie::ubf::StateFields<eyrie::pilot::State>::all() {
  return pilot::kFields;
}
