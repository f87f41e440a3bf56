// SPDX-License-Identifier: MIT
/// \file  Every scenario of scenarios/ with its own seed against tests/determinism/golden_runs.txt:
/// facts that people can judge, and the hash of the last world. When a change of behavior is
/// wanted, fly `EYRIE_UPDATE_GOLDEN=1 build/dev/tests/determinism_test --gtest_filter=Golden.*` and
/// commit the new table with the reason.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "support/flight.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

constexpr const char* kTable = "tests/determinism/golden_runs.txt";

std::string facts(const std::string& name) {
  Flight f(load_scenario(name));
  f.mission.fly();
  std::string text = fmt::format("{} seed {}: {} after {} steps\n", name, f.scenario->spec.seed,
                                 enum_name(f.mission.outcome()), f.world().step());
  for (const model::Side side : {model::Side::blue, model::Side::red}) {
    const auto s = f.tally.side(side);
    if (s.players)
      text += fmt::format("  {}: {} aircraft, {} shots, {} kills, {} losses, {} home\n",
                          scenario::side_name(side), s.players, s.shots, s.kills, s.losses, s.home);
  }
  for (std::size_t i = 0; i < f.scenario->roster.flights.size(); ++i) {
    std::string phases;
    for (const auto& phase : f.tally.phases())
      if (phase.flight == i)
        phases += fmt::format("{} {} {:.1f} s", phases.empty() ? "" : ",", phase.phase, phase.time);
    if (!phases.empty())
      text += fmt::format("  {}:{}\n", f.scenario->roster.flights[i].name, phases);
  }
  return text + fmt::format("  hash 0x{:016x}\n", f.world().hash());
}

/// Paragraphs of the table by the name they begin with.
std::map<std::string, std::string> read_table() {
  std::map<std::string, std::string> table;
  std::ifstream in(kTable);
  std::string line, name;
  while (std::getline(in, line)) {
    if (line.empty() || line.front() == '#')
      continue;
    if (line.front() != ' ')
      name = line.substr(0, line.find(' '));
    table[name] += line + "\n";
  }
  return table;
}

TEST(Golden, RunsOfAllScenariosAreWhatTheyWere) {
  const bool update = std::getenv("EYRIE_UPDATE_GOLDEN") && !std::getenv("CI");
  const auto expected = read_table();
  std::map<std::string, std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator("scenarios"))
    if (entry.path().extension() == ".yaml")
      found[entry.path().stem().string()];
  ASSERT_GE(found.size(), 7U);
  for (auto& [name, text] : found) {
    text = facts(name);
    EXPECT_TRUE(update || expected.contains(name)) << name << " has no golden run";
    EXPECT_EQ(text, update || !expected.contains(name) ? text : expected.at(name));
  }
  for (const auto& [name, text] : expected)
    EXPECT_TRUE(update || found.contains(name)) << name << " is in the table but not in scenarios/";
  if (!update)
    return;
  std::ofstream out(kTable);
  out << "# Every scenario with its own seed. Written by golden_test.cpp, which says how; a "
         "change\n"
         "# of behavior updates it in a commit of its own, with the reason.\n";
  for (const auto& [name, text] : found)
    out << "\n" << text;
}

}  // namespace
}  // namespace eyrie::test
