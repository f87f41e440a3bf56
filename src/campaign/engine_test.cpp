// SPDX-License-Identifier: MIT
#include "campaign/engine.hpp"

#include <gtest/gtest.h>

#include "campaign/store.hpp"
#include "support/campaign/made_up.hpp"
#include "support/program.hpp"

namespace eyrie::campaign {
namespace {

const char* const kStop = "stop: {measure: won, width: 0.25, least: 10, every: 7, most: 90}";

struct Flight {
  const Spec& spec;
  std::shared_ptr<const test::TempFolder> folder = std::make_shared<test::TempFolder>();
  std::vector<Cell> cells = cells_of(spec);
  std::uint64_t flown = 0;

  [[nodiscard]] Store store() const {
    return {*folder / "out", spec, cells, {{kCampaignText, spec.text}}, true};
  }
  /// One process, which is interrupted after `left` results.
  Ended session(std::uint64_t left = ~std::uint64_t{0}, std::uint64_t other = 0) {
    Store kept = store();
    test::MadeUpCrew crew(spec);
    crew.left = left;
    crew.other = other;
    const Ended ended = run(spec, cells, kept, crew, [](const Standing&) {});
    flown += crew.flown;
    return ended;
  }
  [[nodiscard]] std::vector<std::uint64_t> counts() const { return store().counts(); }
  [[nodiscard]] std::uint64_t hash() const { return store().hash(); }
};

TEST(Engine, FliesEveryReplicateOfEveryCellOnce) {
  const Spec spec = test::made_up_spec();
  Flight flight{spec};
  EXPECT_EQ(flight.session(), Ended::complete);
  EXPECT_EQ(flight.flown, 120U);
  EXPECT_EQ(flight.counts(), (std::vector<std::uint64_t>{40, 40, 40}));
  EXPECT_EQ(flight.session(), Ended::complete);
  EXPECT_EQ(flight.flown, 120U) << "nothing is left to fly";
}

TEST(Engine, StopsEachCellAtTheFirstLookAtWhichItsIntervalIsNarrow) {
  const Spec spec = test::made_up_spec(kStop);
  Flight flight{spec};
  EXPECT_EQ(flight.session(), Ended::complete);
  const auto counts = flight.counts();
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    Estimator estimator(spec.measures.estimates[3]);
    std::uint64_t n = 0;
    const auto width = [&] { return estimator.estimate().interval->width(); };
    do
      estimator.add(test::made_up(spec, cell, n++).values);
    while (n < 90 && (n < 10 || (n - 10) % 7 != 0 || width() > 0.25));
    EXPECT_EQ(counts[cell], n);
    EXPECT_LT(n, 90U);
  }
}

TEST(Engine, GoesOnToMoreReplicatesAsIfItHadBeenBegunWithThem) {
  const std::string stop = "stop: {measure: won, width: 0.25, least: 10, every: 7, most: ";
  for (const auto& [before, now] : std::vector<std::pair<std::string, std::string>>{
           {"replicates: 9", "replicates: 40"},
           {"replicates: 9", "replicates: 40  # the interval was too wide"},
           {"budget: {replicates: 150}", "replicates: 120"},
           {"budget: {replicates: 150}", "budget: {replicates: 200}"},
           {stop + "20}", stop + "90}"},
           {stop + "90}\nbudget: {replicates: 40, time: 1 h}",
            stop + "90}\nbudget: {time: 2 h}"}}) {
    const Spec less = test::made_up_spec(before), more = test::made_up_spec(now);
    Flight whole{more}, first{less};
    whole.session();
    first.session();
    EXPECT_LT(first.flown, whole.flown) << before;
    Flight second{more, first.folder};
    second.session();
    EXPECT_EQ(first.flown + second.flown, whole.flown + 1) << "the first is flown again: " << now;
    EXPECT_EQ(second.hash(), whole.hash()) << now;
    EXPECT_THROW(first.session(), disk::Refused) << "it would have less now";
  }
}

TEST(Engine, RefusesMoreReplicatesThatWouldNotHaveBeenFlownFirst) {
  const auto refused = [](const std::string& before, const std::string& now) {
    const Spec less = test::made_up_spec(before), more = test::made_up_spec(now);
    Flight first{less};
    first.session();
    try {
      Flight{more, first.folder}.session();
    } catch (const disk::Refused& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(
      refused("replicates: 9", "replicates: 8").find("was 'replicates: 9', is 'replicates: 8'"),
      std::string::npos);
  EXPECT_NE(
      refused("seeds: {paired: false}\nreplicates: 9", "seeds: {paired: false}\nreplicates: 40")
          .find("seeds that are not paired"),
      std::string::npos);
  EXPECT_NE(refused("replicates: 9\nbudget: {replicates: 20}",
                    "replicates: 40\nbudget: {replicates: 100}")
                .find("the budget would have been spent"),
            std::string::npos);
  EXPECT_NE(refused("replicates: 9", "replicates: 40\nseeds: {first: 2}"), "");
  EXPECT_NE(refused("replicates: 9", "replicates: 40\nset: [until=5 min]"), "");
  EXPECT_NE(refused("budget: {time: 2 h}", "budget: {time: 1 h}"), "");
}

TEST(Engine, FliesPartsOfWhichEachHasAboutAsManyAndAllAreTheWhole) {
  const Spec whole = test::made_up_spec("replicates: 100");
  Flight undisturbed{whole};
  undisturbed.session();
  for (const std::uint64_t of : {2U, 16U, 99U, 400U}) {
    const test::TempFolder folder;
    std::vector<std::uint64_t> flown;
    for (std::uint64_t i = 0; i < of; ++i) {
      Spec spec = whole;
      spec.part = {i, of};
      Store store(part_folder(folder / "out", spec.part), spec, undisturbed.cells, {}, false);
      for (const std::uint64_t left : {std::uint64_t{2}, ~std::uint64_t{0}}) {
        test::MadeUpCrew crew(spec);
        crew.left = left;
        run(spec, undisturbed.cells, store, crew, [](const Standing&) {});
      }
      flown.push_back(0);
      for (const std::uint64_t count : store.counts())
        flown.back() += count;
    }
    const auto [least, most] = std::minmax_element(flown.begin(), flown.end());
    EXPECT_LE(*most - *least, 2U) << of;
    const auto parts = whole_parts(folder / "out", whole, undisturbed.cells.size(), {});
    Store joined(folder / "out", whole, undisturbed.cells, {}, true);
    joined.join(parts);
    EXPECT_EQ(joined.counts(), undisturbed.counts());
    EXPECT_EQ(joined.hash(), undisturbed.hash()) << of;
  }
}

TEST(Engine, InterruptedAnywhereAndResumedGivesTheSameResults) {
  for (const char* more : {"replicates: 9", kStop, "replicates: 40\nbudget: {replicates: 50}"}) {
    const Spec spec = test::made_up_spec(more);
    Flight undisturbed{spec};
    const Ended ended = undisturbed.session();
    for (std::uint64_t left = 0; left < undisturbed.flown; left += 11) {
      Flight flight{spec};
      EXPECT_EQ(flight.session(left), Ended::stopped);
      EXPECT_EQ(flight.session(left / 2 + 1),
                left + left / 2 < undisturbed.flown ? Ended::stopped : ended);
      EXPECT_EQ(flight.session(), ended);
      EXPECT_EQ(flight.counts(), undisturbed.counts()) << more << " after " << left;
      EXPECT_EQ(flight.hash(), undisturbed.hash()) << more << " after " << left;
    }
  }
}

TEST(Engine, RefusesToGoOnWithAnotherProgram) {
  const Spec spec = test::made_up_spec();
  Flight flight{spec};
  EXPECT_EQ(flight.session(5), Ended::stopped);
  EXPECT_THROW(flight.session(100, 1), disk::Refused);
  EXPECT_EQ(flight.counts()[0], 5U);
}

/// Real flights of two cells: each scenario is loaded while others fly.
TEST(ThreadsInOrder, GiveWhatOneGives) {
  const Spec spec = parse_spec(R"(eyrie: 1
name: threads
scenario: merge
set: [until=5 s]
factors:
  speed: {path: blue.flights.viper.start.speed, values: [400 kt, 450 kt]}
measures:
  end: {what: end_time}
  shots: {what: shots}
)",
                               "threads.yaml");
  const std::vector<Cell> cells = cells_of(spec);
  const Load load = [](const std::vector<std::string>& sets) {
    return scenario::load({"scenarios/merge.yaml", sets}, scenario::Source::disk("."));
  };
  constexpr std::array kBatches{Batch{0, 0, 5}, Batch{1, 2, 4}, Batch{0, 5, 3}};
  std::vector<std::vector<Result>> all;
  for (const unsigned workers : {1U, 4U}) {
    std::vector<Result>& results = all.emplace_back();
    Threads(spec, cells, load, workers).fly(kBatches, [&](Result&& result) {
      results.push_back(std::move(result));
      return true;
    });
  }
  ASSERT_EQ(all[0].size(), 12U);
  ASSERT_EQ(all[1].size(), 12U);
  for (std::size_t i = 0; i < 12; ++i) {
    const Result &one = all[0][i], &four = all[1][i];
    EXPECT_EQ(one.cell, i >= 5 && i < 9 ? 1U : 0U);
    EXPECT_EQ(one.replicate, i < 5 ? i : i < 9 ? i - 3 : i - 4);
    EXPECT_EQ(one.flown.seed, one.replicate + 1);
    EXPECT_EQ(four.cell, one.cell);
    EXPECT_EQ(four.replicate, one.replicate);
    EXPECT_EQ(four.flown.hash, one.flown.hash);
    EXPECT_EQ(four.values, one.values);
  }
  EXPECT_NE(all[0][2].flown.hash, all[0][5].flown.hash) << "the same seed in another cell";
}

/// Whose "end" is 0 in every replicate.
struct ZeroCrew final : Crew {
  test::MadeUpCrew crew;
  explicit ZeroCrew(const Spec& spec) : crew(spec) {}
  void fly(std::span<const Batch> batches, const Take& take) override {
    crew.fly(batches, [&](Result&& result) {
      if (!result.values.empty())
        result.values[0] = 0;
      return take(std::move(result));
    });
  }
};

TEST(Engine, DoesNotStopWhileAllValuesAreTheSame) {
  const Spec spec =
      test::made_up_spec("stop: {measure: end, width: 1 s, least: 5, every: 5, most: 60}");
  const Flight flight{spec};
  Store store = flight.store();
  ZeroCrew crew(spec);
  EXPECT_EQ(run(spec, flight.cells, store, crew, [](const Standing&) {}), Ended::complete);
  EXPECT_EQ(store.counts(), (std::vector<std::uint64_t>{60, 60, 60}));
}

TEST(Engine, IsCompleteWithABudgetForAllAndTellsOfEachReplicateOnce) {
  for (const auto& [budget, end] : {std::pair{120U, Ended::complete}, {50U, Ended::budget}}) {
    const Spec spec =
        test::made_up_spec(fmt::format("replicates: 40\nbudget: {{replicates: {}}}", budget));
    const Flight flight{spec};
    Store store = flight.store();
    test::MadeUpCrew crew(spec);
    std::vector<std::uint64_t> told(3);
    EXPECT_EQ(run(spec, flight.cells, store, crew,
                  [&](const Standing& standing) {
                    EXPECT_EQ(standing.last->replicate, told[standing.last->cell]++);
                  }),
              end);
    EXPECT_EQ(told, store.counts()) << budget;
  }
}

TEST(FlyReplicate, OfACellThatTheScenarioRefusesIsAFault) {
  const Spec spec = test::made_up_spec();
  const std::vector<Cell> cells = cells_of(spec);
  Scenarios scenarios(
      spec, cells,
      [](const std::vector<std::string>&) -> std::shared_ptr<const scenario::Scenario> {
        throw ConfigError({"none.yaml", 1, 2}, "no fuel");
      },
      1);
  const Result result = fly_replicate(spec, scenarios, 1, 4);
  EXPECT_EQ(result.flown.outcome, scenario::Outcome::fault);
  EXPECT_EQ(result.flown.fault, "none.yaml:1:2: no fuel");
  EXPECT_EQ(result.flown.seed, 5U);
  EXPECT_TRUE(result.values.empty());
}

}  // namespace
}  // namespace eyrie::campaign
