// SPDX-License-Identifier: MIT
#include "core/vec.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

namespace eyrie {
namespace {

constexpr double kDegree = kPi / 180;
constexpr Vec3 kNorth{1, 0, 0}, kEast{0, 1, 0}, kDown{0, 0, 1};

static_assert(sizeof(Vec3) == 24 && std::is_trivially_copyable_v<Vec3>);

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

}  // namespace
}  // namespace eyrie
