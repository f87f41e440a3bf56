// SPDX-License-Identifier: MIT
#pragma once
/// \file  A type of missile, and the rows of one that flies.
#include "model/entity_type.hpp"
#include "model/fit.hpp"
#include "model/kinematics.hpp"
#include "model/track.hpp"
#include "model/weapon/launch_zone.hpp"
#include "model/weapon/seeker_type.hpp"

namespace eyrie::model::weapon {

/// Mass and thrust over the time since launch. The motor burns until the last breakpoint of thrust.
struct Motor {
  Table1 mass = Table1::constant(100);  ///< kg, the whole missile
  Table1 thrust;                        ///< N at sea level
  double nozzle_area = 0;               ///< m^2, thrust grows by (p0 - p) times this

  [[nodiscard]] double launch_mass() const { return mass(0); }
  [[nodiscard]] double burnout_mass() const { return mass.values().back(); }
  [[nodiscard]] double burn_time() const { return thrust.breakpoints().back(); }
  /// N s at sea level: exact for a table that is linear between breakpoints.
  [[nodiscard]] double total_impulse() const;
  /// s, of the propellant at sea level: total impulse / (g0 * mass burnt).
  [[nodiscard]] double specific_impulse() const;
  /// m/s, without drag and gravity (Tsiolkovsky).
  [[nodiscard]] double ideal_speed_gain() const;

  static constexpr std::string_view type_name = "motor";
  static constexpr std::string_view help = "mass and thrust over the time since launch";
  static constexpr auto params() {
    return Lines{
        param("mass", &Motor::mass, axis("time", "s"), "kg", positive(20e3), "the whole missile")
            .required(),
        param("thrust", &Motor::thrust, axis("time", "s"), "N", range(0, 2e6), "at sea level")
            .required(),
        param("nozzle_area", &Motor::nozzle_area, "m2", range(0, 1),
              "exit area: thrust grows by this times the lack of outside pressure")};
  }
};

/// Drag polar C_D = C_D0(M) + k(M) C_L^2 with a largest C_L(M), all per reference area.
struct MissileAero {
  double reference_area = 0.02;                   ///< m^2
  Table1 drag_power_on = Table1::constant(0.5);   ///< C_D0 while the motor burns
  Table1 drag_power_off = Table1::constant(0.6);  ///< C_D0 afterwards
  Table1 induced_drag = Table1::constant(0.08);   ///< k
  Table1 greatest_lift = Table1::constant(8);     ///< C_L at the greatest angle of attack
  double greatest_load_factor = 30;               ///< g, of structure and autopilot

  static constexpr std::string_view type_name = "missile_aero";
  static constexpr std::string_view help = "lift and drag of a missile";
  static constexpr auto params() {
    using A = MissileAero;
    return Lines{
        param("reference_area", &A::reference_area, "m2", positive(10), "of all coefficients")
            .required(),
        param("drag_power_on", &A::drag_power_on, axis("mach", {}), {}, positive(100),
              "zero-lift drag coefficient while the motor burns")
            .required(),
        param("drag_power_off", &A::drag_power_off, axis("mach", {}), {}, positive(100),
              "zero-lift drag coefficient after burnout")
            .required(),
        param("induced_drag", &A::induced_drag, axis("mach", {}), {}, range(0, 100),
              "k in C_D = C_D0 + k C_L^2")
            .required(),
        param("greatest_lift", &A::greatest_lift, axis("mach", {}), {}, positive(1000),
              "lift coefficient at the greatest angle of attack")
            .required(),
        param("greatest_load_factor", &A::greatest_load_factor, range(1, 100), "g").required()};
  }
};

/// Climbs over thin air: aims above the target while it is far.
struct Loft {
  double angle = si(6, "deg");  ///< rad, aim above the line to the target
  double end_range = 20e3;      ///< m, from here on it aims at the target
  double ceiling = 25e3;        ///< m, altitude that it never aims above

  static constexpr std::string_view type_name = "loft";
  static constexpr std::string_view help = "aims above a distant target to fly in thin air";
  static constexpr auto params() {
    return Lines{
        param("angle", &Loft::angle, "rad", range(0, 60, "deg"), "above the line to the target"),
        param("end_range", &Loft::end_range, "m", positive(500e3), "nearer targets are aimed at"),
        param("ceiling", &Loft::ceiling, "m", positive(100e3), "never aims above this altitude")};
  }
};

/// The guidance computer and the autopilot behind it.
struct MissileGuidance {
  double navigation_gain = 4;           ///< N of proportional navigation
  double autopilot_lag = 0.1;           ///< s, first order, from wanted to achieved acceleration
  std::optional<double> lag_speed;      ///< m/s, see autopilot_lag(); none: the lag is constant
  double separation_time = 0.4;         ///< s after launch without any steering
  std::optional<double> link_interval;  ///< s between updates from the shooter; none: no link
  std::optional<Loft> loft;

