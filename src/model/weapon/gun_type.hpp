// SPDX-License-Identifier: MIT
#pragma once
/// \file  A type of gun: its rounds, how they fly and how well they are aimed.
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>

#include "core/describe.hpp"
#include "core/units.hpp"

namespace eyrie::model::weapon {

/// Const and shared by every aircraft that carries it. Fixed forward along the nose.
struct GunType {
  std::string label;
  std::uint32_t rounds = 500;
  double rate = 100;                 ///< Hz
  double muzzle_velocity = 1030;     ///< m/s
  double drag = 1e-3;                ///< m^2/kg, C_D A / m of a round
  double dispersion = 2.2e-3;        ///< rad, 1 sigma of each of two angles
  double aim_error = 2e-3;           ///< rad, 1 sigma, against a target that flies straight
  double maneuver_error = 0.3;       ///< part of its deflection that the sight does not predict
  double aim_cone = si(1.5, "deg");  ///< rad, from the nose: the pilot's fine aim
  double greatest_range = 1000;      ///< m
  double damage = 0.2;               ///< of one hit; 1 destroys
  double longest_burst = 1;          ///< s, a longer one is reported in parts

  static constexpr std::string_view type_name = "gun";
  static constexpr std::string_view help = "an aircraft's gun";
  static constexpr auto params() {
    using G = GunType;
    return std::tuple{
        param("label", &G::label, "name in the story").items(1, 40).required(),
        param("rounds", &G::rounds, range(1, 10000), "in the drum").required(),
        param("rate", &G::rate, "Hz", range(0.1, 200), "rounds per second").required(),
        param("muzzle_velocity", &G::muzzle_velocity, "m/s", range(100, 3000),
              "relative to the aircraft")
            .required(),
        param("drag", &G::drag, range(0, 0.1), "m2/kg: drag coefficient x area / mass of a round")
            .required(),
        param("dispersion", &G::dispersion, "rad", range(1e-5, 0.1),
              "one standard deviation of each of two angles, gun and mounting")
            .required(),
        param("aim_error", &G::aim_error, "rad", range(0, 0.1),
              "one standard deviation of the aim at a target that flies straight"),
        param("maneuver_error", &G::maneuver_error, range(0, 1),
              "which part of the target's acceleration the sight does not predict"),
        param("aim_cone", &G::aim_cone, "rad", range(0, 0.2),
              "the pilot corrects so much between the nose and the lead that is needed"),
        param("greatest_range", &G::greatest_range, "m", range(50, 5000),
              "nobody is aimed at beyond"),
        param("damage", &G::damage, range(0.001, 1), "of one hit; 1 destroys"),
        param("longest_burst", &G::longest_burst, "s", range(0.1, 10),
              "a longer burst is reported in parts")};
  }
};

}  // namespace eyrie::model::weapon
