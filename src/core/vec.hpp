// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "core/math.hpp"

namespace eyrie {

/// Three numbers in one frame; the name of a variable says which (`_ned`, `_ecef`, `_body`).
struct Vec3 {
  double x = 0, y = 0, z = 0;

  constexpr Vec3& operator+=(const Vec3& b) { return *this = {x + b.x, y + b.y, z + b.z}; }
  constexpr Vec3& operator-=(const Vec3& b) { return *this = {x - b.x, y - b.y, z - b.z}; }
  constexpr Vec3& operator*=(double s) { return *this = {x * s, y * s, z * s}; }
  constexpr Vec3& operator/=(double s) { return *this = {x / s, y / s, z / s}; }
  friend constexpr Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
  friend constexpr Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
  friend constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(Vec3 a, double s) { return a *= s; }
  friend constexpr Vec3 operator*(double s, Vec3 a) { return a *= s; }
  friend constexpr Vec3 operator/(Vec3 a, double s) { return a /= s; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

[[nodiscard]] constexpr double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// The square of the length.
[[nodiscard]] constexpr double norm2(const Vec3& v) {
  return dot(v, v);
}
[[nodiscard]] inline double norm(const Vec3& v) {
  return std::sqrt(norm2(v));
}
/// The direction of `v`; `fallback` if `v` has no length (below 1e-150) or none that is a number.
[[nodiscard]] inline Vec3 normalized(const Vec3& v, const Vec3& fallback) {
  const double length = norm(v);
  return length > 1e-150 && length < 1e150 ? v / length : fallback;
}
/// The angle between two directions in [0, pi]; 0 if one has no length. Accurate for nearly
/// parallel vectors too, where the arc cosine of a dot product is not.
[[nodiscard]] inline double angle_between(const Vec3& a, const Vec3& b) {
  return math::atan2(norm(cross(a, b)), dot(a, b));
}

/// A matrix by rows; `Mat3 * Vec3` is three dot products. The default is the identity.
struct Mat3 {
  Vec3 row_x{1, 0, 0}, row_y{0, 1, 0}, row_z{0, 0, 1};

  friend constexpr Vec3 operator*(const Mat3& m, const Vec3& v) {
    return {dot(m.row_x, v), dot(m.row_y, v), dot(m.row_z, v)};
  }
  friend constexpr bool operator==(const Mat3&, const Mat3&) = default;
};

[[nodiscard]] constexpr Mat3 transpose(const Mat3& m) {
  return {{m.row_x.x, m.row_y.x, m.row_z.x},
          {m.row_x.y, m.row_y.y, m.row_z.y},
          {m.row_x.z, m.row_y.z, m.row_z.z}};
}
[[nodiscard]] constexpr Mat3 operator*(const Mat3& a, const Mat3& b) {
  const Mat3 columns = transpose(b);
  return transpose({a * columns.row_x, a * columns.row_y, a * columns.row_z});
}

/// Heading, pitch and roll in radians, applied in this order (aerospace 3-2-1): nose to the right,
/// nose up, right wing down are positive.
struct Euler {
  double heading = 0, pitch = 0, roll = 0;
};

/// A rotation from body axes (x nose, y right wing, z belly) to NED. The default is no rotation.
/// Stevens, Lewis & Johnson, Aircraft Control and Simulation, 3rd ed., sec. 1.3 and 1.8.
struct Quat {
  double w = 1, x = 0, y = 0, z = 0;

  /// First `b`, then `a`.
  friend constexpr Quat operator*(const Quat& a, const Quat& b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
            a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
  }
  friend constexpr bool operator==(const Quat&, const Quat&) = default;
};

/// The inverse of a unit quaternion: NED to body.
[[nodiscard]] constexpr Quat conjugate(const Quat& q) {
  return {q.w, -q.x, -q.y, -q.z};
}
/// Body to NED, for a unit quaternion.
[[nodiscard]] constexpr Vec3 rotate(const Quat& q, const Vec3& body) {
  const Vec3 u{q.x, q.y, q.z};
  const Vec3 t = 2 * cross(u, body);
  return body + q.w * t + cross(u, t);
}
/// Unit length again after a product or an integration step; no rotation if there is nothing left.
[[nodiscard]] inline Quat normalized(const Quat& q) {
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!(length > 1e-150 && length < 1e150))
    return {};
  return {q.w / length, q.x / length, q.y / length, q.z / length};
}
/// The same rotation as a matrix, body to NED.
[[nodiscard]] constexpr Mat3 to_matrix(const Quat& q) {
  const double ww = q.w * q.w, xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  return {{ww + xx - yy - zz, 2 * (q.x * q.y - q.w * q.z), 2 * (q.x * q.z + q.w * q.y)},
          {2 * (q.x * q.y + q.w * q.z), ww - xx + yy - zz, 2 * (q.y * q.z - q.w * q.x)},
          {2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x), ww - xx - yy + zz}};
}
[[nodiscard]] inline Quat from_euler(double heading, double pitch, double roll) {
  const auto [sh, ch] = math::sin_cos(heading / 2);
  const auto [sp, cp] = math::sin_cos(pitch / 2);
  const auto [sr, cr] = math::sin_cos(roll / 2);
  return {cr * cp * ch + sr * sp * sh, sr * cp * ch - cr * sp * sh, cr * sp * ch + sr * cp * sh,
          cr * cp * sh - sr * sp * ch};
}
/// Heading and roll in (-pi, pi], pitch in [-pi/2, pi/2], of a unit quaternion. Within about 1e-7
/// rad of the vertical only their sum or difference is known: roll is then 0 by convention.
[[nodiscard]] inline Euler to_euler(const Quat& q) {
  const double sine = std::clamp(2 * (q.w * q.y - q.x * q.z), -1.0, 1.0);
  if (std::fabs(sine) > 1 - 1e-14)
    return {wrap_pi(-2 * std::copysign(1.0, sine) * math::atan2(q.x, q.w)),
            std::copysign(kPi / 2, sine), 0};
  return {math::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z)),
          math::asin(sine),
          math::atan2(2 * (q.w * q.x + q.y * q.z), 1 - 2 * (q.x * q.x + q.y * q.y))};
}

}  // namespace eyrie