  static constexpr std::string_view type_name = "missile_guidance";
  static constexpr std::string_view help = "proportional navigation and what surrounds it";
  static constexpr auto params() {
    using G = MissileGuidance;
    return Lines{param("navigation_gain", &G::navigation_gain, range(1, 10),
                       "N: acceleration per closing speed and line-of-sight rate"),
                 param("autopilot_lag", &G::autopilot_lag, "s", positive(10),
                       "first-order lag from wanted to achieved acceleration"),
                 param("lag_speed", &G::lag_speed, "m/s", positive(10e3),
                       "equivalent airspeed below which the lag grows with its inverse, as "
                       "the airframe gets slower; null: never"),
                 param("separation_time", &G::separation_time, "s", range(0, 60),
                       "flies straight for this long after launch"),
                 param("link_interval", &G::link_interval, "s", positive(60),
                       "between midcourse updates from the shooter; null: it has no link"),
                 param("loft", &G::loft, "null: it never lofts")};
  }
};

/// Proximity fuze and warhead. Pk(miss) = best_kill * exp(-(miss / lethal_radius)^2).
struct Warhead {
  double arming_time = 1;    ///< s after launch
  double fuze_range = 10;    ///< m: fires at the closest approach if it is nearer than this
  double lethal_radius = 8;  ///< m
  double best_kill = 0.95;   ///< probability at no miss: reliability of fuze and warhead

  static constexpr std::string_view type_name = "warhead";
  static constexpr std::string_view help = "proximity fuze and kill probability";
  static constexpr auto params() {
    using W = Warhead;
    return Lines{
        param("arming_time", &W::arming_time, "s", range(0, 60), "after launch"),
        param("fuze_range", &W::fuze_range, "m", positive(1000),
              "fires at the closest approach to anybody nearer than this"),
        param("lethal_radius", &W::lethal_radius, "m", positive(1000),
              "miss distance at which the kill probability has fallen to 37 %"),
        param("best_kill", &W::best_kill, range(0, 1), "kill probability of a direct hit")};
  }
};

/// A type of missile. Const after prepare(); shared by every missile of the type.
struct MissileType {
  std::string label;                ///< what the story calls it
  std::string entity_type = "2.1";  ///< see EntityType
  std::string emitter = "0";        ///< see emitter_of(), of its seeker
  Motor motor;
  MissileAero aero;
  MissileGuidance guidance;
  SeekerType seeker;
  Warhead warhead;
  double greatest_time = 60;      ///< s, battery
  double least_speed = 250;       ///< m/s, slower it can not be steered and ends
  double release_interval = 1;    ///< s, between two releases of the aircraft
  double launch_delay = 0.3;      ///< s, from release to motor ignition
  double ejection_speed = 0;      ///< m/s, down and away from the aircraft; 0 from a rail
  double carriage_drag_area = 0;  ///< m^2, added to the aircraft while it hangs there
  LaunchZone zone;                ///< filled by prepare()

  [[nodiscard]] bool locks_before_launch() const { return seeker.kind == SeekerKind::infrared; }
  /// Finds its employment zone (kept_zones.hpp). Call once after binding.
  void prepare();

