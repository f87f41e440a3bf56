// SPDX-License-Identifier: MIT
/// \file  Many flights of one scenario: what beginning one costs, and sweeps a second on so many
/// workers. "efficiency" is what each worker flies beside what one flies alone.
#include <benchmark/benchmark.h>

#include "campaign/in_order.hpp"
#include "campaign/replicate.hpp"

namespace {

using namespace eyrie;

const std::shared_ptr<const scenario::Scenario>& sweep() {
  static const auto scenario =
      scenario::load({"scenarios/sweep.yaml", {}}, scenario::Source::disk(EYRIE_SOURCE_DIR));
  return scenario;
}

void replicate_begins(benchmark::State& state) {
  std::uint64_t seed = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(scenario::Mission(sweep(), ++seed));
}
BENCHMARK(replicate_begins)->Unit(benchmark::kMicrosecond);

void sweeps(benchmark::State& state) {
  constexpr std::uint64_t kSeeds = 96;
  const auto workers = static_cast<unsigned>(state.range(0));
  static double alone = 0;  // sweeps/s of one worker
  std::uint64_t flown = 0;
  const auto begun = std::chrono::steady_clock::now();
  for (auto _ : state)
    campaign::in_order<campaign::Flown>(
        kSeeds, workers, [](std::uint64_t i) { return campaign::fly(sweep(), i + 1); },
        [&](std::uint64_t, campaign::Flown&&) { return ++flown > 0; });
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begun;
  const double rate = static_cast<double>(flown) / wall.count();
  if (workers == 1)
    alone = rate;
  state.counters["per_s"] = rate;
  state.counters["per_s_and_worker"] = rate / workers;
  if (alone > 0)
    state.counters["efficiency"] = rate / workers / alone;
}
BENCHMARK(sweeps)->Arg(1)->Arg(2)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
