// SPDX-License-Identifier: MIT
#include "core/units.hpp"

#include <fmt/format.h>
#include <version>
#ifndef __cpp_lib_to_chars  // libc++ 19
#include <fast_float/fast_float.h>
#endif

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/assert.hpp"
#include "core/diagnostics.hpp"

namespace eyrie {
namespace {

struct Words {
  Dimension dimension;
  std::string_view noun, example;
};

constexpr std::array kWords = std::to_array<Words>({
    {Dimension::none, "a plain number", "0.5"},
    {Dimension::length, "a length", "6000 ft"},
    {Dimension::speed, "a speed", "480 kt"},
    {Dimension::acceleration, "an acceleration", "9 g"},
    {Dimension::angle, "an angle", "30 deg"},
    {Dimension::angular_rate, "an angular rate", "20 deg/s"},
    {Dimension::angular_acceleration, "an angular acceleration", "50 deg/s2"},
    {Dimension::frequency, "a frequency", "10 Hz"},
    {Dimension::time, "a time", "3 min"},
    {Dimension::mass, "a mass", "900 kg"},
    {Dimension::mass_flow, "a mass flow", "4000 lb/h"},
    {Dimension::area, "an area", "5 m2"},
    {Dimension::force, "a force", "76 kN"},
    {Dimension::power, "a power", "5 kW"},
    {Dimension::pressure, "a pressure", "1013.25 hPa"},
    {Dimension::density, "a density", "1.225 kg/m3"},
    {Dimension::temperature, "a temperature", "15 degC"},
    {Dimension::decibel, "a level in decibel", "-3 dB"},
    {Dimension::fuel_consumption, "a fuel consumption", "0.8 lb/lbf/h"},
});

constexpr bool words_follow_the_enumeration() {
  for (std::size_t i = 0; i < kWords.size(); ++i)
    if (kWords[i].dimension != static_cast<Dimension>(i))
      return false;
  return kWords.size() == static_cast<std::size_t>(Dimension::fuel_consumption) + 1;
}
static_assert(words_follow_the_enumeration());

constexpr bool symbols_are_unique() {
  for (std::size_t i = 0; i < detail::kUnits.size(); ++i)
    if (detail::unit_index(detail::kUnits[i].symbol) != i)
      return false;
  return true;
}
static_assert(symbols_are_unique());

/// Spellings from other habits. Those that could mean two things ('nm', 'mil', 'gal') are refused
/// on purpose; for the others one spelling per unit keeps files alike.
struct Habit {
  std::string_view wrong, right;
};

constexpr std::array kHabits = std::to_array<Habit>({
    {"nm", "nmi"},
    {"nautical miles", "nmi"},
    {"feet", "ft"},
    {"foot", "ft"},
    {"'", "ft"},
    {"meter", "m"},
    {"meters", "m"},
    {"metre", "m"},
    {"metres", "m"},
    {"kts", "kt"},
    {"kn", "kt"},
    {"knot", "kt"},
    {"knots", "kt"},
    {"kph", "km/h"},
    {"kmh", "km/h"},
    {"fps", "ft/s"},
    {"fpm", "ft/min"},
    {"mps", "m/s"},
    {"m/s^2", "m/s2"},
    {"m/s/s", "m/s2"},
    {"m/s\xC2\xB2", "m/s2"},
    {"degree", "deg"},
    {"degrees", "deg"},
    {"\xC2\xB0", "deg"},
    {"radian", "rad"},
    {"radians", "rad"},
    {"mil", "mrad"},
    {"mils", "mrad"},
    {"1/s", "Hz"},
    {"hertz", "Hz"},
    {"sec", "s"},
    {"secs", "s"},
    {"second", "s"},
    {"seconds", "s"},
    {"mins", "min"},
    {"minute", "min"},
    {"minutes", "min"},
    {"hr", "h"},
    {"hrs", "h"},
    {"hour", "h"},
    {"hours", "h"},
    {"lbs", "lb"},
    {"pound", "lb"},
    {"pounds", "lb"},
    {"kgs", "kg"},
    {"tons", "t"},
    {"tonne", "t"},
    {"tonnes", "t"},
    {"pph", "lb/h"},
    {"lbs/h", "lb/h"},
    {"lb/hr", "lb/h"},
    {"m^2", "m2"},
    {"m\xC2\xB2", "m2"},
    {"sqm", "m2"},
    {"ft^2", "ft2"},
    {"sqft", "ft2"},
    {"newton", "N"},
    {"newtons", "N"},
    {"watt", "W"},
    {"watts", "W"},
    {"mb", "hPa"},
    {"mbar", "hPa"},
    {"kg/m^3", "kg/m3"},
    {"\xC2\xB0"
     "C",
     "degC"},
    {"c", "degC"},
    {"kelvin", "K"},
    {"decibel", "dB"},
});

constexpr bool is_unit(std::string_view symbol) {
  return detail::unit_index(symbol) < detail::kUnits.size();
}

constexpr bool habits_are_no_units_and_lead_to_one() {
  for (const Habit& habit : kHabits)
    if (is_unit(habit.wrong) || !is_unit(habit.right))
      return false;
  return true;
}
static_assert(habits_are_no_units_and_lead_to_one());

constexpr bool is_space(char c) {
  return c == ' ' || c == '\t';
}

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && is_space(text.back()))
    text.remove_suffix(1);
  return text;
}

