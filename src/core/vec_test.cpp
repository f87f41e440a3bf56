// SPDX-License-Identifier: MIT
#include "core/vec.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <limits>
#include <type_traits>

namespace eyrie {
namespace {

constexpr double kDegree = kPi / 180;
constexpr Vec3 kNorth{1, 0, 0}, kEast{0, 1, 0}, kDown{0, 0, 1};
constexpr Vec3 kNose{1, 0, 0}, kRightWing{0, 1, 0}, kBelly{0, 0, 1};

static_assert(sizeof(Vec3) == 24 && std::is_trivially_copyable_v<Vec3>);
static_assert(sizeof(Quat) == 32 && std::is_trivially_copyable_v<Quat>);

::testing::AssertionResult near(const Vec3& a, const Vec3& b, double tolerance = 1e-15) {
  if (norm(a - b) <= tolerance)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "(" << a.x << ", " << a.y << ", " << a.z << ") is not ("
                                       << b.x << ", " << b.y << ", " << b.z << ")";
}

TEST(Vec3, AddsAndScales) {
  constexpr Vec3 a{1, 2, 3}, b{-4, 5, 0.5};
  static_assert(a + b == Vec3{-3, 7, 3.5});
  static_assert(a - b == Vec3{5, -3, 2.5});
  static_assert(2 * a == a * 2 && a * 2 == Vec3{2, 4, 6});
  static_assert(-a / 2 == Vec3{-0.5, -1, -1.5});
  static_assert(dot(a, b) == 7.5);
  static_assert(cross(kNorth, kEast) == kDown);
  EXPECT_EQ(norm(Vec3{2, 3, 6}), 7);
  EXPECT_EQ(norm2(Vec3{2, 3, 6}), 49);
}

TEST(Vec3, NormalizesOrFallsBack) {
  EXPECT_TRUE(near(normalized({0, -3, 4}, kNorth), {0, -0.6, 0.8}));
  EXPECT_EQ(normalized({}, kEast), kEast);
  EXPECT_EQ(normalized({1e-200, 0, 0}, kEast), kEast);
  EXPECT_EQ(normalized({std::numeric_limits<double>::quiet_NaN(), 0, 0}, kEast), kEast);
  EXPECT_EQ(normalized({std::numeric_limits<double>::infinity(), 0, 0}, kEast), kEast);
}

TEST(Vec3, MeasuresSmallAndFlatAngles) {
  EXPECT_DOUBLE_EQ(angle_between(kNorth, Vec3{1, 1e-9, 0}), 1e-9);
  EXPECT_DOUBLE_EQ(angle_between(kNorth, -kNorth), kPi);
  EXPECT_DOUBLE_EQ(angle_between(3 * kNorth, 0.1 * kDown), kPi / 2);
  EXPECT_EQ(angle_between(Vec3{}, kNorth), 0);
}

TEST(Mat3, MultipliesByRows) {
  constexpr Mat3 m{{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};
  static_assert(m * Vec3{1, 0, -1} == Vec3{-2, -2, -3});
  static_assert(transpose(m).row_x == Vec3{1, 4, 7});
  static_assert(m * Mat3{} == m && Mat3{} * m == m);
  static_assert((m * m).row_z == Vec3{109, 134, 169});
}

TEST(Quat, TurnsTheNoseRightUpAndTheRightWingDown) {
  EXPECT_TRUE(near(rotate(from_euler(90 * kDegree, 0, 0), kNose), kEast));
  EXPECT_TRUE(near(rotate(from_euler(0, 90 * kDegree, 0), kNose), -kDown));
  EXPECT_TRUE(near(rotate(from_euler(0, 0, 90 * kDegree), kRightWing), kDown));
  // heading east, nose 30 deg up, then rolled inverted: the belly shows up and backward
  const Quat q = from_euler(90 * kDegree, 30 * kDegree, 180 * kDegree);
  EXPECT_TRUE(near(rotate(q, kNose), std::sqrt(0.75) * kEast - 0.5 * kDown));
  EXPECT_TRUE(near(rotate(q, kBelly), -std::sqrt(0.75) * kDown - 0.5 * kEast));
}

TEST(Quat, NormalizesOrGivesUp) {
  const Quat q = normalized(Quat{2, 0, 0, 0});
  EXPECT_EQ(q, Quat{});
  EXPECT_EQ(normalized(Quat{0, 0, 0, 0}), Quat{});
  EXPECT_EQ(normalized(Quat{std::numeric_limits<double>::quiet_NaN(), 0, 0, 0}), Quat{});
}

TEST(Quat, HasNoRollInTheVertical) {
  for (const double pitch : {90 * kDegree, -90 * kDegree}) {
    const Quat q = from_euler(50 * kDegree, pitch, 20 * kDegree);
    const Euler e = to_euler(q);
    EXPECT_EQ(e.roll, 0);
    EXPECT_EQ(e.pitch, std::copysign(kPi / 2, pitch));
    const Quat again = from_euler(e.heading, e.pitch, e.roll);
    EXPECT_TRUE(near(rotate(again, kRightWing), rotate(q, kRightWing), 1e-7));
  }
}

double small(std::int32_t n, double range) {
  return range * n / 2147483648.0;
}

RC_GTEST_PROP(Quat, ComesBackFromEulerAngles, (std::int32_t a, std::int32_t b, std::int32_t c)) {
  const Euler e{small(a, 3.14), small(b, 1.57), small(c, 3.14)};
  const Euler back = to_euler(from_euler(e.heading, e.pitch, e.roll));
  const double slack = 1e-14 / math::cos(e.pitch);  // the vertical takes the rest of the digits
  RC_ASSERT(std::fabs(angle_between(back.heading, e.heading)) < slack);
  RC_ASSERT(std::fabs(back.pitch - e.pitch) < slack);
  RC_ASSERT(std::fabs(angle_between(back.roll, e.roll)) < slack);
}

RC_GTEST_PROP(Quat, RotatesAsItsMatrixAndBack,
              (std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d)) {
  const Quat q = from_euler(small(a, 3), small(b, 1.5), small(c, 3));
  const Vec3 v{small(d, 1000), small(a, 1000), small(b, 1000)};
  RC_ASSERT(near(rotate(q, v), to_matrix(q) * v, 5e-12));
  RC_ASSERT(near(rotate(conjugate(q), rotate(q, v)), v, 5e-12));
  RC_ASSERT(std::fabs(norm(rotate(q, v)) - norm(v)) < 5e-12);
  RC_ASSERT(near(rotate(q * q, v), rotate(q, rotate(q, v)), 5e-12));
}

}  // namespace
}  // namespace eyrie
