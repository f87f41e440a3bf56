// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a player radiates: written in act, heard by the warning receivers of the next step.
#include "model/fit.hpp"

namespace eyrie::model {

enum class EmissionKind : std::uint8_t { none, search, track, missile_seeker };
constexpr auto names_of(EmissionKind) {
  return names_from_zero<EmissionKind>("none", "search", "track", "missile_seeker");
}

/// The beam of one aircraft's radar or of one missile's seeker, and its jammer. A search radar is
/// described by the whole sector it sweeps, in azimuth and elevation: it passes everything in there
/// once per frame.
struct Emission {
  Vec3 position{};            ///< m, local frame: where the transmitter was
  Vec3 boresight{};           ///< unit vector, local frame: the middle of the beam or sector
  Vec3 down{};                ///< unit vector, local frame, that a sector is level to; 0: a beam
  double cos_half_angle = 1;  ///< a beam is this cone around the boresight, a sector so wide
  double sin_low = -1;        ///< of the lowest elevation of a sector
  double sin_high = 1;        ///< and of the highest
  double figure = 0;          ///< m, see emission_figure()
  double jamming = 0;         ///< W/Hz, of the aircraft's jammer, in all directions
  PlayerId dwell{};           ///< who the beam rests on (truth); none while searching
  std::uint16_t type = 0;     ///< index of the radar, or of the missile type, in the Library
  EmissionKind kind = EmissionKind::none;
  Side side = Side::none;  ///< whose waveform it is

  static constexpr auto fields() {
    return field_list(field("position", &Emission::position, "m"),
                      field("boresight", &Emission::boresight), field("down", &Emission::down),
                      field("cos_half_angle", &Emission::cos_half_angle),
                      field("sin_low", &Emission::sin_low), field("sin_high", &Emission::sin_high),
                      field("figure", &Emission::figure, "m"), field("jamming", &Emission::jamming),
                      field("dwell", &Emission::dwell), field("type", &Emission::type),
                      field("kind", &Emission::kind), field("side", &Emission::side));
  }
};

/// How far a receiver with the sensitivity and the antenna gain of the radar's own would hear it,
/// in metres, for a radar that just detects `reference_rcs` (m^2) at `reference_range` (m): the
/// one-way and the two-way range equation divided by each other,
///   R1^2 / R2^4 = 4 pi / sigma   =>   R1 = R2^2 sqrt(4 pi / sigma).
/// Wiley, ELINT: The Interception and Analysis of Radar Signals (2006), ch. 2 (range advantage).
[[nodiscard]] inline double emission_figure(double reference_range, double reference_rcs) {
  return reference_range * reference_range * std::sqrt(4 * kPi / reference_rcs);
}

}  // namespace eyrie::model