bool equal_but_for_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

/// The unit that an unknown spelling was meant to be, preferring the expected dimension.
const UnitInfo* meant(std::string_view wrong, Dimension expected) {
  const UnitInfo* found = nullptr;
  for (const UnitInfo& unit : units())
    if (equal_but_for_case(unit.symbol, wrong) && (!found || unit.dimension == expected))
      found = &unit;
  for (const Habit& habit : kHabits)
    if (!found && equal_but_for_case(habit.wrong, wrong))
      found = find_unit(habit.right);
  return found;
}

std::string expectation(std::string_view text, Dimension expected) {
  return fmt::format("expected {} such as '{}', got {}", dimension_noun(expected),
                     dimension_example(expected), quote(text));
}

/// How the unit at the end of a text is wrong for the expected dimension.
std::string unit_error(std::string_view symbol, Dimension expected) {
  const UnitInfo* known = find_unit(symbol);
  const UnitInfo* near = known ? known : meant(symbol, expected);
  if (near && near->dimension != expected)
    return fmt::format(" ({})", dimension_noun(near->dimension));
  if (near)
    return fmt::format("; did you mean '{}'?", near->symbol);
  if (expected == Dimension::none || !is_letter(symbol.front()))
    return {};
  std::string choices;
  for (const UnitInfo& unit : units())
    if (unit.dimension == expected)
      choices += (choices.empty() ? "" : ", ") + std::string(unit.symbol);
  return fmt::format("; its units are {}", choices);
}

/// A number at the start of a text, and what follows it.
struct Lexed {
  enum class Failure { none, not_a_number, beyond_double } failure = Failure::none;
  double number = 0;
  std::string_view rest;
};

Lexed lex_number(std::string_view text) {
  std::string_view digits = text;
  if (!digits.empty() && digits.front() == '+')
    digits.remove_prefix(1);  // from_chars knows no plus sign
  const std::size_t sign = digits.size() < text.size() ? 0 : digits.substr(0, 1) == "-" ? 1 : 0;
  const std::string_view magnitude = digits.substr(sign);
  const bool starts = !magnitude.empty() &&
                      (is_digit(magnitude[0]) || (magnitude.size() > 1 && magnitude[0] == '.' &&
                                                  is_digit(magnitude[1])));  // no inf, no nan
  Lexed result;
  if (!starts) {
    result.failure = Lexed::Failure::not_a_number;
    return result;
  }
#ifdef __cpp_lib_to_chars
  using std::from_chars;
#else
  using fast_float::from_chars;  // the same bits: both round to the nearest
#endif
  const auto [end, error] = from_chars(digits.data(), digits.data() + digits.size(), result.number);
  if (error != std::errc{})
    result.failure = Lexed::Failure::beyond_double;
  result.rest = digits.substr(static_cast<std::size_t>(end - digits.data()));
  return result;
}

Parsed failed(std::string error) {
  return {0, std::move(error)};
}

}  // namespace

std::string_view dimension_noun(Dimension dimension) {
  return kWords[static_cast<std::size_t>(dimension)].noun;
}

std::string_view dimension_example(Dimension dimension) {
  return kWords[static_cast<std::size_t>(dimension)].example;
}

// clang 16 calls what it has computed while compiling once more, which then comes nowhere near here
void detail::this_is_not_the_symbol_of_an_si_unit() {
  EYRIE_DEMAND(false, "the compiler has checked each symbol");
}
void detail::this_is_not_the_symbol_of_a_unit() {
  EYRIE_DEMAND(false, "the compiler has checked each symbol");
}

const UnitInfo* find_unit(std::string_view symbol) {
  const std::size_t i = detail::unit_index(symbol);
  return i < detail::kUnits.size() ? &detail::kUnits[i] : nullptr;
}

Parsed parse_quantity(std::string_view text, Dimension expected) {
  const std::string_view body = trimmed(text);
  const Lexed lexed = lex_number(body);
  if (lexed.failure == Lexed::Failure::not_a_number)
    return failed(expectation(text, expected));
  if (lexed.failure == Lexed::Failure::beyond_double)
    return failed(expectation(text, expected) + " (beyond the range of a double)");

  const std::string_view symbol = trimmed(lexed.rest);
  if (symbol.empty()) {
    const bool bare =
        expected == Dimension::none || (lexed.number == 0 && expected != Dimension::temperature);
    if (!bare)
      return failed(expectation(text, expected) + " (without a unit)");
    return {lexed.number, {}};
  }

  const UnitInfo* unit = find_unit(symbol);
  if (!unit || unit->dimension != expected)
    return failed(expectation(text, expected) + unit_error(symbol, expected));
  const double value = to_si(lexed.number, *unit);
  if (!std::isfinite(value))
    return failed(expectation(text, expected) + " (beyond the range of a double)");
  return {value, {}};
}

}  // namespace eyrie
