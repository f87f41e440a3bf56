// SPDX-License-Identifier: MIT
#include "core/math.hpp"

#include "core/angle.hpp"

namespace eyrie::math {
namespace {

// pi/2 and pi in two parts
constexpr double kHalfPi = 0x1.921fb54442d18p+0, kHalfPiLow = 0x1.1a62633145c07p-54;

/// The leading 26 bits, so that its square is exact.
double leading(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~((std::uint64_t{1} << 27) - 1));
}

/// (asin(x) - x) / x for z = x^2 <= 1/4: minimax, 2^-59.
double asin_rest(double z) {
  const double zz = z * z;
  return z *
         (detail::horner(zz, 0x1.5555555555578p-3, 0x1.6db6db722bf62p-5, 0x1.6e8bdfea93b6dp-6,
                         0x1.ca21493edb187p-7, 0x1.618b6af127635p-7, 0x1.6504889d0b771p-6,
                         0x1.0be54f87b5b27p-5) +
          z * detail::horner(zz, 0x1.333333332df06p-4, 0x1.f1c71a8b711dap-6, 0x1.1c49ddc48fd1ap-6,
                             0x1.75776996c5f62p-7, 0x1.e151fb81fbb1fp-9, -0x1.59f9bc3d6fb2cp-6));
}

/// asin(root) with root^2 = (1 - |x|) / 2, as high + low.
struct HalfAngle {
  double high, low;
};
HalfAngle half_angle(double x) {
  const double square = 0.5 * (1 - std::fabs(x));  // exact for |x| >= 1/2
  const double root = std::sqrt(square);
  if (root == 0)
    return {0, 0};
  const double high = leading(root);
  const double low = (square - high * high) / (root + high);
  return {high, low + root * asin_rest(square)};
}

}  // namespace

SinCos detail::sin_cos_far(double x) {
  // whole turns of a rounded 2 pi: deterministic and bounded; NaN for infinity and NaN
  if (!std::isfinite(x))
    return {kNaN, kNaN};
  return sin_cos(std::fmod(x, kTau));
}

SinCos detail::sin_cos_of_one(double x) {
  return sin_cos(x);
}

double detail::atan2_of_one(double y, double x) {
  return atan2(y, x);
}

double tan(double x) {
  if (!(std::fabs(x) <= 0x1p20)) {
    const auto [s, c] = sin_cos(x);
    return s / c;
  }
  if (std::fabs(x) < 0x1p-27)
    return x;  // the sign of a zero too
  const auto part = detail::quarter_turn(x);
  if ((part.turns & 1) == 0) {
    const double ratio = part.s / part.c;
    return ratio + (part.s_low - ratio * part.c_low) / part.c;
  }
  const double ratio = -part.c / part.s;
  return ratio - (part.c_low + ratio * part.s_low) / part.s;
}

double asin(double x) {
  if (std::fabs(x) <= 0.5)
    return x + x * asin_rest(x * x);
  if (!(std::fabs(x) <= 1))
    return kNaN;
  // pi/2 - 2 asin(root)
  const HalfAngle half = half_angle(x);
  const double angle = (0.5 * kHalfPi - 2 * half.high) + (kHalfPiLow - 2 * half.low);
  return std::copysign(0.5 * kHalfPi + angle, x);
}

double acos(double x) {
  if (std::fabs(x) <= 0.5)
    return kHalfPi - (x - (kHalfPiLow - x * asin_rest(x * x)));
  if (!(std::fabs(x) <= 1))
    return kNaN;
  // 2 asin(root), or pi less that
  const HalfAngle half = half_angle(x);
  if (x > 0)
    return 2 * (half.high + half.low);
  return 2 * ((kHalfPi - half.high) + (kHalfPiLow - half.low));
}

double detail::atan2_special(double y, double x) {
  if (std::isnan(x) || std::isnan(y))
    return kNaN;
  const bool back = std::signbit(x);
  if (y == 0)
    return std::copysign(back ? kPi : 0, y);
  if (std::isinf(x) || std::isinf(y)) {
    // towards infinity only the ratio of infinities counts
    const double to_x = std::copysign(std::isinf(x) ? 1.0 : 0.0, x);
    const double to_y = std::copysign(std::isinf(y) ? 1.0 : 0.0, y);
    return to_y == 0 ? atan2_special(to_y, to_x) : atan2(to_y, to_x);
  }
  // near the ends of the range the sum of both would overflow, or their bits are too few
  const double scale = std::fabs(x) > 1 || std::fabs(y) > 1 ? 0x1p-4 : 0x1p+600;
  return atan2(y * scale, x * scale);
}

}  // namespace eyrie::math
