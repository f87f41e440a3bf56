// SPDX-License-Identifier: MIT
#pragma once
/// \file  A fighter's radar: range equation, scan volume, Doppler notch and measurement errors; and
/// the interrogator that rides on its looks. docs/models/radar.md has the equations and what they
/// are worth.
#include "core/draw.hpp"
#include "model/emission.hpp"
#include "model/entity_type.hpp"
#include "model/environment.hpp"
#include "model/fit.hpp"
#include "model/kinematics.hpp"
#include "model/signature.hpp"
#include "model/track.hpp"

namespace eyrie::model::sensor {

enum class RadarMode : std::uint8_t {
  off,
  search,  ///< track while scan: one look per frame at everything in the scan volume
  track,   ///< single target track: looks at nothing else, many times a second
};
constexpr auto names_of(RadarMode) {
  return names_from_zero<RadarMode>("off", "search", "track");
}

/// Angles of the scan are stabilised: azimuth from the own heading, elevation from the horizon.
struct RadarState {
  double scan_azimuth = 0;    ///< rad, middle of the scan, clockwise from the heading
  double scan_elevation = 0;  ///< rad, middle of the scan, up from the horizontal
  double lock_time = 0;       ///< s, last detection in track mode, or when the mode was entered
  double search_until = 0;    ///< s, no new lock before: the frame after a lock was lost
  TrackId designated{};       ///< the track that the scan follows
  PlayerId locked{};          ///< whose echo the range gate rests on in track mode
  RadarMode mode = RadarMode::off;
  std::uint8_t reserved[3] = {};
  float pulled = 0;  ///< s of the pull-off (jamming.hpp) that the gates have followed; 0: the echo

  static constexpr auto fields() {
    using R = RadarState;
    return field_list(
        field("scan_azimuth", &R::scan_azimuth, "rad"),
        field("scan_elevation", &R::scan_elevation, "rad"), field("lock_time", &R::lock_time, "s"),
        field("search_until", &R::search_until, "s"), field("designated", &R::designated),
        field("locked", &R::locked), field("mode", &R::mode), field("reserved", &R::reserved),
        field("pulled", &R::pulled, "s"));
  }
};

/// Const and shared by every aircraft that carries it. It sees aircraft only: a missile's cross
/// section is some hundred times smaller, so its range is a third or less, and the tracker of the
/// time does not keep it.
struct Radar {
  double reference_range = si(80, "nmi");  ///< m
  double reference_rcs = 3.2;              ///< m^2
  double reference_probability = 0.5;
  double false_alarm = 1e-6;
  double instrumented_range = si(160, "nmi");  ///< m
  double gimbal = si(60, "deg");               ///< rad
  double scan_half_azimuth = si(60, "deg");    ///< rad
  std::uint32_t scan_bars = 4;
  double bar_spacing = si(2.5, "deg");  ///< rad
  double beam_width = si(3, "deg");     ///< rad
  double scan_rate = 0.5;               ///< Hz
  double track_rate = 5;                ///< Hz
  double lock_range = 0;                ///< m
  double lock_memory = 2;               ///< s
  double notch_speed = 50;              ///< m/s
  double notch_edge = 10;               ///< m/s
  double range_cell = 150;              ///< m
  double speed_cell = 3;                ///< m/s
  double angle_floor = 0.05;            ///< of the beam width
  double side_lobes = 35;               ///< dB
  double track_angle_floor = 0.0125;    ///< of the beam width
  std::uint32_t max_contacts = 24;
  std::string emitter = "0";  ///< see emitter_of()

