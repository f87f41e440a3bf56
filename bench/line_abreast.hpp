// SPDX-License-Identifier: MIT
#pragma once
/// \file  A scene of any number of aircraft: N/2 against N/2, 6000 ft apart, 40 nmi between the
/// sides, 480 kt at 20,000 ft.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "scenario/scenario.hpp"

namespace eyrie::bench {

/// "a", "b", ... "z", "ba" ...: flight names must not end in a digit.
inline std::string letters(int i) {
  std::string text;
  do
    text.insert(text.begin(), static_cast<char>('a' + i % 26));
  while (i /= 26);
  return text;
}

/// `apart`: it flies to and fro for an hour, every flight on its own way, and so high above
/// 20,000 ft that nobody collides.
inline std::string side(const char* name, int aircraft, double east, int heading,
                        std::optional<int> apart) {
  std::string text = fmt::format("{}:\n  flights:\n", name);
  for (int i = 0; i < aircraft; i += 4) {
    const std::string flight = fmt::format("{}_{}", name, letters(i / 4));
    text += fmt::format(
        "    {}:\n      aircraft: paper_fighter\n      tree: pilot\n"
        "      start: {{altitude: {} ft, heading: {} deg, speed: 480 kt}}\n      route:\n",
        flight, 20000 + apart.value_or(0), heading);
    for (int leg = 0; leg < (apart ? 5 : 1); ++leg)
      text += fmt::format(
          "        - {{north: {:.1f} ft, east: {} nmi, altitude: {} ft, speed: 480 kt}}\n",
          apart ? (i - (aircraft - 1) / 2.0) * 6000 : 0.0, (leg % 2 ? 4 : -4) * east,
          20000 + apart.value_or(0));
    text += "      players:\n";
    for (int k = i; k < std::min(i + 4, aircraft); ++k)
      text += fmt::format("        - {}{}: {{start: {{north: {:.1f} ft, east: {} nmi}}}}\n", flight,
                          k - i + 1, (k - (aircraft - 1) / 2.0) * 6000, east);
  }
  return text;
}

/// As facts about the peer describe it, so that both can be read side by side.
inline std::shared_ptr<const scenario::Scenario> line_abreast(int aircraft,
                                                              bool for_an_hour = false) {
  const auto apart = [&](int feet) {
    return for_an_hour ? std::optional<int>(feet) : std::nullopt;
  };
  const std::string text =
      "eyrie: 1\nname: line_abreast\nreference: {latitude: 33 deg, longitude: -68 deg}\n"
      "ends: time\nuntil: 1 h\n"
      "trees:\n  pilot:\n    winner_takes_all:\n      - avoid_ground: {vote: 100}\n"
      "      - break_turn: {vote: 70}\n      - egress: {vote: 1}\n"
      "      - follow_lead: {vote: 5}\n      - navigate: {vote: 10}\n" +
      side("blue", aircraft / 2, -20, 90, apart(0)) +
      side("red", aircraft - aircraft / 2, 20, 270, apart(2000));
  auto source = scenario::Source::disk(EYRIE_SOURCE_DIR);
  source.add("line_abreast.yaml", text);
  return scenario::load({"line_abreast.yaml", {}}, std::move(source));
}

}  // namespace eyrie::bench
