// SPDX-License-Identifier: MIT
#pragma once
/// \file  Messages of DIS, IEEE 1278.1-2012: what they are made of, and to and from bytes. Section
/// numbers are the standard's. Lengths in m, speeds in m/s, angles in rad, world coordinates
/// Earth-centred and Earth-fixed (WGS-84), body coordinates x forward, y right, z down.
#include <optional>
#include <string>
#include <variant>

#include "core/enum_names.hpp"
#include "dis/wire.hpp"

namespace eyrie::dis {

/// UDP port at which simulations expect DIS.
inline constexpr std::uint16_t kPort = 3000;

/// 6.2.28: who, in all the exercise.
struct EntityId {
  std::uint16_t site = 0, application = 0, entity = 0;
  static void fields(auto& wire, auto& r) { wire(r.site, r.application, r.entity); }
  friend constexpr auto operator<=>(const EntityId&, const EntityId&) = default;
};
inline constexpr EntityId kNobody{};
inline constexpr EntityId kEverybody{0xFFFF, 0xFFFF, 0xFFFF};

/// 6.2.33: which shot, of all that an application tells of.
struct EventId {
  std::uint16_t site = 0, application = 0, number = 0;
  static void fields(auto& wire, auto& r) { wire(r.site, r.application, r.number); }
  friend constexpr auto operator<=>(const EventId&, const EventId&) = default;
};

/// 6.2.14: hours since 1970 and the fraction of the hour, as a timestamp.
struct ClockTime {
  std::uint32_t hour = 0, past = 0;
  static void fields(auto& wire, auto& r) { wire(r.hour, r.past); }
};

enum class Force : std::uint8_t { other, friendly, opposing, neutral };

/// UID 44 of SISO-REF-010; those of body coordinates are not reckoned.
enum class Reckoning : std::uint8_t { other, fixed, fpw, rpw, rvw, fvw };

/// 7.2.2: where somebody is, how it moves, and how it looks.
struct EntityState {
  static constexpr std::uint8_t kType = 1, kFamily = 1;
  struct Parameter {
    std::array<std::uint8_t, 16> bytes{};
    static void fields(auto& wire, auto& r) { wire(r.bytes); }
  };
  EntityId id;
  Force force = Force::other;
  model::EntityType type, other_type;
  Vec3f velocity{};
  Vec3 location;
  Vec3f orientation{};           ///< psi, theta, phi
  std::uint32_t appearance = 0;  ///< see Appearance
  Reckoning reckoning = Reckoning::fixed;
  Vec3f acceleration{};  ///< m/s^2
  Vec3f spin{};          ///< rad/s, about the body's axes
  std::uint8_t character_set = 1;
  std::array<char, 11> marking{};
  std::uint32_t capabilities = 0;
  std::vector<Parameter> parameters;

  static void fields(auto& wire, auto& r) {
    wire(r.id, r.force);
    const auto count = wire.template count<std::uint8_t>(r.parameters);
    wire(r.type, r.other_type, r.velocity, r.location, r.orientation, r.appearance, r.reckoning);
    wire.zeros(15);
    wire(r.acceleration, r.spin, r.character_set, r.marking, r.capabilities);
    wire.list(r.parameters, count);
  }
};
/// Bits of EntityState::appearance that all platforms and munitions share.
enum Appearance : std::uint32_t {
  kDestroyed = 3u << 3,
  kFrozen = 1u << 21,
  kDeactivated = 1u << 23
};

/// 6.2.19.2: what was fired.
struct Munition {
  model::EntityType type;
  std::uint16_t warhead = 0, fuse = 0;
  std::uint16_t quantity = 1, rate = 0;  ///< rounds; rounds a minute
  static void fields(auto& wire, auto& r) { wire(r.type, r.warhead, r.fuse, r.quantity, r.rate); }
};

/// 7.3.2
struct Fire {
  static constexpr std::uint8_t kType = 2, kFamily = 2;
  EntityId shooter, target, munition;
  EventId event;
  std::uint32_t mission = 0;
  Vec3 location;
  Munition what;
  Vec3f velocity{};
  float range = 0;  ///< m, 0: unknown

