// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a pilot sees out of the window: aircraft, and the plumes of missiles.
/// docs/models/radar.md has the equations and what they are worth.
#include "core/draw.hpp"
#include "model/fit.hpp"
#include "model/kinematics.hpp"
#include "model/sensor/threats.hpp"
#include "model/signature.hpp"
#include "model/track.hpp"

namespace eyrie::model::sensor {

/// Const and shared: the pilot's eyes and the cockpit they look out of. Daylight.
struct Visual {
  double rate = 2;  ///< Hz
  double search = 17e3;
  double cued_search = 140e3;
  double cue_angle = si(10, "deg");  ///< rad
  double visibility = si(40, "km");  ///< m
  double range = si(15, "nmi");      ///< m
  double least_angle = 0.29e-3;      ///< rad
  double identify_angle = 1.86e-3;   ///< rad
  double hold_probability = 0.95;
  double hold_time = 3;               ///< s
  double over_nose = si(15, "deg");   ///< rad
  double over_side = si(40, "deg");   ///< rad
  double tail_blind = si(30, "deg");  ///< rad
  double sigma_range = 0.2;
  double sigma_angle = si(1, "deg");    ///< rad
  double plume_area = 30;               ///< m^2
  double missile_area = 0.15;           ///< m^2
  double steady_rate = si(3, "deg/s");  ///< rad/s

  static constexpr std::string_view type_name = "visual";
  static constexpr std::string_view help = "the eyes of the pilot and the cockpit around them";
  static constexpr auto params() {
    return Lines{
        param("rate", &Visual::rate, "Hz", eyrie::range(0.1, 50), "looks around per second"),
        param("search", &Visual::search, eyrie::range(0, 1e8),
              "acquisitions per second and steradian of target, nothing told where to look"),
        param("cued_search", &Visual::cued_search, eyrie::range(0, 1e8),
              "the same when a track or a warning told where to look"),
        param("cue_angle", &Visual::cue_angle, "rad", eyrie::range(0, 85, "deg"),
              "a target this close to a known direction is looked for there"),
        param("visibility", &Visual::visibility, "m", eyrie::range(100, 1e6),
              "meteorological range: contrast falls to 5 % there"),
        param("range", &Visual::range, "m", eyrie::range(10, 1e5), "nothing is seen beyond"),
        param("least_angle", &Visual::least_angle, "rad", eyrie::range(1e-5, 0.1),
              "apparent diameter below which nothing can be seen"),
        param("identify_angle", &Visual::identify_angle, "rad", eyrie::range(1e-5, 0.5),
              "apparent diameter from which the type is recognised"),
        param("hold_probability", &Visual::hold_probability, eyrie::range(0, 1),
              "chance per look to see again what was seen just before"),
        param("hold_time", &Visual::hold_time, "s", eyrie::range(0, 60),
              "how long 'just before' is"),
        param("over_nose", &Visual::over_nose, "rad", eyrie::range(0, 89.9, "deg"),
              "how far the pilot sees down over the nose"),
        param("over_side", &Visual::over_side, "rad", eyrie::range(0, 89.9, "deg"),
              "how far the pilot sees down over the side"),
        param("tail_blind", &Visual::tail_blind, "rad", eyrie::range(0, 89.9, "deg"),
              "half angle of the cone behind that the seat and the tail hide"),
        param("sigma_range", &Visual::sigma_range, eyrie::range(0.001, 1),
              "range error, 1-sigma, as a share of the range"),
        param("sigma_angle", &Visual::sigma_angle, "rad", eyrie::range(0.005, 30, "deg"),
              "direction error, 1-sigma per axis"),
        param("plume_area", &Visual::plume_area, "m2", eyrie::range(0, 1e4),
              "silhouette of a missile with its plume while the motor burns"),
        param("missile_area", &Visual::missile_area, "m2", eyrie::range(0, 1e3),
              "silhouette of a missile that coasts"),
        param("steady_rate", &Visual::steady_rate, "rad/s", eyrie::range(0, 600, "deg/s"),
              "a missile that comes closer and whose direction turns slower is a threat")};
  }
};

/// The head of a pilot at one moment; made once per look.
struct Eyes {
  Vec3 position{};  ///< m, local frame
  Vec3 velocity{};  ///< m/s
  Axes body;
  double altitude = 0;  ///< m
};
[[nodiscard]] Eyes eyes_of(const Kinematics& own);

/// Whether the cockpit lets the pilot see in a direction. Over the nose the limit is `over_nose`
/// below the plane of the wings, abeam `over_side`, between them a smooth transition; behind,
/// a cone around the tail is hidden.
[[nodiscard]] bool in_view(const Visual& visual, const Eyes& eyes, const Vec3& unit);

/// Chance to acquire a silhouette of `area` (m^2) at `range` (m) in one look of a pilot who
/// searches with `search` (1/s/sr). Search as a Poisson process whose rate is proportional to the
/// solid angle, weakened by haze as exp(-2.996 r / visibility): Andrews, "Modeling of air-to-air
/// visual acquisition", Lincoln Laboratory Journal 2 (1989) 475, and report ATC-151 (1991).
[[nodiscard]] double acquisition_probability(const Visual& visual, double search, double area,
                                             double range);

/// The same of what was seen just before.
[[nodiscard]] double hold_probability(const Visual& visual, double area, double range);

/// How much an observer knows about where to look.
enum class Cue : std::uint8_t { none, cued, held };

/// Whether one look finds an aircraft at `range` (m); `u` is a draw from [0, 1).
[[nodiscard]] bool glimpsed(const Visual& visual, const Eyes& eyes, const Kinematics& other,
                            const Signature& signature, double range, Cue cue, double u);

/// What it is to somebody of side `own`; unknown if it is too small there to see what it is.
[[nodiscard]] Identity recognized(const Visual& visual, const Eyes& eyes, const Kinematics& other,
                                  const Signature& signature, double range, Side own, Side side);
/// What somebody is to whom recognizes it, by the sides of both.
[[nodiscard]] Identity identity_of(Side own, Side other);

/// Apparent diameter (rad) of a disc of that area (m^2).
[[nodiscard]] double apparent_diameter(double area, double range);

/// What a pilot who sees a target makes of where it is. No speed.
[[nodiscard]] Contact estimate(const Visual& visual, const Eyes& eyes, const Vec3& position,
                               PlayerId truth, Draw noise);

/// Whether a missile at this relative position (m) and velocity (m/s), missile minus own, seems to
/// come for the pilot: closer, on a steady bearing.
[[nodiscard]] bool looks_dangerous(const Visual& visual, const Vec3& relative_position,
                                   const Vec3& relative_velocity);

}  // namespace eyrie::model::sensor
