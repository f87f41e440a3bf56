// SPDX-License-Identifier: MIT
#include "campaign/search.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <sstream>

#include "campaign/store.hpp"
#include "support/program.hpp"

namespace eyrie::campaign {
namespace {

const std::string kSearch = R"(eyrie: 1
name: duel
scenario: duel_defense
factors:
  start: {path: blue.flights.eagle.start.east, values: !uniform {low: -20 nmi, high: -2 nmi}}
  until: {path: until, values: !range {from: 40 s, to: 80 s, count: 3}}
replicates: 3
optimize: {measure: shot, goal: minimize, generations: 4, population: 4, proof: 6}
measures:
  shot: {what: event, event: launch, who: blue, take: first, value: range}
  exchange: {what: exchange_ratio, who: blue}
)";

std::string search_with(std::string_view from, std::string_view to) {
  std::string text = kSearch;
  return text.replace(text.find(from), from.size(), to);
}
std::string search_mistake(const std::string& text) {
  try {
    static_cast<void>(parse_search(text, "s.yaml"));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}
std::shared_ptr<const scenario::Scenario> duel(const std::vector<std::string>& sets) {
  return scenario::load({.file = "scenarios/duel_defense.yaml", .sets = sets},
                        scenario::Source::disk("."));
}

TEST(Search, SaysWhatItsFileSays) {
  const auto search = parse_search(kSearch, "s.yaml");
  EXPECT_EQ(search->best->name, "shot");
  EXPECT_EQ(search->seed_of_generation(4), 13U);
  EXPECT_EQ(cell_at(*search, std::vector{0.5, 0.99}).values,
            (std::vector<std::string>{"-11 nmi", "80 s"}));
  EXPECT_EQ(cell_at(*search, std::vector{1.5, -0.99}), cell_at(*search, std::vector{0.5, 0.99}))
      << "reflected";
  EXPECT_EQ(search_mistake(search_with("measure: shot", "measure: shoot")),
            "s.yaml:8:21: optimize: there is no measure 'shoot'; did you mean 'shot'?");
  EXPECT_EQ(search_mistake(search_with("population: 4", "population: 2")),
            "s.yaml:8:71: population: 2 is outside [4, 10000]");
  EXPECT_EQ(search_mistake(search_with("goal: minimize, ", "")),
            "s.yaml:8:11: optimize needs the parameter 'goal'");
  EXPECT_EQ(search_mistake(search_with("replicates", "stop: {}\nreplicates")),
            "s.yaml:7:1: campaign has no parameter 'stop', only eyrie, name, help, scenario, set, "
            "plugins, "
            "seeds, replicates, budget, factors, measures, optimize");
  EXPECT_EQ(search_mistake(search_with("optimize: ", "#")),
            "s.yaml:1:1: a search needs 'optimize'");
  EXPECT_EQ(search_mistake(search_with("replicates", "budget: {time: 1 h}\nreplicates")),
            "s.yaml:7:9: budget: of a search 'generations' says how long it takes");
  EXPECT_EQ(search_mistake(search_with("replicates", "seeds: {paired: false}\nreplicates")),
            "s.yaml:7:8: seeds: those of a search are always paired");
}

/// Means of the first measure over some seeds.
double mean_over(const Search& search, const Cell& cell, std::uint64_t first, std::uint64_t n) {
  const auto scenario = duel(sets_of(search.spec, cell));
  stats::Moments shot;
  for (std::uint64_t seed = first; seed < first + n; ++seed) {
    const auto watching = watch(search.spec.measures, *scenario);
    const Flown flown = fly(scenario, seed, watching.get());
    if (const double v = watching->values(flown.outcome, flown.time)[0]; !std::isnan(v))
      shot.add(v);
  }
  return shot.mean();
}

TEST(Search, FliesOtherSeedsInEveryGenerationAndInTheProof) {
  const auto search = parse_search(kSearch, "s.yaml");
  SearchLog log(*search, "here", "", "log");
  const auto found = optimize(*search, duel, log,
                              {.workers = 2, .tell = [&](const Generation& g, const SearchLog&) {
                                 for (std::size_t c = 0; g.number == 1 && c < 2; ++c) {
                                   EXPECT_NEAR(g.scores[c].value_or(0),
                                               mean_over(*search, g.cells[c], 4, 3), 1e-6);
                                 }
                               }});
  ASSERT_TRUE(found);
  const auto evidence = prove(*search, found->cell, duel, {.workers = 2});
  ASSERT_TRUE(evidence);
  EXPECT_NEAR(*evidence->front().after.value, mean_over(*search, found->cell, 13, 6), 1e-6);
}

TEST(Search, GoesOnAsIfItHadNotBeenInterrupted) {
  const auto search = parse_search(kSearch, "s.yaml");
  int told = 0;
  SearchRun run{.workers = 2, .tell = [&](const Generation&, const SearchLog&) { ++told; }};
  SearchLog whole(*search, "here", "", "log");
  const auto found = optimize(*search, duel, whole, run);
  ASSERT_TRUE(found);
  EXPECT_EQ(told, 4);

  // given up in the third generation
  static std::atomic<bool> stop;
  stop = false;
  std::string kept;
  run.given_up = [] { return stop.load(); };
  run.tell = [&](const Generation& g, const SearchLog& log) {
    kept = log.text();
    stop = g.number == 1;
  };
  SearchLog part(*search, "here", "", "log");
  EXPECT_FALSE(optimize(*search, duel, part, run));
  EXPECT_TRUE(whole.text().starts_with(kept));

  stop = false;
  told = 0;
  run.workers = 1;
  run.tell = [&](const Generation&, const SearchLog&) { ++told; };
  SearchLog rest(*search, "here", kept, "log");
  EXPECT_EQ(optimize(*search, duel, rest, run), found);
  EXPECT_EQ(told, 2) << "two were known";
  EXPECT_EQ(rest.text(), whole.text());

  EXPECT_THROW(SearchLog(*search, "there", kept, "log"), ConfigError);
  kept[kept.size() - 4] ^= 1;
  SearchLog changed(*search, "here", kept, "log");
  EXPECT_THROW((void)optimize(*search, duel, changed, run), ConfigError);
}

TEST(Search, BelievesNoScoreThatNoFlightsHave) {
  const Cell cell{{"-5 nmi", "80 s"}};
  const auto knows = [&](const std::string& measure, const std::string& score) {
    std::string text = search_with("measure: shot", "measure: " + measure);
    text += "  won: {what: outcome, is: [time]}\n";
    const auto search = parse_search(text, "s.yaml");
    const std::string head = SearchLog(*search, "here", "", "log").text();
    SearchLog log(*search, "here", head + "0,0," + score + ",\"-5 nmi\",\"80 s\"\n", "log");
    try {
      return log.next(0, 0, cell).known;
    } catch (const ConfigError& error) {
      EXPECT_STREQ(error.what(),
                   "log:3:1: is not what this search has drawn there: the file was changed");
      return false;
    }
  };
  EXPECT_TRUE(knows("won", "0.5"));
  EXPECT_TRUE(knows("won", "none"));
  EXPECT_TRUE(knows("shot", "-0.5"));
  for (const char* score : {"-0.5", "1.5", "inf", "nan"})
    EXPECT_FALSE(knows("won", score)) << score;
  EXPECT_FALSE(knows("shot", "inf"));
}

TEST(Search, ComparesOnFreshSeedsWhatItFound) {
  const auto search = parse_search(kSearch, "s.yaml");
  const auto evidence = prove(*search, {{"-5 nmi", "80 s"}}, duel, {.workers = 2});
  ASSERT_TRUE(evidence);
  ASSERT_EQ(evidence->size(), 2U);
  const Evidence& shot = evidence->front();
  ASSERT_TRUE(shot.before.value && shot.after.value && shot.difference);
  EXPECT_EQ(shot.after.n, shot.difference->n);
  EXPECT_NEAR(shot.difference->value, *shot.after.value - *shot.before.value, 1e-6);
  EXPECT_LT(shot.difference->value, -100) << "from nearer";
}

TEST(Search, ProvesAsTheReportOfACampaignDoes) {
  const std::string sets = "set: [until=120 s, blue.flights.eagle.start.east=-12 nmi]\n";
  std::string text = search_with("replicates: 3", sets + "replicates: 3");
  const std::string_view ratio = "exchange: {what: exchange_ratio, who: blue}";
  text.replace(text.find(ratio), ratio.size(), "left: {what: fuel_left, who: blue}");
  const auto search = parse_search(text, "s.yaml");
  Search more = *search;
  more.proof = 40;
  const auto evidence = prove(more, {{"-5 nmi", "120 s"}}, duel, {.workers = 2});
  ASSERT_TRUE(evidence);
  const Spec spec = parse_spec(R"(eyrie: 1
name: duel
scenario: duel_defense
set: [blue.flights.eagle.start.east=-12 nmi]
factors:
  search:
    levels:
      before: until=120 s
      after: [blue.flights.eagle.start.east=-5 nmi, until=120 s]
seeds: {first: 13}
replicates: 40
measures:
  shot: {what: event, event: launch, who: blue, take: first, value: range}
  left: {what: fuel_left, who: blue}
)",
                               "c.yaml");
  const test::TempFolder folder;
  const std::vector<Cell> cells = cells_of(spec);
  Store store(folder / "out", spec, cells, {}, false);
  Threads crew(spec, cells, duel, 2);
  EXPECT_EQ(run(spec, cells, store, crew, [](const Standing&) {}), Ended::complete);
  EXPECT_EQ(command_of(spec, cells[0]),
            "eyrie fly duel_defense --set 'blue.flights.eagle.start.east=-12 nmi' "
            "--set 'until=120 s'");
  const auto comparisons = compare(folder / "out", read_summary(folder / "out"));
  ASSERT_EQ(comparisons.size(), 2U);
  for (const Comparison& c : comparisons) {
    const auto& proof = (*evidence)[c.measure].difference;
    ASSERT_TRUE(proof && proof->interval && c.interval);
    EXPECT_EQ(proof->n, c.n);
    EXPECT_EQ(proof->value, c.value);
    EXPECT_EQ(proof->p, c.p);
    EXPECT_EQ(proof->interval->low, c.interval->low);
    EXPECT_EQ(proof->interval->high, c.interval->high);
  }
}

TEST(Search, ProvesNothingOfARatioThatHasNoValue) {
  const auto search =
      parse_search(search_with("replicates: 3", "set: [until=5 s]\nreplicates: 3"), "s.yaml");
  const auto evidence = prove(*search, {{"-5 nmi", "80 s"}}, duel, {.workers = 2});
  ASSERT_TRUE(evidence);
  const Evidence& exchange = evidence->back();
  EXPECT_FALSE(exchange.before.value) << "nobody was lost";
  EXPECT_FALSE(exchange.difference);
}

TEST(Search, CountsWhatTheScenarioRefusesAsWorst) {
  const auto search = parse_search(
      search_with("!range {from: 40 s, to: 80 s, count: 3}", "[80 s, no time]"), "s.yaml");
  SearchLog log(*search, "here", "", "log");
  int refused = 0, flown = 0;
  const auto found = optimize(
      *search, duel, log, {.workers = 2, .tell = [&](const Generation& g, const SearchLog&) {
                             for (std::size_t c = 0; c < g.cells.size(); ++c) {
                               EXPECT_EQ(g.scores[c].has_value(), g.cells[c].values[1] == "80 s");
                               ++(g.scores[c] ? flown : refused);
                             }
                           }});
  ASSERT_TRUE(found);
  EXPECT_GT(refused, 0);
  EXPECT_GT(flown, refused) << "the search leaves them";
}

TEST(Search, FindsNothingByAMeasureThatNoFlightHas) {
  const auto search =
      parse_search(search_with("take: first", "if: time < 1 ms, take: first"), "s.yaml");
  SearchLog log(*search, "here", "", "log");
  int generations = 0;
  const SearchRun run{.workers = 2,
                      .tell = [&](const Generation&, const SearchLog&) { ++generations; }};
  try {
    static_cast<void>(optimize(*search, duel, log, run));
    ADD_FAILURE();
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "s.yaml:10:9: no flight of any candidate gives 'shot' a value: none is better "
                 "than another");
  }
  EXPECT_EQ(generations, 4);
}

