// SPDX-License-Identifier: MIT
#include "core/lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/angle.hpp"
#include "core/draw.hpp"
#include "core/math.hpp"

namespace eyrie::math {
namespace {

using Pair = Lanes<2>;

/// Numbers of all sizes, and the special ones.
std::vector<double> numbers() {
  std::vector<double> all{0.0,        -0.0, 1,     -1,     0x1p20,    -0x1.0000000000001p20,
                          kPi,        -kPi, 1e300, 1e-300, 0x1p-1060, kInfinity,
                          -kInfinity, kNaN};
  Draw draw(1, PlayerId{1}, Stream::test, 0);
  for (int i = 0; i < 100; ++i)
    all.push_back(draw.uniform(-1, 1) * std::ldexp(1.0, static_cast<int>(draw.uniform(-40, 24))));
  return all;
}

/// In both lanes, whatever is in the other one; NaN has any bits.
void expect_bits(const Pair& both, double first, double second, double x, double y) {
  const auto bits = [](double v) {
    return std::isnan(v) ? ~std::uint64_t{0} : std::bit_cast<std::uint64_t>(v);
  };
  EXPECT_EQ(bits(lane(both, 0)), bits(first)) << x << ", " << y;
  EXPECT_EQ(bits(lane(both, 1)), bits(second)) << x << ", " << y;
}

TEST(Lanes, GiveTheBitsOfOneDouble) {
  const std::vector<double> all = numbers();
  for (const double x : all)
    for (const double y : all) {
      const Pair a(Pair::Vector{x, y}), b(Pair::Vector{y, x});
      expect_bits(a + b, x + y, y + x, x, y);
      expect_bits(a * b - a, x * y - x, y * x - y, x, y);
      expect_bits(a / b, x / y, y / x, x, y);
      expect_bits(sqrt(a), std::sqrt(x), std::sqrt(y), x, y);
      expect_bits(abs(-a), std::fabs(x), std::fabs(y), x, y);
      expect_bits(copysign(a, b), std::copysign(x, y), std::copysign(y, x), x, y);
      expect_bits(max(a, b), std::max(x, y), std::max(y, x), x, y);
      expect_bits(min(a, b), std::min(x, y), std::min(y, x), x, y);
      expect_bits(clamp(a, -2, 3), std::clamp(x, -2.0, 3.0), std::clamp(y, -2.0, 3.0), x, y);
      expect_bits(wrap_pi(a), wrap_pi(x), wrap_pi(y), x, y);
      expect_bits(atan2(a, b), atan2(x, y), atan2(y, x), x, y);
      const auto [sine, cosine] = sin_cos(a);
      expect_bits(sine, sin(x), sin(y), x, y);
      expect_bits(cosine, cos(x), cos(y), x, y);
    }
}

TEST(Lanes, HoldRowsMemberByMember) {
  struct Row {
    double a, b, c;
  };
  struct Rows {
    Pair a, b, c;
  };
  Row one{1, 2, 3}, two{4, 5, 6};
  auto both = to_lanes<Rows>(std::array<const Row*, 2>{&one, &two});
  expect_bits(both.b, 2, 5, 2, 5);
  both.c = both.a + both.b;
  from_lanes(both, std::array{&one, &two});
  EXPECT_EQ(one.c, 3);
  EXPECT_EQ(two.c, 9);
}

TEST(Lanes, SelectByWhatIsCompared) {
  const Pair a(Pair::Vector{1, 2}), b(Pair::Vector{2, 1});
  const auto smaller = a < b;
  EXPECT_TRUE(holds(smaller, 0));
  EXPECT_FALSE(holds(smaller, 1));
  EXPECT_TRUE(any(smaller));
  EXPECT_FALSE(any(smaller & (a > b)));
  EXPECT_FALSE(all(smaller));
  EXPECT_TRUE(all(smaller | (a > b)));
  EXPECT_TRUE(holds((!smaller) | (a <= b), 1));
  expect_bits(select(smaller, 7, b), 7, 1, 1, 2);
  EXPECT_EQ(lane(ones(smaller), 0), 1U);
  EXPECT_EQ(lane(ones(smaller), 1), 0U);
  EXPECT_EQ(lane(whole_part(Pair(Pair::Vector{67.9, kNaN})), 0), 67U);
  EXPECT_EQ(lane(whole_part(Pair(Pair::Vector{67.9, kNaN})), 1), 0U);
  expect_bits(whole<Pair>(whole_part(Pair(Pair::Vector{67.9, 0.5}))), 67, 0, 67.9, 0.5);
}

}  // namespace
}  // namespace eyrie::math
