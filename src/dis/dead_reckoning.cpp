// SPDX-License-Identifier: MIT
#include "dis/dead_reckoning.hpp"

namespace eyrie::dis {
namespace {

Vec3 wide(const Vec3f& v) {
  return {v[0], v[1], v[2]};
}

/// E.7.2, [DR]: what `spin` makes of an attitude in `time`.
Mat3 turn(const Vec3& spin, double time) {
  const double rate = norm(spin);
  if (rate * std::fabs(time) < 1e-12)
    return {};
  const auto [s, c] = math::sin_cos(rate * time);
  const Vec3 n = spin / rate;
  const auto row = [&](const Vec3& axis) {  // of (1 - c) n n^T + c I - s [n x]
    return (1 - c) * dot(n, axis) * n + c * axis - s * cross(axis, n);
  };
  return {row({1, 0, 0}), row({0, 1, 0}), row({0, 0, 1})};
}

/// The cosine of the turn between two attitudes, doubled and one more: the trace.
double trace_between(const Mat3& a, const Mat3& b) {
  return dot(a.row_x, b.row_x) + dot(a.row_y, b.row_y) + dot(a.row_z, b.row_z);
}

}  // namespace

Mat3 attitude_of(const Vec3& euler) {
  const auto [sa, ca] = math::sin_cos(euler.x);
  const auto [sb, cb] = math::sin_cos(euler.y);
  const auto [sc, cc] = math::sin_cos(euler.z);
  return {{cb * ca, cb * sa, -sb},
          {sc * sb * ca - cc * sa, sc * sb * sa + cc * ca, sc * cb},
          {cc * sb * ca + sc * sa, cc * sb * sa - sc * ca, cc * cb}};
}

Vec3 euler_of(const Mat3& attitude) {
  const Vec3 &forward = attitude.row_x, &right = attitude.row_y, &down = attitude.row_z;
  const double level = std::sqrt(forward.x * forward.x + forward.y * forward.y);
  if (level < 1e-9)  // along the Earth's axis: the other two angles are one
    return {math::atan2(-right.x, right.y), math::atan2(-forward.z, level), 0};
  return {math::atan2(forward.y, forward.x), math::atan2(-forward.z, level),
          math::atan2(right.z, down.z)};
}

Motion reckon(Reckoning algorithm, const Motion& from, double time) {
  using enum Reckoning;
  Motion to = from;
  const bool moves = algorithm >= fpw && algorithm <= fvw;
  const bool turns = algorithm == rpw || algorithm == rvw;
  const bool gathers = algorithm == rvw || algorithm == fvw;
  if (moves)
    to.position += time * from.velocity;
  if (gathers) {
    to.position += time * time / 2 * from.acceleration;
    to.velocity += time * from.acceleration;
  }
  if (turns)
    to.attitude = turn(from.spin, time) * from.attitude;
  return to;
}

Vec3 spin_between(const Mat3& from, const Mat3& to, double time) {
  const Mat3 turned = to * transpose(from);
  // the part of it that is no symmetric matrix: - sin(angle) [n x]
  const Vec3 twist{(turned.row_y.z - turned.row_z.y) / 2, (turned.row_z.x - turned.row_x.z) / 2,
                   (turned.row_x.y - turned.row_y.x) / 2};
  const double s = norm(twist), c = (trace_between(from, to) - 1) / 2;
  return s < 1e-12 ? Vec3{} : math::atan2(s, c) / (s * time) * twist;
}

Motion motion_of(const EntityState& state) {
  return {.position = state.location,
          .velocity = wide(state.velocity),
          .acceleration = wide(state.acceleration),
          .attitude = attitude_of(wide(state.orientation)),
          .spin = wide(state.spin)};
}

bool apart(const Motion& a, const Motion& b, const Thresholds& thresholds) {
  return norm2(a.position - b.position) > thresholds.position * thresholds.position ||
         trace_between(a.attitude, b.attitude) < 1 + 2 * math::cos(thresholds.angle);
}

}  // namespace eyrie::dis
