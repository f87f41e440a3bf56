// SPDX-License-Identifier: MIT
#pragma once
/// \file  A gun: its type, what it remembers, how its rounds fly and how likely they are to hit.
#include "model/entity_type.hpp"
#include "model/kinematics.hpp"
#include "model/signature.hpp"

namespace eyrie::model::weapon {

/// Rounds left and the burst that is being fired.
struct GunState {
  double owed = 0;                 ///< rounds, the part of one that a step of firing left over
  double burst_range = 0;          ///< m, to who it is at, when he came into the sight
  std::uint32_t rounds = 0;        ///< left in the drum
  std::uint32_t burst_rounds = 0;  ///< fired so far in this burst; 0: not firing
  std::uint32_t burst_hits = 0;    ///< of these, how many hit
  PlayerId burst_target{};         ///< who came into the sight first; none if nobody

  static constexpr auto fields() {
    return field_list(
        field("owed", &GunState::owed), field("burst_range", &GunState::burst_range, "m"),
        field("rounds", &GunState::rounds), field("burst_rounds", &GunState::burst_rounds),
        field("burst_hits", &GunState::burst_hits), field("burst_target", &GunState::burst_target));
  }
};

/// Const and shared by every aircraft that carries it. Fixed forward along the nose.
struct GunType {
  std::string label;
  std::string entity_type = "2.9";  ///< see EntityType, of a round
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
    return Lines{
        param("label", &G::label, "name in the story").items(1, 40).required(),
        param("entity_type", &G::entity_type,
              "SISO-REF-010 number by which other simulations know its rounds")
            .items(3, 27),
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
        param("aim_cone", &G::aim_cone, "rad", range(0, 12, "deg"),
              "the pilot corrects so much between the nose and the lead that is needed"),
        param("greatest_range", &G::greatest_range, "m", range(50, 5000),
              "nobody is aimed at beyond"),
        param("damage", &G::damage, range(0.001, 1), "of one hit; 1 destroys"),
        param("longest_burst", &G::longest_burst, "s", range(0.1, 10),
              "a longer burst is reported in parts")};
  }
};

/// A full drum.
[[nodiscard]] GunState loaded(const GunType& gun);

/// s, of a round over `distance` m through still air of `density` kg/m^3 from `speed` m/s: with
/// quadratic drag v = v0 exp(-k x) and t = (exp(k x) - 1) / (k v0), k = density C_D A / (2 m).
/// McCoy, Modern Exterior Ballistics, 2nd ed., ch. 5 (flat fire, constant drag coefficient).
[[nodiscard]] double time_of_flight(const GunType& gun, double density, double speed,
                                    double distance);

/// Where to shoot at a target.
struct Lead {
  Vec3 direction{1, 0, 0};  ///< unit vector: where the bore must point
  double range = 0;         ///< m, to the target now
  double flight_time = 0;   ///< s
  double off_bore = 0;      ///< rad, between `direction` and the nose
};
/// The lead on a target that keeps its velocity, gravity drop of the round included.
[[nodiscard]] Lead lead_on(const GunType& gun, double density, const Kinematics& own,
                           const Vec3& nose, const Kinematics& target);

/// The chance that one round hits. Aim and dispersion are circular normal errors, so a round passes
/// within r of the aim point with probability 1 - exp(-r^2 / (2 sigma^2)) (Rayleigh; Driels,
/// Weaponeering, ch. 3); r is that of a disk as big as the target's silhouette. What the sight does
/// not predict of the target's acceleration adds a t^2 / 2 to the aim error. Nothing beyond the
/// greatest range or when the nose is farther off than the pilot's fine aim.
[[nodiscard]] double hit_probability(const GunType& gun, const Lead& lead, const Signature& size,
                                     const Kinematics& target);

/// Rounds that leave in a step of `dt` s while the trigger is pressed; counts them.
[[nodiscard]] std::uint32_t fire(const GunType& gun, double dt, GunState& state);

}  // namespace eyrie::model::weapon
