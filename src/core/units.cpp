// SPDX-License-Identifier: MIT
#include "core/units.hpp"

#include <version>
#ifndef __cpp_lib_to_chars  // libc++ 19
#include <fast_float/fast_float.h>
#endif

#include <algorithm>
#include <limits>

#include "core/assert.hpp"
#include "core/diagnostics.hpp"
#include "core/text.hpp"

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
  std::string_view right;
  const char* wrong[4];  ///< null behind the last
};

constexpr Habit kHabits[] = {
    {"nmi", {"nm", "nautical miles"}},
    {"ft", {"feet", "foot", "'"}},
    {"m", {"meter", "meters", "metre", "metres"}},
    {"kt", {"kts", "kn", "knot", "knots"}},
    {"km/h", {"kph", "kmh"}},
    {"ft/s", {"fps"}},
    {"ft/min", {"fpm"}},
    {"m/s", {"mps"}},
    {"m/s2", {"m/s^2", "m/s/s", "m/s\u00B2"}},
    {"deg", {"degree", "degrees"}},
    {"rad", {"radian", "radians"}},
    {"mrad", {"mil", "mils"}},
    {"Hz", {"1/s", "hertz"}},
    {"s", {"sec", "secs", "second", "seconds"}},
    {"min", {"mins", "minute", "minutes"}},
    {"h", {"hr", "hrs", "hour", "hours"}},
    {"lb", {"lbs", "pound", "pounds"}},
    {"kg", {"kgs"}},
    {"t", {"tons", "tonne", "tonnes"}},
    {"lb/h", {"pph", "lbs/h", "lb/hr"}},
    {"m2", {"m^2", "m\u00B2", "sqm"}},
    {"ft2", {"ft^2", "sqft"}},
    {"N", {"newton", "newtons"}},
    {"W", {"watt", "watts"}},
    {"hPa", {"mb", "mbar"}},
    {"kg/m3", {"kg/m^3"}},
    {"degC", {"c"}},
    {"K", {"kelvin"}},
    {"dB", {"decibel"}},
};

constexpr bool is_unit(std::string_view symbol) {
  return detail::unit_index(symbol) < detail::kUnits.size();
}

constexpr bool habits_are_no_units_and_lead_to_one() {
  for (const Habit& habit : kHabits)
    for (const char* wrong : habit.wrong)
      if ((wrong && is_unit(wrong)) || !is_unit(habit.right))
        return false;
  return true;
}
static_assert(habits_are_no_units_and_lead_to_one());

bool equal_but_for_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return to_small(x) == to_small(y); });
}

