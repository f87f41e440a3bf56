// SPDX-License-Identifier: MIT
#include "campaign/replicate.hpp"

#include <gtest/gtest.h>

#include "campaign/in_order.hpp"

namespace eyrie::campaign {
namespace {

std::shared_ptr<const scenario::Scenario> merge() {
  static const auto scenario =
      scenario::load({"scenarios/merge.yaml", {}}, scenario::Source::disk("."));
  return scenario;
}

struct Steps final : sim::Observer {
  void observe(const sim::World&, const sim::StepInfo&, std::span<const sim::Event>) override {
    ++seen;
  }
  std::uint64_t seen = 0;
};

TEST(Replicate, IsTheMissionOfItsSeed) {
  scenario::Mission mission(merge(), 7);
  mission.fly();
  Steps steps;
  const Flown flown = fly(merge(), 7, &steps);
  EXPECT_EQ(flown.seed, 7U);
  EXPECT_EQ(flown.hash, mission.run().world().hash());
  EXPECT_EQ(flown.outcome, mission.outcome());
  EXPECT_EQ(flown.time, mission.run().time());
  EXPECT_EQ(flown.steps, steps.seen);
  EXPECT_EQ(flown.fault, "");
}

TEST(Replicate, EndsWhereItIsTold) {
  const Flown flown = fly(merge(), 7, {}, 2.0);
  EXPECT_EQ(flown.outcome, scenario::Outcome::time);
  EXPECT_EQ(flown.steps, 100U);
  EXPECT_EQ(fly(merge(), 7, {}, {}, [] { return true; }).outcome, scenario::Outcome::stopped);
}

TEST(Replicate, IsTheSameBesideOthers) {
  const auto hashes = [](unsigned workers) {
    std::vector<std::uint64_t> all;
    in_order<Flown>(
        6, workers, [](std::uint64_t i) { return fly(merge(), i + 1); },
        [&](std::uint64_t i, Flown&& flown) {
          EXPECT_EQ(flown.seed, i + 1);
          all.push_back(flown.hash);
          return true;
        });
    return all;
  };
  const auto alone = hashes(1);
  EXPECT_EQ(hashes(4), alone);
  EXPECT_NE(alone[0], alone[1]);
}

}  // namespace
}  // namespace eyrie::campaign
