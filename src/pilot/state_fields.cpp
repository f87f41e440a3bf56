// SPDX-License-Identifier: MIT

#include "model/weapon/stores.hpp"
#include "pilot/danger.hpp"
#include "pilot/fight.hpp"
#include "pilot/gunnery.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {
namespace {

using ubf::kNoValue;
constexpr auto number = ubf::FieldsOf<State>::number;
constexpr auto angle = ubf::FieldsOf<State>::angle;
constexpr auto flag = ubf::FieldsOf<State>::flag;

/// rad in (-pi, pi], of a true bearing from the own heading, positive right.
double right_of_nose(const State& s, double bearing) {
  return angle_between(s.own.heading, bearing);
}

/// A range over a reach; infinite if there is no reach.
double over(double range, double reach) {
  return reach > 0 ? range / reach : math::kInfinity;
}

/// m, from here to the own place in the formation, ahead and to the right along the own heading,
/// level, and down.
Vec3 to_place(const State& s, const team::Leader& lead) {
  const auto turned = [](const Vec3& v, double by) {
    const auto [sine, cosine] = math::sin_cos(by);
    return Vec3{cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
  };
  const Vec3 ned =
      to_ned(s.own, lead.position - s.own.position) + turned(s.place(), s.forward_of(lead));
  return turned(ned, -s.own.heading);
}

std::optional<Sight> sight(const State& s) {
  const Seen* target = s.target();
  return target ? s.gun_sight(*target) : std::nullopt;
}

/// What a function says of what `find` finds in a state; no value if it finds nothing.
template <auto find>
struct OfWhat {
  template <class Of>
  constexpr auto operator()(Of) const {
    return [](const State& s) -> double {
      const auto found = std::invoke(find, s);
      return found ? Of{}(s, *found) : kNoValue;
    };
  }
};
constexpr OfWhat<&State::target> of_target;   ///< the chosen one
constexpr OfWhat<sight> of_sight;             ///< of the gun on the chosen target
constexpr OfWhat<&State::threat> of_missile;  ///< the one to worry about
constexpr OfWhat<&State::leader> of_lead;     ///< who is followed; who leads follows nobody
constexpr OfWhat<spike> of_spike;             ///< the radar that tracks this aircraft

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
    angle("heading", "own, true, in (-180°, 180°]", [](const State& s) { return s.own.heading; }),
    angle("pitch", "own, positive up", [](const State& s) { return s.own.pitch; }),
    angle("roll", "own, positive right wing down", [](const State& s) { return s.own.roll; }),
    number("climb_rate", "m/s", "own, positive up",
           [](const State& s) { return -s.velocity_ned.z; }),
    // the level part of the lift turns the path: Stevens, Lewis & Johnson, Aircraft Control and
    // Simulation, 3rd ed., sec. 3.6, without sideslip
    number("turn_rate", "rad/s",
           "of the own heading as load factor and roll give it, positive right",
           [](const State& s) {
             const auto [path, bank] = math::sin_cos(s.own.pitch, s.own.roll);
             const double level_speed = s.own.speed * path.cos;
             return model::kGravity * s.own.load_factor * bank.sin / std::max(level_speed, 1.0);
           }),
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
    flag("bingo", "fuel is down to the pilot's bingo, at which he is to go home",
         [](const State& s) -> double { return s.bingo(); }),
    number(
        "missiles", "", "left on the stations",
        [](const State& s) { return static_cast<double>(model::weapon::missiles_left(s.stores)); }),
    number("rounds", "", "left in the gun", [](const State& s) { return double(s.gun.rounds); }),
    number("home_range", "m", "to the home of the flight, along the ground",
           [](const State& s) { return s.home_distance().value_or(kNoValue); }),
    angle("home_right", "home off the own heading, in (-180°, 180°], positive right",
          [](const State& s) {
            return s.flight.home
                       ? right_of_nose(s,
                                       bearing_of(to_ned(s.own, *s.flight.home - s.own.position)))
                       : kNoValue;
          }),
    number("rank", "", "own, among the members believed alive; 1 leads",
           [](const State& s) { return double(s.rank); }),
    number("alive", "", "members of the flight believed alive, the pilot included",
           [](const State& s) { return double(std::popcount(s.alive)); }),
    number("lost", "", "members of the flight believed lost",
           [](const State& s) { return double(s.lost); }),
    flag("leads", "the own rank is the first", [](const State& s) -> double { return s.leads(); }),
    number("place_ahead", "m", "from here to the own place in the formation, along the own heading",
           of_lead([](const State& s, const team::Leader& l) { return to_place(s, l).x; })),
    number("place_right", "m", "likewise to the right",
           of_lead([](const State& s, const team::Leader& l) { return to_place(s, l).y; })),
    number("place_above", "m", "likewise up",
           of_lead([](const State& s, const team::Leader& l) { return -to_place(s, l).z; })),
    angle("lead_course",
          "of who is followed, from the own heading, in (-180°, 180°], positive right",
          of_lead([](const State& s, const team::Leader& l) {
            return right_of_nose(s, s.forward_of(l));
          })),
    number("lead_speed", "m/s", "of who is followed, over the ground",
           of_lead([](const State&, const team::Leader& l) { return norm(l.velocity); })),
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
    number("range", "m", "to the chosen target",
           of_target([](const State&, const Seen& t) { return t.range; })),
    number("closing", "m/s", "of the chosen target, positive if the range shrinks",
           of_target([](const State& s, const Seen& t) { return s.closing_on(t); })),
    angle("off_nose",
          "between the nose and the chosen target, up and down too: without a side, in [0, 180°]",
          of_target([](const State& s, const Seen& t) { return s.angles(t).off_nose; })),
    angle("off_tail", "of the chosen target, in [0, 180°]: 0 right behind him",
          of_target([](const State& s, const Seen& t) { return s.angles(t).off_tail; })),
    angle("crossing", "of the chosen target's path and the own one, in [0, 180°]",
          of_target([](const State& s, const Seen& t) { return s.angles(t).crossing; })),
    number("unseen", "s", "since an own eye saw the chosen target; none did: infinite",
           of_target([](const State& s, const Seen& t) {
             const double seen = t.track->seen_time;
             return seen == model::kNever ? std::numeric_limits<double>::infinity() : s.time - seen;
           })),
    number("target_above", "m", "altitude of the chosen target less the own",
           of_target([](const State& s, const Seen& t) {
             return altitude_of(s.own, t.ned) - s.own.altitude;
           })),
    number("target_age", "s", "since anything told of the chosen target",
           of_target([](const State& s, const Seen& t) { return s.time - t.track->time; })),
    number("target_altitude", "m", "of the chosen target",
           of_target([](const State& s, const Seen& t) { return altitude_of(s.own, t.ned); })),
    number("target_speed", "m/s", "of the chosen target, over the ground",
           of_target([](const State& s, const Seen& t) { return norm(s.velocity_of(t)); })),
    angle("target_climb", "of the chosen target's path above the horizon",
          of_target([](const State& s, const Seen& t) { return elevation_of(s.velocity_of(t)); })),
    angle("target_course",
          "of the chosen target from the own heading, in (-180°, 180°], positive right",
          of_target([](const State& s, const Seen& t) {
            return right_of_nose(s, bearing_of(s.velocity_of(t)));
          })),
    angle("target_aspect",
          "of this aircraft from the chosen target's course, in (-180°, 180°], positive on his "
          "right: 0 in front of him",
          of_target([](const State& s, const Seen& t) {
            return angle_between(bearing_of(s.velocity_of(t)), bearing_of(-t.ned));
          })),
    angle("target_right",
          "the chosen target off the own heading along the horizon, in (-180°, 180°], positive "
          "right",
          of_target(
              [](const State& s, const Seen& t) { return right_of_nose(s, bearing_of(t.ned)); })),
    angle("target_up", "the chosen target above the horizon",
          of_target([](const State&, const Seen& t) { return elevation_of(t.ned); })),
    angle("target_azimuth",
          "the chosen target off the nose in the plane of the wings, in (-180°, 180°], positive "
          "right",
          of_target([](const State& s, const Seen& t) { return s.line_of_sight(t).body.azimuth; })),
    angle(
        "target_elevation", "the chosen target out of the plane of the wings, positive up",
        of_target([](const State& s, const Seen& t) { return s.line_of_sight(t).body.elevation; })),
    number("drift_right", "rad/s", "at which the line of sight to the chosen target turns right",
           of_target([](const State& s, const Seen& t) { return s.line_of_sight(t).right; })),
    number("drift_up", "rad/s", "at which it turns up",
           of_target([](const State& s, const Seen& t) { return s.line_of_sight(t).up; })),
    number("over_r_max", "",
           "range of the chosen target over the longest r_max of the missiles on board; infinite "
           "if none reaches him",
           of_target(
               [](const State& s, const Seen& t) { return over(t.range, s.own_reach(t).r_max); })),
    number("over_r_ne", "", "the same over the longest r_ne",
           of_target(
               [](const State& s, const Seen& t) { return over(t.range, s.own_reach(t).r_ne); })),
    number("over_his_r_max", "",
           "range over the r_max of the farthest-reaching radar missile that he might have",
           of_target(
               [](const State& s, const Seen& t) { return over(t.range, s.reach_of(t).r_max); })),
    number(
        "over_his_r_ne", "", "the same over its r_ne",
        of_target([](const State& s, const Seen& t) { return over(t.range, s.reach_of(t).r_ne); })),
    flag("in_zone", "the chosen target is in the zone of a missile that may leave now",
         [](const State& s) -> double {
           return s.target() && s.own_reach(*s.target()).store.has_value();
         }),
    number("shots", "", "own missiles on their way to the chosen target",
           of_target([](const State& s, const Seen& t) {
             return static_cast<double>(s.agent.flying_at(t.id(), s.time));
           })),
    flag("supporting", "an own missile on its way needs the radar",
         [](const State& s) -> double { return support_needed(s); }),
    angle("gun_azimuth", "where to aim the gun at the chosen target, as target_azimuth",
          of_sight([](const State&, const Sight& g) { return g.body.azimuth; })),
    angle("gun_elevation", "likewise as target_elevation",
          of_sight([](const State&, const Sight& g) { return g.body.elevation; })),
    number("over_gun_range", "",
           "range of the chosen target over the farthest that the gun is good for",
           of_sight([](const State& s, const Sight& g) {
             return over(g.range, s.library.guns[*s.type.index.gun].greatest_range);
           })),
    flag("in_gun",
         "the gun is on the chosen target: in its range and its aim cone, with rounds left",
         [](const State& s) -> double { return in_gun(s); }),
    flag("threatened", "a missile is believed to come for this aircraft",
         [](const State& s) -> double { return s.threats.count > 0; }),
    number("missiles_inbound", "", "believed to come for this aircraft",
           [](const State& s) { return double(s.threats.count); }),
    angle("missile_right",
          "the missile to worry about off the own heading, in (-180°, 180°], positive right",
          of_missile([](const State& s, const model::InboundMissile& m) {
            return right_of_nose(s, m.bearing);
          })),
    number("missile_time", "s", "until it is here, if that is known",
           of_missile([](const State& s, const model::InboundMissile& m) {
             return time_to_go(s, m).value_or(kNoValue);
           })),
    flag("missile_heard",
         "the seeker of the missile that is here soonest has been heard: a radar's",
         [](const State& s) -> double {
           const auto* const soonest = inbound(s, std::numeric_limits<double>::infinity());
           return soonest && soonest->emitter;
         }),
    flag("spiked", "a radar tracks this aircraft",
         [](const State& s) -> double { return spike(s) != nullptr; }),
    angle("spike_right", "that radar off the own heading, in (-180°, 180°], positive right",
          of_spike([](const State& s, const model::RwrWarning& w) {
            return right_of_nose(s, w.bearing);
          })),
    number("missile_range", "m", "to the missile to worry about, if its range is known",
           of_missile([](const State&, const model::InboundMissile& m) {
             return m.has_position ? m.range : kNoValue;
           })),
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
