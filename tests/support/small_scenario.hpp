// SPDX-License-Identifier: MIT
#pragma once
/// \file  A scenario of 20 lines without mistakes, which tests spoil.
#include <stdexcept>
#include <string>
#include <vector>

namespace eyrie::test {

/// Line numbers in the tests count from its first line.
inline const std::string kSmallScenario = R"(eyrie: 1
name: small
reference: {latitude: 33 deg, longitude: -68 deg}
until: 2 s
ends: time
trees:
  cruise:
    winner_takes_all:
      - avoid_ground: {vote: 100}
      - navigate: {vote: 10, speed: 480 kt}
blue:
  home: {north: 0 nmi, east: -20 nmi}
  flights:
    eagle:
      aircraft: f15c
      tree: cruise
      players: [eagle1, eagle2]
      start: {north: 0 nmi, east: 0 nmi, altitude: 25000 ft, heading: 90 deg, speed: 480 kt}
      route:
        - {north: 0 nmi, east: 60 nmi, altitude: 25000 ft}
)";

/// One piece of its text for another.
struct Change {
  std::string from, to;
};

[[nodiscard]] inline std::string changed_scenario(const std::vector<Change>& changes) {
  std::string text = kSmallScenario;
  for (const auto& [from, to] : changes) {
    const auto at = text.find(from);
    if (at == std::string::npos)
      throw std::logic_error("not in the small scenario: " + from);
    text.replace(at, from.size(), to);
  }
  return text;
}

}  // namespace eyrie::test
