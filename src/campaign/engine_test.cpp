// SPDX-License-Identifier: MIT
#include "campaign/engine.hpp"

#include <gtest/gtest.h>

#include "support/campaign/made_up.hpp"
#include "support/program.hpp"

namespace eyrie::campaign {
namespace {

const char* const kStop = "stop: {measure: won, width: 0.25, least: 10, every: 7, most: 90}";

struct Flight {
  const Spec& spec;
  test::TempFolder folder{};
  std::vector<Cell> cells = cells_of(spec);
  std::uint64_t flown = 0;

  /// One process, which is interrupted after `left` results.
  Ended session(std::uint64_t left = ~std::uint64_t{0}, std::uint64_t other = 0) {
    Store store(folder / "out", spec, cells, {}, true);
    test::MadeUpCrew crew(spec);
    crew.left = left;
    crew.other = other;
    const Ended ended = run(spec, cells, store, crew, [](const Standing&) {});
    flown += crew.flown;
    return ended;
  }
  [[nodiscard]] std::vector<std::uint64_t> counts() const {
    return Store(folder / "out", spec, cells, {}, true).counts();
  }
  [[nodiscard]] std::uint64_t hash() const {
    return Store(folder / "out", spec, cells, {}, true).hash();
  }
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

}  // namespace
}  // namespace eyrie::campaign
