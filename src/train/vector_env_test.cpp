// SPDX-License-Identifier: MIT
#include "train/vector_env.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/diagnostics.hpp"
#include "debrief/recorded.hpp"
#include "sim/run.hpp"
#include "support/no_allocation.hpp"
#include "train/trainer_test.hpp"

namespace eyrie::train {
namespace {

std::string words(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::exception& e) {
    return e.what();
  }
  return "nothing was thrown";
}

/// A task whose episodes last no longer than so many seconds.
TaskSpec brief(std::string_view name, int seconds) {
  TaskSpec spec = task(name);
  spec.sets.push_back("until=" + std::to_string(seconds) + " s");
  return spec;
}

class EveryTask : public testing::TestWithParam<std::string> {};

TEST_P(EveryTask, IsObservedWithinItsRangesAndItsEpisodesFollowOneAnother) {
  Trainer t(brief(GetParam(), 20), {.envs = 3});
  const Shape& s = t.env.shape();
  EXPECT_EQ(s.agents, task(GetParam()).learners.size());
  int over = 0;
  float most = 0;
  for (int i = 0; i < 450; ++i) {
    t.step();
    for (const float x : t.observations)
      ASSERT_LE(std::fabs(x), 1.0F);
    for (const float x : t.observations)
      most = std::max(most, std::fabs(x));
    for (const float r : t.rewards)
      ASSERT_TRUE(std::isfinite(r));
    for (std::size_t env = 0; env < s.envs; ++env)
      if (t.over[env]) {
        ++over;
        for (std::size_t agent = 0; agent < s.agents; ++agent)
          EXPECT_TRUE(t.alive[env * s.agents + agent]) << "the next one has begun";
        EXPECT_LT(t.env.world(env).step(), 10U) << "it is the learner's turn";
        EXPECT_GE(t.env.world(env).step(), 5U);
      }
  }
  EXPECT_GE(over, 6);
  EXPECT_GT(most, 0);
}
INSTANTIATE_TEST_SUITE_P(VectorEnv, EveryTask, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const TaskSpec& one : tasks())
                             names.push_back(one.name);
                           return names;
                         }()),
                         [](const auto& one) { return one.param; });

/// In a world that has made no step an aircraft can pull nothing, and nobody of a flight is alive.
TEST(VectorEnv, BeginsWithWhatAPilotPerceives) {
  const auto first = [](const char* task, std::string_view field) {
    Trainer t(brief(task, 15), {.envs = 2, .seed = 3});
    const auto features = t.env.observation().items();
    const auto found = std::ranges::find_if(
        features, [&](const pilot::Feature& one) { return one.info().name == field; });
    EXPECT_NE(found, features.end());
    return t.observations[static_cast<std::size_t>(found - features.begin())];
  };
  EXPECT_GT(first("merge", "available"), -0.5F);
  EXPECT_GT(first("sweep", "alive"), 0.5F);
}

/// Also the controls start from what is observed, before the first reset too.
TEST(VectorEnv, IsAsNewAfterAReset) {
  VectorEnv env(brief("merge", 15), scenario::Source::disk("."), {.envs = 2, .seed = 3});
  const auto results = env.results();
  const std::vector<float> actions(results->masks.size(), 0.25F), shown = results->observations;
  env.step(actions);
  const std::vector<float> stepped = results->observations;
  env.reset(3);
  EXPECT_EQ(results->observations, shown);
  env.step(actions);
  EXPECT_EQ(results->observations, stepped);
}

TEST(VectorEnv, GivesTheSameBitsForAnyNumberOfWorkers) {
  std::vector<std::vector<float>> first;
  for (const unsigned workers : {1U, 2U, 5U}) {
    Trainer t(brief("sweep", 15), {.envs = 7, .workers = workers, .seed = 4});
    for (int i = 0; i < 200; ++i) {
      t.step();
      if (workers == 1)
        first.push_back(t.seen());
      else
        ASSERT_EQ(t.seen(), first[static_cast<std::size_t>(i)]) << workers << " workers, " << i;
    }
  }
}

