// SPDX-License-Identifier: MIT
// The bits of each function: at special values as C defines them, and over sweeps the same for
// every compiler, optimisation and processor.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/hash.hpp"
#include "core/math.hpp"

namespace eyrie {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSpecials[] = {0.0,
                                -0.0,
                                1.0,
                                -1.0,
                                0.5,
                                -0.5,
                                2.0,
                                std::numeric_limits<double>::denorm_min(),
                                -std::numeric_limits<double>::min(),
                                std::numeric_limits<double>::max(),
                                std::numeric_limits<double>::lowest(),
                                kInfinity,
                                -kInfinity,
                                std::numeric_limits<double>::quiet_NaN()};

/// NaN for NaN, the sign of a zero, and otherwise a few last bits.
::testing::AssertionResult same(double ours, double of_c) {
  const bool is_same = std::isnan(of_c)
                           ? std::isnan(ours)
                           : ours == of_c || std::fabs(ours - of_c) <= 4e-16 * std::fabs(of_c);
  if (is_same && (std::isnan(of_c) || std::signbit(ours) == std::signbit(of_c)))
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << ours << " where C says " << of_c;
}

TEST(MathBits, FollowCAtSpecialValues) {
  for (const double x : kSpecials) {
    if (!(std::fabs(x) > 0x1p20) || std::isinf(x)) {
      EXPECT_TRUE(same(math::sin(x), std::sin(x))) << "sin " << x;
      EXPECT_TRUE(same(math::cos(x), std::cos(x))) << "cos " << x;
      EXPECT_TRUE(same(math::tan(x), std::tan(x))) << "tan " << x;
    }
    EXPECT_TRUE(same(math::asin(x), std::asin(x))) << "asin " << x;
    EXPECT_TRUE(same(math::acos(x), std::acos(x))) << "acos " << x;
    EXPECT_TRUE(same(math::atan(x), std::atan(x))) << "atan " << x;
    EXPECT_TRUE(same(math::exp(x), std::exp(x))) << "exp " << x;
    EXPECT_TRUE(same(math::exp2(x), std::exp2(x))) << "exp2 " << x;
    EXPECT_TRUE(same(math::log(x), std::log(x))) << "log " << x;
    EXPECT_TRUE(same(math::log2(x), std::log2(x))) << "log2 " << x;
    EXPECT_TRUE(same(math::log10(x), std::log10(x))) << "log10 " << x;
    for (const double y : kSpecials) {
      EXPECT_TRUE(same(math::atan2(y, x), std::atan2(y, x))) << "atan2 " << y << ", " << x;
      if (std::signbit(x))
        continue;  // pow claims nothing there
      EXPECT_TRUE(same(math::pow(x, y), std::pow(x, y))) << "pow " << x << ", " << y;
    }
  }
}

TEST(MathBits, OverflowAndUnderflowWhereCDoes) {
  EXPECT_EQ(math::exp(709.79), kInfinity);
  EXPECT_EQ(math::exp(-746), 0);
  EXPECT_EQ(math::exp2(1024), kInfinity);
  EXPECT_EQ(math::exp2(-1076), 0);
  EXPECT_EQ(math::exp2(-1074), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(math::pow(10, 309), kInfinity);
  EXPECT_EQ(math::pow(10, -324), 0);
  EXPECT_EQ(math::pow(0.5, 1e300), 0);
  EXPECT_EQ(math::pow(0.5, -1e300), kInfinity);
  EXPECT_NEAR(math::pow(10, -310) / 1e-310, 1, 1e-12);
  EXPECT_TRUE(std::isnan(math::pow(-2, 2)));
}

TEST(MathBits, OfAVeryLargeAngleAreANumber) {
  const auto [s, c] = math::sin_cos(std::numeric_limits<double>::max());
  EXPECT_NEAR(s * s + c * c, 1, 1e-15);
}

TEST(MathBits, OfTwoAnglesAbreastAreThoseOfEach) {
  const double angles[] = {0.0,  -0.0, 0.3,   -0.8, 1.6,   -3.0,      5.5,
                           1e-9, 700,  -1e12, 1e5,  -1e-3, kInfinity, 0x1p20};
  for (const double x : angles)
    for (const double y : angles) {
      const auto both = math::sin_cos(x, y);
      const math::SinCos each[] = {math::sin_cos(x), math::sin_cos(y)};
      for (int i = 0; i < 2; ++i) {
        EXPECT_TRUE(same(both[i].sin, each[i].sin)) << x << ", " << y;
        EXPECT_TRUE(same(both[i].cos, each[i].cos)) << x << ", " << y;
      }
    }
}

/// Arguments made from integers, so that they cannot differ either: 52 pseudo-random bits as a
/// fraction in [-1, 1) times a range.
class Arguments {
 public:
  double operator()(double range) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(static_cast<std::int64_t>(state_) >> 11) * 0x1p-52 * range;
  }

 private:
  std::uint64_t state_ = 20240101;
};

struct Sweep {
  const char* name;
  double (*function)(Arguments&);
  std::uint64_t hash;
};

constexpr Sweep kSweeps[] = {
    {"sin", [](Arguments& a) { return math::sin(a(10)); }, 0x26ccf7946bee5cbeu},
    {"cos", [](Arguments& a) { return math::cos(a(1e6)); }, 0x10300c440756caedu},
    {"sin beyond its range", [](Arguments& a) { return math::sin(a(1e12)); }, 0x43e43446d98b0584u},
    {"tan", [](Arguments& a) { return math::tan(a(2)); }, 0x66cd13d40518700au},
    {"asin", [](Arguments& a) { return math::asin(a(1)); }, 0x53ef62669cd02edeu},
    {"acos", [](Arguments& a) { return math::acos(a(1)); }, 0xc6243ca074bf3c04u},
    {"atan", [](Arguments& a) { return math::atan(a(5)); }, 0xf53c483b984eda16u},
    {"atan2",
     [](Arguments& a) {
       const double y = a(1);
       return math::atan2(y, a(3));
     },
     0x1e1b6b50744c14edu},
    {"exp", [](Arguments& a) { return math::exp(a(700)); }, 0xbb597458f8f98286u},
    {"exp2", [](Arguments& a) { return math::exp2(a(1070)); }, 0x28cb3450a1c92b5u},
    {"log", [](Arguments& a) { return math::log(std::fabs(a(4))); }, 0xf98c0482f6f660b2u},
    {"log2", [](Arguments& a) { return math::log2(std::fabs(a(1e9))); }, 0x5f514c9d34e98709u},
    {"log10", [](Arguments& a) { return math::log10(std::fabs(a(1e-9))); }, 0x16601eb7489a66a0u},
    {"pow",
     [](Arguments& a) {
       const double x = std::fabs(a(100));
       return math::pow(x, a(20));
     },
     0x8eed20daa2929a07u},
};

// If this fails on your machine, its runs are not those of other machines. If you changed a
// function on purpose, put the new value here and fly the golden runs again.
TEST(MathBits, AreTheSameEverywhere) {
  for (const Sweep& sweep : kSweeps) {
    Arguments arguments;
    Hasher hasher;
    for (int i = 0; i < 100'000; ++i)
      hasher.word(std::bit_cast<std::uint64_t>(sweep.function(arguments)));
    EXPECT_EQ(hasher.value(), sweep.hash)
        << sweep.name << ": 0x" << std::hex << hasher.value() << "u";
  }
}

}  // namespace
}  // namespace eyrie
