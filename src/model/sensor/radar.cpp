// SPDX-License-Identifier: MIT
#include "model/sensor/radar.hpp"

#include <algorithm>

#include "model/clutter.hpp"

namespace eyrie::model::sensor {
namespace {

/// 0 below `low`, 1 above `high`, a cubic with level ends between.
constexpr double smooth_step(double low, double high, double x) {
  if (x <= low)
    return 0;
  if (x >= high)
    return 1;
  const double t = (x - low) / (high - low);
  return t * t * (3 - 2 * t);
}

/// The share of an echo that has the Doppler shift of the main-lobe clutter, in [0, 1]: of whatever
/// moves slowly along the line of sight over the ground, when the beam behind it meets the ground.
/// Stimson, Introduction to Airborne Radar, 2nd ed., ch. 24.
double in_clutter(const Radar& radar, const Kinematics& own, const Kinematics& other,
                  const Vec3& unit) {
  const double dip = std::sqrt(2 * std::max(own.altitude, 0.0) / (kRadioEarth * kEarthRadius));
  const double half_beam = radar.beam_width / 2;  // rad; small, so sine and angle are the same
  const double looking_down = smooth_step(dip - half_beam, dip + half_beam, dot(unit, own.down));
  if (looking_down == 0)
    return 0;
  const double speed = std::fabs(dot(other.velocity, unit));
  const double outside = smooth_step(radar.notch_speed - radar.notch_edge,
                                     radar.notch_speed + radar.notch_edge, speed);
  return looking_down * (1 - outside);
}

}  // namespace

Detector::Detector(const Radar& radar)
    : log_false_alarm_(math::log(radar.false_alarm)),
      scale_((log_false_alarm_ / math::log(radar.reference_probability) - 1) *
             radar.reference_range * radar.reference_range * radar.reference_range *
             radar.reference_range / radar.reference_rcs) {}

double Detector::probability(double signal_to_noise) const {
  return math::exp(log_false_alarm_ / (1 + signal_to_noise));
}

Gimbal gimbal_of(const Radar& radar, const Kinematics& own) {
  const auto [heading, pitch] = math::sin_cos(own.heading, own.pitch);
  return {.nose = pitch.cos * heading.cos * own.north + pitch.cos * heading.sin * own.east -
                  pitch.sin * own.down,
          .max_range2 = radar.instrumented_range * radar.instrumented_range,
          .cos_gimbal = math::cos(radar.gimbal)};
}

Antenna aim(const Radar& radar, const RadarState& state, const Kinematics& own) {
  const double half_elevation = radar.scan_bars * radar.bar_spacing / 2;
  const auto [sin_half, cos_half] = math::sin_cos(radar.scan_half_azimuth);
  return {.gimbal = gimbal_of(radar, own),
          .position = own.position,
          .scan = level_axes(own, own.heading + state.scan_azimuth),
          .tan_half_azimuth = sin_half / cos_half,
          .sin_low = math::sin(std::max(state.scan_elevation - half_elevation, -kPi / 2)),
          .sin_high = math::sin(std::min(state.scan_elevation + half_elevation, kPi / 2))};
}

void sweep(const Radar& radar, const Vec3& down, Emission& emission) {
  const double elevation = math::asin(std::clamp(-dot(emission.boresight, down), -1.0, 1.0));
  const double half_elevation = radar.scan_bars * radar.bar_spacing / 2;
  emission.down = down;
  const auto [low, high] = math::sin_cos(std::max(elevation - half_elevation, -kPi / 2),
                                         std::min(elevation + half_elevation, kPi / 2));
  emission.sin_low = low.sin;
  emission.sin_high = high.sin;
}

double mean_echo(const Radar& radar, const Detector& detector, const Kinematics& own,
                 const Signature& signature, const Kinematics& other, const Wind& wind) {
  const Vec3 sight = other.position - own.position;
  const double range2 = norm2(sight);
  const double range = std::sqrt(range2);
  if (range <= 0 || range > horizon_range(own.altitude, other.altitude, kRadioEarth))
    return 0;
  const Vec3 unit = sight / range;
  const double cos_aspect = -dot(nose_of(other, wind), unit);
  const double section = radar_cross_section(signature, cos_aspect);
  const double signal = detector.signal_to_noise(range2, section);
  const double share = in_clutter(radar, own, other, unit);
  if (share == 0)
    return signal;
  // what is in the clutter competes with it and with the noise
  const LookDown look{.altitude = own.altitude,
                      .sine = dot(unit, own.down),
                      .beam = radar.beam_width,
                      .cell = radar.range_cell};
  const double over_clutter = signal_to_clutter(look, section, range);
  return signal * (1 - share * signal / (signal + over_clutter));
}

LookErrors errors_of(const Radar& radar, RadarMode mode, double signal_to_noise) {
  constexpr double kCell = 1.0 / 12, kMonopulseSlope = 1.6;
  const double noise = 0.5 / signal_to_noise;
  const double cell = std::sqrt(kCell + noise);
  const double floor = mode == RadarMode::track ? radar.track_angle_floor : radar.angle_floor;
  return {.range = radar.range_cell * cell,
          .range_rate = radar.speed_cell * cell,
          .angle = radar.beam_width *
                   std::sqrt(floor * floor + noise / (kMonopulseSlope * kMonopulseSlope))};
}

Contact measure(const LookErrors& errors, const Kinematics& own, const Axes& level,
                const Kinematics& other, PlayerId truth, Draw noise) {
  const Vec3 sight = other.position - own.position;
  const double range = norm(sight);
  const Vec3 unit = sight / range;
  const Vec3 outwards =
      std::copysign(1.0, dot(unit, level.right)) * normalized(cross(level.down, unit), level.right);
  const Vec3 upwards = normalized(level.down - dot(level.down, unit) * unit, level.forward) * -1;

  const double measured_range = std::max(range + errors.range * noise.normal(), 1.0);
  const double range_rate =
      dot(other.velocity - own.velocity, unit) + errors.range_rate * noise.normal();
  const double aside = errors.angle * noise.normal(), above = errors.angle * noise.normal();

  Contact contact;
  contact.line = normalized(unit + aside * outwards + above * upwards, unit);
  contact.range = measured_range;
  contact.position = own.position + measured_range * contact.line;
  contact.speed_along = range_rate + dot(own.velocity, contact.line);
  contact.sigma_along = errors.range;
  contact.sigma_across = errors.angle * measured_range;
  // the own speed across the line, taken for speed along it; that of the target is about the same
  const double turned = errors.angle * norm(own.velocity);
  contact.sigma_speed = std::sqrt(errors.range_rate * errors.range_rate + turned * turned);
  contact.truth = truth;
  contact.source = kFromRadar;
  return contact;
}

Contact strobe(Contact contact, const Vec3& own, double farthest) {
  const double angle = contact.sigma_across / contact.range;
  contact.range = farthest / 2;  // a uniform law: its mean and its deviation
  contact.position = own + contact.range * contact.line;
  contact.sigma_along = farthest / std::sqrt(12.0);
  contact.sigma_across = angle * contact.range;
  contact.speed_along = contact.sigma_speed = 0;
  contact.bearing_only = true;
  return contact;
}

}  // namespace eyrie::model::sensor
