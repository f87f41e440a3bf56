// SPDX-License-Identifier: MIT
#include "dis/dead_reckoning.hpp"

namespace eyrie::dis {
namespace {

/// The cosine of the turn between two attitudes, doubled and one more: the trace.
double trace_between(const Mat3& a, const Mat3& b) {
  return dot(a.row_x, b.row_x) + dot(a.row_y, b.row_y) + dot(a.row_z, b.row_z);
}

}  // namespace

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
    to.attitude = model::turn(from.spin, time) * from.attitude;
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
