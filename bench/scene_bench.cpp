// SPDX-License-Identifier: MIT
/// \file  Whole scenes. line_abreast: N/2 against N/2 aircraft, 6000 ft apart, 40 nmi between the
/// sides, 480 kt at 20,000 ft, with rate-limited dynamics, autopilot, radar, warning receiver,
/// tracks, datalink, four missiles on stations and one agent of five behaviors under one arbiter;
/// nobody fires. "ns" is the time of one player-step: one aircraft for one step of 20 ms with its
/// share of everything slower. sweep: the mission from start to end; "x_real_time" is simulated
/// over wall time. Labels carry the world hash, so a benchmark is a determinism test as well.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <string>

#include "debrief/decision.hpp"
#include "debrief/recorded.hpp"
#include "line_abreast.hpp"
#include "model/flight/abreast.hpp"
#include "page/page.hpp"
#include "scenario/mission.hpp"
#include "support/no_allocation.hpp"

namespace {

using namespace eyrie;

void count_bytes(benchmark::State& state, const scenario::Scenario& s) {
  std::size_t bytes = 0;
  for (const std::uint32_t column : s.simulation->schema().table(s.aircraft.table).columns)
    bytes += s.simulation->schema().column(column).stride;
  state.counters["bytes"] = static_cast<double>(bytes);
}

void line_abreast(benchmark::State& state) {
  const int aircraft = static_cast<int>(state.range(0));
  const auto scene = bench::line_abreast(aircraft);
  sim::Workspace work(*scene->simulation);
  sim::World warm = scene->world(1);
  for (int i = 0; i < 500; ++i)  // ten seconds: radars have turned, tracks are there
    scene->simulation->step(warm, work);
  sim::World world = warm;
  constexpr std::uint64_t kSteps = 500;
  NoAllocation guard;
  for (auto _ : state) {
    if (world.step() == warm.step() + kSteps)
      world = warm;
    scene->simulation->step(world, work);
  }
  state.counters["allocs"] = static_cast<double>(guard.count());
  guard.dismiss();
  state.counters["ns"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * aircraft * 1e-9,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  count_bytes(state, *scene);
  sim::World last = warm;
  for (std::uint64_t i = 0; i < kSteps; ++i)
    scene->simulation->step(last, work);
  state.SetLabel(fmt::format("hash 0x{:016x}", last.hash()));
}
BENCHMARK(line_abreast)->Arg(2)->Arg(6)->Arg(20)->Arg(100)->Arg(500)->Arg(1000);

/// The same aircraft flown in a bare loop: autopilot, dynamics and vertical, nothing else.
void bare_loop(benchmark::State& state) {
  const auto scene = bench::line_abreast(static_cast<int>(state.range(0)));
  sim::World world = scene->world(1);
  const auto kinematics = world.rows(scene->aircraft.kinematics);
  const auto flying = world.rows(scene->aircraft.flying);
  const auto propulsion = world.rows(scene->aircraft.propulsion);
  const auto command = world.rows(scene->aircraft.command);
  const auto fit = world.rows(scene->aircraft.fit);
  const auto& library = *scene->library;
  const model::AircraftType& type = library.aircraft[fit[0].type];
  const model::flight::PointMass flight_model(library.airframes[type.index.airframe]);
  double time = 0;
  NoAllocation guard;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kinematics.size(); ++i) {
      model::flight::Flyer flyer{.model = &flight_model,
                                 .kinematics = &kinematics[i],
                                 .flying = &flying[i],
                                 .propulsion = &propulsion[i],
                                 .command = &command[i],
                                 .routes = library.flights[fit[i].flight].routes,
                                 .time = time};
      model::flight::fly({library.reference, library.environment, 0.02}, std::array{&flyer});
      benchmark::DoNotOptimize(flyer.ran_dry);
    }
    time += 0.02;
  }
  state.counters["allocs"] = static_cast<double>(guard.count());
  guard.dismiss();
  state.counters["ns"] = benchmark::Counter(
      static_cast<double>(state.iterations() * static_cast<std::int64_t>(kinematics.size())) * 1e-9,
      benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(bare_loop)->Arg(6)->Arg(1000);

std::shared_ptr<const scenario::Scenario> load(const std::string& file,
                                               const std::vector<std::string>& sets) {
  return scenario::load({.file = fmt::format("{}/{}", EYRIE_SOURCE_DIR, file), .sets = sets},
                        scenario::Source::disk(EYRIE_SOURCE_DIR));
}

void fly(benchmark::State& state, const char* name) {
  const auto scene = load(fmt::format("scenarios/{}.yaml", name), {});
  double time = 0, allocations = 0;
  std::uint64_t hash = 0;
  for (auto _ : state) {
    state.PauseTiming();
    scenario::Mission mission(scene, scene->spec.seed);
    for (int i = 0; i < 500; ++i)
      mission.step();
    NoAllocation guard;
    state.ResumeTiming();
    mission.fly();
    state.PauseTiming();
    allocations += static_cast<double>(guard.count());
    guard.dismiss();
    time += mission.run().time() - 10;
    hash = mission.run().world().hash();
    state.ResumeTiming();
  }
  state.counters["allocs"] = allocations;
  state.counters["x_real_time"] = benchmark::Counter(time, benchmark::Counter::kIsRate);
  state.SetLabel(fmt::format("hash 0x{:016x}", hash));
}
BENCHMARK_CAPTURE(fly, sweep, "sweep")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fly, sweep_paper, "sweep_paper")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fly, sweep_even, "sweep_even")->Unit(benchmark::kMillisecond);

