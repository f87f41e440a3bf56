// SPDX-License-Identifier: MIT
/// \file  validate and --version.
#include <fmt/format.h>

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
  const std::size_t vehicles = scenario.count(scenario::Platform::vehicle);
  const std::size_t aircraft = scenario.count(scenario::Platform::aircraft);
  std::size_t convoys = 0;
  for (const auto& flight : scenario.roster.flights)
    convoys +=
        scenario.roster.find(flight.members.front())->platform == scenario::Platform::vehicle;
  const std::string air = fmt::format("{} aircraft in {}", aircraft,
                                      counted(scenario.roster.flights.size() - convoys, "flight"));
  const std::string ground =
      fmt::format("{} in {}", counted(vehicles, "vehicle"), counted(convoys, "convoy"));
  return !vehicles ? air : !aircraft ? ground : air + " and " + ground;
}

}  // namespace

int validate(const std::vector<std::string>& files, const std::vector<std::string>& plugins,
             const std::vector<std::string>& includes) {
  int code = 0;
  for (const std::string& file : files) {
    if (const auto scenario = load_or_complain(file, {}, plugins, includes))
      say("{}: {}, {}\n", scenario->file, players_text(*scenario),
          counted(scenario->trees->size() + scenario->driver_trees->size(), "tree"));
    else
      code = 2;
  }
  return code;
}

}  // namespace eyrie::app
