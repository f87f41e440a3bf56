// SPDX-License-Identifier: MIT
#pragma once
/// \file  The three defenses against a radar missile and who shoots it: notch, drag, last ditch.
#include "pilot/danger.hpp"
#include "pilot/fight.hpp"
#include "ubf/memory.hpp"

namespace eyrie::pilot {

struct EvadeMemory {
  double until = 0;    ///< s, goes on until then if nothing is heard of the danger again
  double bearing = 0;  ///< rad, of the danger when it was last known
  double began = 0;    ///< m, its altitude when it began
  Call call = Call::none;
  std::int32_t side =
      0;  ///< 1: the danger is kept to the left, -1: to the right; 0: not yet chosen
};

/// How one of the three is flown when a file says nothing else.
struct Evasion {
  std::string_view name, help;
  Call call = Call::none;  ///< when it answers a missile
  Against against = Against::missile;
  float vote = 75;
  double within = 8;        ///< s
  double angle = kPi / 2;   ///< rad
  double load_factor = 6;   ///< g
  double least_mach = 0.7;  ///< 0: turns as hard as it can
  double recovery = 2;      ///< s
  double slack = 0;         ///< rad, that the bearing of a radar may be off before somebody turns
  model::Dispense dispense = model::Dispense::none;
  bool across = false;  ///< turns through the danger's bearing instead of away from it
};

/// Turns until the danger is `angle` off the nose, on the nearer side, which it keeps until the
/// danger is gone, and goes down: a radar below its hunter is harder to see, and thicker air costs
/// a missile speed. Never slower than `least_mach` allows, never below `floor`. `running` as long
/// as it defends; fails without a danger. Answers a missile that comes for this aircraft, and is
/// here `within` s; with `against: radar` or `fighter` also who may shoot one.
template <const Evasion& kDefault>
class Evade final : public ubf::WithMemory<Maneuver, EvadeMemory> {
 public:
  static constexpr std::string_view type_name = kDefault.name;
  static constexpr std::string_view help = kDefault.help;
  static constexpr auto params() {
    using E = Evade;
    return joined(
        Maneuver::params(),
        Lines{
            param("against", &E::against_, "missile, radar or fighter; each includes those before"),
            param("within", &E::within_, "s", range(0, 120),
                  "answers a missile that is here so soon"),
            param("angle", &E::angle_, "rad", range(10, 180, "deg"),
                  "off the nose at the end of the turn"),
            param("dive", &E::dive_, "m", range(0, 15e3),
                  "goes down by so much from where it began"),
            param("dispense", &E::dispense_,
                  "none, chaff, flares or both: thrown out at a missile that is here within 6 s"),
            param("recovery", &E::recovery_, "s", range(0, 300),
                  "goes on for so long after the last of the danger")});
  }

  Evade() {
    this->vote_ = kDefault.vote;
    this->load_factor_ = kDefault.load_factor;
    this->least_mach_ = kDefault.least_mach;
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  Against against_ = kDefault.against;
  double within_ = kDefault.within;
  double angle_ = kDefault.angle;
  double dive_ = si(6000, "ft");
  double recovery_ = kDefault.recovery;
  model::Dispense dispense_ = kDefault.dispense;
};

/// The danger on the beam: the closing speed to its radar is that of the ground then, and a radar
/// that looks down filters it out with the clutter (docs/models/radar.md, Doppler notch).
inline constexpr Evasion kNotch{.name = "notch",
                                .help = "puts a missile or a radar on the beam, nose low",
                                .call = Call::notch,
                                .dispense = model::Dispense::chaff};
/// The danger on the tail: a missile has to catch up, and one shot from far runs out of speed.
inline constexpr Evasion kDrag{.name = "drag",
                               .help = "puts a missile or a fighter on the tail and runs, nose low",
                               .call = Call::drag,
                               .vote = 72,
                               .within = 20,
                               .angle = kPi,
                               .load_factor = 5,
                               .recovery = 4,
                               .slack = si(15, "deg")};  // a receiver's bearing is good to 10
/// The hardest turn through the missile's bearing, when it is almost here: it has to turn with
/// several times the load factor and has no time (Shaw, Fighter Combat, ch. 1, missile defense).
inline constexpr Evasion kLastDitch{.name = "last_ditch",
                                    .help = "breaks across a missile that is almost here",
                                    .call = Call::last_ditch,
                                    .vote = 85,
                                    .within = 4,
                                    .load_factor = 9,
                                    .least_mach = 0,
                                    .recovery = 1,
                                    .dispense = model::Dispense::both,
                                    .across = true};

using Notch = Evade<kNotch>;
using Drag = Evade<kDrag>;
using LastDitch = Evade<kLastDitch>;
extern template class Evade<kNotch>;
extern template class Evade<kDrag>;
extern template class Evade<kLastDitch>;

}  // namespace eyrie::pilot
