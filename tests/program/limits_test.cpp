// SPDX-License-Identifier: MIT
/// \file  Scenarios that are built to be large: the limit is said where it is passed, in one line,
/// instead of a load that takes the square of their size.
#include <gtest/gtest.h>

#include <functional>

#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

std::string repeated(int count, const std::function<std::string(const std::string&)>& one) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += one(std::to_string(i));
  return text;
}

struct Large {
  const char* name;
  std::string text;
  const char* expected;  ///< how stderr begins
};
void PrintTo(const Large& l, std::ostream* out) {
  *out << l.name;
}
class Limits : public testing::TestWithParam<Large> {};

TEST_P(Limits, AreSaid) {
  const TempFolder folder;
  folder.write("x.yaml", GetParam().text);
  const Ran ran = run_program(folder, {"validate", "x.yaml"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_TRUE(ran.err.starts_with(GetParam().expected)) << ran.err.substr(0, 300);
  EXPECT_LT(ran.err.size(), 20'000u);
}

INSTANTIATE_TEST_SUITE_P(
    OfAScenario, Limits,
    testing::Values(
        Large{"Trees",
              changed_scenario({{"trees:\n", "trees:\n" + repeated(40'000,
                                                                   [](const std::string& i) {
                                                                     return "  t" + i +
                                                                            ": navigate\n";
                                                                   })}}),
              "x.yaml:7:3: trees: 40001 of them; a scenario has at most 2000"},
        Large{"TreesOfASequencer",
              changed_scenario({{"trees:\n", "trees:\n  many: {sequencer: {start: s0, trees: {" +
                                                 repeated(501,
                                                          [](const std::string& i) {
                                                            return "s" + i + ": navigate, ";
                                                          }) +
                                                 "}}}\n"}}),
              "x.yaml:7:40: 501 trees; a sequencer has at most 500"},
        Large{"Models",
              "data:\n  missiles:\n" +
                  repeated(40'000,
                           [](const std::string& i) { return "    m" + i + ": {base: r77}\n"; }) +
                  kSmallScenario,
              "x.yaml:2:3: data.missiles: 40000 models; a scenario has at most 200 of a kind"},
        Large{
            "Flights",
            kSmallScenario + repeated(6'000,
                                      [](const std::string& i) {
                                        return "    f" + i + "x: {aircraft: f15c, players: [f" + i +
                                               "x1], start: {north: 0 nmi, east: 0 nmi, altitude: "
                                               "9 km, heading: 90 deg, speed: 480 kt}}\n";
                                      }),
            "x.yaml:5020:5: a scenario has at most 5000 flights and convoys"},
        Large{"UnknownKeys",
              kSmallScenario +
                  repeated(90'000, [](const std::string& i) { return "k" + i + ": 1\n"; }),
              "x.yaml:21:1: scenario has no parameter 'k0'"}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace eyrie::test
