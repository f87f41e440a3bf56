// SPDX-License-Identifier: MIT
#include "ubf/blend.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <utility>

namespace eyrie::ubf::blend {
namespace {

template <class Sum, class T>
auto blended(std::initializer_list<std::pair<T, double>> opinions) {
  Sum sum;
  for (const auto& [value, vote] : opinions)
    sum.add(value, vote);
  return sum.get();
}

std::optional<double> direction(std::initializer_list<std::pair<double, double>> opinions) {
  return blended<Angle::Sum<double>, double>(opinions);
}

TEST(BlendMean, IsTheWeightedMean) {
  EXPECT_EQ((blended<Mean::Sum<double>, double>({{10, 1}, {40, 2}})), 30);
  EXPECT_EQ((blended<Mean::Sum<double>, double>({})), std::nullopt);
}

TEST(BlendMean, NeverLeavesWhatWasAskedForByRounding) {
  EXPECT_EQ((blended<Mean::Sum<double>, double>({{0.1, 0.3}, {0.1, 0.7}, {0.1, 1e-9}})), 0.1);
}

TEST(BlendAngle, CrossesNorth) {
  EXPECT_NEAR(*direction({{radians(350), 1}, {radians(30), 1}}), radians(10), 1e-12);
  EXPECT_NEAR(*direction({{radians(340), 1}, {radians(350), 1}}), radians(345), 1e-12);
}

/// The sum of unit vectors by libm.
TEST(BlendAngle, IsTheDirectionOfTheVectorSum) {
  const double east = 3 * std::sin(0.4) + 5 * std::sin(2.1);
  const double north = 3 * std::cos(0.4) + 5 * std::cos(2.1);
  EXPECT_NEAR(*direction({{0.4, 3}, {2.1, 5}}), std::atan2(east, north), 1e-12);
}

TEST(BlendAngle, LeavesTheOnlyOpinionAsItIs) {
  EXPECT_EQ(direction({{0.1, 3}}), 0.1);
  EXPECT_EQ(direction({{-0.1, 3}, {-0.1, 2}}), -0.1);
}

TEST(BlendAngle, GivesOpinionsThatCancelToTheStrongestTheEarlierOfEquals) {
  EXPECT_NEAR(*direction({{0.0, 1}, {kPi, 1}}), 0.0, 1e-12);
  EXPECT_NEAR(*direction({{kPi, 1}, {0.0, 1}}), kPi, 1e-12);
  EXPECT_NEAR(*direction({{0.0, 1}, {0.0, 1}, {kPi, 2}}), kPi, 1e-12);
}

TEST(BlendAngle, OfThreeThatCancelIsOneOfThem) {
  const double third = kTau / 3;
  EXPECT_NEAR(*direction({{0.5, 1}, {0.5 + third, 1}, {0.5 + 2 * third, 1}}), 0.5, 1e-12);
}

TEST(BlendStrongest, TakesTheHighestVoteTheEarlierOfEquals) {
  EXPECT_EQ((blended<Strongest::Sum<int>, int>({{7, 1}, {8, 3}, {9, 3}})), 8);
  EXPECT_EQ((blended<Strongest::Sum<int>, int>({})), std::nullopt);
}

TEST(BlendAgreed, KeepsOnlyWhatNobodyDisputes) {
  EXPECT_EQ((blended<Agreed::Sum<int>, int>({{7, 1}, {7, 3}})), 7);
  EXPECT_EQ((blended<Agreed::Sum<int>, int>({{7, 1}, {8, 3}, {7, 9}})), std::nullopt);
  EXPECT_EQ((blended<Agreed::Sum<int>, int>({})), std::nullopt);
}

}  // namespace
}  // namespace eyrie::ubf::blend
