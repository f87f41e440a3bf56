// SPDX-License-Identifier: MIT
#pragma once
/// \file  Units at the file boundary. Inside, everything is SI and radians.
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/angle.hpp"
#include "core/enum_names.hpp"

namespace eyrie {

enum class Dimension : std::uint8_t {
  none,
  length,
  speed,
  acceleration,
  angle,
  angular_rate,
  angular_acceleration,
  frequency,
  time,
  mass,
  mass_flow,
  area,
  force,
  power,
  pressure,
  density,
  temperature,
  decibel,           ///< a ratio, kept in dB
  fuel_consumption,  ///< fuel mass flow per thrust
};

/// A spelling that files may use. SI value = number * numerator / denominator + offset; the factors
/// are split so that both are exact (or correctly rounded) doubles.
struct UnitInfo {
  std::string_view symbol;
  Dimension dimension;
  double numerator = 1, denominator = 1, offset = 0;
};

namespace detail {
/// Every unit, the SI unit of a dimension first. Factors: NIST SP 811 (2008), appendix B.8, where
/// the foot, nautical mile, avoirdupois pound, standard gravity and pound-force are exact. Degrees
/// are those of radians() in core/angle.hpp, to the bit.
inline constexpr std::array kUnits = std::to_array<UnitInfo>({
    {"m", Dimension::length},
    {"km", Dimension::length, 1000},
    {"cm", Dimension::length, 1, 100},
    {"mm", Dimension::length, 1, 1000},
    {"ft", Dimension::length, 3048, 10000},
    {"nmi", Dimension::length, 1852},
    {"m/s", Dimension::speed},
    {"km/h", Dimension::speed, 1000, 3600},
    {"kt", Dimension::speed, 1852, 3600},
    {"ft/s", Dimension::speed, 3048, 10000},
    {"ft/min", Dimension::speed, 3048, 600000},
    {"m/s2", Dimension::acceleration},
    {"ft/s2", Dimension::acceleration, 3048, 10000},
    {"g", Dimension::acceleration, 980665, 100000},
    {"rad", Dimension::angle},
    {"mrad", Dimension::angle, 1, 1000},
    {"deg", Dimension::angle, kPi / 180},
    {"°", Dimension::angle, kPi / 180},  // as Eyrie shows it; files that it writes have "deg"
    {"rad/s", Dimension::angular_rate},
    {"deg/s", Dimension::angular_rate, kPi / 180},
    {"°/s", Dimension::angular_rate, kPi / 180},
    {"rad/s2", Dimension::angular_acceleration},
    {"deg/s2", Dimension::angular_acceleration, kPi / 180},
    {"°/s2", Dimension::angular_acceleration, kPi / 180},
    {"Hz", Dimension::frequency},
    {"kHz", Dimension::frequency, 1e3},
    {"MHz", Dimension::frequency, 1e6},
    {"GHz", Dimension::frequency, 1e9},
    {"s", Dimension::time},
    {"ms", Dimension::time, 1, 1e3},
    {"us", Dimension::time, 1, 1e6},
    {"min", Dimension::time, 60},
    {"h", Dimension::time, 3600},
    {"kg", Dimension::mass},
    {"t", Dimension::mass, 1000},
    {"lb", Dimension::mass, 45359237, 1e8},
    {"kg/s", Dimension::mass_flow},
    {"kg/h", Dimension::mass_flow, 1, 3600},
    {"lb/h", Dimension::mass_flow, 45359237, 3600e8},
    {"m2", Dimension::area},
    {"cm2", Dimension::area, 1, 1e4},
    {"ft2", Dimension::area, 9290304, 1e8},
    {"N", Dimension::force},
    {"kN", Dimension::force, 1e3},
    {"lbf", Dimension::force, 44482216152605, 1e13},
    {"W", Dimension::power},
    {"kW", Dimension::power, 1e3},
    {"MW", Dimension::power, 1e6},
    {"Pa", Dimension::pressure},
    {"hPa", Dimension::pressure, 100},
    {"kPa", Dimension::pressure, 1000},
    {"kg/m3", Dimension::density},
    {"K", Dimension::temperature},
    {"degC", Dimension::temperature, 1, 1, 273.15},
    {"°C", Dimension::temperature, 1, 1, 273.15},
    {"dB", Dimension::decibel},
    {"kg/N/s", Dimension::fuel_consumption},
    {"kg/N/h", Dimension::fuel_consumption, 1, 3600},
    {"lb/lbf/h", Dimension::fuel_consumption, 1e5, 980665 * 3600.0},
});

/// Its index in kUnits, or the number of units. Not a pointer: comparing one with null is no
/// constant expression for GCC 12 under the undefined-behavior sanitizer.
constexpr std::size_t unit_index(std::string_view symbol) {
  std::size_t i = 0;
  while (i < kUnits.size() && kUnits[i].symbol != symbol)
    ++i;
  return i;
}

constexpr std::string_view si_symbol(Dimension dimension) {
  for (const UnitInfo& unit : kUnits)
    if (unit.dimension == dimension)
      return unit.symbol;
  return "";
}

/// Not constexpr: reaching one of them is how a misspelled unit stops the compilation.
void this_is_not_the_symbol_of_an_si_unit();
void this_is_not_the_symbol_of_a_unit();
}  // namespace detail

/// Every spelling that parse_quantity knows, in the order of the reference.
[[nodiscard]] constexpr std::span<const UnitInfo> units() {
  return detail::kUnits;
}

/// The unit of that spelling, or null.
[[nodiscard]] const UnitInfo* find_unit(std::string_view symbol);

/// The SI unit of a described number, written as "m", "m/s", "rad" ...; "1" or "" for none. A
/// symbol that is not SI or is misspelled does not compile.
struct Unit {
  Dimension dimension = Dimension::none;
  std::string_view si_symbol = "";  ///< "" for none

