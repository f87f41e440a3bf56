// SPDX-License-Identifier: MIT
#pragma once
/// \file  Chaff, flares and towed decoys: what a dispenser throws out, and how it looks to a
/// seeker.
#include "model/command.hpp"
#include "model/environment.hpp"
#include "model/weapon/seeker_type.hpp"

namespace eyrie::model::weapon {

/// Const. A dispenser with two kinds of cartridges. A cloud of chaff, and a flare, are points that
/// lose the speed of their aircraft with a time constant and then stand in the air (chaff) or fall
/// (flares): docs/models/countermeasures.md.
struct Dispenser {
  std::uint16_t chaff = 60, flares = 60;  ///< cartridges when loaded
  double interval = 0.5;                  ///< s, between two cartridges of a program
  double chaff_section = 60;              ///< m^2, once it has bloomed
  double chaff_bloom = 0.4;               ///< s, time constant
  double chaff_life = 8;                  ///< s: then it is too thin
  double chaff_slowing = 0.3;             ///< s, time constant of its speed
  double flare_intensity = 8000;          ///< W/sr, in the band of the seekers
  double flare_rise = 0.3;                ///< s, time constant
  double flare_life = 4;                  ///< s, burning time
  double flare_slowing = 2.4;             ///< s, time constant of its speed
  std::uint16_t towed = 0;                ///< decoys on a line when loaded; one is out at a time
  double tow_length = 100;                ///< m
  double towed_section = 50;              ///< m^2, of an echo as strong as what it sends back
  double tow_time = 10;                   ///< s, until the next is out

  static constexpr std::string_view type_name = "dispenser";
  static constexpr std::string_view help = "a dispenser of chaff, flares and towed decoys";
  static constexpr auto params() {
    using D = Dispenser;
    return Lines{
        param("chaff", &D::chaff, range(0, 1000), "cartridges of chaff when loaded"),
        param("flares", &D::flares, range(0, 1000), "flares when loaded"),
        param("interval", &D::interval, "s", range(0.02, 60),
              "between two cartridges as long as the pilot asks for them"),
        param("chaff_section", &D::chaff_section, "m2", range(0, 10e3),
              "radar cross section of a cloud that has bloomed"),
        param("chaff_bloom", &D::chaff_bloom, "s", positive(60), "time constant of its growth"),
        param("chaff_life", &D::chaff_life, "s", positive(600), "then it is too thin to matter"),
        param("chaff_slowing", &D::chaff_slowing, "s", positive(60),
              "time constant with which a cloud loses its aircraft's speed"),
        param("flare_intensity", &D::flare_intensity, range(0, 1e6),
              "W/sr in the infrared band of the seekers, at its brightest"),
        param("flare_rise", &D::flare_rise, "s", positive(60), "time constant of its ignition"),
        param("flare_life", &D::flare_life, "s", positive(600), "burning time"),
        param("flare_slowing", &D::flare_slowing, "s", positive(60),
              "time constant with which a flare loses its aircraft's speed"),
        param("towed", &D::towed, range(0, 100),
              "decoys on a line when loaded; one at a time is out, from the beginning"),
        param("tow_length", &D::tow_length, "m", positive(1000), "length of the line"),
        param("towed_section", &D::towed_section, "m2", range(0, 10e3),
              "radar cross section of an echo as strong as what the towed repeater sends back"),
        param("tow_time", &D::tow_time, "s", range(0, 600),
              "from the loss of a towed decoy until the next is out")};
  }
};

/// A cloud of chaff or a flare on its own.
struct Decoy {
  Vec3 position{};         ///< m, local frame, when it was thrown out
  Vec3 velocity{};         ///< m/s, of its aircraft then
  double time = 0;         ///< s
  std::uint64_t step = 0;  ///< of the world: names it among those of its aircraft
  Dispense kind = Dispense::none;
  std::uint8_t reserved[7] = {};

