// SPDX-License-Identifier: MIT
#include "pilot/policy/controls.hpp"

#include "pilot/gunnery.hpp"
#include "pilot/state.hpp"

namespace eyrie::pilot {
namespace {

using model::Dispense, model::Manual;

/// What is commanded, beyond the fields of Manual that say so.
constexpr std::uint16_t kTrigger = 1U << 9, kRelease = 1U << 10, kChaff = 1U << 11,
                        kFlares = 1U << 12;
constexpr std::uint16_t kVertical = Manual::kClimb | Manual::kAltitude;

constexpr double nowhere(const State&) {
  return 0;
}
template <Dispense what>
double dispenses(const State& s) {
  return (what != Dispense::flares && s.decoys.chaff > 0) ||
         (what != Dispense::chaff && s.decoys.flares > 0);
}
/// 1 and the index of the missile that a release would take; 0 if none would reach.
double store_to_release(const State& s) {
  const Seen* target = s.target();
  const auto store = target && target->hostile() ? s.own_reach(*target).store : std::nullopt;
  return store ? *store + 1 : 0;
}
/// As shoot_gun with its defaults would fire.
double gun_bears(const State& s) {
  const Seen* target = s.target();
  return target && target->hostile() && in_gun(s) &&
         !friend_in_line(s, {.direction = s.gun_sight(*target)->aim,
                             .to = target->range + 1000,
                             .half_angle = radians(3)});
}
template <Dispense what>
void dispense(double, double on, Manual& m) {
  if (on > 0) {
    m.dispense =
        static_cast<Dispense>(static_cast<unsigned>(m.dispense) | static_cast<unsigned>(what));
    m.said |= Manual::kDispense;
  }
}
void say(Manual& m, Manual::Field field, float Manual::*member, double value) {
  m.*member = static_cast<float>(value);
  m.said |= field;
}

constexpr double kSteepest = radians(90);

void turn_to(double from, double x, Manual& m) {
  say(m, Manual::kHeading, &Manual::heading, wrap_pi(from + x));
}
void climb_by(double from, double x, Manual& m) {
  say(m, Manual::kClimb, &Manual::climb, std::clamp(from + x, -kSteepest, kSteepest));
}
void climb_to(double from, double x, Manual& m) {
  say(m, Manual::kAltitude, &Manual::altitude, from + x);
}

constexpr std::array kTypes = std::to_array<ControlType>({
    {"turn", "heading to fly, from the own one, positive right", Manual::kHeading,
     [](const State& s) { return s.own.heading; }, turn_to, "rad", -kPi, kPi},
    {"heading", "true heading to fly", Manual::kHeading, nowhere,
     [](double, double x, Manual& m) { say(m, Manual::kHeading, &Manual::heading, x); }, "rad",
     -kPi, kPi},
    {"climb", "direction to fly to above the horizon, whichever way up, as the mode aim", kVertical,
     nowhere, [](double, double x, Manual& m) { say(m, Manual::kClimb, &Manual::climb, x); }, "rad",
     -kSteepest, kSteepest},
    {"pull", "the same from the own direction of flight, positive up", kVertical,
     [](const State& s) { return s.own.pitch; }, climb_by, "rad", -kSteepest, kSteepest},
    {"aim_right",
     "heading to fly, from that of the line to the target (inside the gun's reach: to where its "
     "rounds would meet him), positive right; without a target from the own one",
     Manual::kHeading, [](const State& s) { return s.aim().azimuth; }, turn_to, "rad", -kPi,
     kPi},
    {"aim_up", "direction to fly to above the horizon, from that line, positive up", kVertical,
     [](const State& s) { return s.aim().elevation; }, climb_by, "rad", -kSteepest,
     kSteepest},
    {"altitude", "to fly", kVertical, nowhere, climb_to, "m", 0, 25e3},
    {"altitude_change", "altitude to fly, from the own one", kVertical,
     [](const State& s) { return s.own.altitude; }, climb_to, "m", -25e3, 25e3},
    {"speed", "true airspeed to fly", Manual::kSpeed, nowhere,
     [](double, double x, Manual& m) { say(m, Manual::kSpeed, &Manual::speed, x); }, "m/s", 50,
     1000},
    {"speed_change", "true airspeed to fly, from the own one", Manual::kSpeed,
     [](const State& s) { return s.own.speed; },
     [](double from, double x, Manual& m) {
       say(m, Manual::kSpeed, &Manual::speed, std::max(from + x, 50.0));
     },
     "m/s", -500, 500},
    {"load_factor", "g, the most that turning may use", Manual::kLoadFactor, nowhere,
     [](double, double x, Manual& m) { say(m, Manual::kLoadFactor, &Manual::load_factor, x); }, "",
     1, 12},
    {"trigger", "presses the trigger of the gun", kTrigger,
     [](const State& s) -> double { return s.gun.rounds > 0 && s.type.index.gun; },
     [](double, double on, Manual& m) { m.trigger = on > 0 ? 1 : 0; }},
    {"shoot",
     "presses the trigger if the target is hostile, within the gun's reach and in its cone of aim, "
     "and no friend is in the line of fire",
     kTrigger, gun_bears,
     [](double bears, double on, Manual& m) { m.trigger = on > 0 && bears > 0 ? 1 : 0; }},
    {"release",
     "releases a missile at the target, if it is hostile and in the zone of one that may leave "
     "now: of these the one of the shortest reach",
     kRelease, store_to_release,
     [](double store, double on, Manual& m) {
       if (on > 0)
         m.store = static_cast<std::uint8_t>(store);
     }},
    {"radar", "the radar radiates", Manual::kRadar,
     [](const State& s) -> double { return s.type.index.radar.has_value(); },
     [](double, double on, Manual& m) {
       m.radar_off = on > 0 ? 0 : 1;
       m.said |= Manual::kRadar;
     }},
    {"chaff", "throws out chaff by the dispenser's program", kChaff, dispenses<Dispense::chaff>,
     dispense<Dispense::chaff>},
    {"flares", "throws out flares by the dispenser's program", kFlares, dispenses<Dispense::flares>,
     dispense<Dispense::flares>},
    {"dispense", "throws out both", kChaff | kFlares, dispenses<Dispense::both>,
     dispense<Dispense::both>},
});
constexpr auto kNames = [] {
  std::array<std::string_view, kTypes.size()> names{};
  for (std::size_t i = 0; i < names.size(); ++i)
    names[i] = kTypes[i].name;
  return names;
}();

std::optional<Control> read_control(LayoutLine& line) {
  const std::string_view name = line.word();
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end())
    return line.fail(
        fmt::format("there is no control {}{}", quote(name), did_you_mean(name, kNames)));
  Control control{.type = static_cast<std::uint32_t>(found - kNames.begin())};
  const ControlType& type = control.info();
  if (type.is_flag())
    return line.end() ? std::optional(control) : std::nullopt;
  const auto range = line.range(type.unit.dimension);
  if (!range)
    return std::nullopt;
  std::tie(control.low, control.high) = *range;
  if (control.low < type.least || control.high > type.most)
    return line.fail(fmt::format("{}: the range must be within {} to {}", name,
                                 exact_quantity(type.least, type.unit.dimension),
                                 exact_quantity(type.most, type.unit.dimension)));
  if (const std::string_view shape = line.word(); !shape.empty()) {
    if (shape != "cubic")
      return line.fail(
          fmt::format("expected 'cubic' or the end of the line, got {}", quote(shape)));
    control.cubic = true;
  }
  return line.end() ? std::optional(control) : std::nullopt;
}

}  // namespace