TEST(VectorEnv, GoesOnFromWhatWasSavedAsItDidBefore) {
  Trainer t(brief("merge", 12), {.envs = 3});
  for (int i = 0; i < 70; ++i)
    t.step();
  const auto saved = t.env.save();
  const auto decisions = t.decisions;
  std::vector<std::vector<float>> before;
  for (int i = 0; i < 130; ++i) {
    t.step();
    before.push_back(t.seen());
  }
  Trainer other(brief("merge", 12), {.envs = 3, .workers = 2, .seed = 99});
  for (Trainer* again : {&t, &other}) {
    again->env.restore(*saved);
    again->decisions = decisions;
    for (const auto& seen : before) {
      again->step();
      ASSERT_EQ(again->seen(), seen);
    }
  }
  Trainer alone(brief("merge", 12), {.envs = 2});
  EXPECT_THROW(alone.env.restore(*saved), std::invalid_argument);
}

TEST(VectorEnv, BeginsEachEpisodeElsewhereAndTheSameOneForTheSameSeed) {
  Trainer t(brief("merge", 5), {.envs = 2});
  EXPECT_NE(t.env.seed(0), t.env.seed(1));
  const auto place = [&](std::size_t env) {
    return t.env.world(env).rows(t.env.scenario().aircraft.kinematics)[0].position;
  };
  EXPECT_NE(place(0), place(1));
  const Vec3 first = place(0);
  const std::uint64_t seed = t.env.seed(0);
  while (!t.over[0])
    t.step();
  EXPECT_NE(t.env.seed(0), seed);
  EXPECT_EQ(t.env.finished(0).seed, seed);
  EXPECT_EQ(t.env.finished(0).steps, 250U);
  EXPECT_EQ(t.env.finished(0).outcome, scenario::Outcome::time);
  EXPECT_TRUE(t.truncated[0]);
  EXPECT_FALSE(t.terminated[0]);
  t.env.reset_one(1, seed);
  EXPECT_EQ(place(1), first);
}

TEST(VectorEnv, TellsAnEndByDeathFromAnEndByTime) {
  // into the ground
  Trainer t(task("merge"), {.envs = 1});
  std::vector<float> sum{0};
  while (!t.over[0]) {
    t.act();
    t.actions = {0, -1, 1, 1, -1, -1};
    t.env.step(t.actions);
    sum[0] += t.rewards[0];
    ASSERT_LT(t.decisions, 2000U);
  }
  EXPECT_TRUE(t.terminated[0]);
  EXPECT_FALSE(t.truncated[0]);
  EXPECT_EQ(t.env.finished(0).outcome, scenario::Outcome::blue_lost);
  EXPECT_LT(sum[0], -0.9F) << "it lost";
  EXPECT_EQ(t.last_observations, std::vector<float>(t.last_observations.size(), 0)) << "it is gone";
}

TEST(VectorEnv, WritesEpisodesThatFlyAgainToTheSameWorld) {
  for (const char* name : {"merge", "merge_votes", "sweep"}) {
    SCOPED_TRACE(name);
    TaskSpec spec = brief(name, 14);
    if (spec.name == "merge")
      spec.opponents = {{"bandit1", {"dogfight", "fight", "bug_out"}}};
    Trainer t(std::move(spec), {.envs = 2, .seed = 3});
    while (!t.over[0])
      t.step();
    for (int i = 0; i < 33; ++i)
      t.step();
    for (const bool last_one : {false, true}) {
      const record::RunFile run = t.env.episode(0, last_one);
      if (!last_one) {
        EXPECT_EQ(run.trail.last_step, t.env.world(0).step());
        EXPECT_EQ(run.trail.last_hash, t.env.world(0).hash());
      }
      // as replay does it, from the bytes of the file alone
      const auto decoded = record::decode(record::encode(run));
      ASSERT_EQ(decoded.error, "");
      const auto opened = debrief::open(decoded.run, "episode", {}, "test");
      ASSERT_EQ(opened.problems, std::vector<std::string>{});
      sim::Run flight(opened.recorded->scenario->simulation,
                      opened.recorded->scenario->world(run.seed));
      sim::TrailChecker checker(decoded.run.trail);
      flight.attach(checker);
      for (const sim::Order& order : decoded.run.orders)
        ASSERT_EQ(flight.submit(order), "");
      while (flight.world().step() < run.trail.last_step)
        flight.step();
      flight.finish();
      EXPECT_FALSE(checker.departure()) << checker.departure()->reason;
    }
    EXPECT_THROW(static_cast<void>(t.env.episode(1)), std::invalid_argument) << "not kept";
  }
}