/// The unit that an unknown spelling was meant to be, preferring the expected dimension.
const UnitInfo* meant(std::string_view wrong, Dimension expected) {
  const UnitInfo* found = nullptr;
  for (const UnitInfo& unit : units())
    if (equal_but_for_case(unit.symbol, wrong) && (!found || unit.dimension == expected))
      found = &unit;
  for (const Habit& habit : kHabits)
    for (const char* other : habit.wrong)
      if (!found && other && equal_but_for_case(other, wrong))
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

/// Three significant digits and `more`, but never fewer than the whole number has below a billion.
std::string three_digits(double x, int more) {
  const double size = std::fabs(x);
  return size >= 100 && size < 1e9 ? fmt::format("{:.{}f}", x, more)
                                   : fmt::format("{:.{}g}", x, 3 + more);
}

/// How hard a number is to read: its characters, once more the digits between first and last that
/// is not 0, and as much as ten of them for zeros that an exponent stands for. So 20000 ft is
/// easier than 6096 m, 250 m/s as easy as 900 km/h, and 1000000000 s easier than 1e+15 us.
std::size_t reading_cost(std::string_view number) {
  const auto is_significant = [](char c) { return c >= '1' && c <= '9'; };
  const std::string_view mantissa = number.substr(0, number.find('e'));
  const auto first = std::ranges::find_if(mantissa, is_significant);
  const auto last = std::find_if(mantissa.rbegin(), mantissa.rend(), is_significant).base();
  const auto digits =
      first < last ? std::count_if(first, last, [](char c) { return c != '.'; }) : 0;
  const std::size_t zeros = number.find("e+") != number.npos ? 10 : 0;
  return number.size() + static_cast<std::size_t>(digits) + zeros;
}

UnitSystem unit_system = UnitSystem::us;

/// How people read a dimension; the others, in SI. tests/quantities.txt holds the page to it, too.
struct Read {
  Dimension dimension;
  UnitName us, metric;
  int decimals = 0;
};
constexpr Read kFar{Dimension::length, "nmi", "km", 1};
constexpr Read kNear{Dimension::length, "ft", "m"};
constexpr Read kClimb{Dimension::speed, "ft/min", "m/s"};
constexpr Read kRead[] = {
    {Dimension::speed, "kt", "km/h"},
    {Dimension::acceleration, "g", "g", 1},
    {Dimension::mass, "lb", "kg"},
    {Dimension::mass_flow, "lb/h", "kg/h"},
    {Dimension::force, "lbf", "kN"},
    {Dimension::pressure, "hPa", "hPa", 1},
    {Dimension::temperature, "°C", "°C"},
    {Dimension::angle, "°", "°"},
    {Dimension::angular_rate, "°/s", "°/s", 1},
};

UnitName unit_of(const Read& read) {
  return unit_system == UnitSystem::us ? read.us : read.metric;
}
std::string format_as(const Read& read, double si, int more) {
  return format_in(si, unit_of(read), read.decimals + more);
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

std::string format_in(double si, UnitName unit, int decimals) {
  const std::string_view symbol = unit.info().symbol;
  return fmt::format("{}{}{}",
                     without_minus_zero(fmt::format("{:.{}f}", from_si(si, unit.info()), decimals)),
                     symbol.starts_with("°") ? "" : " ", symbol);
}

void write_units(UnitSystem system) {
  unit_system = system;
}

std::string format_quantity(double si, Dimension dimension, int more) {
  if (dimension == Dimension::length)
    return std::fabs(si) < to_si(1, unit_of(kFar).info()) ? format_height(si, more)
                                                          : format_range(si, more);
  for (const Read& read : kRead)
    if (read.dimension == dimension)
      return format_as(read, si, more);
  const std::string_view symbol = detail::si_symbol(dimension);
  return fmt::format("{}{}{}", three_digits(si, more), symbol.empty() ? "" : " ", symbol);
}

std::string format_range(double meters, int more) {
  return format_as(kFar, meters, more);
}

std::string format_height(double meters, int more) {
  return format_as(kNear, meters, more);
}

std::string format_climb(double meters_per_second, int more) {
  return format_as(kClimb, meters_per_second, more);
}

std::string format_direction(double radians, int more) {
  double scale = 1;
  for (int i = 0; i < more; ++i)
    scale *= 10;
  const double rounded = std::fmod(std::nearbyint(in_unit(radians, "deg") * scale) / scale, 360);
  return fmt::format("{:0{}.{}f}°", rounded < 0 ? rounded + 360 : rounded + 0.0,
                     more ? 4 + more : 3, more);
}

std::string format_side(double radians) {
  const std::string size = format_in(std::fabs(radians), "°");
  return size == "0°" || size == "180°" ? size : size + (radians < 0 ? " left" : " right");
}

template <std::floating_point Real>
std::string exact_quantity(Real si, Dimension dimension) {
  const std::string_view si_symbol = detail::si_symbol(dimension);
  if (dimension == Dimension::none)
    return fmt::format("{}", si);
  std::string best = fmt::format("{} {}", si, si_symbol);
  std::size_t best_cost = si_symbol.starts_with("rad") ? std::numeric_limits<std::size_t>::max()
                                                       : reading_cost(fmt::format("{}", si));
  for (const UnitInfo& unit : units()) {
    if (unit.dimension != dimension || unit.symbol == si_symbol)
      continue;
    // the number that converts back may be shorter than the one conversion gives: that many digits
    // suffice unless the conversion rounded badly
    const double number = from_si(static_cast<double>(si), unit);
    const std::string text =
        fmt::format("{:.{}g} {}", number, std::numeric_limits<Real>::digits10, unit.symbol);
    const Parsed back = parse_quantity(text, dimension);
    // at equal cost SI is preferred, and degrees to mrad
    const std::size_t cost = (unit.symbol == "mrad" ? 2 : 1) +
                             reading_cost(std::string_view(text).substr(0, text.find(' ')));
    if (cost < best_cost && back && static_cast<Real>(back.value) == si) {
      best = text;
      best_cost = cost;
    }
  }
  return best;
}

std::string with_degree_signs(std::string text) {
  constexpr std::string_view kDegrees = " deg";
  for (std::size_t at = 0; (at = text.find(kDegrees, at)) != text.npos;)
    text.replace(at, kDegrees.size(), "°");
  return text;
}

template std::string exact_quantity(double, Dimension);
template std::string exact_quantity(float, Dimension);

}  // namespace eyrie