std::span<const ControlType> control_types() {
  return kTypes;
}

double Control::value(float unit) const {
  const double given = static_cast<double>(unit);
  const double x = cubic ? given * given * given : given;
  return info().is_flag() ? (x > 0 ? 1 : 0) : from_unit(x, low, high);
}

std::optional<Control> Control::read(LayoutLine& line, std::span<const Control> before) {
  const auto control = read_control(line);
  for (const Control& other : before)
    if (control && (other.info().commands & control->info().commands) != 0)
      line.fail(
          fmt::format("{} commands what {} commands", control->info().name, other.info().name));
  return control;
}

std::string Control::text() const {
  std::string text(info().name);
  if (!info().is_flag())
    text += ' ' + range_text(low, high, info().unit.dimension);
  return cubic ? text + " cubic" : text;
}

Controls::Start Controls::start(const State& state) const {
  Start start;
  if (const Seen* target = state.target())
    start.target = target->id();
  for (std::size_t i = 0; i < size(); ++i)
    start.from[i] = items()[i].info().from(state);
  return start;
}

Manual Controls::apply(const Start& start, std::span<const float> units) const {
  EYRIE_DEMAND(units.size() >= size(), "a number for each control");
  Manual manual{.target = start.target, .seat = model::Seat::person};
  if (start.target)
    manual.said |= Manual::kTarget;
  for (std::size_t i = 0; i < size(); ++i)
    if (!std::isnan(units[i]))
      items()[i].info().apply(start.from[i], items()[i].value(units[i]), manual);
  return manual;
}

void Controls::mask(const Start& start, std::uint8_t* out) const {
  for (std::size_t i = 0; i < size(); ++i)
    out[i] = !items()[i].info().is_flag() || start.from[i] > 0 ? 1 : 0;
}

}  // namespace eyrie::pilot
