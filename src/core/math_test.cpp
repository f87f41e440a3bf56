// SPDX-License-Identifier: MIT
// How far each function is from the true value: libm in long double, over the range it claims.
#include "core/math.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/angle.hpp"

namespace eyrie {
namespace {

constexpr int kPoints = 300'000;

/// Evenly spread numbers in [low, high], the same on every machine: multiples of the golden
/// section.
double spread(int i, double low, double high) {
  const double turns = (i + 0.5) * 0x1.3c6ef372fe95p-1;
  return low + (high - low) * (turns - std::floor(turns));
}

/// The error of a result in units in the last place of the true value.
double ulp_error(double result, long double truth) {
  int exponent = 0;
  std::frexp(static_cast<double>(truth), &exponent);
  return static_cast<double>(std::fabs(result - truth) / std::ldexp(1.0L, exponent - 53));
}

struct Worst {
  double error = 0, x = 0, y = 0;

  void see(double result, long double truth, double at_x, double at_y = 0) {
    const double new_error = ulp_error(result, truth);
    if (!(new_error <= error))  // NaN too
      *this = {new_error, at_x, at_y};
  }
};

using Function = double (*)(double);
using LongTruth = long double (*)(long double);

/// `spaced` maps [low, high] to the arguments: itself, or exp2 for many orders of magnitude.
void expect_within(
    double ulp, Function function, LongTruth truth, double low, double high,
    double (*spaced)(double) = [](double x) { return x; }) {
  Worst worst;
  for (int i = 0; i < kPoints; ++i) {
    const double x = spaced(spread(i, low, high));
    worst.see(function(x), truth(x), x);
  }
  EXPECT_LE(worst.error, ulp) << "at " << worst.x << " in [" << low << ", " << high << "]";
}

double power_of_two(double x) {
  return std::exp2(x);
}
double minus_power_of_two(double x) {
  return -std::exp2(x);
}

TEST(Math, SineAndCosineAreWithin0_85Ulp) {
  for (const double range : {1.0, 4.0, 100.0, 0x1p20}) {
    expect_within(0.85, math::sin, std::sin, -range, range);
    expect_within(0.85, math::cos, std::cos, -range, range);
  }
  expect_within(0.85, math::sin, std::sin, -300, 0, power_of_two);
}

TEST(Math, SineAndCosineKeepTheirDigitsNearTheirZeros) {
  Worst worst;
  for (int quarter = 1; quarter < 600'000; quarter += 7) {
    const double zero = static_cast<double>(quarter * (kPi / 2));
    for (const double x : {zero, std::nextafter(zero, 0), zero * (1 + 1e-9), -zero * (1 - 1e-12)}) {
      worst.see(math::sin(x), std::sin(static_cast<long double>(x)), x);
      worst.see(math::cos(x), std::cos(static_cast<long double>(x)), x);
    }
  }
  EXPECT_LE(worst.error, 0.85) << "at " << worst.x;
}

TEST(Math, SineAndCosineBeyondTheirRangeStayBoundedAndNear) {
  for (int i = 0; i < 1000; ++i) {
    const double x = spread(i, 0x1p20, 0x1p30);
    const auto [s, c] = math::sin_cos(x);
    EXPECT_LE(std::fabs(s), 1);
    EXPECT_NEAR(s, static_cast<double>(std::sin(static_cast<long double>(x))), x * 0x1p-53);
    EXPECT_NEAR(c, static_cast<double>(std::cos(static_cast<long double>(x))), x * 0x1p-53);
  }
}

TEST(Math, TangentIsWithin1_5Ulp) {
  for (const double range : {1.0, 4.0, 0x1p20})
    expect_within(1.5, math::tan, std::tan, -range, range);
  expect_within(1.5, math::tan, std::tan, -300, 0, power_of_two);
}

TEST(Math, ArcSineAndArcCosineAreWithin0_9Ulp) {
  expect_within(0.9, math::asin, std::asin, -1, 1);
  expect_within(0.9, math::asin, std::asin, -0.6, -0.4);
  expect_within(0.9, math::asin, std::asin, -300, 0, power_of_two);
  expect_within(0.9, math::acos, std::acos, -1, 1);
  expect_within(0.9, math::acos, std::acos, -0.6, 0.6);
  expect_within(0.9, math::acos, std::acos, -52, -1, [](double x) { return 1 - std::exp2(x); });
}

TEST(Math, ArcTangentIsWithin1_3Ulp) {
  expect_within(1.3, math::atan, std::atan, -1, 1);
  expect_within(1.3, math::atan, std::atan, 0.3, 0.4);
  expect_within(1.3, math::atan, std::atan, -300, 300, power_of_two);
  expect_within(1.3, math::atan, std::atan, -30, 30, minus_power_of_two);
}

TEST(Math, ArcTangentOfTwoIsWithin1_6UlpInAllDirections) {
  for (const double scale : {1.0, 0x1p-700, 0x1p700}) {
    Worst worst;
    for (int i = 0; i < kPoints; ++i) {
      const double direction = spread(i, -kPi, kPi), length = scale * spread(7 * i, 0.5, 2);
      const double y = length * std::sin(direction), x = length * std::cos(direction);
      worst.see(math::atan2(y, x), std::atan2(static_cast<long double>(y), x), y, x);
    }
    EXPECT_LE(worst.error, 1.6) << "at " << worst.x << ", " << worst.y;
  }
  // the ends of the range of double
  for (const double x : {1e308, 3.0, 1e-308, 5e-324})
    for (const double y : {1.7e308, 1e308, -2.0, 1e-308, 5e-324})
      if (std::fabs(y / x) > 0x1p-1022) {
        const long double truth = std::atan2(static_cast<long double>(y), x);
        EXPECT_LE(ulp_error(math::atan2(y, x), truth), 1.6) << y << ", " << x;
      }
}

TEST(Math, ExponentialsAreWithin0_65Ulp) {
  for (const double range : {0.5, 10.0, 708.0})
    expect_within(0.65, math::exp, std::exp, -range, range);
  expect_within(0.65, math::exp, std::exp, 708, 709.78);
  expect_within(0.65, math::exp, std::exp, -300, 0, power_of_two);
  for (const double range : {0.5, 10.0, 1021.9})
    expect_within(0.65, math::exp2, std::exp2, -range, range);
  expect_within(0.65, math::exp2, std::exp2, 1022, 1023.999);
}

TEST(Math, LogarithmsAreWithin0_51Ulp) {
  const auto check = [](Function function, LongTruth truth) {
    expect_within(0.51, function, truth, 0.5, 2);
    expect_within(0.51, function, truth, 0.99, 1.01);
    expect_within(0.51, function, truth, -1074, 1023, power_of_two);
    expect_within(0.51, function, truth, -50, -6, [](double x) { return 1 + std::exp2(x); });
    expect_within(0.51, function, truth, -50, -6, [](double x) { return 1 - std::exp2(x); });
  };
  check(math::log, std::log);
  check(math::log2, std::log2);
  check(math::log10, std::log10);
}

TEST(Math, LogarithmsOfWholePowersAreWhole) {
  for (int k = -1074; k <= 1023; ++k)
    EXPECT_EQ(math::log2(std::ldexp(1.0, k)), k);
  double ten_to_k = 1;
  for (int k = 0; k <= 22; ++k, ten_to_k *= 10)
    EXPECT_EQ(math::log10(ten_to_k), k);
}

TEST(Math, PowerIsWithin0_65Ulp) {
  struct Range {
    double log2_x, y;
  };
  for (const Range& range : {Range{20, 10}, Range{1, 5}, Range{0.001, 1e5}, Range{1020, 0.9}}) {
    Worst worst;
    for (int i = 0; i < kPoints; ++i) {
      const double x = std::exp2(spread(i, -range.log2_x, range.log2_x));
      const double y = spread(11 * i, -range.y, range.y);
      worst.see(math::pow(x, y), std::pow(static_cast<long double>(x), y), x, y);
    }
    EXPECT_LE(worst.error, 0.65) << "at " << worst.x << ", " << worst.y;
  }
  EXPECT_EQ(math::pow(10, 3), 1000);
  EXPECT_EQ(math::pow(2, -10), 0x1p-10);
  EXPECT_EQ(math::pow(144, 0.5), 12);
}

TEST(Math, MirrorsExactly) {
  // what keeps a mirrored scenario mirrored
  for (int i = 0; i < 100'000; ++i) {
    const double x = spread(i, 0, 50), y = spread(3 * i, 0, 50);
    ASSERT_EQ(math::sin(-x), -math::sin(x));
    ASSERT_EQ(math::cos(-x), math::cos(x));
    ASSERT_EQ(math::tan(-x), -math::tan(x));
    ASSERT_EQ(math::asin(-x / 50), -math::asin(x / 50));
    ASSERT_EQ(math::atan2(-y, x), -math::atan2(y, x));
    ASSERT_EQ(math::atan2(-y, -x), -math::atan2(y, -x));
  }
}

}  // namespace
}  // namespace eyrie
