// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "core/units.hpp"

namespace eyrie {
namespace {

/// Three significant digits, but never fewer than the whole number has below a billion.
std::string three_digits(double x) {
  const double size = std::fabs(x);
  return size >= 100 && size < 1e9 ? fmt::format("{:.0f}", x) : fmt::format("{:.3g}", x);
}

/// How hard a number is to read: its characters, and once more the digits between first and last
/// that is not 0. So 20000 ft is easier than 6096 m, and 250 m/s as easy as 900 km/h.
std::size_t reading_cost(std::string_view number) {
  const auto is_significant = [](char c) { return c >= '1' && c <= '9'; };
  const std::string_view mantissa = number.substr(0, number.find('e'));
  const auto first = std::find_if(mantissa.begin(), mantissa.end(), is_significant);
  const auto last = std::find_if(mantissa.rbegin(), mantissa.rend(), is_significant).base();
  const auto digits =
      first < last ? std::count_if(first, last, [](char c) { return c != '.'; }) : 0;
  return number.size() + static_cast<std::size_t>(digits);
}

}  // namespace

std::string format_in(double si, UnitName unit, int decimals) {
  const std::string number = fmt::format("{:.{}f}", from_si(si, unit.info()), decimals);
  const bool minus_zero = number[0] == '-' && number.find_first_not_of("-0.") == number.npos;
  return fmt::format("{} {}", std::string_view(number).substr(minus_zero ? 1 : 0),
                     unit.info().symbol);
}

std::string format_quantity(double si, Dimension dimension, UnitStyle style) {
  if (style == UnitStyle::aviation) {
    switch (dimension) {
      case Dimension::length:
        return std::fabs(si) < 1852 ? format_in(si, "ft") : format_in(si, "nmi", 1);
      case Dimension::speed:
        return format_in(si, "kt");
      case Dimension::acceleration:
        return format_in(si, "g", 1);
      case Dimension::mass:
        return format_in(si, "lb");
      case Dimension::mass_flow:
        return format_in(si, "lb/h");
      case Dimension::force:
        return format_in(si, "lbf");
      case Dimension::pressure:
        return format_in(si, "hPa", 1);
      case Dimension::temperature:
        return format_in(si, "degC");
      case Dimension::angle:
        return format_in(si, "deg");
      case Dimension::angular_rate:
        return format_in(si, "deg/s", 1);
      default:
        break;
    }
  }
  const std::string_view symbol = detail::si_symbol(dimension);
  return fmt::format("{}{}{}", three_digits(si), symbol.empty() ? "" : " ", symbol);
}

template <std::floating_point Real>
std::string exact_quantity(Real si, Dimension dimension) {
  const std::string_view si_symbol = detail::si_symbol(dimension);
  if (dimension == Dimension::none)
    return fmt::format("{}", si);
  std::string best = fmt::format("{} {}", si, si_symbol);
  std::size_t best_cost = reading_cost(fmt::format("{}", si));
  for (const UnitInfo& unit : units()) {
    if (unit.dimension != dimension || unit.symbol == si_symbol)
      continue;
    // the number that converts back may be shorter than the one conversion gives: that many digits
    // suffice unless the conversion rounded badly
    const double number = from_si(static_cast<double>(si), unit);
    const std::string text =
        fmt::format("{:.{}g} {}", number, std::numeric_limits<Real>::digits10, unit.symbol);
    const Parsed back = parse_quantity(text, dimension);
    // at equal cost SI is preferred
    const std::size_t cost = 1 + reading_cost(std::string_view(text).substr(0, text.find(' ')));
    if (cost < best_cost && back && static_cast<Real>(back.value) == si) {
      best = text;
      best_cost = cost;
    }
  }
  return best;
}

template std::string exact_quantity(double, Dimension);
template std::string exact_quantity(float, Dimension);

}  // namespace eyrie