  static constexpr auto fields() {
    using D = Decoy;
    return field_list(field("position", &D::position, "m"), field("velocity", &D::velocity, "m/s"),
                      field("time", &D::time, "s"), field("step", &D::step),
                      field("kind", &D::kind), field("reserved", &D::reserved));
  }
};

inline constexpr std::size_t kMaxDecoys = 8;

/// What is left in the dispenser of one aircraft, and the last that it threw out.
struct Decoys {
  std::array<Decoy, kMaxDecoys> thrown{};  ///< a ring
  double ready_time = 0;                   ///< s: no cartridge before
  double tow_time = 0;                     ///< s: none is towed before
  std::uint16_t chaff = 0, flares = 0;     ///< cartridges left
  std::uint16_t next = 0;                  ///< place in the ring
  std::uint16_t towed = 0;                 ///< left, with that on the line

  static constexpr auto fields() {
    using D = Decoys;
    return field_list(field("thrown", &D::thrown), field("ready_time", &D::ready_time, "s"),
                      field("tow_time", &D::tow_time, "s"), field("chaff", &D::chaff),
                      field("flares", &D::flares), field("next", &D::next),
                      field("towed", &D::towed));
  }
};
[[nodiscard]] Decoys loaded(const Dispenser& dispenser);

/// How a decoy is at `time` (s): where, how fast, and how bright for its kind of seeker (m^2 or
/// W/sr); nothing when it is over. `down` is the unit vector along which a flare falls, `wind` the
/// velocity of the air (m/s, local frame): the drag ends at it.
struct DecoyNow {
  Vec3 position{};
  Vec3 velocity{};
  Vec3 acceleration{};  ///< m/s^2
  double signature = 0;
};
[[nodiscard]] std::optional<DecoyNow> decoy_at(const Dispenser& dispenser, const Decoy& decoy,
                                               const Vec3& down, const Vec3& wind, double time);

/// Throws out what is asked for, if the program is due and any is left: one of each kind. Bits of
/// Dispense that were thrown.
Dispense throw_out(const Dispenser& dispenser, Dispense wanted, const Vec3& position,
                   const Vec3& velocity, double time, std::uint64_t step, Decoys& decoys);

/// Whether a decoy and its aircraft are one echo, or one spot, to a seeker that rests on the
/// aircraft. A radar: in one range gate and one Doppler gate, and no faster on the way out of it
/// than gates are moved (kTurnInGate), which for chaff means an aircraft on the beam. An infrared
/// seeker: within its field of view.
struct Apart {
  Vec3 line{};          ///< unit vector from the seeker to the aircraft
  double range = 0;     ///< m, to the aircraft
  Vec3 offset{};        ///< m, from the aircraft to the decoy
  Vec3 slip{};          ///< m/s, velocity of the decoy less that of the aircraft
  Vec3 acceleration{};  ///< m/s^2, of the decoy
};
[[nodiscard]] bool merged(const SeekerType& seeker, const Apart& apart);

/// The chance that the seeker goes on with the decoy of two that are merged: the share of its power
/// in what the seeker sees, which is where the centroid of two unresolved sources lies (Schleher,
/// Electronic Warfare in the Information Age, ch. 4), times the chance that it does not reject it.
[[nodiscard]] double seduction(const SeekerType& seeker, double decoy, double aircraft);

/// m, from an aircraft that flies with `velocity` (m/s) to the decoy that it tows; nothing while
/// none is out.
[[nodiscard]] std::optional<Vec3> towed_at(const Dispenser& dispenser, const Decoys& decoys,
                                           const Vec3& velocity, double time);

/// An aircraft and the repeater behind it as one radar seeker has them: `apart` (m) from the seeker
/// to the aircraft, `offset` (m) from there to the decoy, cross sections in m^2. While they are in
/// one range gate and one beam it sees the centroid of their powers, and both; resolved, the
/// stronger.
struct TwoEchoes {
  Vec3 shift{};  ///< m, from the aircraft to where the seeker sees it
  double signature = 0;
};
[[nodiscard]] TwoEchoes seen_together(const SeekerType& seeker, const Vec3& apart,
                                      const Vec3& offset, double decoy, double aircraft);

}  // namespace eyrie::model::weapon
