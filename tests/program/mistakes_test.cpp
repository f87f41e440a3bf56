// SPDX-License-Identifier: MIT
/// \file  The user's mistakes, through the real program: exit code 2, every mistake of the file
/// with its place and the nearest right name, and nothing left on the disk.
#include <gtest/gtest.h>

#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

struct Mistake {
  const char* name;
  std::vector<Change> changes;
  const char* expected;  ///< stderr; without a line end: how it begins
};

void PrintTo(const Mistake& m, std::ostream* out) {
  *out << m.name;
}

/// All of it, or its beginning if no line end is expected.
void expect_said(const std::string& said, const std::string& expected) {
  const bool whole = expected.ends_with('\n');
  EXPECT_EQ(whole ? said : said.substr(0, expected.size()), expected) << said;
}

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreSaidWithTheirPlaceAndLeaveNothing) {
  const TempFolder folder;
  folder.write("x.yaml", changed_scenario(GetParam().changes));
  for (const char* command : {"fly", "validate"}) {
    const Ran ran = run_program(folder, {command, "x.yaml"});
    EXPECT_EQ(ran.code, 2) << command;
    expect_said(ran.err, GetParam().expected);
    EXPECT_EQ(ran.out, "") << command;
  }
  EXPECT_EQ(folder.everything(), std::vector<std::string>{"x.yaml"});
}

/// Ten times ten times ten: 10^6 values from a few lines.
std::string bomb() {
  std::string text = "x: {a: &a [0, 0, 0, 0, 0, 0, 0, 0, 0, 0]";
  for (char c = 'b'; c < 'h'; ++c) {
    text += std::string(",\n  ") + c + ": &" + c + " [";
    for (int i = 0; i < 10; ++i)
      text += std::string(i ? ", *" : "*") + static_cast<char>(c - 1);
    text += "]";
  }
  return text + "}\n";
}

