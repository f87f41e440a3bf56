// SPDX-License-Identifier: MIT
#include "campaign/spec.hpp"

#include <gtest/gtest.h>

#include "campaign/search.hpp"

namespace eyrie::campaign {
namespace {

const std::string kGood = R"(eyrie: 1
name: fuel
scenario: sweep
set: [until=60 min]
factors:
  bingo: {path: blue.flights.eagle.bingo, values: [1800 kg, 2200 kg]}
  tree:
    levels:
      veteran: blue.flights.eagle.tree=veteran
      same: [blue.flights.eagle.tree=veteran, red.flights.bogey.tree=veteran]
seeds: {first: 10}
stop: {measure: left, width: 100 lb, most: 500}
measures:
  won: {what: outcome, is: [red_lost]}
  exchange: {what: exchange_ratio, who: blue}
  left: {what: fuel_left, who: eagle}
  near: {what: event, event: launch, who: blue, if: range < 10 nmi and time > 5 min, take: first, value: range}
  breaks: {what: decision, node: jink, if: missile_range < 2 nmi, take: any}
budget: {time: 2 h}
)";

std::string with(std::string_view from, std::string_view to) {
  std::string text = kGood;
  const auto at = text.find(from);
  if (at == text.npos)
    throw std::logic_error("not there: " + std::string(from));
  return text.replace(at, from.size(), to);
}
std::string mistake(const std::string& text) {
  try {
    static_cast<void>(parse_spec(text, "c.yaml"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Spec, SaysWhatItsFileSays) {
  const Spec spec = parse_spec(kGood, "x/c.yaml");
  const std::vector<Cell> cells = cells_of(spec);
  ASSERT_EQ(cells.size(), 4U);
  EXPECT_EQ(cells[1].values, (std::vector<std::string>{"1800 kg", "same"}));
  EXPECT_EQ(sets_of(spec, cells[1]),
            (std::vector<std::string>{"until=60 min", "blue.flights.eagle.bingo=1800 kg",
                                      "blue.flights.eagle.tree=veteran",
                                      "red.flights.bogey.tree=veteran"}));
  EXPECT_EQ(spec.scenario, "sweep");
  EXPECT_EQ(parse_spec(with("scenario: sweep", "scenario: ../y.yaml"), "x/c.yaml").scenario,
            "y.yaml");
  EXPECT_EQ(spec.budget.time, 7200);
  ASSERT_TRUE(spec.stop);
  EXPECT_EQ(spec.stop->measure, 2U);
  EXPECT_DOUBLE_EQ(spec.stop->width, si(100, "lb"));
  EXPECT_EQ(spec.stop->every, 50U);
  std::vector<std::string> columns;
  for (const Column& c : spec.measures.columns)
    columns.push_back(c.name + " " + c.unit);
  EXPECT_EQ(columns, (std::vector<std::string>{"won ", "exchange.sum ", "exchange.per ", "left kg",
                                               "near m", "breaks "}));
  EXPECT_EQ(spec.measures.estimates[0].kind, Measure::share);
  EXPECT_EQ(spec.measures.estimates[1].kind, Measure::ratio);
  EXPECT_EQ(spec.measures.estimates[3].kind, Measure::mean);
  EXPECT_EQ(spec.measures.estimates[4].column, 5U);
}

TEST(Spec, PairsTheSeedsOfAllCells) {
  const Spec paired = parse_spec(kGood, "c.yaml");
  EXPECT_EQ(seed_of(paired, 0, 3), 13U);
  EXPECT_EQ(seed_of(paired, 2, 3), 13U);
  const Spec apart = parse_spec(with("{first: 10}", "{first: 10, paired: false}"), "c.yaml");
  EXPECT_EQ(seed_of(apart, 2, 3), 1013U) << "500 for each cell";
}

/// What check() says of a campaign of the real sweep.
std::string refused(const std::string& text) {
  try {
    check(parse_spec(text, "c.yaml"), [](const std::vector<std::string>& sets) {
      return scenario::load({.file = "scenarios/sweep.yaml", .sets = sets},
                            scenario::Source::disk("."));
    });
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(Spec, TriesEachLevelOnceBeforeAnythingIsFlown) {
  EXPECT_EQ(refused(kGood), "");
  EXPECT_EQ(
      refused(with("2200 kg", "2200 lbf")),
      "c.yaml:6:61: bingo: the scenario refuses '2200 lbf'\n"
      "--set blue.flights.eagle.bingo=2200 lbf:1:26: bingo: expected a mass such as '900 kg', "
      "got '2200 lbf' (a force)");
  EXPECT_EQ(refused(with("path: blue.flights.eagle.bingo", "path: blue.flights.eagel.bingo")),
            "c.yaml:6:52: bingo: the scenario refuses '1800 kg'\n"
            "--set blue.flights.eagel.bingo=1800 kg:1:14: there is no 'eagel' here; did you mean "
            "'eagle'?");
  EXPECT_EQ(refused(with("1800 kg", "1800 ft")).substr(0, 55),
            "c.yaml:6:52: bingo: the scenario refuses '1800 ft'\n--se");
  EXPECT_EQ(refused(with("until=60 min", "a.b=1")),
            "c.yaml:4:7: set: the scenario refuses 'a.b=1'\n"
            "--set a.b=1:1:1: there is no 'a' here; what is new is set whole, as in a={b: ...}");
  EXPECT_EQ(refused(with("who: eagle", "who: eagel")),
            "c.yaml:16:32: left: there is no side, flight or player 'eagel'; did you mean "
            "'eagle'?");
  EXPECT_EQ(refused(with("[1800 kg, 2200 kg]", "[1800 kg, 2 m, 3 m]")),
            "c.yaml:6:61: bingo: the scenario refuses '2 m'\n"
            "c.yaml:6:66: bingo: the scenario refuses '3 m'\n"
            "--set blue.flights.eagle.bingo=2 m:1:26: bingo: expected a mass such as '900 kg', "
            "got '2 m' (a length)\n"
            "--set blue.flights.eagle.bingo=3 m:1:26: bingo: expected a mass such as '900 kg', "
            "got '3 m' (a length)")
      << "each that is refused";
  // of a distribution the least and the greatest that are drawn
  const std::string drawn = refused(R"(eyrie: 1
name: fuel
scenario: sweep
factors:
  bingo: {path: blue.flights.eagle.bingo, values: !uniform {low: 1 t, high: 6.2 t}}
design: {kind: latin_hypercube, cells: 40, seed: 3}
measures: {end: {what: end_time}}
)");
  EXPECT_EQ(drawn.substr(0, drawn.find('\'')), "c.yaml:5:3: bingo: the scenario refuses ");
}

TEST(Spec, TriesEachCellBeforeAnythingIsFlown) {
  const Spec spec = parse_spec(R"(eyrie: 1
name: fuel
scenario: merge
factors:
  low: {path: blue.flights.viper.bingo, values: [500 kg, 2000 kg]}
  fuel: {path: blue.flights.viper.fuel, values: [2500 kg, 1000 kg]}
measures: {end: {what: end_time}}
)",
                               "c.yaml");
  const Load load = [](const std::vector<std::string>& sets) {
    return scenario::load({.file = "scenarios/merge.yaml", .sets = sets},
                          scenario::Source::disk("."));
  };
  check(spec, load);
  std::string refused;
  try {
    check_cells(spec, cells_of(spec), load);
  } catch (const ConfigError& error) {
    refused = error.what();
  }
  EXPECT_TRUE(refused.starts_with(
      "c.yaml: the scenario refuses cell 3 (low 2000 kg, fuel 1000 kg)\n--set "))
      << refused;
}

TEST(Spec, OfEachExampleFliesItsScenario) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("examples/campaigns")) {
    const std::string file = entry.path().string(), text = read_text(file);
    const bool is_search = text.find("\noptimize:") != text.npos;
    const Spec spec = is_search ? probe_of(*parse_search(text, file)) : parse_spec(text, file);
    check(spec, [&](const std::vector<std::string>& sets) {
      return scenario::load({.file = "scenarios/" + spec.scenario + ".yaml", .sets = sets},
                            scenario::Source::disk("."));
    });
    ++count;
  }
  EXPECT_GE(count, 4U);
}

struct Mistake {
  std::string from, to, expected;
};
class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, IsSaidWithItsPlaceAndTheNearestName) {
  EXPECT_EQ(mistake(with(GetParam().from, GetParam().to)), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    OfACampaign, Mistakes,
    testing::Values(
        Mistake{"seeds:", "seedz:",
                "c.yaml:11:1: campaign has no parameter 'seedz'; did you mean 'seeds'?"},
        Mistake{"scenario: sweep\n", "", "c.yaml:1:1: campaign needs the parameter 'scenario'"},
        Mistake{"until=60 min", "until", "c.yaml:4:7: set: expected path=value, got 'until'"},
        Mistake{"until=60 min", "seed=7",
                "c.yaml:4:7: set: 'seed' does nothing here: 'seeds' says which are flown"},
        Mistake{"until=60 min", "until=60 min, until=50 min",
                "c.yaml:4:21: set: 'until' is set twice (also at c.yaml:4:7)"},
        Mistake{"until=60 min", "a.0=1, 'a.\"0\"=2'",
                "c.yaml:4:14: set: 'a.0' is set twice (also at c.yaml:4:7)"},
        Mistake{"until=60 min", "blue.flights.eagle.bingo=1 lb",
                "c.yaml:4:7: set: 'blue.flights.eagle.bingo' is set by bingo in each cell, too"},
        Mistake{"[red_lost]", "[time, fault]",
                "c.yaml:14:28: won: what ends with a fault is in no measure; the report and the "
                "table `faults` count it"},
        Mistake{"[red_lost]", "[running]", "c.yaml:14:28: won: no flight ends 'running'"},
        Mistake{"{first: 10}", "{first: 10 s}",
                "c.yaml:11:16: seeds.first: expected a whole number, got '10 s'"},
        Mistake{"seeds: {first: 10}", "seeds:", "c.yaml:11:1: seeds: expected a map, got nothing"},
        Mistake{"seeds:", "design:\nseeds:", "c.yaml:11:1: design: expected a map, got nothing"},
        Mistake{"budget: {time: 2 h}",
                "budget:", "c.yaml:19:1: budget: expected a map, got nothing"},
        // factors
        Mistake{
            "values: [1800 kg, 2200 kg]", "value: [1800 kg, 2200 kg]",
            "c.yaml:6:10: bingo: a factor has 'path' and 'values', or 'levels' alone\nc.yaml:6:43: "
            "bingo: factor has no parameter 'value'; did you mean 'values'?"},
        Mistake{"[1800 kg, 2200 kg]", "1800 kg",
                "c.yaml:6:51: bingo: expected a list of two values or more, got '1800 kg'"},
        Mistake{"[1800 kg, 2200 kg]", "[1800 kg, 1800 kg]",
                "c.yaml:6:61: bingo: '1800 kg' is there twice"},
        Mistake{"[1800 kg, 2200 kg]", "[1800 kg, 1800.0 kg]",
                "c.yaml:6:61: bingo: '1800.0 kg' is there twice, first as '1800 kg'"},
        Mistake{"[1800 kg, 2200 kg]", "[2 t, 2000 kg]",
                "c.yaml:6:57: bingo: '2000 kg' is there twice, first as '2 t'"},
        Mistake{"[1800 kg, 2200 kg]", "!unifrom {low: 1 kg, high: 2 kg}",
                "c.yaml:6:51: there is no tag '!unifrom', only !tree, !choice, !range, !uniform, "
                "!log_uniform, !normal; did you mean '!uniform'?"},
        Mistake{"[1800 kg, 2200 kg]", "!tree {low: 1 kg, high: 2 kg}",
                "c.yaml:6:51: bingo: there is no '!tree', only !choice, !range, !uniform, "
                "!log_uniform, !normal"},
        Mistake{"[1800 kg, 2200 kg]", "!uniform {low: 1 kg, hihg: 2 kg}",
                "c.yaml:6:51: distribution needs the parameter 'high'\n"
                "c.yaml:6:72: distribution has no parameter 'hihg'; did you mean 'high'?"},
        Mistake{"[1800 kg, 2200 kg]", "!range {from: 1 kg, to: 2 lb, count: 3}",
                "c.yaml:6:75: bingo: from and to must be in one unit"},
        Mistake{"[1800 kg, 2200 kg]", "!range {from: 1 kgs, to: 2 kg, count: 3}",
                "c.yaml:6:65: bingo: from: expected a number and its unit such as '2.5 nmi', got "
                "'1 kgs'"},
        Mistake{"[1800 kg, 2200 kg]", "!log_uniform {low: 0 kg, high: 2 kg}",
                "c.yaml:6:70: bingo: low must be more than 0"},
        Mistake{"[1800 kg, 2200 kg]", "!normal {mean: 1 kg, deviation: -1 kg}",
                "c.yaml:6:83: bingo: deviation must be more than 0"},
        Mistake{"veteran: blue.flights.eagle.tree=veteran", "veteran: blue.flights.eagle.tree",
                "c.yaml:9:16: tree: expected path=value, got 'blue.flights.eagle.tree'"},
        Mistake{"same: [blue.flights.eagle.tree=veteran", "same: [blue.flights.eagle.bingo=2 t",
                "c.yaml:7:3: tree: 'blue.flights.eagle.bingo' is set by bingo, too: one would "
                "undo the other"},
        Mistake{"same: [blue.flights.eagle.tree=veteran", "same: ['\"blue\"=[]'",
                "c.yaml:7:3: tree: 'blue.flights.eagle.bingo' is set by bingo, too: one would "
                "undo the other"},
        Mistake{"path: blue.flights.eagle.bingo, values: [1800 kg, 2200 kg]",
                "path: until, values: [1 s, 2 s]}\n  end: {path: '\"until\"', values: [3 s, 4 s]",
                "c.yaml:7:3: end: '\"until\"' is set by bingo, too: one would undo the other"},
        Mistake{"path: blue.flights.eagle.bingo", "path: [a.0.b, a.00.b]",
                "c.yaml:6:3: bingo: 'a.0.b' is set twice"},
        Mistake{"same: [blue.flights.eagle.tree=veteran", "same: [x=1, x=2",
                "c.yaml:10:7: tree: 'x' is set twice"},
        Mistake{"same: [blue.flights.eagle.tree=veteran", "same: [seed=1",
                "c.yaml:7:3: tree: 'seed' does nothing here: 'seeds' says which are flown"},
        Mistake{"path: blue.flights.eagle.bingo", "path: '\"seed\"'",
                "c.yaml:6:3: bingo: 'seed' does nothing here: 'seeds' says which are flown"},
        // designs
        Mistake{"seeds:", "design: sobel\nseeds:",
                "c.yaml:11:9: kind: expected one of full_factorial, one_at_a_time, "
                "latin_hypercube, sobol, random, got 'sobel'; did you mean 'sobol'?"},
        Mistake{"seeds:", "design: sobol\nseeds:", "c.yaml:11:9: design: sobol needs 'cells'"},
        Mistake{"[1800 kg, 2200 kg]", "!uniform {low: 1 kg, high: 2 kg}",
                "c.yaml:6:3: design: full_factorial needs levels: give bingo some, as with !range, "
                "or choose latin_hypercube, sobol or random"},
        Mistake{"[1800 kg, 2200 kg]", "[1800 kg]",
                "c.yaml:6:51: bingo: expected a list of two values or more, got a shorter one"},
        // measures
        Mistake{"what: outcome", "what: outcom",
                "c.yaml:14:15: what: expected one of outcome, end_time, losses, kills, shots, "
                "shots_per_kill, exchange_ratio, time_in_phase, fuel_left, variety, "
                "motion_variety, holds, event, "
                "decision, got "
                "'outcom'; did you mean 'outcome'?"},
        Mistake{"red_lost", "red_last",
                "c.yaml:14:29: is[0]: expected one of running, blue_home, blue_lost, red_lost, "
                "time, stopped, fault, both_lost, got 'red_last'; did you mean 'red_lost'?"},
        Mistake{", who: blue}", ", whom: blue}",
                "c.yaml:15:13: exchange: exchange_ratio needs 'who'\n"
                "c.yaml:15:36: exchange: 'whom' says nothing of exchange_ratio"},
        Mistake{"event: launch", "event: lunch",
                "c.yaml:17:30: near: there is no event 'lunch'; did you mean 'launch'?"},
        Mistake{
            "event: launch, who: blue, if: range < 10 nmi and time > 5 min, take: first",
            "event: lunch, take: frist",
            "c.yaml:17:30: near: there is no event 'lunch'; did you mean 'launch'?\n"
            "c.yaml:17:43: take: expected one of any, count, first, last, sum, least, most, got "
            "'frist'; did you mean 'first'?"},
        Mistake{
            "take: first, value: range", "take: frist, value: rang",
            "c.yaml:17:92: take: expected one of any, count, first, last, sum, least, most, got "
            "'frist'; did you mean 'first'?\n"
            "c.yaml:17:106: near: launch has no value 'rang'; did you mean 'range'?"},
        Mistake{"range < 10 nmi", "rnge < 10 nmi",
                "c.yaml:17:53: launch has no value 'rnge'; did you mean 'range'?"},
        Mistake{"range < 10 nmi", "closure < 10 nmi",
                "c.yaml:17:53: launch has no value 'closure', only range, time, altitude, "
                "speed, mach, fuel, missile_range, enemy_range, whom.altitude, whom.speed, "
                "whom.mach, whom.fuel, whom.missile_range, whom.enemy_range"},
        Mistake{"range < 10 nmi", "5 nmi < 10 nmi", "c.yaml:17:53: neither side is a value"},
        Mistake{"range < 10 nmi", "range < 10 kg",
                "c.yaml:17:61: range: expected a length such as '6000 ft', got '10 kg' (a mass)"},
        Mistake{"value: range", "value: store",
                "c.yaml:17:106: near: launch has no value 'store', only range, time, altitude, "
                "speed, mach, fuel, missile_range, enemy_range, whom.altitude, whom.speed, "
                "whom.mach, whom.fuel, whom.missile_range, whom.enemy_range"},
        Mistake{"value: range", "value: rang",
                "c.yaml:17:106: near: launch has no value 'rang'; did you mean 'range'?"},
        Mistake{"take: any", "take: any, value: vote",
                "c.yaml:18:85: breaks: 'any' takes no value"},
        Mistake{"seeds:", "optimize: {}\nseeds:",
                "c.yaml:11:11: this is a search: eyrie optimize 'c.yaml'"},
        // when it stops
        Mistake{"measure: left", "measure: lfet",
                "c.yaml:12:17: stop: there is no measure 'lfet'; did you mean 'left'?"},
        Mistake{
            "100 lb", "100 ft",
            "c.yaml:12:30: stop: width: expected a mass such as '900 kg', got '100 ft' (a length)"},
        Mistake{"measure: left, width: 100 lb", "measure: won, width: 1",
                "c.yaml:12:29: stop: width: that of a share must be less than 1, got '1'"},
        Mistake{"most: 500", "most: 50", "c.yaml:12:44: stop: most: 50 is less than least, 100"},
        Mistake{"seeds:", "replicates: 5\nseeds:",
                "c.yaml:11:13: 'stop' says how many replicates there are; leave out "
                "'replicates'"},
        Mistake{
            "2 h", "2 nmi",
            "c.yaml:19:16: budget.time: expected a time such as '3 min', got '2 nmi' (a length)"}));

}  // namespace
}  // namespace eyrie::campaign