  constexpr Unit() = default;
  consteval Unit(const char* symbol) : Unit(std::string_view(symbol)) {}
  constexpr explicit Unit(Dimension d) : dimension(d), si_symbol(detail::si_symbol(d)) {}

  bool operator==(const Unit&) const = default;

 private:
  consteval explicit Unit(std::string_view symbol) {
    if (symbol.empty() || symbol == "1")
      return;
    const std::size_t i = detail::unit_index(symbol);
    if (i == detail::kUnits.size() || detail::si_symbol(detail::kUnits[i].dimension) != symbol)
      detail::this_is_not_the_symbol_of_an_si_unit();
    dimension = detail::kUnits[i].dimension;
    si_symbol = detail::kUnits[i].symbol;
  }
};

/// Any unit of units(), named by a literal that is checked by the compiler.
class UnitName {
 public:
  consteval UnitName(const char* symbol) : index_(detail::unit_index(symbol)) {
    if (index_ == detail::kUnits.size())
      detail::this_is_not_the_symbol_of_a_unit();
  }
  [[nodiscard]] constexpr const UnitInfo& info() const { return detail::kUnits[index_]; }

 private:
  std::size_t index_;
};

/// A number of that unit, in SI.
[[nodiscard]] constexpr double to_si(double number, const UnitInfo& unit) {
  return number * unit.numerator / unit.denominator + unit.offset;
}

/// An SI value as a number of that unit.
[[nodiscard]] constexpr double from_si(double si, const UnitInfo& unit) {
  return (si - unit.offset) * unit.denominator / unit.numerator;
}

/// For defaults that read like the file: `double danger_range = si(2, "nmi");`
[[nodiscard]] constexpr double si(double number, UnitName unit) {
  return to_si(number, unit.info());
}

/// For reports: `in_unit(range, "nmi")`.
[[nodiscard]] constexpr double in_unit(double value, UnitName unit) {
  return from_si(value, unit.info());
}

/// A dimension as a noun with its article: "a length". For none: "a plain number".
[[nodiscard]] std::string_view dimension_noun(Dimension dimension);

/// A quantity of that dimension as a file would write it: "6000 ft".
[[nodiscard]] std::string_view dimension_example(Dimension dimension);

/// The result of parsing: a value in SI, or what is wrong with the text.
struct Parsed {
  double value = 0;
  std::string error;

  explicit operator bool() const { return error.empty(); }
};

/// Reads "6000 ft", "-3dB", "0.5". The unit is needed unless the dimension is none or the number is
/// 0 (a temperature always needs one: 0 is ambiguous). Refuses NaN, infinity, hexadecimal, numbers
/// beyond a double, a unit of another dimension, and anything before or after. Any bytes are safe.
[[nodiscard]] Parsed parse_quantity(std::string_view text, Dimension expected);

/// In which units people read: "6000 ft", "5.0 nmi", "467 kt", "5000 lb", or "1829 m", "9.3 km",
/// "865 km/h", "2268 kg".
enum class UnitSystem : std::uint8_t { us, metric };
constexpr auto names_of(UnitSystem) {
  return names_from_zero<UnitSystem>("us", "metric");
}
/// For the process, before it has threads; us until then. Files keep the units that they are in.
void write_units(UnitSystem system);

/// For people, rounded to what they can use: "6000 ft" below one mile and "1.0 nmi" from there (or
/// "999 m" and "1.0 km"), "467 kt", "30°", with so many more decimals. Do not parse it back.
[[nodiscard]] std::string format_quantity(double si, Dimension dimension, int more = 0);
/// A range, in miles or kilometers however short it is: "0.4 nmi".
[[nodiscard]] std::string format_range(double meters, int more = 0);
/// A height, in feet or meters however large it is: "36000 ft".
[[nodiscard]] std::string format_height(double meters, int more = 0);
/// A speed up or down: "1500 ft/min", or "8 m/s".
[[nodiscard]] std::string format_climb(double meters_per_second, int more = 0);
/// A direction over the ground, clockwise from north: "075°", from 000 to 359.
[[nodiscard]] std::string format_direction(double radians, int more = 0);
/// An angle from the nose in the plane of the horizon, positive to the right: "35° right".
[[nodiscard]] std::string format_side(double radians);

/// For people, in the unit the writer chose: `format_in(altitude, "ft")` is "6000 ft".
[[nodiscard]] std::string format_in(double si, UnitName unit, int decimals = 0);

/// For files and references: a text that parse_quantity reads back to the same double or float, in
/// SI or in the unit that says it more simply, so 3704 m is "2 nmi".
/// An angle is never in rad that can be said in degrees or mrad.
template <std::floating_point Real>
[[nodiscard]] std::string exact_quantity(Real si, Dimension dimension);
/// What a file or reference says as people are shown it: "30°" for "30 deg".
[[nodiscard]] std::string with_degree_signs(std::string text);

extern template std::string exact_quantity(double, Dimension);
extern template std::string exact_quantity(float, Dimension);

}  // namespace eyrie
