// SPDX-License-Identifier: MIT
#include "dis/station.hpp"

#include <charconv>

namespace eyrie::dis {

std::optional<Station> station_of(std::string_view text) {
  Station station;
  const char *at = text.data(), *const end = at + text.size();
  bool good = true;
  const auto take = [&](auto& number, std::uint16_t most, bool last) {
    if (!good)
      return;
    const auto [next, failed] = std::from_chars(at, end, number);
    good = failed == std::errc{} && number > 0 && number <= most &&
           (last ? next == end : next != end && *next == '.');
    at = next + (last ? 0 : 1);
  };
  take(station.exercise, 255, false);
  take(station.site, 65534, false);
  take(station.application, 65534, true);
  return good ? std::optional(station) : std::nullopt;
}

}  // namespace eyrie::dis