INSTANTIATE_TEST_SUITE_P(
    OfAFile, Mistakes,
    testing::Values(
        Mistake{"DuplicateKey",
                {{"vote: 10,", "vote: 10, vote: 20,"}},
                "x.yaml:10:30: 'vote' is given twice (first at line 10)\n"},
        Mistake{"DuplicateKeyAtTheTop",
                {{"until: 2 s", "until: 2 s\nuntil: 3 s"}},
                "x.yaml:5:1: 'until' is given twice (first at line 4)\n"},
        Mistake{"AliasBomb",
                {{"eyrie: 1\n", "eyrie: 1\n" + bomb()}},
                "x.yaml:7:10: more than 200000 values, aliases expanded\n"},
        Mistake{"ACampaign",
                {{"until: 2 s", "until: 2 s\nmeasures: {}"}},
                "x.yaml:1:1: this is a campaign: eyrie campaign 'x.yaml'\n"},
        Mistake{"ASearch",
                {{"until: 2 s", "until: 2 s\noptimize: {}"}},
                "x.yaml:1:1: this is a search: eyrie optimize 'x.yaml'\n"},
        Mistake{"UnknownKey",
                {{"until", "untill"}},
                "x.yaml:4:1: scenario has no parameter 'untill'; did you mean 'until'?\n"},
        Mistake{"UnknownParameter",
                {{"vote: 100", "vot: 100"}},
                "x.yaml:9:24: avoid_ground has no parameter 'vot'; did you mean 'vote'?\n"},
        Mistake{
            "WrongDimension",
            {{"speed: 480 kt}\nblue", "speed: 480 nmi}\nblue"}},
            "x.yaml:10:37: speed: expected a speed such as '480 kt', got '480 nmi' (a length)\n"},
        Mistake{"MissingUnit",
                {{"speed: 480 kt}\nblue", "speed: 480}\nblue"}},
                "x.yaml:10:37: speed: expected a speed such as '480 kt', got '480' (without a "
                "unit)\n"},
        Mistake{"NotANumber",
                {{"until: 2 s", "until: nan s"}},
                "x.yaml:4:8: until: expected a time such as '3 min', got 'nan s'\n"},
        Mistake{"YamlNan",
                {{"vote: 10,", "vote: .nan,"}},
                "x.yaml:10:26: vote: expected a plain number such as '0.5', got '.nan'\n"},
        Mistake{"Infinity",
                {{"until: 2 s", "until: inf s"}},
                "x.yaml:4:8: until: expected a time such as '3 min', got 'inf s'\n"},
        Mistake{"OutOfRange",
                {{"vote: 100", "vote: -4"}},
                "x.yaml:9:30: vote: -4 is outside [0, 1000]\n"},
        Mistake{
            "OtherFormatVersion",
            {{"eyrie: 1", "eyrie: 2"}},
            "x.yaml:1:8: eyrie: this file is of format 2, which needs a newer program; this one, "},
        Mistake{"NoFormatVersion",
                {{"eyrie: 1", "eyrie: -1"}},
                "x.yaml:1:8: eyrie: there is no format -1; this program, "},
        Mistake{"UnknownChoice",
                {{"ends: time", "ends: tim"}},
                "x.yaml:5:7: ends: expected one of blue_home, last_side, time, got 'tim'; did you "
                "mean 'time'?\n"},
        Mistake{"OverBeforeItsFirstStep",
                {{"ends: time", "ends: last_side"}},
                "x.yaml:5:7: ends: last_side holds at the start already (red_lost): nothing would "
                "be flown\n"},
        Mistake{"MissingInclude",
                {{"name: small", "name: small\ninclude: pilots.yaml"}},
                "x.yaml:3:10: cannot read 'pilots.yaml'\n"},
        Mistake{"IncludeOfItself",
                {{"name: small", "name: small\ninclude: x.yaml"}},
                "x.yaml:3:10: 'x.yaml' includes itself: x.yaml -> x.yaml\n"},
        Mistake{"TwoPlayersOfOneName",
                {{"eagle2]", "eagle1]"}},
                "x.yaml:17:25: there are two players 'eagle1' (also at x.yaml:17:17)\n"},
        Mistake{"NoLead",
                {{"[eagle1, eagle2]", "[eagle2, eagle3]"}},
                "x.yaml:17:16: flight 'eagle' has no lead: none of its players is 'eagle1'\n"},
        Mistake{"NoPlayers",
                {{"[eagle1, eagle2]", "[]"}},
                "x.yaml:17:16: flight 'eagle' needs its players: a list such as [eagle1, "
                "eagle2]\n"},
        Mistake{"NoPlayerThatIsOne",
                {{"[eagle1, eagle2]", "[hawk1]"}, {"f15c", "f15"}, {"tree: cruise", "tree: cruse"}},
                "x.yaml:15:17: unknown aircraft 'f15'; did you mean 'f15c'?\n"
                "x.yaml:16:13: there is no tree 'cruse'; did you mean 'cruise'?\n"
                "x.yaml:17:17: 'hawk1' is not the flight's name and a rank, such as 'eagle1'\n"},
        Mistake{"TreeThatRefersToItself",
                {{"- avoid_ground: {vote: 100}", "- tree: cruise"}},
                "x.yaml:9:15: tree 'cruise' refers to itself: cruise -> cruise\n"},
        Mistake{"TreesThatReferToEachOther",
                {{"trees:\n", "trees:\n  a: {tree: b}\n  b: {tree: a}\n"}},
                "x.yaml:7:13: tree 'b' refers to itself: b -> a -> b\n"
                "x.yaml:8:13: tree 'a' refers to itself: a -> b -> a\n"},
        Mistake{"UnknownBehavior",
                {{"navigate", "navigat"}},
                "x.yaml:10:9: there is no node 'navigat'; did you mean 'navigate'?\n"},
        Mistake{"UnknownSubtree",
                {{"- avoid_ground: {vote: 100}", "- tree: cruse"}},
                "x.yaml:9:15: there is no tree 'cruse'; did you mean 'cruise'?\n"},
        Mistake{"UnknownAircraft",
                {{"f15c", "f15d"}},
                "x.yaml:15:17: unknown aircraft 'f15d'; did you mean 'f15c'?\n"},
        Mistake{"UnknownTree",
                {{"tree: cruise", "tree: criuse"}},
                "x.yaml:16:13: there is no tree 'criuse'; did you mean 'cruise'?\n"},
        Mistake{"NoAircraft",
                {{"      aircraft: f15c\n", ""}, {"[eagle1, eagle2]", "[eagle1]"}},
                "x.yaml:16:17: eagle1: which aircraft? Neither it nor its flight says\n"},
        Mistake{"EmptyAircraft",
                {{"f15c", ""}},
                "x.yaml:15:7: aircraft: expected a text, got nothing\n"},
        Mistake{"AircraftWithoutAName",
                {{"f15c", "''"}, {"[eagle1, eagle2]", "[eagle1]"}},
                "x.yaml:17:17: eagle1: which aircraft? Neither it nor its flight says\n"},
        Mistake{"UnknownStore",
                {{"tree: cruise", "tree: cruise\n      loadout: [aim9, aim121]"}},
                "x.yaml:17:23: unknown missile 'aim121'; did you mean 'aim120'?\n"},
        Mistake{
            "MissingData",
            {{"name: small", "name: small\ndata: {aircraft: {mine: {base: f15c, radar: apg36}}}"},
             {"aircraft: f15c", "aircraft: mine"}},
            "x.yaml:3:45: unknown radar 'apg36'; did you mean 'apg63'?\n"},
        Mistake{"AirframeThatIsWrongAndFlown",
                {{"name: small",
                  "name: small\ndata: {airframes: {own: {base: f15cc}}, aircraft: {mine: {base: "
                  "f15c, airframe: own}}}"},
                 {"aircraft: f15c", "aircraft: mine"}},
                "x.yaml:3:32: unknown airframe 'f15cc'; did you mean 'f15c'?\n"},
        Mistake{
            "SeekerThatLooksFasterThanTheStep",
            {{"name: small",
              "name: small\ndata: {missiles: {own: {base: aim9, seeker: {look_rate: 60 Hz}}}}"}},
            "x.yaml:3:57: data.missiles.own.seeker.look_rate: 60 Hz is faster than the step, "
            "which runs at 50 Hz\n"},
        Mistake{"TooMuchFuel",
                {{"tree: cruise", "tree: cruise\n      fuel: 20000 kg"}},
                "x.yaml:17:13: fuel 20000 kg is more than a f15c holds (5952 kg)\n"},
        Mistake{"UnknownPlayerAndTreeOfAnOrder",
                {{"ends: time",
                  "ends: time\norders:\n  - {at: 1 s, player: eagel1, swap_tree: crusie}"}},
                "x.yaml:7:23: there is no player 'eagel1'; did you mean 'eagle1'?\n"
                "x.yaml:7:42: there is no tree 'crusie'; did you mean 'cruise'?\n"},
        Mistake{"OrderAfterTheEnd",
                {{"ends: time", "ends: time\norders: [{at: 500 s, player: eagle1, lose: true}]"}},
                "x.yaml:6:15: an order at 500 s is never given: the flight ends at 2 s (until)\n"},
        Mistake{
            "OrderInTheLastHalfStep",
            {{"ends: time", "ends: time\norders: [{at: 1.995 s, player: eagle1, lose: true}]"}},
            "x.yaml:6:15: an order at 1.995 s is never given: the flight ends at 2 s (until)\n"},
        Mistake{"MoreRoundsThanTheGunHolds",
                {{"tree: cruise", "tree: cruise\n      rounds: 10000"}},
                "x.yaml:17:15: 10000 rounds are more than the gun of a f15c holds (940)\n"},
        Mistake{"RoundsWithoutAGun",
                {{"name: small", "name: small\ndata: {aircraft: {mine: {base: f15c, gun: null}}}"},
                 {"aircraft: f15c", "aircraft: mine\n      rounds: 1"}},
                "x.yaml:17:15: a mine has no gun for 1 rounds\n"},
        Mistake{"BingoAboveTheTank",
                {{"tree: cruise", "tree: cruise\n      bingo: 90000 kg"}},
                "x.yaml:17:14: bingo 90000 kg is not less than the fuel at the start (5952 kg)\n"},
        Mistake{"BingoAboveTheFuel",
                {{"tree: cruise", "tree: cruise\n      fuel: 2000 kg\n      bingo: 2000 kg"}},
                "x.yaml:18:14: bingo 2000 kg is not less than the fuel at the start (2000 kg)\n"},
        Mistake{"ModelOfEyriesName",
                {{"name: small", "name: small\ndata: {aircraft: {f15c: {base: f16c}}}"}},
                "x.yaml:3:19: aircraft 'f15c' is there already (data/aircraft/f15c.yaml): give "
                "yours another name; 'base: f15c' takes over what it does not say\n"},
        Mistake{"TwoBases",
                {{"name: small", "name: small\ndata: {missiles: {a: {base: r77, base: aim9}}}"}},
                "x.yaml:3:34: 'base' is given twice (first at line 3)\n"},
        Mistake{"PartTwiceBesideABase",
                {{"name: small",
                  "name: small\ndata: {aircraft: {a: {base: su27, radar: n001, radar: n019}}}"}},
                "x.yaml:3:48: 'radar' is given twice (first at line 3)\n"},
        Mistake{"KeyTwiceInAPartBesideABase",
                {{"name: small",
                  "name: small\ndata: {missiles: {a: {base: r77, warhead: {best_kill: 1, "
                  "best_kill: 0.5}}}}"}},
                "x.yaml:3:58: 'best_kill' is given twice (first at line 3)\n"},
        Mistake{"UnknownKeyInAModelThatNobodyFlies",
                {{"name: small", "name: small\ndata: {missiles: {a: {base: r77, colour: red}}}"}},
                "x.yaml:3:34: missile has no parameter 'colour', only "},
        Mistake{"AbsurdIntervalInAModelThatNobodyFlies",
                {{"name: small",
                  "name: small\ndata: {missiles: {a: {base: r77, release_interval: 1e308 s}}}"}},
                "x.yaml:3:52: release_interval: 1e308 s is outside [0 s, 600 s]\n"},
        Mistake{"RateThatDoesNotDivideInAModelThatNobodyFlies",
                {{"name: small",
                  "name: small\ndata: {radars: {mine: {base: apg63, track_rate: 7 Hz}}}"}},
                "x.yaml:3:49: data.radars.mine.track_rate: 7 Hz"},
        Mistake{"RateThatDoesNotFitAShippedModel",
                {{"name: small", "name: small\nrates: {kinematics: 7 Hz, decisions: 7 Hz}"}},
                "x.yaml:3:8: data.radars.apg63."},
        Mistake{"UntilBeforeTheFirstStep",
                {{"until: 2 s", "until: 1 ms"}},
                "x.yaml:4:8: until: 1 ms is outside"},
        Mistake{"UntilBeyondAnyFlight",
                {{"until: 2 s", "until: 1e308 s"}},
                "x.yaml:4:8: until: 1e308 s is outside"},
        Mistake{"OnlyATilde",
                {{changed_scenario({}), "~\n"}},
                "x.yaml:1:1: expected a map, got nothing\n"},
        Mistake{"NotYaml",
                {{"blue:\n", "blue: ]\n"}},
                "x.yaml:11:7: not YAML: while parsing a block node: did not find expected node "
                "content\n"},
        Mistake{
            "EverythingAtOnce",
            {{"until", "untill"},
             {"vote: 100", "vote: -4"},
             {"speed: 480 kt}\nblue", "speed: 480 nmi}\nblue"},
             {"east: -20 nmi", "east: -20 kg"},
             {"f15c", "f15d"},
             {"tree: cruise", "tree: criuse"},
             {"altitude: 25000 ft, heading", "altitud: 25000 ft, heading"}},
            "x.yaml:4:1: scenario has no parameter 'untill'; did you mean 'until'?\n"
            "x.yaml:9:30: vote: -4 is outside [0, 1000]\n"
            "x.yaml:10:37: speed: expected a speed such as '480 kt', got '480 nmi' (a length)\n"
            "x.yaml:12:30: east: expected a length such as '6000 ft', got '-20 kg' (a mass)\n"
            "x.yaml:15:17: unknown aircraft 'f15d'; did you mean 'f15c'?\n"
            "x.yaml:16:13: there is no tree 'criuse'; did you mean 'cruise'?\n"
            "x.yaml:18:42: start: start has no parameter 'altitud'; did you mean 'altitude'?\n"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(GoodScenario, HasNoMistakes) {
  const TempFolder folder;
  folder.write("x.yaml", kSmallScenario);
  const Ran ran = run_program(folder, {"validate", "x.yaml"});
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(ran.out, "x.yaml: 2 aircraft in 1 flight, 1 tree\n");
  EXPECT_EQ(run_program(folder, {"fly", "x.yaml"}).code, 0);
}

/// One bad file does not hide the others.
TEST(Validate, LooksAtEveryFile) {
  const TempFolder folder;
  folder.write("x.yaml", kSmallScenario);
  folder.write("y.yaml", changed_scenario({{"vote: 100", "vote: -4"}}));
  const Ran ran = run_program(folder, {"validate", "y.yaml", "gone.yaml", "x.yaml", "sweep"});
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.err,
            "y.yaml:9:30: vote: -4 is outside [0, 1000]\neyrie: there is no scenario "
            "'gone.yaml'\n");
  EXPECT_TRUE(ran.out.starts_with("x.yaml: 2 aircraft in 1 flight, 1 tree\n")) << ran.out;
  EXPECT_NE(ran.out.find("sweep.yaml: 6 aircraft in 2 flights"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace eyrie::test