  static constexpr std::string_view type_name = "missile";
  static constexpr std::string_view help = "an air-to-air missile";
  static constexpr auto params() {
    using M = MissileType;
    return Lines{
        param("label", &M::label, "name in the story").items(1, 40).required(),
        param("entity_type", &M::entity_type, kEntityTypeHelp).items(3, 27),
        param("emitter", &M::emitter, kEmitterHelp).items(1, 5),
        param("motor", &M::motor, "mass and thrust").required(),
        param("aero", &M::aero, "lift and drag").required(),
        param("guidance", &M::guidance, "how it steers").required(),
        param("seeker", &M::seeker, "what it sees").required(),
        param("warhead", &M::warhead, "fuze and kill probability").required(),
        param("greatest_time", &M::greatest_time, "s", positive(1000), "of flight: battery")
            .required(),
        param("least_speed", &M::least_speed, "m/s", positive(1000),
              "slower it can not be steered and destroys itself")
            .required(),
        param("release_interval", &M::release_interval, "s", range(0, 600),
              "shortest time between two releases of one aircraft"),
        param("launch_delay", &M::launch_delay, "s", range(0, 60), "from release to launch"),
        param("ejection_speed", &M::ejection_speed, "m/s", range(0, 30),
              "away from the aircraft's belly; 0 from a rail"),
        param("carriage_drag_area", &M::carriage_drag_area, "m2", range(0, 10),
              "drag area that one adds to the aircraft that carries it")};
  }
};

/// Why a missile ended without its fuze: values[0] of EventKind::timeout.
enum class MissileEnd : std::uint8_t {
  none,
  ground,  ///< flew into the ground
  speed,   ///< slower than the least speed at which it can be steered
  time,    ///< its battery is empty
  lost,    ///< saw nothing for longer than it remembers and destroyed itself
  decoy,   ///< its fuze worked at the towed decoy of whom it saw
};
constexpr auto names_of(MissileEnd) {
  return names_from_zero<MissileEnd>("none", "ground", "speed", "time", "lost", "decoy");
}

/// The memory of one missile. It knows what it was told by its shooter and what its seeker saw,
/// never the truth: `intended` is for scoring and `seen` names the echo that the seeker rests on.
struct MissileState {
  Vec3 target_position{};     ///< m, local frame: believed place of the target at target_time
  Vec3 target_velocity{};     ///< m/s
  double target_time = 0;     ///< s
  Vec3 sight{1, 0, 0};        ///< unit vector: filtered line of sight of the seeker at sight_time
  Vec3 sight_rate{};          ///< rad/s, its angular velocity
  double sight_time = 0;      ///< s, last look that saw something
  Vec3 glint{};               ///< m, across the line of sight: the target's apparent center
  double closing_speed = 0;   ///< m/s, as the seeker measures or assumes it
  Vec3 wanted{};              ///< m/s^2, acceleration that guidance asks for
  Vec3 lift{};                ///< m/s^2, aerodynamic acceleration across the flight path
  double launch_time = 0;     ///< s
  double next_fuze_scan = 0;  ///< s: before that nobody can be close enough to matter
  PlayerId shooter{};
  PlayerId intended{};      ///< truth of the track it was launched at: scoring and debrief only
  TrackId track{};          ///< name of the target in the shooter's track file
  PlayerId seen{};          ///< who the seeker saw last; none if nobody yet
  std::uint16_t type = 0;   ///< index of the MissileType in the Library
  Side side = Side::none;   ///< of the shooter
  std::uint8_t active = 0;  ///< 1: the seeker is switched on
  std::uint8_t locked = 0;  ///< 1: the seeker rests on `seen` now
  std::uint8_t decoy = 0;   ///< 1 + place among the decoys of `seen` on which it rests; 0: on none
  std::uint8_t remote = 0;  ///< 1: another program flies it, see model/remote.hpp
  std::uint8_t reserved = 0;
  std::uint64_t decoy_step = 0;  ///< Decoy::step of that one

  static constexpr auto fields() {
    using M = MissileState;
    return field_list(
        field("target_position", &M::target_position, "m"),
        field("target_velocity", &M::target_velocity, "m/s"),
        field("target_time", &M::target_time, "s"), field("sight", &M::sight),
        field("sight_rate", &M::sight_rate, "rad/s"), field("sight_time", &M::sight_time, "s"),
        field("glint", &M::glint, "m"), field("closing_speed", &M::closing_speed, "m/s"),
        field("wanted", &M::wanted, "m/s2"), field("lift", &M::lift, "m/s2"),
        field("launch_time", &M::launch_time, "s"),
        field("next_fuze_scan", &M::next_fuze_scan, "s"), field("shooter", &M::shooter),
        field("intended", &M::intended), field("track", &M::track), field("seen", &M::seen),
        field("type", &M::type), field("side", &M::side), field("active", &M::active),
        field("locked", &M::locked), field("decoy", &M::decoy), field("remote", &M::remote),
        field("reserved", &M::reserved), field("decoy_step", &M::decoy_step));
  }
};

struct Launch {
  const MissileType& type;
  std::uint16_t type_index = 0;
  PlayerId shooter;
  Side side = Side::none;
  double time = 0;  ///< s
};

struct Newborn {
  Kinematics kinematics;
  MissileState state;
};

/// A missile at its shooter's place with its shooter's velocity, pushed away from the belly, that
/// has been told of the target what the track says. An infrared seeker is switched on already and
/// points at the track.
[[nodiscard]] Newborn launched(const Launch& launch, const Kinematics& shooter, const Track& track);

}  // namespace eyrie::model::weapon
