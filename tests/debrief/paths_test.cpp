// SPDX-License-Identifier: MIT
/// \file  Paths of players stay bounded however long the run is.
#include "record/paths.hpp"

#include <gtest/gtest.h>

#include "support/recorded.hpp"

namespace eyrie::record {
namespace {

TEST(Paths, KeepLessOftenWhatIsLong) {
  const debrief::Recorded recorded = test::recorded_flight("merge", 60);
  const auto points = [&](std::size_t most) {
    Paths paths(*recorded.scenario, most);
    debrief::Reflight flight(recorded);
    flight.attach(paths);
    while (flight.step()) {
    }
    paths.finish(flight.after());
    return paths.all().at(1).points;
  };
  const auto whole = points(Paths::kMost), few = points(16);
  ASSERT_EQ(whole.size(), 61U);
  EXPECT_LE(few.size(), 17U);
  EXPECT_GE(few.size(), 8U);
  EXPECT_EQ(few.front().time, 0);
  EXPECT_NEAR(few.back().time, 60, 1e-9);
  for (std::size_t i = 1; i + 1 < few.size(); ++i) {
    EXPECT_NEAR(few[i].time - few[i - 1].time, 4, 1e-9);
    EXPECT_EQ(few[i].place.latitude,
              whole[static_cast<std::size_t>(few[i].time + 0.5)].place.latitude);
  }
}

TEST(Paths, HaveNoNegativeZeros) {
  const debrief::Recorded recorded = test::recorded_flight("convoy", 30);
  Paths paths(*recorded.scenario);
  debrief::Reflight flight(recorded);
  flight.attach(paths);
  while (flight.step()) {
  }
  paths.finish(flight.after());
  EXPECT_EQ(geojson(paths).find("-0.0]"), std::string::npos);
}

}  // namespace
}  // namespace eyrie::record
