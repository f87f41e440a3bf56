// SPDX-License-Identifier: MIT
#pragma once
/// \file  Who we are in an exercise of several simulations.
#include <optional>
#include <string_view>

#include "dis/dead_reckoning.hpp"

namespace eyrie::dis {

/// UDP port at which simulations expect DIS.
inline constexpr std::uint16_t kPort = 3000;

struct Station {
  std::uint8_t exercise = 1;
  std::uint16_t site = 1, application = 1;
  Thresholds thresholds;

  /// One of its entities; 0: the application itself.
  [[nodiscard]] EntityId entity(std::uint16_t number) const { return {site, application, number}; }
};

/// "1.1.1": exercise (1 to 255), site and application (1 to 65534). Nothing if it is another text.
[[nodiscard]] std::optional<Station> station_of(std::string_view text);

}  // namespace eyrie::dis
