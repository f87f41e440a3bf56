// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>

#include "core/lanes.hpp"

namespace eyrie {

inline constexpr double kPi = 0x1.921fb54442d18p+1;
inline constexpr double kTau = 2 * kPi;

/// Degrees to radians.
[[nodiscard]] constexpr double radians(double degrees) {
  return degrees * (kPi / 180);
}
/// Radians to degrees.
[[nodiscard]] constexpr double degrees(double radians) {
  return radians * (180 / kPi);
}

/// The same direction in (-pi, pi]. An angle that is already there comes back unchanged, bit for
/// bit. Not a number, and infinity, give NaN.
[[nodiscard]] inline double wrap_pi(double x) {
  if (x > -kPi && x <= kPi)
    return x;
  const double turned = x - kTau * std::ceil((x - kPi) / kTau);
  if (turned <= -kPi)
    return kPi;  // rounding may land on the open end, which is the same direction as the closed one
  return turned > kPi ? kPi : turned;
}

template <std::size_t N>
[[nodiscard]] math::Lanes<N> wrap_pi(const math::Lanes<N>& x) {
  const auto inside = (x > -kPi) & (x <= kPi);
  if (math::all(inside))
    return x;
  const math::Lanes<N> turned = x - kTau * math::ceil((x - kPi) / kTau);
  return math::select(inside, x, math::select((turned <= -kPi) | (turned > kPi), kPi, turned));
}

/// The same direction in [0, 2 pi). An angle that is already there comes back unchanged.
[[nodiscard]] inline double wrap_tau(double x) {
  if (x >= 0 && x < kTau)
    return x;
  const double turned = x - kTau * std::floor(x / kTau);
  return turned < 0 || turned >= kTau ? 0 : turned;
}

/// deg, to so many parts of one, from 0 to below 360, as files have it.
[[nodiscard]] inline double heading_degrees(double heading, double parts) {
  const double turned = std::floor(degrees(wrap_tau(heading)) * parts + 0.5);
  return turned < 360 * parts ? turned / parts : 0;
}

/// The signed shortest turn that leads from one heading to another, in (-pi, pi]; positive is
/// clockwise seen from above, as headings are counted.
[[nodiscard]] inline double angle_between(double from, double to) {
  return wrap_pi(to - from);
}
template <std::size_t N>
[[nodiscard]] math::Lanes<N> angle_between(const math::Lanes<N>& from, const math::Lanes<N>& to) {
  const math::Lanes<N> turn = to - from;
  return wrap_pi(turn);
}

}  // namespace eyrie
