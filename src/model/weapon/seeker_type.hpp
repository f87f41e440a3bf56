// SPDX-License-Identifier: MIT
#pragma once
/// \file  The sensor in the nose of a missile: what it can see and how well.
#include "core/describe.hpp"

namespace eyrie::model::weapon {

enum class SeekerKind : std::uint8_t {
  radar,     ///< active: measures angles, range and closing speed; heard by warning receivers
  infrared,  ///< measures angles only; must be locked on before launch
};
constexpr auto names_of(SeekerKind) {
  return names_from_zero<SeekerKind>("radar", "infrared");
}

/// Const. Angles in radians, everything else SI.
struct SeekerType {
  SeekerKind kind = SeekerKind::radar;
  double detection_range = 15e3;           ///< m, at the reference signature
  double reference_signature = 5;          ///< m^2 (radar) or W/sr (infrared)
  double greatest_range = 40e3;            ///< m, however bright the target
  double activation_range = 15e3;          ///< m, to the believed target: switch on
  double field_of_view = si(6, "deg");     ///< rad, whole cone in which it searches
  double gimbal = si(50, "deg");           ///< rad, off the axis of the missile
  double greatest_rate = si(30, "deg/s");  ///< rad/s, of the line of sight, that it can follow
  double look_rate = 50;                   ///< Hz
  double angle_noise = 1e-3;               ///< rad, 1 sigma of each of two angles in one look, near
  double glint = 0;            ///< m, 1 sigma: how far the target's apparent center wanders
  double glint_time = 0.1;     ///< s, in which it does
  double range_noise = 10;     ///< m, 1 sigma (radar)
  double closing_noise = 2;    ///< m/s, 1 sigma (radar)
  double filter_time = 0.1;    ///< s, time constant of the line-of-sight filter
  double memory = 5;           ///< s without seeing anything before it destroys itself
  double notch_speed = 50;     ///< m/s (radar): slower along the line of sight is clutter
  double range_gate = 150;     ///< m (radar): nearer to each other than half of it is one echo
  double doppler_gate = 30;    ///< m/s (radar): of a speed, the same
  double decoy_rejection = 0;  ///< chance that a decoy is known as one

  static constexpr std::string_view type_name = "seeker";
  static constexpr std::string_view help = "the sensor of a missile";
  static constexpr auto params() {
    using S = SeekerType;
    return Lines{
        param("kind", &S::kind, "radar (active) or infrared").required(),
        param("detection_range", &S::detection_range, "m", positive(500e3),
              "detection range of the reference signature")
            .required(),
        param("reference_signature", &S::reference_signature, positive(1e6),
              "m2 of radar cross section, or W/sr in its infrared band")
            .required(),
        param("greatest_range", &S::greatest_range, "m", positive(500e3),
              "it sees nothing farther away, however bright"),
        param("activation_range", &S::activation_range, "m", range(0, 500e3),
              "radar: switches on when the target is believed to be this near"),
        param("field_of_view", &S::field_of_view, "rad", range(0.05, 180, "deg"),
              "whole angle of the cone that it searches around the expected direction"),
        param("gimbal", &S::gimbal, "rad", range(0.5, 180, "deg"),
              "greatest angle between the missile's axis and the line of sight"),
        param("greatest_rate", &S::greatest_rate, "rad/s", positive(si(6000, "deg/s")),
              "fastest turn of the line of sight that it can follow"),
        param("look_rate", &S::look_rate, "Hz", positive(1000), "measurements per second"),
        param("angle_noise", &S::angle_noise, "rad", range(0, 1),
              "one standard deviation of each angle in one look at a signal 20 dB above "
              "detection or more; farther away it grows with the square of range"),
        param("glint", &S::glint, "m", range(0, 100),
              "one standard deviation of the target's apparent center along each of two axes"),
        param("glint_time", &S::glint_time, "s", positive(60),
              "time in which the apparent center forgets where it was (correlation 1/e)"),
        param("range_noise", &S::range_noise, "m", range(0, 10e3),
              "radar: one standard deviation in one look"),
        param("closing_noise", &S::closing_noise, "m/s", range(0, 1000),
              "radar: one standard deviation in one look"),
        param("filter_time", &S::filter_time, "s", positive(60),
              "time constant of the filter behind the line-of-sight rate"),
        param("memory", &S::memory, "s", positive(600),
              "once it is on: destroys itself after seeing nothing for this long"),
        param("notch_speed", &S::notch_speed, "m/s", range(0, 1000),
              "radar, looking down: a target slower than this along the line of sight is clutter"),
        param(
            "range_gate", &S::range_gate, "m", range(0, 10e3),
            "radar: width of the gate around its target's range; chaff inside is one echo with it"),
        param("doppler_gate", &S::doppler_gate, "m/s", range(0, 1000),
              "radar: width of the gate around its target's closing speed"),
        param("decoy_rejection", &S::decoy_rejection, range(0, 1),
              "chance that it knows a flare, or chaff, for what it is")};
  }
};

}  // namespace eyrie::model::weapon
