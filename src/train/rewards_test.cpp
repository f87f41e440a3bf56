// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "model/events.hpp"
#include "train/trainer_test.hpp"

namespace eyrie::train {
namespace {

TEST(Reward, IsPaidForEachRoundWhenItIsFired) {
  TaskSpec spec = task("merge");
  spec.rewards = {{Term::rounds, 1}};
  spec.controls = "trigger\n";
  Trainer t(std::move(spec), {.envs = 1});
  const sim::World& world = t.env.world(0);
  const auto gun = t.env.scenario().aircraft.gun;
  const auto before = world.rows(gun)[0].rounds;
  float sum = 0;
  for (int decision = 0; decision < 30; ++decision) {
    t.act();
    t.actions = {decision % 3 == 0 ? 1.0F : -1.0F};
    t.env.step(t.actions);
    sum += t.rewards[0];
    ASSERT_FALSE(t.over[0]);
    ASSERT_EQ(sum, static_cast<float>(before - world.rows(gun)[0].rounds)) << decision;
  }
  EXPECT_GT(sum, 50);
}

TEST(Reward, CountsHitsOfEnemiesOnly) {
  const Trainer t(task("sweep"), {.envs = 1});
  const scenario::Roster& roster = t.env.scenario().roster;
  const PlayerId who = roster.find("eagle1").value();
  Merit merit;
  for (const std::string_view whom : {"eagle2", "bogey1"})
    note({.kind = model::EventKind::hit, .who = who, .whom = roster.find(whom).value()}, who,
         roster, merit);
  EXPECT_EQ(merit.hits, 1U);
}

TEST(Reward, OfARangeOfOnePointIsNothingBeyondIt) {
  TaskSpec spec = task("merge");
  spec.rewards = {{Term::nose_on, 1, 1000, 1000}};
  Trainer t(std::move(spec), {.envs = 1});
  t.step();
  EXPECT_EQ(t.rewards[0], 0) << "he is miles away";
}

}  // namespace
}  // namespace eyrie::train
