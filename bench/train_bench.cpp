// SPDX-License-Identifier: MIT
/// \file  Decisions a second of training environments: so many worlds of the task merge, commanded
/// at random, against a tree written by hand. One decision is five steps of the world, 0.1 s; and
/// by how much the process grew meanwhile.
#include <benchmark/benchmark.h>

#include <unistd.h>

#include <fstream>

#include "core/draw.hpp"
#include "scenario/source.hpp"
#include "train/vector_env.hpp"

namespace {

using namespace eyrie;

/// kB that the process has in memory.
double resident() {
  double all = 0, pages = 0;
  std::ifstream("/proc/self/statm") >> all >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1000;
}

void merge(benchmark::State& state) {
  train::TaskSpec task = train::task("merge");
  train::VectorEnv env(std::move(task), scenario::Source::disk(EYRIE_SOURCE_DIR),
                       {.envs = static_cast<std::size_t>(state.range(0)),
                        .workers = static_cast<unsigned>(state.range(1)),
                        .keep_episodes = 0});
  const train::Shape& s = env.shape();
  const std::size_t agents = s.envs * s.agents;
  // another action every second, so that they fly somewhere
  std::vector<std::vector<float>> actions(16, std::vector<float>(agents * s.action));
  Draw draw(1, PlayerId{1}, Stream::test, 0);
  for (auto& each : actions)
    for (float& x : each)
      x = static_cast<float>(draw.uniform(-1, 1));
  env.reset(1);
  env.step(actions[0]);
  const double before = resident();
  std::uint64_t decisions = 0, episodes = 0;
  for (auto _ : state) {
    env.step(actions[decisions++ / 10 % actions.size()]);
    for (const std::uint8_t one : env.results()->over)
      episodes += one;
  }
  const auto made = static_cast<double>(decisions) * static_cast<double>(s.envs);
  state.counters["decisions_per_s"] = benchmark::Counter(made, benchmark::Counter::kIsRate);
  state.counters["decisions_per_s_and_worker"] =
      benchmark::Counter(made / static_cast<double>(state.range(1)), benchmark::Counter::kIsRate);
  state.counters["episodes"] = static_cast<double>(episodes);
  state.counters["grown_kB"] = resident() - before;
}
BENCHMARK(merge)->ArgsProduct({{1, 64, 1024}, {1, 2}})->UseRealTime()->MeasureProcessCPUTime();

}  // namespace

BENCHMARK_MAIN();