TEST(VectorEnv, EndsEachOfManyEpisodesAsAMissionEnds) {
  constexpr std::size_t kEnvs = 6;
  Trainer t(task("merge"), {.envs = kEnvs, .seed = 5, .keep_episodes = kEnvs});
  for (std::size_t compared = 0; compared < 2 * kEnvs;) {
    t.step();
    for (std::size_t env = 0; env < kEnvs; ++env) {
      if (!t.over[env])
        continue;
      const record::RunFile run = t.env.episode(env, true);
      const auto opened = debrief::open(run, "episode", {}, "test");
      const auto& scenario = opened.recorded->scenario;
      scenario::Mission mission(scenario, scenario->world(run.seed), scenario->spec.until, false);
      for (const sim::Order& order : run.orders)
        ASSERT_EQ(mission.run().submit(order), "");
      mission.fly();
      EXPECT_EQ(mission.outcome(), t.env.finished(env).outcome);
      EXPECT_EQ(mission.run().world().step(), t.env.finished(env).steps);
      ++compared;
    }
  }
}

TEST(VectorEnv, FliesAnActionInTheStepThatFollowsItsObservation) {
  Trainer t(brief("merge", 14), {.envs = 1, .seed = 3});
  for (int i = 0; i < 40; ++i)
    t.step();
  const auto& scenario = t.env.scenario();
  const auto id = *scenario.roster.find("viper1");
  const auto period = static_cast<std::uint32_t>(t.env.seconds() / scenario.simulation->dt() + 0.5);
  const record::RunFile run = t.env.episode(0);
  const auto commands =
      std::count_if(run.orders.begin(), run.orders.end(), [&](const sim::Order& order) {
        return order.player == id && sim::due(order.step, id, period);
      });
  EXPECT_GE(commands, 40);
  EXPECT_EQ(commands, static_cast<long>(run.orders.size()));
  EXPECT_TRUE(sim::due(t.env.world(0).step(), id, period)) << "what it observes now";
}

TEST(VectorEnv, DrawsAnOpponentForEachEpisode) {
  TaskSpec spec = brief("merge", 2);
  spec.opponents = {{"bandit1", {"dogfight", "bug_out"}}};
  Trainer t(std::move(spec), {.envs = 16});
  t.step();
  std::array<int, 2> flown{};
  for (std::size_t env = 0; env < 16; ++env) {
    const auto& scenario = t.env.scenario();
    const auto tree = t.env.world(env).rows(scenario.pilots.agent)[1].tree;
    ++flown[(*scenario.trees)[tree].name() == "dogfight" ? 0 : 1];
  }
  EXPECT_GT(flown[0], 2);
  EXPECT_GT(flown[1], 2);
}

TEST(VectorEnv, RefusesWhatCannotBeDoneBeforeAnythingChanges) {
  Trainer t(brief("sweep", 10), {.envs = 2});
  t.step();
  const std::uint64_t hash = t.env.world(1).hash();
  t.act();
  t.actions[t.env.shape().action * 5 + 1] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(words([&] { t.env.step(t.actions); }),
            "action altitude_change of eagle2 in environment 1 is not a number");
  t.act();
  EXPECT_EQ(words([&] { t.env.step(std::span(t.actions).first(3)); }),
            "actions: 3 numbers, expected 48");
  EXPECT_EQ(t.env.world(1).hash(), hash);
  EXPECT_THROW(t.env.reset_one(2, 1), std::invalid_argument);
  const Options many{.envs = 1'000'000, .keep_episodes = 1'000'000};
  EXPECT_TRUE(
      words([&] { Trainer(task("merge"), many); }).starts_with("1000000 environments need "));

  // beyond the bounds is taken as the bound
  std::fill(t.actions.begin(), t.actions.end(), 1e30F);
  t.env.step(t.actions);
}

