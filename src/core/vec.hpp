// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "core/angle.hpp"
#include "core/math.hpp"

namespace eyrie {

/// Three numbers in one frame; the name of a variable says which (`_ned`, `_ecef`, `_body`).
template <class Real>
struct Vec3Of {
  Real x = 0, y = 0, z = 0;

  constexpr Vec3Of& operator+=(const Vec3Of& b) { return *this = {x + b.x, y + b.y, z + b.z}; }
  constexpr Vec3Of& operator-=(const Vec3Of& b) { return *this = {x - b.x, y - b.y, z - b.z}; }
  constexpr Vec3Of& operator*=(const Real& s) { return *this = {x * s, y * s, z * s}; }
  constexpr Vec3Of& operator/=(const Real& s) { return *this = {x / s, y / s, z / s}; }
  friend constexpr Vec3Of operator+(Vec3Of a, const Vec3Of& b) { return a += b; }
  friend constexpr Vec3Of operator-(Vec3Of a, const Vec3Of& b) { return a -= b; }
  friend constexpr Vec3Of operator-(const Vec3Of& a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3Of operator*(Vec3Of a, const Real& s) { return a *= s; }
  friend constexpr Vec3Of operator*(const Real& s, Vec3Of a) { return a *= s; }
  friend constexpr Vec3Of operator/(Vec3Of a, const Real& s) { return a /= s; }
  friend constexpr bool operator==(const Vec3Of&, const Vec3Of&) = default;

  [[nodiscard]] friend constexpr Real dot(const Vec3Of& a, const Vec3Of& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }
  [[nodiscard]] friend constexpr Vec3Of cross(const Vec3Of& a, const Vec3Of& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};
using Vec3 = Vec3Of<double>;

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

/// A vector as it stands in rows and messages.
using Vec3f = std::array<float, 3>;
[[nodiscard]] constexpr Vec3f narrow(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
[[nodiscard]] constexpr Vec3 wide(const Vec3f& v) {
  return {v[0], v[1], v[2]};
}

/// A matrix by rows; `Mat3 * Vec3` is three dot products. The default is the identity.
struct Mat3 {
  Vec3 row_x{1, 0, 0}, row_y{0, 1, 0}, row_z{0, 0, 1};

  template <class Real>
  friend constexpr Vec3Of<Real> operator*(const Mat3& m, const Vec3Of<Real>& v) {
    const auto row = [&](const Vec3& r) { return r.x * v.x + r.y * v.y + r.z * v.z; };
    return {row(m.row_x), row(m.row_y), row(m.row_z)};
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

}  // namespace eyrie
