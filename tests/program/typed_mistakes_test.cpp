// SPDX-License-Identifier: MIT
/// \file  The user's mistakes on the command line, through the real program: exit code 2, a line or
/// two of our own words, and nothing left on the disk.
#include <gtest/gtest.h>

#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

/// Mistakes in what was typed, with the good scenario.
struct Typed {
  const char* name;
  std::vector<std::string> arguments;
  const char* expected;  ///< stderr; without a line end: how it begins
};

void PrintTo(const Typed& t, std::ostream* out) {
  *out << t.name;
}

class TypedMistakes : public testing::TestWithParam<Typed> {};

TEST_P(TypedMistakes, AreSaidAndLeaveNothing) {
  const TempFolder folder;
  folder.write("x.yaml", kSmallScenario);
  folder.write("full/file", "kept");
  const Ran ran = run_program(folder, GetParam().arguments);
  EXPECT_EQ(ran.code, 2);
  const std::string expected = GetParam().expected;
  const bool whole = expected.ends_with('\n');
  EXPECT_EQ(whole ? ran.err : ran.err.substr(0, expected.size()), expected) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(folder.everything(), (std::vector<std::string>{"full", "full/file", "x.yaml"}));
}

INSTANTIATE_TEST_SUITE_P(
    OfTheCommandLine, TypedMistakes,
    testing::Values(
        Typed{"NoSuchScenario",
              {"fly", "sweap"},
              "eyrie: there is no scenario 'sweap'; did you mean 'sweep'?\n"},
        Typed{"NoSuchFile",
              {"fly", "nowhere/x.yaml"},
              "eyrie: there is no scenario 'nowhere/x.yaml'\n"},
        Typed{"MisspelledFile",
              {"fly", "y.yaml"},
              "eyrie: there is no scenario 'y.yaml'; did you mean 'x.yaml'?\n"},
        Typed{"FileWithoutItsEnding",
              {"validate", "x"},
              "eyrie: there is no scenario 'x'; did you mean 'x.yaml'?\n"},
        Typed{"CampaignWithoutItsEnding",
              {"campaign", "x"},
              "x: there is no such file; did you mean 'x.yaml'?\n"},
        Typed{"AScenarioIsNoCampaign",
              {"campaign", "x.yaml"},
              "x.yaml:1:1: this is a scenario: eyrie fly 'x.yaml'\n"},
        Typed{"SetWithoutValue",
              {"fly", "x.yaml", "--set", "blue"},
              "--set blue:1:1: expected path=value\n"},
        Typed{"SetOfAnUnknownPath",
              {"fly", "x.yaml", "--set", "blue.flights.egle.tree=cruise"},
              "--set blue.flights.egle.tree=cruise:1:14: there is no 'egle' here; did you mean "
              "'eagle'?\n"},
        Typed{"SetOfAnUnknownKey",
              {"fly", "x.yaml", "--set", "untill=3 s"},
              "--set untill=3 s:1:1: scenario has no parameter 'untill'; did you mean 'until'?\n"},
        Typed{
            "SetWithTheWrongUnit",
            {"fly", "x.yaml", "--set", "until=3 kg"},
            "--set until=3 kg:1:7: until: expected a time such as '3 min', got '3 kg' (a mass)\n"},
        Typed{"SetOfBrokenYaml",
              {"fly", "x.yaml", "--set", "seed={"},
              "--set seed={:1:6: not YAML: while parsing a flow node: did not find expected node "
              "content\n"},
        Typed{"TwoBadSets",
              {"fly", "x.yaml", "--set", "blue", "--set", "=3"},
              "--set blue:1:1: expected path=value\n--set =3:1:1: expected path=value\n"},
        Typed{"UntilInTheWrongUnit",
              {"fly", "x.yaml", "--until", "3 kg"},
              "--until: expected a time such as '3 min', got '3 kg' (a mass)\n"},
        Typed{"UntilTheStart", {"fly", "x.yaml", "--until", "0 s"}, "--until: 0 s is outside"},
        Typed{"OutThatIsNotEmpty",
              {"fly", "x.yaml", "--out", "full"},
              "eyrie: 'full' exists already; name another folder or add --force\n"},
        Typed{"OutThatIsAFile",
              {"fly", "x.yaml", "--out", "x.yaml"},
              "eyrie: 'x.yaml' is a file; only a folder is made or replaced\n"},
        Typed{"NegativeSeed",
              {"fly", "x.yaml", "--seed", "-1"},
              "eyrie: --seed: '-1' is no whole number from 0 to 18446744073709551615\n"
              "eyrie fly --help says more\n"},
        Typed{
            "NoWorkers",
            {"fly", "x.yaml", "--workers", "0"},
            "eyrie: --workers: '0' is no whole number from 1 to 256\neyrie fly --help says more\n"},
        Typed{"TooManyWorkers",
              {"fly", "x.yaml", "--workers", "257"},
              "eyrie: --workers: '257' is no whole number from 1 to 256\neyrie fly --help says "
              "more\n"},
        Typed{"ParanoidByHalves",
              {"fly", "x.yaml", "--paranoid", "1.5"},
              "eyrie: --paranoid: '1.5' is no whole number from 1 to 256\neyrie fly --help says "
              "more\n"},
        Typed{"UnknownOption",
              {"fly", "x.yaml", "--bogus"},
              "eyrie: fly has no option '--bogus'\neyrie fly --help says more\n"},
        Typed{"NoCommand",
              {},
              "eyrie: say what to do, such as eyrie fly sweep\neyrie --help says more\n"},
        Typed{"ReplayOfNothing", {"replay", "nowhere"}, "nowhere: there is no such file\n"},
        Typed{"ReplayOfAMisspelledFile",
              {"replay", "x.yml"},
              "x.yml: there is no such file; did you mean 'x.yaml'?\n"},
        Typed{"ReplayOfAForeignFile", {"replay", "x.yaml"}, "x.yaml: this is not a run file\n"},
        Typed{"UnknownOptionThatIsNear",
              {"fly", "x.yaml", "--sed", "7"},
              "eyrie: fly has no option '--sed'; did you mean '--seed'?\neyrie fly --help says "
              "more\n"},
        Typed{"UnknownNode",
              {"catalog", "persue"},
              "there is no node 'persue'; did you mean 'pursue'?\n"},
        Typed{"UnknownCommand",
              {"flly", "x.yaml"},
              "eyrie: there is no command 'flly'; did you mean 'fly'?\neyrie --help says more\n"},
        Typed{"EmptyUntil",
              {"fly", "x.yaml", "--until", ""},
              "eyrie: --until must not be empty\neyrie fly --help says more\n"},
        Typed{"EmptyOut",
              {"fly", "x.yaml", "--out", ""},
              "eyrie: --out must not be empty\neyrie fly --help says more\n"},
        Typed{"EmptySet",
              {"fly", "x.yaml", "--set", ""},
              "eyrie: --set must not be empty\neyrie fly --help says more\n"},
        Typed{"EmptyPlugin",
              {"fly", "x.yaml", "--plugin", ""},
              "eyrie: --plugin must not be empty\neyrie fly --help says more\n"},
        Typed{"EmptyAllowInclude",
              {"fly", "x.yaml", "--allow-include", ""},
              "eyrie: --allow-include must not be empty\neyrie fly --help says more\n"},
        Typed{"EmptyRealtime",
              {"fly", "x.yaml", "--real-time", ""},
              "eyrie: --real-time must not be empty\neyrie fly --help says more\n"},
        Typed{"EmptyRealtimeBehindAnEqualsSign",
              {"fly", "x.yaml", "--real-time="},
              "eyrie: --real-time must not be empty\neyrie fly --help says more\n"},
        Typed{"EmptyScenario",
              {"fly", ""},
              "eyrie: an argument must not be empty\neyrie fly --help says more\n"},
        Typed{"ValidateOfNothing",
              {"validate", ""},
              "eyrie: an argument must not be empty\neyrie validate --help says more\n"},
        Typed{"EmptyAt",
              {"explain", "r", "--player", "eagle1", "--at", ""},
              "eyrie: --at must not be empty\neyrie explain --help says more\n"},
        Typed{"EmptyEvent",
              {"explain", "r", "--player", "eagle1", "--event", ""},
              "eyrie: --event must not be empty\neyrie explain --help says more\n"},
        Typed{"EmptyFrom",
              {"explain", "r", "--player", "eagle1", "--from", ""},
              "eyrie: --from must not be empty\neyrie explain --help says more\n"},
        Typed{"EmptyTo",
              {"explain", "r", "--player", "eagle1", "--to", ""},
              "eyrie: --to must not be empty\neyrie explain --help says more\n"},
        Typed{"EmptyPlayer",
              {"explain", "r", "--player", ""},
              "eyrie: --player must not be empty\neyrie explain --help says more\n"},
        Typed{"EmptyPlayerOfAnExport",
              {"export", "r", "--to", "czml", "--player", ""},
              "eyrie: --player must not be empty\neyrie export --help says more\n"},
        Typed{"EmptyRun",
              {"replay", ""},
              "eyrie: an argument must not be empty\neyrie replay --help says more\n"},
        Typed{"RealtimeNan",
              {"fly", "x.yaml", "--real-time=nan"},
              "eyrie: --real-time: 'nan' is no rate: 0.1 to 100, or max\neyrie fly --help says "
              "more\n"},
        Typed{"RealtimeTiny",
              {"fly", "x.yaml", "--real-time=1e-300"},
              "eyrie: --real-time: '1e-300' is no rate: 0.1 to 100, or max\neyrie fly --help says "
              "more\n"},
        Typed{"RealtimeNegative",
              {"fly", "x.yaml", "--real-time=-1"},
              "eyrie: --real-time: '-1' is no rate: 0.1 to 100, or max\neyrie fly --help says "
              "more\n"},
        Typed{"RealtimeInfinite",
              {"fly", "x.yaml", "--real-time=inf"},
              "eyrie: --real-time: 'inf' is no rate: 0.1 to 100, or max\neyrie fly --help says "
              "more\n"},
        Typed{"ExportToAnUnknownFormat",
              {"export", "r", "--to", "cmzl"},
              "eyrie: --to: must be one of czml, geojson, decisions, answers, sqlite, pcap, got "
              "'cmzl'; "
              "did you mean "
              "'czml'?\neyrie export --help says more\n"},
        Typed{"ExplainAtNegative",
              {"explain", "r", "--player", "eagle1", "--at=-0:01"},
              "--at '-0:01': expected a time such as 312.4, '5 min' or 5:12.4\n"},
        Typed{"ExplainAtSeconds",
              {"explain", "r", "--player", "eagle1", "--at=1:99"},
              "--at '1:99': expected a time such as 312.4, '5 min' or 5:12.4\n"},
        Typed{"ExplainAtInfinite",
              {"explain", "r", "--player", "eagle1", "--at=inf"},
              "--at 'inf': expected a time such as 312.4, '5 min' or 5:12.4\n"},
        Typed{"ExplainAtHalfAMinute",
              {"explain", "r", "--player", "eagle1", "--at=1.5:00"},
              "--at '1.5:00': expected a time such as 312.4, '5 min' or 5:12.4\n"},
        Typed{"ExplainAtWord",
              {"explain", "r", "--player", "eagle1", "--at=noon"},
              "--at 'noon': expected a time such as 312.4, '5 min' or 5:12.4\n"},
        Typed{"ExplainAtNegativeQuantity",
              {"explain", "r", "--player", "eagle1", "--at=-5 min"},
              "--at '-5 min': expected a time such as 312.4, '5 min' or 5:12.4\n"},
        Typed{"ExplainToInfinity",
              {"explain", "r", "--player", "eagle1", "--to", "inf"},
              "--to 'inf': expected a time such as 312.4, '5 min' or 5:12.4\n"},
        Typed{"ExplainBackwards",
              {"explain", "r", "--player", "eagle1", "--from", "5", "--to", "4"},
              "--to '4': must be after --from\n"},
        Typed{"ExplainAnEventThatIsNoWord",
              {"explain", "r", "--player", "eagle1", "--event", "."},
              "--event '.': expected a word, such as break\n"},
        Typed{"SeedTwice",
              {"fly", "x.yaml", "--seed", "4", "--set", "seed=3"},
              "eyrie: --set 'seed=3': --seed sets 'seed', too\n"},
        Typed{"SeedsAndASeed",
              {"fly", "x.yaml", "--seeds", "1..2", "--set", "seed=3"},
              "eyrie: --set 'seed=3': --seeds sets 'seed', too\n"},
        Typed{"UntilTwice",
              {"fly", "x.yaml", "--until", "1 min", "--set", "until=2 min"},
              "eyrie: --set 'until=2 min': --until sets 'until', too\n"},
        Typed{"SetTwice",
              {"fly", "x.yaml", "--set", "seed=1", "--set", "seed=2"},
              "eyrie: --set 'seed=1': --set 'seed=2' sets 'seed', too\n"},
        Typed{"SetTwiceInTwoSpellings",
              {"fly", "x.yaml", "--set", "until=3 s", "--set", "\"until\"=1 s"},
              "eyrie: --set 'until=3 s': --set '\"until\"=1 s' sets 'until', too\n"},
        Typed{"SetTwiceFromAbove",
              {"fly", "x.yaml", "--set", "blue.flights=[]", "--set", "blue={flights: []}"},
              "eyrie: --set 'blue.flights=[]': --set 'blue={flights: []}' sets 'blue.flights', "
              "too\n"},
        Typed{"SeedTwiceInTwoSpellings",
              {"fly", "x.yaml", "--seed", "3", "--set", "\"seed\"=5"},
              "eyrie: --set '\"seed\"=5': --seed sets '\"seed\"', too\n"},
        Typed{"UntilTwiceInTwoSpellings",
              {"fly", "x.yaml", "--until", "2 s", "--set", "\"until\"=1 s"},
              "eyrie: --set '\"until\"=1 s': --until sets '\"until\"', too\n"},
        Typed{
            "SetToNothing",
            {"fly", "x.yaml", "--set", "blue.flights.eagle.start.altitude="},
            "--set blue.flights.eagle.start.altitude=:1:35: start.altitude: expected a length such "
            "as '6000 ft', got nothing\n"},
        Typed{"UnitsOfSeeds",
              {"fly", "x.yaml", "--seeds", "1..2", "--units", "metric"},
              "eyrie: --seeds excludes --units\neyrie fly --help says more\n"},
        Typed{"FlagWithAValue",
              {"fly", "x.yaml", "--quiet=false"},
              "eyrie: --quiet takes no value\neyrie fly --help says more\n"},
        Typed{"FlagWithAWord",
              {"fly", "x.yaml", "--json=pretty"},
              "eyrie: --json takes no value\neyrie fly --help says more\n"},
        Typed{"ThreeRunsToDebrief",
              {"debrief", "a", "b", "c"},
              "eyrie: debrief has no use for 'c'\neyrie debrief --help says more\n"},
        Typed{"ThreeRunsToServe",
              {"serve", "a", "b", "c"},
              "eyrie: serve has no use for 'c'\neyrie serve --help says more\n"},
        Typed{"WordBehindHelp",
              {"help", "fly", "extra"},
              "eyrie: help has no use for 'extra'\neyrie fly --help says more\n"},
        Typed{"WorkersOfAQuery",
              {"query", "r", "SELECT 1", "--workers", "3"},
              "eyrie: --workers requires --decisions\neyrie query --help says more\n"},
        Typed{"ForceOfAReportInItsPlace",
              {"report", "r", "--force"},
              "eyrie: --force requires --out\neyrie report --help says more\n"},
        Typed{"FolderAsAScenario", {"fly", "full"}, "eyrie: 'full' is a folder, not a file\n"},
        Typed{"OursThatIsNobody",
              {"fly", "x.yaml", "--dis", "--ours", "blu"},
              "--ours blu: there is no side, flight or player 'blu'; did you mean 'blue'?\n"},
        Typed{"OursThatIsNoName",
              {"fly", "x.yaml", "--dis", "--ours", "blue],*x"},
              "--ours blue],*x: there is no side, flight or player 'blue]'; did you mean 'blue'?\n"
              "--ours blue],*x: there is no side, flight or player '*x'\n"},
        Typed{"OursThatIsEmpty",
              {"fly", "x.yaml", "--dis", "--ours", "blue,"},
              "--ours blue,: there is no side, flight or player ''\n"},
        Typed{"TwoDistancesOfDis",
              {"fly", "x.yaml", "--dis", "--dis-threshold", "2 m, 3 deg, 3 m"},
              "--dis-threshold: '2 m, 3 deg, 3 m' has two distances\n"},
        Typed{"ZonesAboveTheirTable",
              {"zones", "aim9", "--draw", "--altitude", "100 km"},
              "eyrie: --altitude '100 km': must be from 300 m to 15 km, for which zones are "
              "flown\n"},
        Typed{"UntilEndless", {"fly", "x.yaml", "--until", "1e308 s"}, "--until: "},
        Typed{"UntilInfinite", {"fly", "x.yaml", "--until", "1e300 h"}, "--until: "},
        Typed{"UntilNoStep", {"fly", "x.yaml", "--until", "1 ms"}, "--until: "},
        Typed{"UntilBeyondAnyFlight", {"fly", "x.yaml", "--until", "1000001 s"}, "--until: "}),
    [](const auto& test) { return std::string(test.param.name); });

