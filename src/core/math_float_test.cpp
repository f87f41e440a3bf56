// SPDX-License-Identifier: MIT
#include "core/math_float.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/hash.hpp"

namespace eyrie {
namespace {

constexpr int kFloats = 300'000;

using FourFunction = math::Four (*)(const math::Four&);

float lane_of(FourFunction function, float x) {
  return function(math::four(x))[2];
}

/// The worst error in units in the last place over [low, high].
double worst_of(FourFunction function, long double (*truth)(long double), double low, double high) {
  double most = 0;
  for (int i = 0; i < kFloats; ++i) {
    const auto x = static_cast<float>(low + (high - low) * (i + 0.5) / kFloats);
    const long double wanted = truth(static_cast<long double>(x));
    int exponent = 0;
    std::frexp(static_cast<float>(wanted), &exponent);
    const long double ulp = std::ldexp(1.0L, exponent - 24);
    const auto error = static_cast<double>(
        std::fabs(static_cast<long double>(lane_of(function, x)) - wanted) / ulp);
    if (!(error <= most))  // NaN too
      most = error;
  }
  return most;
}

TEST(MathFloat, ExponentialIsWithin1_1Ulp) {
  for (const double range : {0.1, 1.0, 10.0, 87.0})
    EXPECT_LE(worst_of(math::exp, std::exp, -range, range), 1.1) << range;
}

TEST(MathFloat, SigmoidIsWithin2_6Ulp) {
  const auto truth = [](long double x) { return 1 / (1 + std::exp(-x)); };
  for (const double range : {0.1, 1.0, 10.0, 80.0})
    EXPECT_LE(worst_of(math::sigmoid, truth, -range, range), 2.6) << range;
}

TEST(MathFloat, HyperbolicTangentIsWithin2_1Ulp) {
  for (const double range : {1e-6, 0.1, 0.626, 1.0, 10.0, 1e4})
    EXPECT_LE(worst_of(math::tanh, std::tanh, -range, range), 2.1) << range;
  EXPECT_LE(worst_of(math::tanh, std::tanh, 0.6249, 0.6251), 2.1);
}

TEST(MathFloat, KeepTheirBoundsAndNaN) {
  constexpr float kInfinite = std::numeric_limits<float>::infinity();
  for (const float x : {kInfinite, 1e30F, 90.0F, 10.0F}) {
    EXPECT_EQ(lane_of(math::tanh, x), 1);
    EXPECT_EQ(lane_of(math::tanh, -x), -1);
    EXPECT_EQ(lane_of(math::sigmoid, x), x > 20 ? 1 : lane_of(math::sigmoid, x));
    EXPECT_GE(lane_of(math::sigmoid, -x), 0);
    EXPECT_LE(lane_of(math::sigmoid, -x), 5e-5F);
  }
  EXPECT_TRUE(std::signbit(lane_of(math::tanh, -0.0F)));
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(std::isnan(lane_of(math::tanh, nan)) && std::isnan(lane_of(math::exp, nan)) &&
              std::isnan(lane_of(math::sigmoid, nan)));
}

TEST(MathFloat, HaveTheSameBitsEverywhere) {
  Hasher hasher;
  for (int i = 0; i < 40'000; ++i) {
    const auto x = static_cast<float>((i - 20'000) * 0x1.3p-8);
    for (const FourFunction function :
         {FourFunction(math::exp), FourFunction(math::sigmoid), FourFunction(math::tanh)}) {
      const math::Four four = function(math::Four{x, -x, 0.25F * x, 3 * x});
      hasher.bytes(&four, sizeof four);
    }
  }
  EXPECT_EQ(hash_text(hasher.value()), "0xc8539d94bc56f64d");
}

}  // namespace
}  // namespace eyrie
