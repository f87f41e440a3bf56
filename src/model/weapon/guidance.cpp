// SPDX-License-Identifier: MIT
#include "model/weapon/guidance.hpp"

#include <algorithm>

#include "core/math.hpp"
#include "model/environment.hpp"

namespace eyrie::model::weapon {

namespace {

constexpr double kTurnCosine = 0.70710678118654752;  // of 45 degrees
constexpr double kTurnRate = 2;                      // rad/s per unit of cosine beyond that

}  // namespace

Vec3 steer(const MissileGuidance& guidance, const LineOfSight& los, const Vec3& velocity,
           const Vec3& down) {
  const double speed = norm(velocity);
  const double closing = std::max(los.closing, speed / 2);
  Vec3 wanted = proportional_navigation(guidance.navigation_gain, closing, los) - kGravity * down;

  // over the shoulder: proportional navigation alone would leave the turn for later
  const double ahead = dot(velocity, los.direction);
  if (ahead < kTurnCosine * speed) {
    const Vec3 across = perpendicular(los.direction, velocity / std::max(speed, 1.0));
    const double excess = kTurnCosine * speed - ahead;
    wanted += (kTurnRate * excess) * normalized(across, Vec3{});
  }
  return wanted;
}

Vec3 lofted(const Loft& loft, const Vec3& relative_position, const Vec3& down, double altitude) {
  const double beyond = norm(relative_position) - loft.end_range;
  if (beyond <= 0)
    return relative_position;
  const double target_altitude = altitude - dot(down, relative_position);
  const double room = std::max(loft.ceiling - target_altitude, 0.0);
  return relative_position - std::min(beyond * math::tan(loft.angle), room) * down;
}

}  // namespace eyrie::model::weapon
