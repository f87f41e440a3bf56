// SPDX-License-Identifier: MIT
/// \file  A flight by the clock: line_abreast with everything that is recorded, and Tacviews that
/// watch, as `eyrie fly --tacview` makes it, or viewers, as `eyrie serve` does. Arguments:
/// aircraft, clients. It takes EYRIE_BENCH_SECONDS, 60 if that is not set. Times are ms: how late
/// frames of 20 ms began.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <thread>
#include <vector>

#include "line_abreast.hpp"
#include "live/exercise.hpp"
#include "net/precedence.hpp"
#include "net/telemetry_host.hpp"
#include "record/acmi.hpp"
#include "record/event_table.hpp"
#include "record/run_file.hpp"
#include "scenario/mission.hpp"
#include "support/live_viewer.hpp"
#include "support/tcp_client.hpp"

namespace {

using namespace eyrie;

double seconds() {
  const char* set = std::getenv("EYRIE_BENCH_SECONDS");
  return set ? std::atof(set) : 60;
}

void count(benchmark::State& state, const net::Pacing& pacing) {
  state.counters["missed"] = static_cast<double>(pacing.missed());
  state.counters["p50"] = pacing.late().percentile(0.5) * 1e3;
  state.counters["p99"] = pacing.late().percentile(0.99) * 1e3;
  state.counters["p99.9"] = pacing.late().percentile(0.999) * 1e3;
  state.counters["max"] = pacing.late().max() * 1e3;
  state.counters["load_%"] = 100 * pacing.load();
  state.counters["most_%"] = 100 * pacing.work().max() / pacing.frame();
}

void once_each(benchmark::internal::Benchmark* flown) {
  for (const auto& [aircraft, clients] : {std::pair{6, 1}, {100, 0}, {100, 3}, {1000, 3}})
    flown->Args({aircraft, clients});
  flown->Iterations(1)->UseRealTime()->Unit(benchmark::kSecond);
}

void live(benchmark::State& state) {
  const auto scene = bench::line_abreast(static_cast<int>(state.range(0)), true);
  const auto folder = std::filesystem::temp_directory_path() / "eyrie-live-bench";
  std::filesystem::create_directories(folder);
  for (auto _ : state) {
    disk::Sink run(folder / "run.eyrie"), events(folder / "events.csv"),
        flight(folder / "flight.acmi");
    net::TelemetryHost host({});
    record::AcmiWriter acmi(
        *scene,
        [&](std::string_view lines) {
          flight.write(lines);
          host.send(lines, host.wanted() ? acmi.whole() : "");
        },
        record::AcmiWriter::kWatched);
    record::EventsCsv csv(*scene, events);
    record::RunFileWriter recorder(run, record::run_file_of(*scene, 1, "bench"));
    std::vector<std::size_t> got(static_cast<std::size_t>(state.range(1)));
    std::vector<std::thread> clients;
    for (std::size_t& bytes : got)
      clients.emplace_back([&bytes, client = test::join_telemetry(host.at().port)]() mutable {
        bytes = client.read_all().size();
      });
    while (host.counts().joined < got.size())
      std::this_thread::yield();

    scenario::Mission mission(scene, 1, seconds());
    for (sim::Observer* o : std::initializer_list<sim::Observer*>{&csv, &acmi, &recorder})
      mission.run().attach(*o);
    net::Pacing pacing(mission.run().simulation().dt(), net::Clock::now());
    net::Precedence precedence;
    for (bool more = true; more;) {
      precedence.sleep_until(pacing.due(), [] { return false; });
      const auto begun = net::Clock::now();
      precedence.ask(pacing.is_kept(begun));
      more = mission.step();
      if (more)
        pacing.made(begun, net::Clock::now());
    }
    mission.run().finish();
    host.close(std::chrono::seconds(1));
    for (std::thread& client : clients)
      client.join();
    if (std::any_of(got.begin(), got.end(), [&](std::size_t n) { return n != flight.size(); }))
      state.SkipWithError("a client has not got everything");

    count(state, pacing);
    state.counters["kB/s"] = static_cast<double>(host.counts().bytes) / seconds() / 1e3 /
                             std::max(1.0, double(got.size()));
  }
  std::filesystem::remove_all(folder);
}
BENCHMARK(live)->Apply(once_each);

/// What a viewer gets, besides the first message.
std::size_t look(std::uint16_t port) {
  test::LiveChannel channel(port);
  std::size_t bytes = 0;
  for (;;) {
    const auto [binary, data] = channel.next();
    if (!binary)
      bytes += data.size();
    if (!binary && nlohmann::json::parse(data).value("outcome", "running") != "running")
      return bytes;
  }
}

void serve(benchmark::State& state) {
  const auto scene = bench::line_abreast(static_cast<int>(state.range(0)), true);
  const auto folder = std::filesystem::temp_directory_path() / "eyrie-live-bench";
  std::filesystem::create_directories(folder);
  for (auto _ : state) {
    disk::Sink run(folder / "run.eyrie"), events(folder / "events.csv"),
        flight(folder / "flight.acmi");
    record::AcmiWriter acmi(*scene, [&](std::string_view lines) { flight.write(lines); });
    record::EventsCsv csv(*scene, events);
    const record::RunFile head = record::run_file_of(*scene, 1, "bench");
    record::RunFileWriter recorder(run, head);
    scenario::Mission mission(scene, 1, seconds());
    for (sim::Observer* o : std::initializer_list<sim::Observer*>{&csv, &acmi, &recorder})
      mission.run().attach(*o);
    live::Exercise exercise(mission, head, {}, {});
    std::vector<std::size_t> got(static_cast<std::size_t>(state.range(1)));
    std::vector<std::thread> viewers;
    for (std::size_t& bytes : got)
      viewers.emplace_back([&bytes, port = exercise.host().at().port] { bytes = look(port); });
    while (exercise.host().counts().viewers < got.size())
      std::this_thread::yield();
    exercise.fly([] { return false; });
    for (std::thread& viewer : viewers)
      viewer.join();
    mission.run().finish();
    count(state, exercise.pacing());
    if (!got.empty())
      state.counters["kB/s"] = static_cast<double>(got.front()) / seconds() / 1e3;
  }
  std::filesystem::remove_all(folder);
}
BENCHMARK(serve)->Apply(once_each);

}  // namespace

BENCHMARK_MAIN();