TEST(VectorEnv, RefusesActionsOfTheDead) {
  TaskSpec spec = task("sweep");
  spec.sets = {"ends=time"};
  Trainer t(std::move(spec), {.envs = 1});
  while (t.alive[0]) {  // the lead flies into the ground
    std::fill(t.actions.begin(), t.actions.end(), 0.0F);
    t.actions[1] = -1;
    t.env.step(t.actions);
    ASSERT_FALSE(t.over[0]);
  }
  EXPECT_TRUE(t.terminated[0]);
  EXPECT_TRUE(t.alive[1]);
  EXPECT_EQ(t.masks[0], 0) << "nothing can be done";
  EXPECT_EQ(words([&] { t.env.step(t.actions); }),
            "eagle1 in environment 0 is dead: its actions must be 0");
  t.actions[1] = 0;
  t.env.step(t.actions);
  EXPECT_FALSE(t.terminated[0]) << "said once";
}

TEST(VectorEnv, SaysWhatIsWrongWithATask) {
  const auto problem = [](const std::function<void(TaskSpec&)>& change,
                          const char* name = "merge") {
    TaskSpec spec = task(name);
    change(spec);
    return words([&] { VectorEnv(spec, scenario::Source::disk("."), {}); });
  };
  EXPECT_EQ(problem([](TaskSpec& t) { t.learners = {"viper"}; }),
            "learner: there is no player 'viper'; did you mean 'viper1'?");
  EXPECT_EQ(problem([](TaskSpec& t) {
              t.learners = {"viper1", "viper1"};
            }),
            "learner 'viper1' is named twice");
  EXPECT_EQ(problem([](TaskSpec& t) { t.learners = {}; }), "nobody learns: name a learner");
  EXPECT_EQ(problem([](TaskSpec& t) { t.controls = ""; }),
            "a task has controls or votes, one of them");
  EXPECT_EQ(problem([](TaskSpec& t) { t.votes->arbiter = "root/winner_take_all"; }, "merge_votes"),
            "votes: tree 'arbitrated' of viper1 has no node 'root/winner_take_all'; did you mean "
            "'root/winner_takes_all'?");
  EXPECT_EQ(problem([](TaskSpec& t) {
              t.opponents = {{"bandit1", {"dogfigth"}}};
            }),
            "opponent 'bandit1': there is no tree 'dogfigth'; did you mean 'dogfight'?");
  EXPECT_EQ(words([] { static_cast<void>(task("merg")); }),
            "there is no task 'merg'; did you mean 'merge'?");
  EXPECT_THROW(VectorEnv(
                   [] {
                     TaskSpec spec = task("merge");
                     spec.observation = "rnge linear 0 km 1 km\n";
                     return spec;
                   }(),
                   scenario::Source::disk("."), {}),
               ConfigError);
}

TEST(VectorEnv, AllocatesNothingInAStepEvenWhereAnEpisodeBegins) {
  for (const unsigned workers : {1U, 2U}) {
    Trainer t(brief("merge", 4), {.envs = 4, .workers = workers, .keep_episodes = 4});
    for (int i = 0; i < 20; ++i)
      t.step();
    int over = 0;
    NoAllocation guard(NoAllocation::Scope::process);
    for (int i = 0; i < 150; ++i) {
      t.step();
      over += t.over[0];
    }
    EXPECT_EQ(over, 4);
  }
}

TEST(VectorEnv, KeepsItsMemoryFlatForAHundredThousandSteps) {
  Trainer t(brief("merge", 20), {.envs = 100});
  const auto resident = [] {
    std::ifstream file("/proc/self/statm");
    std::uint64_t total = 0, pages = 0;
    file >> total >> pages;
    return pages * 4096;
  };
  for (int i = 0; i < 250; ++i)
    t.step();
  const std::uint64_t before = resident();
  for (int i = 0; i < 1000; ++i)
    t.step();
  EXPECT_LT(resident(), before + (2U << 20));
}

}  // namespace
}  // namespace eyrie::train
