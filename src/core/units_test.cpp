// SPDX-License-Identifier: MIT
#include "core/units.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace eyrie {
namespace {

struct UnitCase {
  const char* text;
  Dimension dimension;
  double si;  ///< by hand from the definition of the unit
};

const std::vector<UnitCase>& unit_cases() {
  static const std::vector<UnitCase> kCases{
      {"250 m", Dimension::length, 250},
      {"80 km", Dimension::length, 80000},
      {"12.5 cm", Dimension::length, 0.125},
      {"20 mm", Dimension::length, 0.02},
      {"6000 ft", Dimension::length, 1828.8},
      {"2 nmi", Dimension::length, 3704},
      {"240 m/s", Dimension::speed, 240},
      {"900 km/h", Dimension::speed, 250},
      {"480 kt", Dimension::speed, 246.93333333333334},
      {"1000 ft/s", Dimension::speed, 304.8},
      {"30000 ft/min", Dimension::speed, 152.4},
      {"5 m/s2", Dimension::acceleration, 5},
      {"100 ft/s2", Dimension::acceleration, 30.48},
      {"9 g", Dimension::acceleration, 88.25985},
      {"0.5 rad", Dimension::angle, 0.5},
      {"17.5 mrad", Dimension::angle, 0.0175},
      {"180 deg", Dimension::angle, 3.141592653589793},
      {"2 rad/s", Dimension::angular_rate, 2},
      {"180 °", Dimension::angle, 3.141592653589793},
      {"90 °/s", Dimension::angular_rate, 1.5707963267948966},
      {"360 °/s2", Dimension::angular_acceleration, 6.283185307179586},
      {"90 deg/s", Dimension::angular_rate, 1.5707963267948966},
      {"3 rad/s2", Dimension::angular_acceleration, 3},
      {"360 deg/s2", Dimension::angular_acceleration, 6.283185307179586},
      {"10 Hz", Dimension::frequency, 10},
      {"300 kHz", Dimension::frequency, 3e5},
      {"1.5 MHz", Dimension::frequency, 1.5e6},
      {"9.5 GHz", Dimension::frequency, 9.5e9},
      {"20 s", Dimension::time, 20},
      {"20 ms", Dimension::time, 0.02},
      {"3 us", Dimension::time, 3e-6},
      {"3 min", Dimension::time, 180},
      {"1.5 h", Dimension::time, 5400},
      {"900 kg", Dimension::mass, 900},
      {"11.5 t", Dimension::mass, 11500},
      {"1000 lb", Dimension::mass, 453.59237},
      {"1.2 kg/s", Dimension::mass_flow, 1.2},
      {"3600 kg/h", Dimension::mass_flow, 1},
      {"3600 lb/h", Dimension::mass_flow, 0.45359237},
      {"5 m2", Dimension::area, 5},
      {"25 cm2", Dimension::area, 0.0025},
      {"300 ft2", Dimension::area, 27.870912},
      {"700 N", Dimension::force, 700},
      {"76.3 kN", Dimension::force, 76300},
      {"10 lbf", Dimension::force, 44.482216152605},
      {"60 W", Dimension::power, 60},
      {"5 kW", Dimension::power, 5000},
      {"1.1 MW", Dimension::power, 1.1e6},
      {"101325 Pa", Dimension::pressure, 101325},
      {"1013.25 hPa", Dimension::pressure, 101325},
      {"101.325 kPa", Dimension::pressure, 101325},
      {"1.225 kg/m3", Dimension::density, 1.225},
      {"288.15 K", Dimension::temperature, 288.15},
      {"15 degC", Dimension::temperature, 288.15},
      {"15 °C", Dimension::temperature, 288.15},
      {"-3 dB", Dimension::decibel, -3},
      {"2e-5 kg/N/s", Dimension::fuel_consumption, 2e-5},
      {"3600 kg/N/h", Dimension::fuel_consumption, 1},
      {"9806.65 lb/lbf/h", Dimension::fuel_consumption, 1 / 3.6},  // 1 lbf weighs 1 lb at 1 g
  };
  return kCases;
}

TEST(Units, ConvertAsTheirDefinitionsSay) {
  for (const UnitCase& c : unit_cases()) {
    const Parsed parsed = parse_quantity(c.text, c.dimension);
    ASSERT_TRUE(parsed) << parsed.error;
    EXPECT_DOUBLE_EQ(parsed.value, c.si) << c.text;
  }
}

TEST(Units, AreAllInTheTableAbove) {
  std::multiset<std::string> tested, known;
  for (const UnitCase& c : unit_cases())
    tested.insert(std::string(c.text).substr(std::string(c.text).find(' ') + 1));
  for (const UnitInfo& unit : units())
    known.emplace(unit.symbol);
  EXPECT_EQ(tested, known);
}

TEST(Units, ReadTheSameNumberAsCodeInSi) {
  for (const UnitCase& c : unit_cases()) {
    const std::string text = c.text;
    const UnitInfo* unit = find_unit(std::string_view(text).substr(text.find(' ') + 1));
    ASSERT_NE(unit, nullptr);
    const double number = std::stod(text);
    EXPECT_EQ(parse_quantity(text, c.dimension).value, to_si(number, *unit)) << text;
  }
}

// what exact factors promise: no rounding where the definition needs none
static_assert(si(6000, "ft") == 1828.8);
static_assert(si(2, "nmi") == 3704);
static_assert(si(30, "deg") == radians(30));
static_assert(si(1, "lb") == 0.45359237);
static_assert(si(1, "lbf") == 4.4482216152605);
static_assert(si(1, "g") == 9.80665);
static_assert(si(15, "degC") == 288.15);
static_assert(in_unit(3704, "nmi") == 2);
static_assert(Unit("m").dimension == Dimension::length && Unit("m").si_symbol == "m");
static_assert(Unit("1") == Unit("") && Unit("").dimension == Dimension::none);
static_assert(Unit(Dimension::speed) == Unit("m/s"));

// a unit that is not SI or is misspelled must not compile
template <std::size_t N>
struct Literal {
  char text[N]{};
  consteval Literal(const char (&from)[N]) {
    for (std::size_t i = 0; i < N; ++i)
      text[i] = from[i];
  }
};
template <Literal L>
concept NamesAnSiUnit = requires {
  typename std::bool_constant<(Unit(L.text), true)>;
};
template <Literal L>
concept NamesAUnit = requires {
  typename std::bool_constant<(UnitName(L.text), true)>;
};
static_assert(NamesAnSiUnit<"m/s"> && NamesAnSiUnit<"kg/m3"> && NamesAnSiUnit<"dB">);
static_assert(!NamesAnSiUnit<"deg"> && !NamesAnSiUnit<"nmi"> && !NamesAnSiUnit<"metre">);
static_assert(NamesAUnit<"nmi"> && !NamesAUnit<"nm"> && !NamesAUnit<"">);

TEST(ParseQuantity, AllowsSpacesSignsAndExponents) {
  const auto length = [](std::string_view text) {
    const Parsed parsed = parse_quantity(text, Dimension::length);
    return parsed ? parsed.value : std::numeric_limits<double>::quiet_NaN();
  };
  EXPECT_EQ(length("6000ft"), 1828.8);
  EXPECT_EQ(length("  6000 \t ft "), 1828.8);
  EXPECT_EQ(length("+6e3 ft"), 1828.8);
  EXPECT_EQ(length("-.5km"), -500);
  EXPECT_EQ(length("1. m"), 1);
  EXPECT_EQ(length("1E-2 m"), 0.01);
}

TEST(ParseQuantity, AllowsABareNumberOnlyForPlainNumbersAndZero) {
  EXPECT_EQ(parse_quantity("-0.5", Dimension::none).value, -0.5);
  EXPECT_TRUE(parse_quantity("0", Dimension::length));
  EXPECT_TRUE(parse_quantity("-0.0", Dimension::decibel));
  EXPECT_FALSE(parse_quantity("1", Dimension::length));
  EXPECT_FALSE(parse_quantity("0", Dimension::temperature));  // of which scale?
}

struct ErrorCase {
  const char* text;
  Dimension expected;
  const char* error;
};

TEST(ParseQuantity, SaysWhatWasExpectedAndWhatIsWrong) {
  const std::vector<ErrorCase> cases{
      {"2 kg", Dimension::length, "expected a length such as '6000 ft', got '2 kg' (a mass)"},
      {"480", Dimension::speed, "expected a speed such as '480 kt', got '480' (without a unit)"},
      {"2 kg", Dimension::none, "expected a plain number such as '0.5', got '2 kg' (a mass)"},
      {"2 nm", Dimension::length,
       "expected a length such as '6000 ft', got '2 nm'; did you mean 'nmi'?"},
      {"2 NM", Dimension::length,
       "expected a length such as '6000 ft', got '2 NM'; did you mean 'nmi'?"},
      {"5 KM", Dimension::length,
       "expected a length such as '6000 ft', got '5 KM'; did you mean 'km'?"},
      {"5 miles", Dimension::length,
       "expected a length such as '6000 ft', got '5 miles'; its units are m, km, cm, mm, ft, nmi"},
      {"480 knots", Dimension::length,
       "expected a length such as '6000 ft', got '480 knots' (a speed)"},
      {"480 knots", Dimension::speed,
       "expected a speed such as '480 kt', got '480 knots'; did you mean 'kt'?"},
      {"3 mil", Dimension::angle,
       "expected an angle such as '30 deg', got '3 mil'; did you mean 'mrad'?"},
      {"500 g", Dimension::mass, "expected a mass such as '900 kg', got '500 g' (an acceleration)"},
      {"1:30", Dimension::time, "expected a time such as '3 min', got '1:30'"},
      {"1,000 ft", Dimension::length, "expected a length such as '6000 ft', got '1,000 ft'"},
      {"3 min 5 s", Dimension::time,
       "expected a time such as '3 min', got '3 min 5 s'; its units are s, ms, us, min, h"},
      {"fast", Dimension::speed, "expected a speed such as '480 kt', got 'fast'"},
      {"", Dimension::power, "expected a power such as '5 kW', got ''"},
      {"-", Dimension::force, "expected a force such as '76 kN', got '-'"},
      {"+-1 N", Dimension::force, "expected a force such as '76 kN', got '+-1 N'"},
      {"++1 N", Dimension::force, "expected a force such as '76 kN', got '++1 N'"},
      {".", Dimension::none, "expected a plain number such as '0.5', got '.'"},
      {"nan", Dimension::none, "expected a plain number such as '0.5', got 'nan'"},
      {".nan", Dimension::none, "expected a plain number such as '0.5', got '.nan'"},
      {"-inf", Dimension::none, "expected a plain number such as '0.5', got '-inf'"},
      {"inf m", Dimension::length, "expected a length such as '6000 ft', got 'inf m'"},
      {"0x10", Dimension::none, "expected a plain number such as '0.5', got '0x10'"},
      {"0x1p3 m2", Dimension::area,
       "expected an area such as '5 m2', got '0x1p3 m2'; its units are m2, cm2, ft2"},
      {"1e999 Hz", Dimension::frequency,
       "expected a frequency such as '10 Hz', got '1e999 Hz' (beyond the range of a double)"},
      {"1e-999", Dimension::none,
       "expected a plain number such as '0.5', got '1e-999' (beyond the range of a double)"},
      {"1e308 GHz", Dimension::frequency,
       "expected a frequency such as '10 Hz', got '1e308 GHz' (beyond the range of a double)"},
      {"0", Dimension::temperature,
       "expected a temperature such as '15 degC', got '0' (without a unit)"},
      {"5\x1b[2J m", Dimension::length, "expected a length such as '6000 ft', got '5\\x1b[2J m'"},
      {"x", Dimension::acceleration, "expected an acceleration such as '9 g', got 'x'"},
      {"x", Dimension::angular_rate, "expected an angular rate such as '20 deg/s', got 'x'"},
      {"x", Dimension::angular_acceleration,
       "expected an angular acceleration such as '50 deg/s2', got 'x'"},
      {"x", Dimension::mass_flow, "expected a mass flow such as '4000 lb/h', got 'x'"},
      {"x", Dimension::pressure, "expected a pressure such as '1013.25 hPa', got 'x'"},
      {"x", Dimension::density, "expected a density such as '1.225 kg/m3', got 'x'"},
      {"x", Dimension::decibel, "expected a level in decibel such as '-3 dB', got 'x'"},
      {"x", Dimension::fuel_consumption,
       "expected a fuel consumption such as '0.8 lb/lbf/h', got 'x'"},
  };
  for (const ErrorCase& c : cases) {
    const Parsed parsed = parse_quantity(c.text, c.expected);
    EXPECT_EQ(parsed.error, c.error);
    EXPECT_EQ(parsed.value, 0) << c.text;
  }
}

TEST(ParseQuantity, ReadsTheExampleOfEveryDimension) {
  for (int d = 0; d <= static_cast<int>(Dimension::fuel_consumption); ++d) {
    const auto dimension = static_cast<Dimension>(d);
    EXPECT_TRUE(parse_quantity(dimension_example(dimension), dimension));
    EXPECT_EQ(detail::si_symbol(dimension).empty(), dimension == Dimension::none);
  }
}

RC_GTEST_PROP(Units, ComeBackFromSiWithinRounding, ()) {
  const UnitInfo& unit = units()[*rc::gen::inRange<std::size_t>(0, units().size())];
  const double number = *rc::gen::inRange(-1000000, 1000000) / 64.0;
  const double back = from_si(to_si(number, unit), unit);
  const double scale = std::fabs(number) + std::fabs(unit.offset);
  RC_ASSERT(std::fabs(back - number) <= 4 * std::numeric_limits<double>::epsilon() * scale);
}

/// Any bytes: no crash, and either an error or a finite value. A quick cousin of fuzz/units_fuzz.
TEST(ParseQuantity, SurvivesAnyBytes) {
  std::uint64_t state = 1;
  const auto next = [&](std::uint64_t bound) {
    state = state * 6364136223846793005u + 1442695040888963407u;  // Knuth's MMIX generator
    return (state >> 33) % bound;
  };
  const std::string_view likely = "0123456789.+-eE xX'\t/mktfngrads2HzNWPaKCbu";
  int accepted = 0;
  for (int i = 0; i < 200000; ++i) {
    std::string text;
    for (std::uint64_t n = next(12); n > 0; --n)
      text += next(16) == 0 ? static_cast<char>(next(256)) : likely[next(likely.size())];
    const auto dimension = static_cast<Dimension>(next(19));
    const Parsed parsed = parse_quantity(text, dimension);
    ASSERT_TRUE(std::isfinite(parsed.value)) << text;
    ASSERT_TRUE(parsed || parsed.value == 0) << text;
    accepted += parsed ? 1 : 0;
  }
  EXPECT_GT(accepted, 100);  // the bytes are likely enough to reach the other path too
}

TEST(FormatQuantity, ReadsAsOnThePageInEitherSystem) {
  std::ifstream table("tests/quantities.txt");
  int read = 0;
  for (std::string line; std::getline(table, line);) {
    if (line.starts_with("#"))
      continue;
    std::string kind, us, metric;
    double si = 0;
    char bar = 0;
    std::istringstream words(line);
    std::getline(std::getline(words >> kind >> si >> bar >> std::ws, us, '|') >> std::ws, metric);
    us.erase(us.find_last_not_of(' ') + 1);
    const auto written = [&](UnitSystem system) {
      write_units(system);
      return kind == "height"      ? format_height(si)
             : kind == "climb"     ? format_climb(si)
             : kind == "direction" ? format_direction(si)
             : kind == "side"      ? format_side(si)
             : kind == "1"         ? format_quantity(si, Dimension::none)
                                   : format_quantity(si, find_unit(kind)->dimension);
    };
    EXPECT_EQ(written(UnitSystem::metric), metric) << line;
    EXPECT_EQ(written(UnitSystem::us), us) << line;
    ++read;
  }
  EXPECT_GT(read, 20);
}

TEST(FormatQuantity, HasAsManyMoreDecimalsAsAskedFor) {
  EXPECT_EQ(format_in(37040, "nmi", 2), "20.00 nmi");
  EXPECT_EQ(format_quantity(1234.5678, Dimension::length, 2), "4050.42 ft");
  EXPECT_EQ(format_quantity(0.123456, Dimension::time, 1), "0.1235 s");
}

TEST(ExactQuantity, PicksTheUnitThatSaysItMostSimply) {
  const auto exact = [](double x, Dimension d) { return exact_quantity(x, d); };
  EXPECT_EQ(exact(1e9, Dimension::time), "1000000000 s") << "not 1e+15 us";
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
  EXPECT_EQ(exact(0, Dimension::angle), "0 deg");
  EXPECT_EQ(exact(0.5, Dimension::angle), "500 mrad");
  EXPECT_EQ(exact(1e-3, Dimension::angle), "1 mrad");
  EXPECT_EQ(exact(radians(3), Dimension::angular_rate), "3 deg/s");
  EXPECT_EQ(exact(0.5, Dimension::angular_rate), "0.5 rad/s") << "no degrees are just that";
  EXPECT_EQ(exact(std::nan(""), Dimension::angle), "nan rad");
  EXPECT_EQ(exact(0.02, Dimension::time), "20 ms");
  EXPECT_EQ(exact(60, Dimension::time), "60 s");
  EXPECT_EQ(exact(300, Dimension::time), "5 min");
  EXPECT_EQ(exact(-3, Dimension::decibel), "-3 dB");
  EXPECT_EQ(exact(288.15, Dimension::temperature), "15 degC");
  EXPECT_EQ(exact(0.5, Dimension::none), "0.5");
  EXPECT_EQ(exact(std::numeric_limits<double>::infinity(), Dimension::mass), "inf kg");
}

TEST(WithDegreeSigns, ShowsWhatAFileSays) {
  EXPECT_EQ(with_degree_signs("[-30 deg, 3 deg/s, 15 degC]"), "[-30°, 3°/s, 15°C]");
  EXPECT_EQ(with_degree_signs("2 nmi"), "2 nmi");
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

TEST(FormatDirection, IsWrittenInThreeDigitsFrom000To359) {
  EXPECT_EQ(format_direction(0), "000°");
  EXPECT_EQ(format_direction(radians(7.4)), "007°");
  EXPECT_EQ(format_direction(radians(-75)), "285°");
  EXPECT_EQ(format_direction(radians(359.6)), "000°");
  EXPECT_EQ(format_direction(radians(-0.2)), "000°");
  EXPECT_EQ(format_direction(radians(720 + 90)), "090°");
  EXPECT_EQ(format_direction(radians(7.44), 1), "007.4°");
  EXPECT_EQ(format_direction(radians(359.96), 1), "000.0°");
}

TEST(FormatRange, IsInMilesOrKilometersHoweverShortItIs) {
  EXPECT_EQ(format_range(700), "0.4 nmi");
  write_units(UnitSystem::metric);
  EXPECT_EQ(format_range(700), "0.7 km");
  write_units(UnitSystem::us);
}

}  // namespace
}  // namespace eyrie
