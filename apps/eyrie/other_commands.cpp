// SPDX-License-Identifier: MIT
/// \file  validate and --version.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "commands.hpp"
#include "locate.hpp"
#include "say.hpp"

namespace eyrie::app {

std::string version_text() {
  return "eyrie " EYRIE_VERSION " (" EYRIE_COMPILER ", " EYRIE_BUILD_TYPE ")";
}

namespace {

/// "1 flight", "2 flights"
std::string counted(std::size_t n, std::string_view what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

/// "6 aircraft in 2 flights and 5 vehicles in 1 convoy"
std::string players_text(const scenario::Scenario& scenario) {
  std::string text;
  for (std::size_t f = 0; f < scenario.fleets.size(); ++f) {
    const auto& words = scenario.fleets[f]->words;
    const auto players =
        std::count_if(scenario.roster.players.begin(), scenario.roster.players.end(),
                      [&](const auto& player) { return player.fleet == f; });
    const auto groups = static_cast<std::size_t>(std::count_if(
        scenario.roster.flights.begin(), scenario.roster.flights.end(), [&](const auto& flight) {
          return scenario.roster.find(flight.members.front())->fleet == f;
        }));
    if (players)
      text += fmt::format("{}{} {} in {}", text.empty() ? "" : " and ", players,
                          players == 1 ? words.name : words.plural, counted(groups, words.group));
  }
  return text;
}

}  // namespace

int validate(const std::vector<std::string>& files, const std::vector<std::string>& plugins,
             const std::vector<std::string>& includes) {
  int code = 0;
  for (const std::string& file : files) {
    if (const auto scenario = load_or_complain(file, {}, plugins, includes))
      say("{}: {}, {}\n", scenario->file, players_text(*scenario),
          counted(scenario->tree_count(), "tree"));
    else
      code = 2;
  }
  return code;
}

}  // namespace eyrie::app
