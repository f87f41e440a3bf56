// SPDX-License-Identifier: MIT
#pragma once
/// \file  Radar warning receiver.
#include "core/describe.hpp"
#include "core/draw.hpp"
#include "model/datalink/datalink.hpp"
#include "model/emission.hpp"

namespace eyrie::model::sensor {

/// One emitter on the display: where from and what kind, never how far.
struct RwrWarning {
  double bearing = 0;         ///< rad, true, clockwise from north, in (-pi, pi]
  double time = 0;            ///< s, last heard
  double first_time = 0;      ///< s, first heard without a gap
  double kind_time = 0;       ///< s, since when it is of that kind
  double faintness = 0;       ///< amplitude that is just heard over the signal's, filtered; grows
                              ///< with range, by a factor that nobody knows
  double faintness_rate = 0;  ///< 1/s
  PlayerId emitter{};         ///< fingerprint of the pulse train: tells emitters apart, and debrief
  std::uint16_t type = 0;     ///< as Emission::type: the class of emitter
  EmissionKind kind = EmissionKind::none;
  std::uint8_t looks = 0;  ///< that the faintness was filtered from, saturating

  static constexpr auto fields() {
    return field_list(
        field("bearing", &RwrWarning::bearing, "rad"), field("time", &RwrWarning::time, "s"),
        field("first_time", &RwrWarning::first_time, "s"),
        field("kind_time", &RwrWarning::kind_time, "s"), field("faintness", &RwrWarning::faintness),
        field("faintness_rate", &RwrWarning::faintness_rate, "Hz"),
        field("emitter", &RwrWarning::emitter), field("type", &RwrWarning::type),
        field("kind", &RwrWarning::kind), field("looks", &RwrWarning::looks));
  }
};

inline constexpr std::size_t kMaxWarnings = 8;

/// The warnings of one aircraft, the most urgent kind first, then the one that has been it longest.
struct RwrState {
  std::array<RwrWarning, kMaxWarnings> warnings{};
  std::uint32_t count = 0;
  std::uint8_t reserved[4] = {};

  static constexpr auto fields() {
    return field_list(field("warnings", &RwrState::warnings), field("count", &RwrState::count),
                      field("reserved", &RwrState::reserved));
  }
};

/// Const and shared by every aircraft that carries it. It hears main beams only: a radar that does
/// not point here, or does not sweep over here, is not heard.
struct Rwr {
  double insensitivity = 85;                  ///< dB
  double sigma_bearing = si(10, "deg");       ///< rad
  double bearing_step = si(5, "deg");         ///< rad
  double sigma_level = 0.3;                   ///< dB
  double elevation_coverage = si(45, "deg");  ///< rad
  double search_rate = 1;                     ///< Hz
  double seeker_rate = 5;                     ///< Hz
  double memory = 5;                          ///< s
  bool hides_friends = true;