  static constexpr std::string_view type_name = "radar";
  static constexpr std::string_view help = "air-to-air radar of a fighter";
  static constexpr auto params() {
    return Lines{
        param("reference_range", &Radar::reference_range, "m", range(1e3, 1e6),
              "range at which the reference target is found with the reference probability")
            .required(),
        param("reference_rcs", &Radar::reference_rcs, "m2", range(1e-3, 1e4),
              "radar cross section of the reference target")
            .required(),
        param("reference_probability", &Radar::reference_probability, range(0.01, 0.99),
              "chance of detection in one look at the reference range"),
        param("false_alarm", &Radar::false_alarm, range(1e-12, 1e-3),
              "false alarm probability of one look, sets how steep detection is over range"),
        param("instrumented_range", &Radar::instrumented_range, "m", range(1e3, 1e6),
              "nothing is shown beyond"),
        param("gimbal", &Radar::gimbal, "rad", range(5, 85, "deg"),
              "largest angle between nose and antenna, in any direction"),
        param("scan_half_azimuth", &Radar::scan_half_azimuth, "rad", range(2.5, 85, "deg"),
              "half width of the search scan"),
        param("scan_bars", &Radar::scan_bars, range(1, 16), "rows of the search scan"),
        param("bar_spacing", &Radar::bar_spacing, "rad", range(0.5, 12, "deg"),
              "elevation from row to row"),
        param("beam_width", &Radar::beam_width, "rad", range(0.25, 30, "deg"),
              "half-power beam width"),
        param("scan_rate", &Radar::scan_rate, "Hz", range(0.01, 50), "search frames per second"),
        param("track_rate", &Radar::track_rate, "Hz", range(0.1, 100),
              "looks per second in single target track"),
        param("lock_range", &Radar::lock_range, "m", range(0, 1e6),
              "a designated target inside this range is tracked alone even if nobody asked; 0: "
              "never"),
        param("lock_memory", &Radar::lock_memory, "s", range(0, 60),
              "how long a lock survives without a detection"),
        param("notch_speed", &Radar::notch_speed, "m/s", range(0, 500),
              "ground clutter hides a target whose own speed along the line of sight is less"),
        param("notch_edge", &Radar::notch_edge, "m/s", range(0.1, 200),
              "half width of the edge of the notch"),
        param("range_cell", &Radar::range_cell, "m", range(0.1, 1e4),
              "width of a range cell: errors of range go with it"),
        param("speed_cell", &Radar::speed_cell, "m/s", range(0.01, 1e3),
              "width of a Doppler filter: errors of closing speed go with it"),
        param("angle_floor", &Radar::angle_floor, range(1e-4, 1),
              "error across the line of sight of the strongest echo in search, as a share of the "
              "beam width, 1-sigma per axis"),
        param("track_angle_floor", &Radar::track_angle_floor, range(1e-4, 1),
              "the same in single target track"),
        param("side_lobes", &Radar::side_lobes, "dB", range(0, 100),
              "how far its antenna's gain beside the beam is below that in its middle"),
        param("max_contacts", &Radar::max_contacts, range(1, 32),
              "the nearest so many detections of a frame are kept"),
        param("emitter", &Radar::emitter, kEmitterHelp).items(1, 5)};
  }
};

/// The detection statistics of one radar: the range equation anchored at its reference point, and
/// the chance to detect a Swerling 1 target in one look.
class Detector {
 public:
  explicit Detector(const Radar& radar);

  /// Signal over noise (a power ratio) of a target of `rcs` (m^2) at the square of its range (m^2).
  [[nodiscard]] double signal_to_noise(double range_squared, double rcs) const {
    return scale_ * rcs / (range_squared * range_squared);
  }
  /// Pfa^(1 / (1 + S/N)): exact for a Swerling 1 target, one look, square-law detector. Mahafza,
  /// Radar Systems Analysis and Design Using MATLAB, eq. 2.75; Richards, Fundamentals of Radar
  /// Signal Processing, eq. 6.99.
  [[nodiscard]] double probability(double signal_to_noise) const;

  /// The S/N that one look shows for a mean of `signal_to_noise`, if it is above the threshold; `u`
  /// is a draw from [0, 1). Signal and noise together are exponential (Swerling 1, square law), so
  /// the draw that decides on detection says how strong the echo was, too.
  [[nodiscard]] std::optional<double> echo(double signal_to_noise, double u) const {
    const double power = -(1 + signal_to_noise) * math::log(1 - u);
    return power > -log_false_alarm_ ? std::optional(power - 1) : std::nullopt;
  }

