// SPDX-License-Identifier: MIT
#include "model/track/motion.hpp"

#include <algorithm>

namespace eyrie::model::track {
namespace {

/// Below this part of the memory the closed form loses its digits; the leading terms do.
constexpr double kShort = 0.02;

/// What does not make the determinant of a covariance smaller than so much is not worth it.
constexpr double kWorthIt = 0.9;

/// An acceleration that is a first-order Markov process: R. A. Singer, "Estimating Optimal Tracking
/// Filter Performance for Manned Maneuvering Targets", IEEE Trans. AES-6 (1970) 473; Bar-Shalom et
/// al., sec. 8.2.3.
/// `kept`: which part of it is left, e^-x.
Transition turn(const Motion& motion, double dt, double x, double kept) {
  const double variance = motion.maneuver * motion.maneuver, memory = motion.maneuver_memory;
  const double kept2 = kept * kept;
  Transition t{.dt = dt, .kept = kept};
  if (x < kShort) {
    const double q = 2 * variance / memory, dt2 = dt * dt;
    t.to_position = dt2 * (0.5 - x / 6);
    t.to_velocity = dt * (1 - x / 2);
    t.noise = {q * dt2 * dt2 * dt / 20, q * dt2 * dt2 / 8, q * dt2 * dt / 3,
               q * dt2 * dt / 6,        q * dt2 / 2,       q * dt};
    return t;
  }
  t.to_position = memory * memory * (x - 1 + kept);
  t.to_velocity = memory * (1 - kept);
  const double v = variance * memory;
  t.noise.position = v * memory * memory * memory *
                     (1 - kept2 + 2 * x + 2 * x * x * x / 3 - 2 * x * x - 4 * x * kept);
  t.noise.cross = v * memory * memory * (kept2 + 1 - 2 * kept + 2 * x * kept - 2 * x + x * x);
  t.noise.velocity = v * memory * (4 * kept - 3 - kept2 + 2 * x);
  t.noise.position_acceleration = v * memory * (1 - kept2 - 2 * x * kept);
  t.noise.velocity_acceleration = v * (kept2 + 1 - 2 * kept);
  t.noise.acceleration = variance * (1 - kept2);
  return t;
}

}  // namespace

Transition straight_on(const Motion& motion, double dt) {
  const double q = motion.wander * motion.wander;  // m^2/s^3: so much variance of velocity a second
  return {.dt = dt, .noise = {q * dt * dt * dt / 3, q * dt * dt / 2, q * dt}};
}

Interval interval(const Motion& motion, double dt) {
  const double x = dt / motion.maneuver_memory;
  const auto [kept, as_it_was] = math::exp(-x, -dt / motion.straight_time - dt / motion.turn_time);
  const double settled = 1 - as_it_was;
  return {.straight = straight_on(motion, dt),
          .turning = turn(motion, dt, x, kept),
          .begins = motion.turning() * settled,
          .ends = (1 - motion.turning()) * settled};
}

Intersection intersect(const AxisState& own, const AxisState& theirs) {
  Intersection result{.covariance = own};
  const double own_det = own.position * own.velocity - own.cross * own.cross;
  const double their_det = theirs.position * theirs.velocity - theirs.cross * theirs.cross;
  if (own_det <= 0 || their_det <= 0)
    return result;

  // the determinant of w A + (1 - w) B, both inverse, is a parabola in w: its top within [0, 1]
  const double a = 1 / own_det, b = 1 / their_det;
  const double mixed = (own.velocity * theirs.position + own.position * theirs.velocity -
                        2 * own.cross * theirs.cross) *
                       a * b;
  const double bend = mixed - a - b;
  const double w = bend > 0 ? std::clamp((mixed / 2 - b) / bend, 0.0, 1.0) : (a >= b ? 1.0 : 0.0);
  // the information of both, weighted, and its inverse
  const double theirs_pp = (1 - w) * b * theirs.velocity, theirs_pv = -(1 - w) * b * theirs.cross,
               theirs_vv = (1 - w) * b * theirs.position;
  const double pp = w * a * own.velocity + theirs_pp, pv = -w * a * own.cross + theirs_pv,
               vv = w * a * own.position + theirs_vv;
  const double det = pp * vv - pv * pv;
  if (det * own_det < 1 / kWorthIt)
    return result;
  AxisState& c = result.covariance;
  c.position = vv / det;
  c.cross = -pv / det;
  c.velocity = pp / det;
  result.worth_it = true;
  result.position_position = c.position * theirs_pp + c.cross * theirs_pv;
  result.position_velocity = c.position * theirs_pv + c.cross * theirs_vv;
  result.velocity_position = c.cross * theirs_pp + c.velocity * theirs_pv;
  result.velocity_velocity = c.cross * theirs_pv + c.velocity * theirs_vv;

  const double by_position =
      a * (own.velocity * own.position_acceleration - own.cross * own.velocity_acceleration);
  const double by_velocity =
      a * (own.position * own.velocity_acceleration - own.cross * own.position_acceleration);
  result.acceleration_position = by_position;
  result.acceleration_velocity = by_velocity;
  c.position_acceleration = by_position * c.position + by_velocity * c.cross;
  c.velocity_acceleration = by_position * c.cross + by_velocity * c.velocity;
  c.acceleration += by_position * (c.position_acceleration - own.position_acceleration) +
                    by_velocity * (c.velocity_acceleration - own.velocity_acceleration);
  return result;
}

}  // namespace eyrie::model::track
