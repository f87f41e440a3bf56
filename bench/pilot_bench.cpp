// SPDX-License-Identifier: MIT
/// \file  What a decision costs: perceiving the state from the rows, and asking a tree about it,
/// over the number of hostile tracks. A pilot decides ten times per second: a fifth of the time of
/// a decision is what one step of 20 ms pays.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <filesystem>

#include "pilot/policy/policy_file.hpp"
#include "support/no_allocation.hpp"
#include "support/pilot/networks.hpp"
#include "support/pilot/testing.hpp"
#include "train/task.hpp"

namespace {

using namespace eyrie;
using namespace eyrie::pilot;

/// The five behaviors of the scene line_abreast (bench/scene_bench.cpp).
constexpr const char* kAbreast =
    "{winner_takes_all: [avoid_ground, break_turn, {egress: {vote: 1}}, follow_lead, navigate]}";
/// What a pilot beyond visual range asks (scenarios/packages/pilots.yaml).
constexpr const char* kAttack =
    "{per_field: [{winner_takes_all: [avoid_ground, break_turn]}, {release_weapon: {zone: 1}}, "
    "{pursue: {crank: 50 deg}}, follow_lead, navigate]}";

/// The second of four, with so many hostiles 40 km ahead, in range of no missile.
pilot::testing::Desk desk(std::int64_t tracks) {
  pilot::testing::Desk d;
  d.in_flight(4, 2);
  for (std::int64_t i = 0; i < tracks; ++i)
    d.track({40e3, static_cast<double>(i) * 2000, 0}).targeted_by = i % 3 == 0 ? 1 : 0;
  return d;
}

/// What `make` gives is made, and counts as used.
template <class Make>
void measure(benchmark::State& state, Make make) {
  NoAllocation guard;
  guard.dismiss();
  for (auto _ : state) {
    const auto made = make();
    benchmark::DoNotOptimize(&made);
    benchmark::ClobberMemory();
  }
  state.counters["allocs"] = static_cast<double>(guard.count());
}

void perceive(benchmark::State& state) {
  const pilot::testing::Desk d = desk(state.range(0));
  measure(state, [&] { return d.state(); });
}
BENCHMARK(perceive)->ArgName("tracks")->Arg(0)->Arg(2)->Arg(8)->Arg(16);

void decide(benchmark::State& state, const char* tree) {
  const pilot::testing::Desk d = desk(state.range(0));
  pilot::testing::Pilot pilot(tree);
  measure(state, [&] { return pilot.decide(d); });
}
BENCHMARK_CAPTURE(decide, abreast, kAbreast)->ArgName("tracks")->Arg(0)->Arg(2)->Arg(16);
BENCHMARK_CAPTURE(decide, attack, kAttack)->ArgName("tracks")->Arg(0)->Arg(2)->Arg(8)->Arg(16);

/// The policy of the task merge with two layers of 64 behind each other: what one decision by it
/// costs, looking and evaluating. The second of the layers may remember.
PolicyFile policy_of(const char* second, std::size_t gates) {
  const train::TaskSpec& task = train::task("merge");
  const std::size_t in = Observation(task.observation).size();
  const std::size_t out = Controls(task.controls).size();
  testing::Safetensors file;
  file.word("eyrie_policy", PolicyFile::kVersion)
      .word("observation", task.observation)
      .word("controls", task.controls)
      .word("network", fmt::format("linear a tanh\n{}\nlinear c\n", second))
      .linear("a", in, 64, 1)
      .linear("c", 64, out, 3);
  if (gates == 1)
    file.linear("b", 64, 64, 2);
  else
    file.recurrent("b", gates, 64, 64, 2);
  Diagnostics diagnostics;
  auto policy = PolicyFile::read(file.bytes(), "bench", diagnostics);
  if (!policy)
    throw ConfigError(diagnostics);
  return std::move(*policy);
}

void learned(benchmark::State& state, const char* second, std::size_t gates) {
  const PolicyFile policy = policy_of(second, gates);
  const pilot::testing::Desk d = desk(2);
  const State s = d.state();
  std::vector<float> seen(policy.observation.size()), memory(policy.network.memory());
  std::vector<float> answer(policy.network.outputs());
  measure(state, [&] {
    policy.observation.write(s, seen.data());
    policy.network.evaluate(seen, memory, answer);
    return answer.data();
  });
}
BENCHMARK_CAPTURE(learned, mlp_64_64, "linear b tanh", 1);
BENCHMARK_CAPTURE(learned, gru_64, "gru b", 3);
BENCHMARK_CAPTURE(learned, lstm_64, "lstm b", 4);

}  // namespace

/// Loads data/ from the source tree, wherever it is run.
int main(int count, char** arguments) {
  std::filesystem::current_path(EYRIE_SOURCE_DIR);
  benchmark::Initialize(&count, arguments);
  benchmark::RunSpecifiedBenchmarks();
}
