// SPDX-License-Identifier: MIT
#pragma once
/// \file  A scene of any number of aircraft: N/2 against N/2, 6000 ft apart, 40 nmi between the
/// sides, 480 kt at 20,000 ft.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>

#include "scenario/scenario.hpp"

namespace eyrie::bench {

inline std::string home() {
  const char* set = std::getenv("EYRIE_HOME");
  return set ? set : EYRIE_SOURCE_DIR;
}

/// "a", "b", ... "z", "ba" ...: flight names must not end in a digit.
inline std::string letters(int i) {
  std::string text;
  do
    text.insert(text.begin(), static_cast<char>('a' + i % 26));
  while (i /= 26);
  return text;
}

inline std::string side(const char* name, int aircraft, double east, int heading) {
  std::string text = fmt::format("{}:\n  flights:\n", name);
  for (int i = 0; i < aircraft; i += 4) {
    const std::string flight = fmt::format("{}_{}", name, letters(i / 4));
    text += fmt::format(
        "    {}:\n      aircraft: paper_fighter\n      tree: pilot\n"
        "      start: {{altitude: 20000 ft, heading: {} deg, speed: 480 kt}}\n"
        "      route: [{{north: 0 nmi, east: {} nmi, altitude: 20000 ft, speed: 480 kt}}]\n"
        "      players:\n",
        flight, heading, -4 * east);
    for (int k = i; k < std::min(i + 4, aircraft); ++k)
      text += fmt::format("        - {}{}: {{start: {{north: {:.1f} ft, east: {} nmi}}}}\n", flight,
                          k - i + 1, (k - (aircraft - 1) / 2.0) * 6000, east);
  }
  return text;
}

/// As facts about the peer describe it, so that both can be read side by side.
inline std::shared_ptr<const scenario::Scenario> line_abreast(int aircraft) {
  const std::string text =
      "eyrie: 1\nname: line_abreast\nreference: {latitude: 33 deg, longitude: -68 deg}\n"
      "ends: time\nuntil: 1 h\n"
      "trees:\n  pilot:\n    winner_takes_all:\n      - avoid_ground: {vote: 100}\n"
      "      - break_turn: {vote: 70}\n      - egress: {vote: 1}\n"
      "      - follow_lead: {vote: 5}\n      - navigate: {vote: 10}\n" +
      side("blue", aircraft / 2, -20, 90) + side("red", aircraft - aircraft / 2, 20, 270);
  auto source = scenario::Source::disk(home());
  source.add("line_abreast.yaml", text);
  return scenario::load({"line_abreast.yaml", {}}, std::move(source));
}

}  // namespace eyrie::bench
