// SPDX-License-Identifier: MIT
#pragma once
/// \file  What learned behaviors are made of, in single precision and four at a time: the same bits
/// whether the compiler has vectors or not. As in core/math.hpp they are made of + - * / and bit
/// operations only, and the bounds are in units in the last place of the true value; the
/// polynomials interpolate at Chebyshev's points.
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace eyrie::math {

/// Four floats side by side, and their bits.
using Four = float __attribute__((vector_size(16)));
using FourBits = std::uint32_t __attribute__((vector_size(16)));

[[nodiscard]] inline Four four(float x) {
  return Four{x, x, x, x};
}
/// Four floats that stand one after the other.
[[nodiscard]] inline Four load_four(const float* from) {
  Four x;
  std::memcpy(&x, from, sizeof x);
  return x;
}
inline void store_four(float* to, const Four& x) {
  std::memcpy(to, &x, sizeof x);
}
/// a where the condition holds, else b.
[[nodiscard]] inline Four pick(const FourBits& condition, const Four& a, const Four& b) {
  return std::bit_cast<Four>((std::bit_cast<FourBits>(a) & condition) |
                             (std::bit_cast<FourBits>(b) & ~condition));
}
[[nodiscard]] inline FourBits less(const Four& a, const Four& b) {
  return std::bit_cast<FourBits>(a < b);
}
[[nodiscard]] inline Four abs(const Four& x) {
  return std::bit_cast<Four>(std::bit_cast<FourBits>(x) & 0x7fffffffU);
}

/// [-87, 88]: 1.1 ulp; what is beyond counts as the end of it. NaN stays.
[[nodiscard]] inline Four exp(const Four& any) {
  const Four low = pick(less(any, four(-87)), four(-87), any);
  const Four x = pick(less(four(88), low), four(88), low);
  // r = x - n ln 2, with ln 2 in two parts: the first product is exact
  const Four shifted = x * 0x1.715476p+0F + 0x1.8p23F;
  const Four n = shifted - 0x1.8p23F;
  const Four r = (x - n * 0x1.62e4p-1F) - n * 0x1.7f7d1cp-20F;
  // e^r = 1 + r + r^2 q(r), |r| <= 0.35: 2^-29
  const Four q = 0.5F + r * (0x1.5554d8p-3F +
                             r * (0x1.555516p-5F + r * (0x1.12105cp-7F + r * 0x1.6d15f8p-10F)));
  const Four value = 1.0F + (r + r * r * q);
  return value * std::bit_cast<Four>((std::bit_cast<FourBits>(shifted) << 23) + 0x3f800000U);
}

/// 1 / (1 + e^-x). [-87, 87]: 2.6 ulp; 0 and 1 beyond, give or take 2e-38.
[[nodiscard]] inline Four sigmoid(const Four& x) {
  return 1.0F / (1.0F + exp(-x));
}

/// Everywhere: 2.1 ulp, and within [-1, 1]. NaN stays.
[[nodiscard]] inline Four tanh(const Four& x) {
  const Four a = abs(x), z = x * x;
  // tanh x = x + x^3 p(x^2), |x| < 5/8: 2^-25
  const Four p =
      -0x1.555552p-2F +
      z * (0x1.110dd8p-3F + z * (-0x1.b91582p-5F + z * (0x1.576e30p-6F + z * -0x1.8c2d0ap-8F)));
  const Four small = a + a * (z * p);
  const Four large = 1.0F - 2.0F / (exp(2.0F * a) + 1.0F);
  const Four size = pick(less(a, four(0.625F)), small, large);
  return std::bit_cast<Four>(std::bit_cast<FourBits>(size) |
                             (std::bit_cast<FourBits>(x) & 0x80000000U));
}

}  // namespace eyrie::math
