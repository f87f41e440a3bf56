// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/lanes.hpp"

/// \file The elementary functions that a step may use. They are made of + - * / sqrt and bit
/// operations only (and fmod, which is exact), so they give the same bits on every IEEE 754 machine
/// with any compiler at any optimisation. libm does not: glibc picks other code on a processor
/// without FMA.
///
/// Every comment bounds the error over the range it names, in units in the last place (ulp) of the
/// true value; 0.5 is perfect. The bounds are the worst of 40 million points, rounded up; math_test
/// holds them. Special values are those of C: zeros, infinities, NaN. Results below 2^-1022 are
/// deterministic like all others, but their accuracy is not claimed.
///
/// Polynomials are minimax fits (Remez); reductions follow W. J. Cody and W. Waite, "Software
/// Manual for the Elementary Functions" (1980), and J.-M. Muller, "Elementary Functions" (3rd ed.,
/// 2016).
namespace eyrie::math {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

template <class Real>
struct SinCosOf {
  Real sin, cos;
};
using SinCos = SinCosOf<double>;

/// Both at once: the second is nearly free. Radians; |x| <= 2^20: 0.85 ulp. Beyond that the error
/// grows with |x| as if x were off by |x| 2^-53, but the results stay in [-1, 1].
[[nodiscard]] SinCos sin_cos(double x);
/// Of two angles abreast, in hardly more time than of one; the same bits.
[[nodiscard]] std::array<SinCos, 2> sin_cos(double x, double y);
[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);
/// |x| <= 2^20: 1.5 ulp.
[[nodiscard]] double tan(double x);

/// [-1, 1]: 0.9 ulp; NaN outside.
[[nodiscard]] double asin(double x);
/// [-1, 1]: 0.9 ulp; NaN outside.
[[nodiscard]] double acos(double x);
/// Everywhere: 1.3 ulp.
[[nodiscard]] double atan(double x);
/// The angle of (x, y) in [-pi, pi]: 1.6 ulp everywhere. atan2(0, 0) is 0.
[[nodiscard]] double atan2(double y, double x);

/// Everywhere: 0.65 ulp.
[[nodiscard]] double exp(double x);
/// Of both, side by side.
[[nodiscard]] std::array<double, 2> exp(double x, double y);
/// Everywhere: 0.65 ulp.
[[nodiscard]] double exp2(double x);
/// Everywhere: 0.51 ulp. -infinity for 0, NaN below.
[[nodiscard]] double log(double x);
/// Everywhere: 0.51 ulp; exact for powers of two.
[[nodiscard]] double log2(double x);
/// Everywhere: 0.51 ulp; exact for whole powers of ten.
[[nodiscard]] double log10(double x);
/// x to the power of y, for x >= 0: 0.65 ulp wherever the result is a normal number. NaN for x < 0
/// (even if y is whole: write x * x).
[[nodiscard]] double pow(double x, double y);

namespace detail {

/// c0 + c1 z + c2 z^2 ...
template <class Real>
constexpr double horner(const Real&, double c) {
  return c;
}
template <class Real, class... Rest>
constexpr Real horner(const Real& z, double c, double next, Rest... rest) {
  return c + z * horner(z, next, rest...);
}

/// a where the mask is all zeros, b where it is all ones, without a branch.
template <class Real>
Real pick(const Real& a, const Real& b, const BitsOf<Real>& mask) {
  const auto bits = std::bit_cast<BitsOf<Real>>(a);
  return std::bit_cast<Real>(bits ^ ((bits ^ std::bit_cast<BitsOf<Real>>(b)) & mask));
}
template <class Real>
Real flip_sign(const Real& x, const BitsOf<Real>& flip) {
  return std::bit_cast<Real>(std::bit_cast<BitsOf<Real>>(x) ^ flip << 63);
}

SinCos sin_cos_far(double x);
double atan2_special(double y, double x);
/// sin_cos and atan2, not inlined.
SinCos sin_cos_of_one(double x);
double atan2_of_one(double y, double x);

/// Adding and subtracting it rounds a double below 2^51 to a whole number, which then is in the
/// low bits of the sum.
inline constexpr double kRounder = 0x1.8p52;

/// x less its nearest whole number of quarter turns, |x| <= 2^20, and sine and cosine of that, each
/// with what the last rounding took away.
template <class Real>
struct QuarterTurn {
  Real s, s_low, c, c_low;
  BitsOf<Real> turns;  ///< in the low bits
};

template <class Real>
QuarterTurn<Real> quarter_turn(const Real& x) {
  // r + tail = x - q pi/2, with pi/2 in three parts: the first two products are exact
  const Real shifted = x * 0x1.45f306dc9c883p-1 + kRounder;
  const Real q = shifted - kRounder;
  const Real far = x - q * 0x1.921fb544p+0;
  const Real b = q * 0x1.0b4611a6p-34;
  const Real c = q * 0x1.3198a2e037073p-69;
  const Real near = far - b;
  const Real r = near - c;
  const Real tail = ((near - r) - c) + ((far - near) - b);

  // sin r = r + r^3 (s0 + z s(z)), cos r = 1 - z / 2 + z^2 c(z), |r| <= pi/4: minimax, 2^-57, 2^-64
  const Real z = r * r, zz = z * z, cube = z * r;
  const Real s = horner(zz, 0x1.111111110f73p-7, 0x1.71de355529b72p-19, 0x1.5d8b4bda17f1dp-33) +
                 z * horner(zz, -0x1.a01a019be9205p-13, -0x1.ae5e4b826cf2p-26);
  const Real co =
      horner(zz, 0x1.555555555554bp-5, 0x1.a01a019c8c7d5p-16, 0x1.1ee9d9c5fae6ep-29) +
      z * horner(zz, -0x1.6c16c16c15005p-10, -0x1.27e4f7ef0d057p-22, -0x1.8fa55309e4213p-37);
  // written so that the sign of a zero survives
  const Real sine_rest = (z * (0.5 * tail - cube * s) - tail) - cube * -0x1.5555555555548p-3;
  const Real sine = r - sine_rest;
  const Real half = 0.5 * z;
  const Real one = 1 - half;
  const Real cosine_rest = ((1 - one) - half) + (zz * co - r * tail);
  const Real cosine = one + cosine_rest;
  return {sine, (r - sine) - sine_rest, cosine, (one - cosine) + cosine_rest,
          std::bit_cast<BitsOf<Real>>(shifted)};
}

template <class Real>
SinCosOf<Real> sin_cos_near(const Real& x) {
  const QuarterTurn<Real> part = quarter_turn(x);
  const BitsOf<Real> swap = -(part.turns & 1);
  return {flip_sign(pick(part.s, part.c, swap), part.turns >> 1 & 1),
          flip_sign(pick(part.c, part.s, swap), (part.turns + 1) >> 1 & 1)};
}

}  // namespace detail

inline SinCos sin_cos(double x) {
  if (!(std::fabs(x) <= 0x1p20))
    return detail::sin_cos_far(x);
  return detail::sin_cos_near(x);
}
template <std::size_t N>
SinCosOf<Lanes<N>> sin_cos(const Lanes<N>& x) {
  if (!all(abs(x) <= 0x1p20)) {
    const auto of = [&](std::size_t i) { return detail::sin_cos_of_one(x.v[i]); };
    return {each_lane<Lanes<N>>([&](std::size_t i) { return of(i).sin; }),
            each_lane<Lanes<N>>([&](std::size_t i) { return of(i).cos; })};
  }
  return detail::sin_cos_near(x);
}

inline std::array<SinCos, 2> sin_cos(double x, double y) {
  if (!(std::fabs(x) <= 0x1p20 && std::fabs(y) <= 0x1p20))
    return {sin_cos(x), sin_cos(y)};
  const auto [sines, cosines] = detail::sin_cos_near(Lanes<2>(Lanes<2>::Vector{x, y}));
  return {{{sines.v[0], cosines.v[0]}, {sines.v[1], cosines.v[1]}}};
}
template <std::size_t N>
std::array<SinCosOf<Lanes<N>>, 2> sin_cos(const Lanes<N>& x, const Lanes<N>& y) {
  return {sin_cos(x), sin_cos(y)};
}

inline double sin(double x) {
  return sin_cos(x).sin;
}
inline double cos(double x) {
  return sin_cos(x).cos;
}

namespace detail {

/// atan2 where the smaller of |x| and |y| is a number and the larger one in (2^-960, 2^1020).
template <class Real>
Real atan2_ordinary(const Real& y, const Real& x, const Real& small, const Real& big) {
  // small / big is tan(atan(step / 2) + atan(u)) with |u| <= 5/16; the numerator is exact
  const auto step = ones(small >= 0.3125 * big) + ones(small >= 0.75 * big);
  const Real t = 0.5 * whole<Real>(step);
  const Real u = (small - t * big) / (big + t * small);

  // atan(u) = u + u^3 rest(u^2): minimax, 2^-57
  const Real z = u * u, zz = z * z;
  const Real rest = horner(zz, -0x1.55555555554e3p-2, -0x1.24924917bd9c9p-3, -0x1.745c0070b271cp-4,
                           -0x1.0f881b1406b62p-4, -0x1.1a2d480ac9d06p-5) +
                    z * horner(zz, 0x1.999999998291ap-3, 0x1.c71c6ac208b68p-4, 0x1.3af97189c7adcp-4,
                               0x1.c5b6bb9e731f0p-5);

  // the angle is base +- atan(u); where it is folded at pi/4 or at pi/2 the sign turns
  struct Base {
    double high, low;
  };
  static constexpr std::array<Base, 12> kBase{{
      {0, 0},                                         // 0
      {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},  // atan(1/2)
      {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},  // pi/4
      {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54},  // pi/2
      {0x1.1b6e192ebbe44p+0, 0x1.b1b466a88828ep-54},  // pi/2 - atan(1/2)
      {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},  // pi/4
      {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53},  // pi
      {0x1.56c6e7397f5aep+1, 0x1.660b64ece6f4bp-53},  // pi - atan(1/2)
      {0x1.2d97c7f3321d2p+1, 0x1.a79394c9e8a0ap-54},  // 3 pi/4
      {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54},  // pi/2
      {0x1.0468a8ace4df6p+1, 0x1.0620bf7406affp-55},  // pi/2 + atan(1/2)
      {0x1.2d97c7f3321d2p+1, 0x1.a79394c9e8a0ap-54},  // 3 pi/4
  }};
  const auto steep = ones(abs(y) >= big), back = sign_bit(x);
  const auto place = 6 * back + 3 * steep + step;
  const auto base = [&](double Base::*part) {
    return each_lane<Real>([&](std::size_t i) { return kBase[lane(place, i)].*part; });
  };
  const auto flip = steep ^ back;
  const Real angle =
      base(&Base::high) + (flip_sign(u, flip) + (flip_sign(u * z * rest, flip) + base(&Base::low)));
  return copysign(angle, y);
}

}  // namespace detail

inline double atan2(double y, double x) {
  const double small = min(abs(x), abs(y)), big = max(abs(y), abs(x));
  if (!(big > 0x1p-960 && big < 0x1p1020 && small >= 0))
    return detail::atan2_special(y, x);
  return detail::atan2_ordinary(y, x, small, big);
}
template <std::size_t N>
Lanes<N> atan2(const Lanes<N>& y, const Lanes<N>& x) {
  const Lanes<N> small = min(abs(x), abs(y)), big = max(abs(y), abs(x));
  if (!all((big > 0x1p-960) & (big < 0x1p1020) & (small >= 0)))
    return each_lane<Lanes<N>>([&](std::size_t i) { return detail::atan2_of_one(y.v[i], x.v[i]); });
  return detail::atan2_ordinary(y, x, small, big);
}

inline double atan(double x) {
  return atan2(x, 1);
}

}  // namespace eyrie::math