TEST(Search, TakesTheBestOfTheLastGenerationIfTheMiddleIsRefused) {
  const auto search = parse_search(kSearch, "s.yaml");
  std::vector<Generation> seen;
  const SearchRun run{.workers = 2,
                      .tell = [&](const Generation& g, const SearchLog&) { seen.push_back(g); }};
  SearchLog log(*search, "here", "", "log");
  const auto middle = optimize(*search, duel, log, run);
  ASSERT_TRUE(middle);
  EXPECT_FALSE(middle->generation);
  ASSERT_EQ(seen.size(), 4U);

  const Load none =
      [](const std::vector<std::string>&) -> std::shared_ptr<const scenario::Scenario> {
    throw ConfigError({"s.yaml", 1, 1}, "not this one");
  };
  /// From a log in which generations from that one on have no score.
  const auto found = [&](char from) {
    std::string text;
    std::istringstream lines(log.text());
    for (std::string line; std::getline(lines, line); text += line + '\n')
      if (line[0] >= from && line[0] <= '9') {
        const auto score = line.find(',', 2) + 1;
        line.replace(score, line.find(',', score) - score, "none");
      }
    SearchLog again(*search, "here", text, "log");
    return optimize(*search, none, again, run);
  };
  for (const std::size_t generation : {3U, 2U}) {
    const auto best = found(static_cast<char>('1' + generation));
    ASSERT_TRUE(best);
    EXPECT_EQ(best->generation, generation);
    EXPECT_EQ(best->cell, seen[generation].cells[seen[generation].best]);
    EXPECT_NE(best->refusal.find("not this one"), std::string::npos);
  }
  EXPECT_EQ(seen.size(), 4U) << "nothing was flown again";
  SearchLog empty(*search, "here", "", "log");
  EXPECT_THROW(static_cast<void>(optimize(*search, none, empty, run)), ConfigError);
}

}  // namespace
}  // namespace eyrie::campaign