 private:
  double log_false_alarm_;
  double scale_;
};

/// Where the antenna can look now, in the local frame.
struct Gimbal {
  Vec3 nose{};            ///< unit vector, its middle
  double max_range2 = 0;  ///< m^2
  double cos_gimbal = 1;
};
[[nodiscard]] Gimbal gimbal_of(const Radar& radar, const Kinematics& own);

/// Where the antenna looks in a search, in the local frame.
struct Antenna {
  Gimbal gimbal;
  Vec3 position{};  ///< m
  Axes scan;        ///< level axes, forward to the middle of the scan
  double tan_half_azimuth = 0;
  double sin_low = 0, sin_high = 0;  ///< sines of the lowest and highest elevation
};

/// The search volume around the scan center of `state`.
[[nodiscard]] Antenna aim(const Radar& radar, const RadarState& state, const Kinematics& own);

/// Sets the elevations of an emission that is the sector which the search scan sweeps around its
/// boresight, as `covers`, but for the gimbal; `down` is that of its owner.
void sweep(const Radar& radar, const Vec3& down, Emission& emission);

/// Whether a line of sight (m, from the antenna) lies in range, inside the gimbal and in the scan.
[[nodiscard]] inline bool covers(const Antenna& a, const Vec3& sight, double range2) {
  const Gimbal& g = a.gimbal;
  const double along = dot(sight, g.nose);
  if (range2 > g.max_range2 || along < 0 || along * along < g.cos_gimbal * g.cos_gimbal * range2)
    return false;
  const double ahead = dot(sight, a.scan.forward);
  if (ahead <= 0 || std::fabs(dot(sight, a.scan.right)) > a.tan_half_azimuth * ahead)
    return false;
  const double up = -dot(sight, a.scan.down), range = std::sqrt(range2);
  return up >= a.sin_low * range && up <= a.sin_high * range;
}

/// Whether the gimbal lets the antenna point along `sight` at all; track mode needs no more.
[[nodiscard]] inline bool within_gimbal(const Gimbal& g, const Vec3& sight, double range2) {
  const double along = dot(sight, g.nose);
  return range2 <= g.max_range2 && along > 0 &&
         along * along >= g.cos_gimbal * g.cos_gimbal * range2;
}

/// Mean S/N of `other` in one look if the beam passes it: range, aspect, horizon and notch. `wind`
/// turns its nose against its way over the ground.
[[nodiscard]] double mean_echo(const Radar& radar, const Detector& detector, const Kinematics& own,
                               const Signature& signature, const Kinematics& other,
                               const Wind& wind = kCalm);

/// Errors of one look, 1-sigma: of thermal noise, cell / sqrt(2 S/N) and width / (1.6 sqrt(2 S/N)),
/// 1.6 the slope of a monopulse antenna (Barton & Leonov, Radar Technology Encyclopedia (1997), p.
/// 6), with what stays however strong the echo is: cell / sqrt(12) of a number in whole cells, and
/// the floors of the angle.
struct LookErrors {
  double range = 0;       ///< m
  double range_rate = 0;  ///< m/s
  double angle = 0;       ///< rad, each of the two across the line of sight
};
[[nodiscard]] LookErrors errors_of(const Radar& radar, RadarMode mode, double signal_to_noise);

/// The measurement of a detected target, with errors. The error across the line of sight is counted
/// outwards from the nose, so that a mirrored scene gives the mirrored contact for the same draw.
[[nodiscard]] Contact measure(const LookErrors& errors, const Kinematics& own, const Axes& level,
                              const Kinematics& other, PlayerId truth, Draw noise);

/// The direction of whoever jams, as `contact` has it; the range is anywhere within `farthest` (m).
[[nodiscard]] Contact strobe(Contact contact, const Vec3& own, double farthest);

/// Const and shared by every aircraft that carries it. Everybody carries a transponder.
struct Iff {
  double range = si(100, "nmi");  ///< m
  double reply_probability = 0.95;
  std::uint32_t tries = 3;

  static constexpr std::string_view type_name = "iff";
  static constexpr std::string_view help = "interrogator: a friend answers, nobody else does";
  static constexpr auto params() {
    return Lines{
        param("range", &Iff::range, "m", eyrie::range(0, 1e6), "asks no target beyond"),
        param("reply_probability", &Iff::reply_probability, eyrie::range(0, 1),
              "chance that a friend's reply is received and decoded"),
        param("tries", &Iff::tries, eyrie::range(0, 255),
              "so many interrogations in a row without a reply declare a track hostile; 0: never")};
  }
};

/// Whether the player that gave an echo answers to `asking`.
[[nodiscard]] inline bool answers(const Iff& iff, Side asking, Side asked, Draw draw) {
  return asking == asked && asking != Side::none && draw.chance(iff.reply_probability);
}

}  // namespace eyrie::model::sensor