/// The sweep again from its run file: flown alone, with every decision of every player traced, and
/// made into the debrief page. What the debrief costs; recording a run costs nothing of it.
debrief::Recorded recorded(const std::string& file, const std::vector<std::string>& sets) {
  const auto scene = load(file, sets);
  sim::TrailRecorder trail;
  scenario::Mission mission(scene, scene->spec.seed);
  mission.run().attach(trail);
  mission.fly();
  debrief::Recorded recorded;
  recorded.run.seed = scene->spec.seed;
  recorded.run.trail = trail.trail();
  recorded.scenario = scene;
  return recorded;
}
debrief::Recorded recorded_sweep() {
  return recorded("scenarios/sweep.yaml", {});
}

void again(benchmark::State& state, bool traced) {
  const debrief::Recorded recorded = recorded_sweep();
  const auto* pilots = debrief::find_system<pilot::PilotSystem>(*recorded.scenario->simulation);
  pilot::Trace trace(recorded.scenario->trees->max_size());
  double decisions = 0;
  std::uint64_t hash = 0;
  for (auto _ : state) {
    debrief::Reflight flight(recorded);
    while (flight.step())
      for (std::uint32_t id = 1; traced && id <= recorded.scenario->roster.players.size(); ++id)
        pilots->revisit(flight.before(), flight.after(), PlayerId{id}, flight.orders(),
                        [&](const team::Moment<pilot::State>& m) {
                          team::ask_again((*recorded.scenario->trees)[m.state.agent.tree], m,
                                          &trace);
                          ++decisions;
                        });
    hash = flight.after().hash();
  }
  state.counters["decisions"] = decisions / static_cast<double>(state.iterations());
  state.SetLabel(fmt::format("hash 0x{:016x}", hash));
}
BENCHMARK_CAPTURE(again, flown, false)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(again, traced, true)->Unit(benchmark::kMillisecond);

/// How long a decision of flight eagle takes under one of the architectures of the study, in the
/// five minutes that lead into the fight; "nodes" is the size of the tree.
void decide(benchmark::State& state, const char* tree) {
  const debrief::Recorded flown = recorded("studies/architectures/mission.yaml",
                                           {fmt::format("blue.flights.eagle.tree={}", tree)});
  const auto* pilots = debrief::find_system<pilot::PilotSystem>(*flown.scenario->simulation);
  constexpr int kTimes = 64;
  std::vector<std::byte> memory;
  double nodes = 0, ns = 0;
  for (auto _ : state) {
    std::chrono::nanoseconds spent{};
    std::int64_t decisions = 0;
    debrief::Reflight flight(flown);
    while (flight.step() && flight.after().step() < 27'000)  // 9 min
      for (std::uint32_t id = 1; flight.after().step() > 12'000 && id <= 4; ++id)
        pilots->revisit(flight.before(), flight.after(), PlayerId{id}, flight.orders(),
                        [&](const team::Moment<pilot::State>& m) {
                          const auto& asked = (*flown.scenario->trees)[m.state.agent.tree];
                          nodes = static_cast<double>(asked.size());
                          const auto begun = std::chrono::steady_clock::now();
                          for (int i = 0; i < kTimes; ++i) {
                            memory.assign(m.memory.begin(), m.memory.end());
                            benchmark::DoNotOptimize(team::ask_again(asked, m, memory.data()));
                          }
                          spent += std::chrono::steady_clock::now() - begun;
                          decisions += kTimes;
                        });
    state.SetIterationTime(std::chrono::duration<double>(spent).count());
    ns = std::chrono::duration<double, std::nano>(spent).count() / static_cast<double>(decisions);
  }
  state.counters["nodes"] = nodes;
  state.counters["ns"] = ns;
}
BENCHMARK_CAPTURE(decide, winner_takes_all, "winner_takes_all")->UseManualTime()->Iterations(1);
BENCHMARK_CAPTURE(decide, paper_fusion, "paper_fusion")->UseManualTime()->Iterations(1);
BENCHMARK_CAPTURE(decide, weighted_fusion, "weighted_fusion")->UseManualTime()->Iterations(1);
BENCHMARK_CAPTURE(decide, per_field, "per_field")->UseManualTime()->Iterations(1);
BENCHMARK_CAPTURE(decide, behavior_tree, "behavior_tree")->UseManualTime()->Iterations(1);
BENCHMARK_CAPTURE(decide, subsumption, "subsumption")->UseManualTime()->Iterations(1);
BENCHMARK_CAPTURE(decide, sequencer, "sequencer")->UseManualTime()->Iterations(1);

void debrief_page(benchmark::State& state) {
  const debrief::Recorded recorded = recorded_sweep();
  std::size_t bytes = 0;
  for (auto _ : state)
    bytes = page::page_data(recorded).size();
  state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(debrief_page)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
