// SPDX-License-Identifier: MIT
/// \file  The same scenario and seed give the same bits: for every number of workers, over save and
/// restore, watched or not, made once or twice. Suites begin with Workers: the stage with the
/// thread sanitizer picks them by that name.
#include <gtest/gtest.h>

#include "core/hash.hpp"
#include "disk/sink.hpp"
#include "pilot/pilot_system.hpp"
#include "record/acmi.hpp"
#include "record/event_table.hpp"
#include "record/run_file.hpp"
#include "record/story.hpp"
#include "sim/trail.hpp"
#include "support/flight.hpp"
#include "support/no_allocation.hpp"
#include "support/program.hpp"

namespace eyrie::test {
namespace {

using scenario::Mission;

std::uint64_t final_hash(const std::shared_ptr<const scenario::Scenario>& scenario,
                         const sim::RunOptions& options, double until) {
  Mission mission(scenario, scenario->spec.seed, until, options);
  mission.fly();
  return mission.run().world().hash();
}

/// Flights of eight on both sides, head-on in rows, so that several chunks of 256 rows exist and
/// everybody sees, decides and shoots within seconds.
std::string crowd(int flights_per_side) {
  std::string text =
      "eyrie: 1\nname: crowd\nreference: {latitude: 33 deg, longitude: -68 deg}\nuntil: 5 s\n"
      "ends: time\ntrees:\n  attack:\n    per_field:\n"
      "      - release_weapon: {vote: 60, zone: 5, one_shooter: false}\n"
      "      - pursue: {vote: 40}\n";
  for (const char* side : {"blue", "red"}) {
    const bool blue = side[0] == 'b';
    text += std::string(side) + ":\n  home: {north: 0 nmi, east: " + (blue ? "-100" : "100") +
            " nmi}\n  flights:\n";
    for (int i = 0; i < flights_per_side; ++i) {
      const std::string name = std::string(1, side[0]) + static_cast<char>('a' + i / 26) +
                               static_cast<char>('a' + i % 26);
      text += "    " + name + ":\n      aircraft: " + (blue ? "f15c" : "mig29") +
              "\n      tree: attack\n      privileged: " + (i % 2 ? "true" : "false") +
              "\n      players: [";
      for (int rank = 1; rank <= 8; ++rank)
        text += (rank > 1 ? ", " : "") + name + std::to_string(rank);
      text += "]\n      start: {north: " + std::to_string(10 * i - 10 * flights_per_side / 2) +
              " nmi, east: " + (blue ? "-9" : "9") +
              " nmi, altitude: " + std::to_string(20000 + 100 * i) +
              " ft, heading: " + (blue ? "90" : "270") + " deg, speed: 480 kt}\n";
    }
  }
  return text;
}

class WorkersScenario : public testing::TestWithParam<const char*> {};

TEST_P(WorkersScenario, GiveTheSameHashForOneTwoThreeAndSeven) {
  const auto scenario = load_scenario(GetParam());
  const double until = scenario->spec.until;
  const std::uint64_t one = final_hash(scenario, {.workers = 1}, until);
  for (const unsigned workers : {2U, 3U, 7U})
    EXPECT_EQ(final_hash(scenario, {.workers = workers}, until), one) << workers << " workers";
}
INSTANTIATE_TEST_SUITE_P(Whole, WorkersScenario, testing::Values("sweep", "sweep_even"),
                         [](const auto& test) { return std::string(test.param); });

TEST(WorkersCrowd, GiveTheSameHashAndTheSameEventsOverSeveralChunks) {
  const TempFolder folder;
  const std::string file = folder.write("crowd.yaml", crowd(38));
  const auto scenario = scenario::load({file, {}}, scenario::Source::disk("."));
  ASSERT_EQ(scenario->roster.players.size(), 608U);

  std::optional<std::uint64_t> hash, events;
  for (const unsigned workers : {1U, 2U, 3U, 7U}) {
    Flight f(scenario, 1, {.workers = workers});
    f.mission.fly();
    Hasher hasher;
    for (const Happened& h : f.log.all())
      hasher.bytes(&h.event, sizeof h.event);
    EXPECT_EQ(f.world().step(), 250U);
    EXPECT_GT(f.log.of(EventKind::in_charge).size(), 600U) << "everybody decided";
    EXPECT_GT(f.log.of(EventKind::release).size(), 0U) << "and somebody shot";
    EXPECT_EQ(f.world().hash(), hash.value_or(f.world().hash())) << workers << " workers";
    EXPECT_EQ(hasher.value(), events.value_or(hasher.value())) << workers << " workers";
    hash = f.world().hash();
    events = hasher.value();
  }
}

/// The middle of the engagement of the sweep, in s: everything is in use.
constexpr double kMiddle = 590;

TEST(WorkersSnapshot, ContinueACopiedWorldToTheSameEnd) {
  const auto scenario = load_scenario("sweep");
  Flight whole(scenario);
  whole.fly_until(kMiddle);
  ASSERT_EQ(whole.time(), kMiddle);
  const sim::World branch = whole.world();
  whole.mission.fly();
  const std::uint64_t end = whole.world().hash();
  const std::uint64_t steps = whole.world().step();
  ASSERT_GT(whole.tally.side(model::Side::blue).shots, 0U);

  // in a scenario that was loaded again, and twice in the same one
  const auto again = load_scenario("sweep");
  const auto elsewhere = branch.moved_to(again->simulation->shared_schema());
  ASSERT_TRUE(elsewhere);
  EXPECT_EQ(elsewhere->hash(), branch.hash());
  const std::pair<std::shared_ptr<const scenario::Scenario>, sim::World> ways[] = {
      {again, *elsewhere}, {scenario, branch}, {scenario, branch}};
  for (unsigned i = 0; i < std::size(ways); ++i) {
    sim::Run run(ways[i].first->simulation, ways[i].second, {.workers = i + 1});
    while (run.world().step() < steps)
      run.step();
    EXPECT_EQ(run.world().hash(), end) << "way " << i;
  }
}

TEST(WorkersSnapshot, LetABranchGoItsOwnWayAndComeBack) {
  constexpr double kEarly = 250;  // s: all are alive, and on their way there
  const auto scenario = load_scenario("sweep");
  Flight f(scenario);
  f.fly_until(kEarly);
  const sim::World kept = f.world();
  f.fly_until(kEarly + 60);
  const std::uint64_t first = f.world().hash();
  // another way from the same world: the first who lives gets the order to fly home
  const PlayerId somebody = kept.ids(scenario->aircraft.table)[0];
  sim::Run other(scenario->simulation, kept);
  ASSERT_EQ(other.submit(pilot::PilotSystem::swap_tree_order(
                kept.step(), somebody, scenario->trees->find("homeward").value())),
            "");
  while (other.time() < kEarly + 60 - 1e-9)
    other.step();
  EXPECT_NE(other.world().hash(), first);
  // and back: the order does not reach into the branch without it
  sim::Run again(scenario->simulation, kept);
  while (again.time() < kEarly + 60 - 1e-9)
    again.step();
  EXPECT_EQ(again.world().hash(), first);
}

TEST(WorkersParanoid, FindNothingInTheFirstMinuteOfTheEngagement) {
  const auto scenario = load_scenario("sweep");
  Flight f(scenario);
  while (!f.log.first(EventKind::launch) && f.mission.step()) {
  }
  ASSERT_TRUE(f.log.first(EventKind::launch));
  sim::Run run(scenario->simulation, f.world(), {.workers = 1, .paranoid_workers = 3});
  for (int i = 0; i < 60 * 50; ++i) {
    run.step();
    ASSERT_FALSE(run.difference()) << run.difference()->text();
  }
}

TEST(WorkersObservers, ChangeNothing) {
  const auto scenario = load_scenario("sweep");
  sim::World bare = scenario->world(scenario->spec.seed);
  sim::Workspace work(*scenario->simulation);

  const TempFolder folder;
  disk::Sink events(folder / "events.csv"), acmi(folder / "flight.acmi");
  record::EventsCsv csv(*scenario, events);
  record::AcmiWriter tacview(*scenario, [&](std::string_view lines) { acmi.write(lines); });
  std::size_t lines = 0, traced = 0;
  record::Story story(*scenario, [&](const record::StoryLine&) { ++lines; });
  sim::TrailRecorder trail;
  Flight watched(scenario);
  for (sim::Observer* o : std::initializer_list<sim::Observer*>{&csv, &tacview, &story, &trail})
    watched.mission.run().attach(*o);

  const pilot::PilotSystem* pilots = nullptr;
  for (const auto& system : scenario->simulation->systems())
    if (const auto* found = dynamic_cast<const pilot::PilotSystem*>(system.get()))
      pilots = found;
  ASSERT_TRUE(pilots);
  pilot::Trace trace(scenario->trees->max_size());
  sim::World before = watched.world();
  while (watched.mission.step()) {
    scenario->simulation->step(bare, work);
    // every pilot is asked for his reasons once per second
    if (before.step() % 50 < 5)
      for (std::uint32_t id = 1; id <= scenario->roster.players.size(); ++id)
        traced += pilots->revisit(before, watched.world(), PlayerId{id}, {}, [&](const auto& m) {
          team::ask_again((*scenario->trees)[m.state.agent.tree], m, &trace);
        });
    before = watched.world();
    if (watched.world().step() % 500 == 0) {
      ASSERT_EQ(watched.world().hash(), bare.hash()) << "at step " << bare.step();
    }
  }
  EXPECT_EQ(watched.world().hash(), bare.hash());
  EXPECT_GT(lines, 20U);
  EXPECT_GT(traced, 1000U);
}

TEST(WorkersNoAllocation, InAnyStepOfTheSweepAfterTheFirstTenSeconds) {
  ASSERT_TRUE(NoAllocation::counts());
  const auto scenario = load_scenario("sweep");
  for (const unsigned workers : {1U, 2U}) {
    sim::World world = scenario->world(scenario->spec.seed);
    sim::Workspace work(*scenario->simulation, workers);
    while (world.step() < 500)
      scenario->simulation->step(world, work);
    std::uint64_t first = 0, count = 0;
    for (std::uint64_t i = 0; i < 60 * 50 * 25; ++i) {
      NoAllocation guard(NoAllocation::Scope::process);
      scenario->simulation->step(world, work);
      if (guard.count() && !first)
        first = world.step();
      count += guard.count();
      guard.dismiss();
    }
    EXPECT_EQ(count, 0U) << "first in step " << first << " with " << workers << " workers";
  }
}

TEST(WorkersReplay, GoTheWayOfTheRecordingThroughARunFile) {
  const auto scenario = load_scenario("sweep");
  sim::TrailRecorder trail;
  Flight f(scenario, 7);
  f.mission.run().attach(trail);
  f.mission.fly();
  record::RunFile file{.build = "test",
                       .scenario = scenario->file,
                       .files = scenario->files,
                       .sets = scenario->sets,
                       .seed = 7,
                       .layout_hash = scenario->simulation->schema().layout_hash(),
                       .plugins = {},
                       .trail = trail.trail(),
                       .orders = {},
                       .outcome = ""};
  const record::Decoded back = record::decode(record::encode(file));
  ASSERT_EQ(back.error, "");
  ASSERT_TRUE(back.run == file);

  // nothing but what the run file holds
  const auto bundled =
      scenario::load({back.run.scenario, back.run.sets}, scenario::Source::bundle(back.run.files));
  ASSERT_EQ(bundled->simulation->schema().layout_hash(), back.run.layout_hash);
  sim::TrailChecker checker(back.run.trail);
  sim::Run replay(bundled->simulation, bundled->world(back.run.seed), {.workers = 2});
  replay.attach(checker);
  while (replay.world().step() < back.run.trail.last_step)
    replay.step();
  replay.finish();
  EXPECT_FALSE(checker.departure()) << checker.departure()->reason;
  EXPECT_EQ(replay.world().hash(), f.world().hash());
}

}  // namespace
}  // namespace eyrie::test