  static void fields(auto& wire, auto& r) {
    wire(r.shooter, r.target, r.munition, r.event, r.mission, r.location, r.what, r.velocity,
         r.range);
  }
};

/// UID 62 of SISO-REF-010, those that we tell.
enum class Result : std::uint8_t {
  other = 0,
  impact = 1,          ///< of a round in the target
  proximate = 2,       ///< killed by a warhead beside it
  ground_impact = 3,   ///< flew into the ground
  fly_out_miss = 31,   ///< ended on its way
  end_game_miss = 32,  ///< its fuze worked, and nobody was killed
};

/// 7.3.3
struct Detonation {
  static constexpr std::uint8_t kType = 3, kFamily = 2;
  EntityId shooter, target, munition;
  EventId event;  ///< of the Fire
  Vec3f velocity{};
  Vec3 location;
  Munition what;
  Vec3f place{};  ///< body coordinates of the target
  Result result = Result::other;
  std::vector<EntityState::Parameter> parameters;

  static void fields(auto& wire, auto& r) {
    wire(r.shooter, r.target, r.munition, r.event, r.velocity, r.location, r.what, r.place,
         r.result);
    const auto count = wire.template count<std::uint8_t>(r.parameters);
    wire.zeros(2);
    wire.list(r.parameters, count);
  }
};

/// UID 78 of SISO-REF-010, those that we tell.
enum class BeamFunction : std::uint8_t {
  search = 1,
  tracking = 4,
  acquisition_and_tracking = 5,
  missile_seeker = 11,
  jamming = 12,
};

/// 7.6.2: what somebody radiates.
struct Emission {
  static constexpr std::uint8_t kType = 23, kFamily = 6;
  /// 6.2.98: who is tracked or jammed.
  struct Target {
    EntityId who;
    std::uint8_t emitter = 0, beam = 0;  ///< of it, if it is jammed
    static void fields(auto& wire, auto& r) { wire(r.who, r.emitter, r.beam); }
    friend bool operator==(const Target&, const Target&) = default;
  };
  struct Beam {
    std::uint8_t number = 1;
    std::uint16_t parameters = 0;
    float frequency = 0, frequency_range = 0;  ///< Hz
    float power = 0;                           ///< dBm, effective radiated
    float repetition = 0;                      ///< Hz
    float pulse_width = 0;                     ///< us
    float azimuth = 0, azimuth_sweep = 0;      ///< rad, body; half of the sweep
    float elevation = 0, elevation_sweep = 0;  ///< likewise
    float sync = 0;                            ///< % of the sweep
    BeamFunction function = BeamFunction::search;
    std::uint8_t crowded = 0;                 ///< 1: it tracks more than are listed
    std::uint8_t off = 0;                     ///< 1: it has been switched off
    std::array<std::uint8_t, 4> technique{};  ///< of jamming
    std::vector<Target> targets;

    static void fields(auto& wire, auto& r) {
      const auto mark = wire.begin();
      wire(r.number, r.parameters, r.frequency, r.frequency_range, r.power, r.repetition,
           r.pulse_width, r.azimuth, r.azimuth_sweep, r.elevation, r.elevation_sweep, r.sync,
           r.function);
      const auto count = wire.template count<std::uint8_t>(r.targets);
      wire(r.crowded, r.off, r.technique);
      wire.list(r.targets, count);
      wire.end(mark);
    }
  };
  struct System {
    std::uint16_t name = 0;     ///< UID 75 of SISO-REF-010
    std::uint8_t function = 0;  ///< UID 76
    std::uint8_t number = 1;    ///< of this entity
    Vec3f location{};
    std::vector<Beam> beams;

    static void fields(auto& wire, auto& r) {
      const auto mark = wire.begin();
      const auto count = wire.template count<std::uint8_t>(r.beams);
      wire.zeros(2);
      wire(r.name, r.function, r.number, r.location);
      wire.list(r.beams, count);
      wire.end(mark);
    }
  };
  EntityId emitter;
  EventId event;
  std::uint8_t changed = 1;  ///< 0: said again as it was
  std::vector<System> systems;