/// Whatever is typed, what is said of it stays short and in our words.
TEST(LongArguments, AreNotEchoedWhole) {
  const TempFolder folder;
  folder.write("x.yaml", kSmallScenario);
  const std::string huge(100'000, 'x');
  const std::vector<std::vector<std::string>> lines{
      {huge},
      {"fly", huge},
      {"fly", "--" + huge},
      {"fly", "x.yaml", huge},
      {"fly", "x.yaml", "--until", huge},
      {"fly", "x.yaml", "--seed", huge},
      {"fly", "x.yaml", "--set", huge},
      {"fly", "x.yaml", "--set", "name=" + huge},
      {"fly", "x.yaml", "--set", huge + "=1"},
      {"fly", "x.yaml", "--set", "blue." + huge + ".x=1"},
      {"fly", "x.yaml", "--plugin", huge},
      {"fly", "x.yaml", "--allow-include", huge},
      {"fly", "x.yaml", "--real-time", huge},
      {"fly", "x.yaml", "--out", huge},
      {"fly", "x.yaml", "--out", huge, "--force"},
      {"validate", huge},
      {"replay", huge},
      {"explain", huge, "--player", "eagle1"},
      {"diff", huge, huge},
      {"debrief", huge},
      {"export", huge, "--to", "czml"},
      {"export", "r", "--to", huge},
      {"new", "behavior", huge},
  };
  for (const auto& words : lines) {
    const Ran ran = run_program(folder, words);
    const std::string which = words[0].substr(0, 20) + " " + words.back().substr(0, 20);
    EXPECT_EQ(ran.code, 2) << which;
    EXPECT_LT(ran.err.size(), 1000u) << which;
    EXPECT_EQ(ran.err.find("filesystem"), std::string::npos) << which << ran.err;
    EXPECT_EQ(ran.err.find("std::"), std::string::npos) << which << ran.err;
    EXPECT_NE(ran.err.find("x..."), std::string::npos) << which << " is not named: " << ran.err;
  }
  EXPECT_EQ(folder.everything(), std::vector<std::string>{"x.yaml"});
}

TEST(CurrentFolder, IsSaidToBeGone) {
  const TempFolder folder;
  const Ran ran =
      run_line(folder, "mkdir gone && cd gone && rmdir ../gone && eyrie validate merge");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.err, "eyrie: the current folder is gone; go to another\n");
}

TEST(WrongHome, IsSaidToBeWrong) {
  const TempFolder folder;
  folder.write("x.yaml", kSmallScenario);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"fly", "x.yaml"},
                                                {"validate", "x.yaml"},
                                                {"catalog"},
                                                {"new", "behavior", "mine"}}) {
    const Ran ran = run_program(folder, words, {.home = "/nowhere"});
    EXPECT_EQ(ran.code, 2) << words[0];
    EXPECT_EQ(ran.err, "eyrie: EYRIE_HOME is '/nowhere', where there is no folder 'data'\n");
  }
}

}  // namespace
}  // namespace eyrie::test
