// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

#include "core/units.hpp"

namespace eyrie {
namespace {

TEST(FormatQuantity, RoundsForPeople) {
  const auto metric = [](double x, Dimension d) { return format_quantity(x, d, UnitStyle::si); };
  const auto pilot = [](double x, Dimension d) {
    return format_quantity(x, d, UnitStyle::aviation);
  };
  EXPECT_EQ(metric(1852.4, Dimension::length), "1852 m");
  EXPECT_EQ(metric(123456.7, Dimension::length), "123457 m");
  EXPECT_EQ(metric(0.5235987, Dimension::angle), "0.524 rad");
  EXPECT_EQ(metric(2, Dimension::none), "2");
  EXPECT_EQ(pilot(1828.8, Dimension::length), "6000 ft");
  EXPECT_EQ(pilot(1852, Dimension::length), "1.0 nmi");
  EXPECT_EQ(pilot(-37040, Dimension::length), "-20.0 nmi");
  EXPECT_EQ(pilot(240, Dimension::speed), "467 kt");
  EXPECT_EQ(pilot(-0.0001, Dimension::angle), "0 deg");
  EXPECT_EQ(pilot(radians(30), Dimension::angle), "30 deg");
  EXPECT_EQ(pilot(radians(12.25), Dimension::angular_rate), "12.2 deg/s");
  EXPECT_EQ(pilot(68.64655, Dimension::acceleration), "7.0 g");
  EXPECT_EQ(pilot(4535.9237, Dimension::mass), "10000 lb");
  EXPECT_EQ(pilot(0.45359237, Dimension::mass_flow), "3600 lb/h");
  EXPECT_EQ(pilot(44482.216152605, Dimension::force), "10000 lbf");
  EXPECT_EQ(pilot(101325, Dimension::pressure), "1013.2 hPa");
  EXPECT_EQ(pilot(288.15, Dimension::temperature), "15 degC");
  EXPECT_EQ(pilot(12.5, Dimension::time), "12.5 s");
  EXPECT_EQ(format_in(37040, "nmi", 2), "20.00 nmi");
}

TEST(ExactQuantity, PicksTheUnitThatSaysItMostSimply) {
  const auto exact = [](double x, Dimension d) { return exact_quantity(x, d); };
  EXPECT_EQ(exact(3704, Dimension::length), "2 nmi");
  EXPECT_EQ(exact(50e3, Dimension::length), "50 km");
  EXPECT_EQ(exact(1828.8, Dimension::length), "6000 ft");
  EXPECT_EQ(exact(6096, Dimension::length), "20000 ft");
  EXPECT_EQ(exact(300, Dimension::length), "300 m");
  EXPECT_EQ(exact(0, Dimension::length), "0 m");
  EXPECT_EQ(exact(0.1, Dimension::length), "0.1 m");
  EXPECT_EQ(exact(-1234.5, Dimension::length), "-1234.5 m");
  EXPECT_EQ(exact(250, Dimension::speed), "250 m/s");
  EXPECT_EQ(exact(radians(30), Dimension::angle), "30 deg");
  EXPECT_EQ(exact(0.5, Dimension::angle), "0.5 rad");
  EXPECT_EQ(exact(0.02, Dimension::time), "20 ms");
  EXPECT_EQ(exact(60, Dimension::time), "60 s");
  EXPECT_EQ(exact(300, Dimension::time), "5 min");
  EXPECT_EQ(exact(-3, Dimension::decibel), "-3 dB");
  EXPECT_EQ(exact(288.15, Dimension::temperature), "15 degC");
  EXPECT_EQ(exact(0.5, Dimension::none), "0.5");
  EXPECT_EQ(exact(std::numeric_limits<double>::infinity(), Dimension::mass), "inf kg");
}

TEST(ExactQuantity, WritesAFloatWithTheDigitsOfAFloat) {
  EXPECT_EQ(exact_quantity(0.1f, Dimension::none), "0.1");
  EXPECT_EQ(exact_quantity(0.1f, Dimension::length), "0.1 m");
  EXPECT_EQ(exact_quantity(static_cast<float>(radians(60)), Dimension::angle), "60 deg");
}

template <class Real>
void reads_back() {
  // an odd factor spreads small numbers, which RapidCheck prefers, over all exponents
  const auto bits = *rc::gen::arbitrary<std::uint64_t>() * 0x9E3779B97F4A7C15u;
  const auto dimension = static_cast<Dimension>(
      *rc::gen::inRange(0, static_cast<int>(Dimension::fuel_consumption) + 1));
  using Bits = std::conditional_t<sizeof(Real) == 8, std::uint64_t, std::uint32_t>;
  const Real value = std::bit_cast<Real>(static_cast<Bits>(bits >> (64 - 8 * sizeof(Real))));
  RC_PRE(std::isfinite(value) && std::fpclassify(value) != FP_SUBNORMAL);
  const std::string text = exact_quantity(value, dimension);
  const Parsed back = parse_quantity(text, dimension);
  RC_ASSERT(back.error == "");
  RC_ASSERT(static_cast<Real>(back.value) == value);
}

RC_GTEST_PROP(ExactQuantity, ReadsBackToTheSameDouble, ()) {
  reads_back<double>();
}
RC_GTEST_PROP(ExactQuantity, ReadsBackToTheSameFloat, ()) {
  reads_back<float>();
}

}  // namespace
}  // namespace eyrie