  static void fields(auto& wire, auto& r) {
    wire(r.emitter, r.event, r.changed);
    const auto count = wire.template count<std::uint8_t>(r.systems);
    wire.zeros(2);
    wire.list(r.systems, count);
  }
};

/// 7.5.4
struct StartResume {
  static constexpr std::uint8_t kType = 13, kFamily = 5;
  EntityId from, to;
  ClockTime real, simulated;
  std::uint32_t request = 0;
  static void fields(auto& wire, auto& r) { wire(r.from, r.to, r.real, r.simulated, r.request); }
};

/// 7.5.5
struct StopFreeze {
  static constexpr std::uint8_t kType = 14, kFamily = 5;
  EntityId from, to;
  ClockTime real;
  std::uint8_t reason = 0;  ///< 2: the run is over
  std::uint8_t frozen = 0;  ///< what goes on while it is frozen
  std::uint32_t request = 0;
  static void fields(auto& wire, auto& r) {
    wire(r.from, r.to, r.real, r.reason, r.frozen);
    wire.zeros(2);
    wire(r.request);
  }
};

/// 7.5.6
struct Acknowledge {
  static constexpr std::uint8_t kType = 15, kFamily = 5;
  EntityId from, to;
  std::uint16_t what = 0, response = 0;
  std::uint32_t request = 0;
  static void fields(auto& wire, auto& r) { wire(r.from, r.to, r.what, r.response, r.request); }
};

/// 6.2.37 and 6.2.93: a number of 32 bits, or bytes, under the number of what it means.
struct FixedDatum {
  std::uint32_t id = 0, value = 0;
  static void fields(auto& wire, auto& r) { wire(r.id, r.value); }
};
struct VariableDatum {
  std::uint32_t id = 0;
  std::string text;
  static void fields(auto& wire, auto& r) {
    wire(r.id);
    wire.text(r.text);
  }
};
struct Datums {
  std::vector<FixedDatum> fixed;
  std::vector<VariableDatum> variable;
  static void fields(auto& wire, auto& r) {
    const auto fixed = wire.template count<std::uint32_t>(r.fixed);
    const auto variable = wire.template count<std::uint32_t>(r.variable);
    wire.list(r.fixed, fixed);
    wire.list(r.variable, variable);
  }
};

/// 7.5.11
struct Data {
  static constexpr std::uint8_t kType = 20, kFamily = 5;
  EntityId from, to;
  std::uint32_t request = 0;
  Datums datums;
  static void fields(auto& wire, auto& r) {
    wire(r.from, r.to, r.request);
    wire.zeros(4);
    wire(r.datums);
  }
};

/// 7.5.13
struct Comment {
  static constexpr std::uint8_t kType = 22, kFamily = 5;
  EntityId from, to;
  Datums datums;
  static void fields(auto& wire, auto& r) { wire(r.from, r.to, r.datums); }
};

using Pdu = std::variant<EntityState, Fire, Detonation, Emission, StartResume, StopFreeze,
                         Acknowledge, Data, Comment>;

/// 6.2.66, with the PDU itself.
struct Packet {
  std::uint8_t version = 7, exercise = 1;
  std::uint32_t timestamp = 0;  ///< see timestamp_at()
  std::uint8_t status = 0;
  Pdu pdu;
};

/// s since the full hour as a timestamp: 2^31 units an hour, relative to the sender's own clock.
[[nodiscard]] constexpr std::uint32_t timestamp_at(double seconds) {
  const double hour = seconds / 3600;
  const double part = hour - static_cast<double>(static_cast<std::uint64_t>(hour));
  return static_cast<std::uint32_t>(part * 2147483648.0 + 0.5) << 1;
}

[[nodiscard]] std::vector<std::byte> encode(const Packet& packet);

/// Why something that came in is not used.
enum class Unused : std::uint8_t {
  truncated,    ///< shorter than it says
  version,      ///< neither 6 nor 7
  kind,         ///< a PDU that is not read
  malformed,    ///< its parts do not have the length of the whole
  exercise,     ///< of another exercise
  own,          ///< what we sent ourselves, or somebody under our number
  twice,        ///< it was there before
  late,         ///< a newer one was there before
  implausible,  ///< no number, or nowhere near the place of the scenario
  crowded,      ///< more entities, or applications, than can be
  no_place,     ///< an entity that is nobody of the scenario, and no place is left for it
};
constexpr auto names_of(Unused) {
  return names_from_zero<Unused>("truncated", "version", "kind", "malformed", "exercise", "own",
                                 "twice", "late", "implausible", "crowded", "no_place");
}

struct Decoded {
  Packet packet;                    ///< whole if nothing was refused
  std::optional<Unused> refusal{};  ///< truncated, version, kind or malformed
  std::size_t length = 0;  ///< bytes up to the next PDU of the datagram; 0: nothing more is there
};
/// Reads the first PDU of a datagram. Any bytes may come.
[[nodiscard]] Decoded decode(std::span<const std::byte> bytes);

}  // namespace eyrie::dis