  static constexpr std::string_view type_name = "rwr";
  static constexpr std::string_view help = "radar warning receiver";
  static constexpr auto params() {
    return Lines{
        param("insensitivity", &Rwr::insensitivity, "dB", range(0, 200),
              "how much more power than the radar's own receiver, antenna gain included, it needs"),
        param("sigma_bearing", &Rwr::sigma_bearing, "rad", range(0, 85, "deg"),
              "bearing error, 1-sigma"),
        param("bearing_step", &Rwr::bearing_step, "rad", range(0.05, 90, "deg"),
              "bearings come in steps of this, counted from the nose"),
        param("sigma_level", &Rwr::sigma_level, "dB", range(0, 20),
              "error of a signal's level in one look, 1-sigma"),
        param("elevation_coverage", &Rwr::elevation_coverage, "rad", range(5, 89.9, "deg"),
              "deaf above and below this angle from the plane of the wings"),
        param("search_rate", &Rwr::search_rate, "Hz", range(0.05, 50),
              "how often it sorts the radars it hears"),
        param("seeker_rate", &Rwr::seeker_rate, "Hz", range(0.05, 50),
              "how often it looks for missile seekers"),
        param("memory", &Rwr::memory, "s", range(0.1, 60),
              "a warning stays so long after it was last heard"),
        param("hides_friends", &Rwr::hides_friends,
              "the threat library knows the own side's waveforms and does not show them")};
  }
};

/// Where a receiver is and how it is turned; made once per look.
struct RwrAntenna {
  Vec3 position{};  ///< m, local frame
  Axes body;
  double altitude = 0;      ///< m
  double sensitivity = 0;   ///< (range / figure)^2 at which a main beam is just heard
  double sin_coverage = 0;  ///< of elevation_coverage
  Side side = Side::none;
};
[[nodiscard]] RwrAntenna aim(const Rwr& rwr, const Kinematics& own, Side side);

/// Power of an emission at the receiver over the least it hears, or 0 if it is not heard: too far,
/// not in the beam, outside the antenna coverage, a friend, or radio silence. A beam that rests
/// falls off from its middle to its edge, where it has half its power, like a Gaussian one: 12 dB
/// times the square of the angle over the beam width (Skolnik, Introduction to Radar Systems,
/// 3rd ed., sec. 9.2); one that sweeps passes with its middle. The horizon is left to the caller,
/// who asks only for what is worth showing.
[[nodiscard]] double hear(const Rwr& rwr, const RwrAntenna& antenna, const Emission& emission);

/// The warning that an emission heard with `strength` gives: a bearing with error, in the steps of
/// the display, and a level with error. The error of the bearing is counted outwards from the nose,
/// so that a mirrored scene gives the mirrored warning.
[[nodiscard]] RwrWarning warn(const Rwr& rwr, const RwrAntenna& antenna, const Kinematics& own,
                              const Emission& emission, double strength, PlayerId emitter,
                              double time, Draw draw);

/// Whether the line through the levels of a signal has all its looks (3 s).
[[nodiscard]] bool has_line(const RwrWarning& warning);

/// s from the last look until a missile's seeker is here, if it comes straight here with the speed
/// that it has: the faintness, which is in proportion to its range, is gone then. Nothing before
/// the line has all its looks, for a beam that just swings over grows, too; while the
/// error of the estimate is beyond 10 %; and for one that goes away. Who is
/// aside of a beam that rests on a mate, d metres from the line between him and the emitter that
/// comes at speed V, sees a value that does not fall far below 4.32 d / (beam width V): he leaves
/// the beam as it comes near.
[[nodiscard]] std::optional<double> time_to_go(const RwrWarning& warning, const Rwr& rwr);

/// m/s, the closing speed that is reckoned with for a missile: nobody measures it. A medium-range
/// missile after burnout does about 700 m/s, its target 250 ([judgement]: docs/models/missile.md
/// has the flights).
inline constexpr double kMissileClosing = 1000;

/// The seekers heard in the last second, each carried on to `time` (s), for a message to mates;
/// gives how many.
std::size_t share(const RwrState& state, double time,
                  std::array<datalink::SharedSeeker, datalink::kSharedSeekers>& seekers);

/// s, how old the levels are that are compared: a straight line through looks is surest in their
/// middle.
inline constexpr double kLevelAge = 1;

/// Whether a mate hears a seeker louder than he would if it rested on this aircraft or on neither:
/// levels fall as 1/range and off the middle of the beam, so who of two hears it fainter than his
/// distance explains is farther off the middle. `offset` is where the mate was (m, north-east-down
/// from here) kLevelAge ago, `theirs` what he heard `age` s ago. Never true on both sides; two
/// nearer to each other than the noise of the levels tells apart stay in doubt.
[[nodiscard]] bool rests_on_mate(const RwrWarning& own, const datalink::SharedSeeker& theirs,
                                 double age, const Vec3& offset, double time);

/// Puts a warning on the display; bearing and level go into the filters of what it has there. True
/// if the emitter is new there or has become more urgent. When the display is full the least urgent
/// and then the longest unheard makes room, if the new one is more urgent.
bool show(RwrState& state, const RwrWarning& warning);

/// The warning of that emitter, or null.
[[nodiscard]] const RwrWarning* find(const RwrState& state, PlayerId emitter);

/// Takes off the display what has not been heard for longer than the memory.
void forget(RwrState& state, const Rwr& rwr, double time);

}  // namespace eyrie::model::sensor
