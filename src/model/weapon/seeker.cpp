// SPDX-License-Identifier: MIT
#include "model/weapon/seeker.hpp"

#include "model/clutter.hpp"

namespace eyrie::model::weapon {

namespace {

/// Errors are as stated from 20 dB above the S/N of detection on: ten times its amplitude.
constexpr double kNearAmplitude = 10;

/// The target's place and speed as the seeker knows them now.
void update_target(const SeekerView& view, double range, double time, MissileState& state) {
  state.target_position = view.position + range * state.sight;
  state.target_velocity = view.velocity - state.closing_speed * state.sight +
                          range * cross(state.sight_rate, state.sight);
  state.target_time = time;
}

/// 13 dB: 90 % of the looks at a steady echo for one false alarm in a million (Albersheim).
constexpr double kSeenThrough = 20;

}  // namespace

double acquisition_range(const SeekerType& seeker, double signature) {
  const double ratio = std::sqrt(std::max(signature, 0.0) / seeker.reference_signature);
  const double factor = seeker.kind == SeekerKind::radar ? std::sqrt(ratio) : ratio;
  return std::min(seeker.detection_range * factor, seeker.greatest_range);
}

bool visible(const SeekerType& seeker, const SeekerView& view, const LineOfSight& los,
             const Vec3& velocity, double signature) {
  if (los.range > acquisition_range(seeker, signature))
    return false;
  if (dot(los.direction, view.axis) < math::cos(seeker.gimbal))
    return false;
  if (norm2(los.rate) > seeker.greatest_rate * seeker.greatest_rate)
    return false;
  const double sine = dot(los.direction, view.down);
  if (seeker.kind != SeekerKind::radar || sine <= 0 ||
      std::fabs(dot(velocity, los.direction)) >= seeker.notch_speed)
    return true;
  const LookDown look{.altitude = view.altitude,
                      .sine = sine,
                      .beam = seeker.field_of_view,
                      .cell = seeker.range_gate};
  return signal_to_clutter(look, signature, los.range) >= kSeenThrough;
}

SeekerLook measure(const SeekerType& seeker, const SeekerView& view, const LineOfSight& los,
                   double reach, double dt, Vec3& glint, Draw noise) {
  const bool radar = seeker.kind == SeekerKind::radar;
  SeekerLook look{.direction = los.direction,
                  .range = los.range,
                  .closing = radar ? los.closing : norm(view.velocity)};
  const double share = los.range / reach;
  const double faint = std::max(kNearAmplitude * share * share, 1.0);
  look.faint = faint;
  const double angle = faint * seeker.angle_noise;
  if (angle > 0 || seeker.glint > 0) {
    const Vec3 level = normalized(cross(view.down, los.direction), Vec3{1, 0, 0});
    const Vec3 upright = cross(los.direction, level);
    const double outwards = dot(level, view.axis) > 0 ? -1 : 1;
    const auto aside = [&](double sigma) {
      const double a = outwards * sigma * noise.normal();
      const double b = sigma * noise.normal();
      return a * level + b * upright;
    };
    // the target is no point: its bright center wanders, an angle that grows with 1 / range; a look
    // at the launch itself may be a rounding error before it
    const double kept = math::exp(-std::max(dt, 0.0) / seeker.glint_time);
    glint = kept * perpendicular(glint, los.direction) +
            aside(seeker.glint * std::sqrt(1 - kept * kept));
    look.direction =
        normalized(los.direction + aside(angle) + glint / std::max(los.range, 1.0), los.direction);
  }
  if (radar && seeker.range_noise > 0)
    look.range = std::max(los.range + seeker.range_noise * noise.normal(), 0.0);
  if (radar && seeker.closing_noise > 0)
    look.closing += seeker.closing_noise * noise.normal();
  return look;
}

void start_following(MissileState& state, const SeekerLook& look, const Vec3& expected_rate,
                     double time) {
  state.sight = look.direction;
  state.sight_rate = perpendicular(expected_rate, look.direction);
  state.sight_time = time;
  state.closing_speed = look.closing;
}

void follow(const SeekerType& seeker, const SeekerView& view, const SeekerLook& look, double time,
            MissileState& state) {
  const double dt = time - state.sight_time;
  if (dt > 0) {
    const Vec3 expected = sight_at(state, time);
    const Vec3 residual = look.direction - expected;
    // critically damped: both poles at theta
    const double errors_over_turns = look.faint * std::sqrt(look.faint);
    const double theta = math::exp(-dt / (seeker.filter_time * std::sqrt(errors_over_turns)));
    const double alpha = 1 - theta * theta;
    const double beta = (1 - theta) * (1 - theta);
    state.sight = normalized(expected + alpha * residual, expected);
    state.sight_rate =
        perpendicular(state.sight_rate + (beta / dt) * cross(expected, residual), state.sight);
    state.sight_time = time;
    state.closing_speed = look.closing;
  }
  if (seeker.kind == SeekerKind::radar)
    update_target(view, look.range, time, state);
}

Vec3 sight_at(const MissileState& state, double time) {
  const double dt = time - state.sight_time;
  return normalized(state.sight + dt * cross(state.sight_rate, state.sight), state.sight);
}

}  // namespace eyrie::model::weapon
