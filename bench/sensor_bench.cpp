// SPDX-License-Identifier: MIT
/// \file  What sensors, tracks and datalink cost: the peer's scene line_abreast with nothing else
/// in it, and the kernels that the cost is made of.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cstdint>
#include <memory>

#include "model/columns.hpp"
#include "model/library.hpp"
#include "model/sensor/sensor_system.hpp"
#include "sim/simulation.hpp"
#include "support/no_allocation.hpp"

namespace {

using namespace eyrie;
using namespace eyrie::model;

/// Straight flight, so that the scene changes as it would.
class StraightOn final : public sim::System {
 public:
  explicit StraightOn(const AircraftColumns& columns) : columns_(columns) {}
  [[nodiscard]] std::string_view name() const override { return "straight on"; }
  [[nodiscard]] TableId table() const override { return columns_.table; }
  void move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
            sim::Outbox&) const override {
    const auto rows = world.rows(columns_.kinematics);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i)
      rows[i].position += info.dt * rows[i].velocity;
  }

 private:
  AircraftColumns columns_;
};

Kinematics flying(double north, double east, bool southbound) {
  Kinematics k;
  k.position = {north, east, -6096};
  k.north = {1, 0, 0};
  k.east = {0, 1, 0};
  k.down = {0, 0, 1};
  k.altitude = 6096;
  k.heading = southbound ? kPi : 0;
  k.speed = si(480, "kt");
  k.velocity = {southbound ? -k.speed : k.speed, 0, 0};
  return k;
}

/// Which sensors the aircraft of a scene carry.
enum Equipment : int { kNone = 0, kRadar = 1, kRwr = 2, kVisual = 4, kDatalink = 8, kAll = 15 };

/// N/2 against N/2, line abreast at 6000 ft, 40 nmi apart, 480 kt, 20 000 ft, flights of four.
struct LineAbreast {
  LineAbreast(std::uint32_t n, int equipment) {
    auto library = std::make_shared<Library>();
    AircraftType type;
    type.label = "fighter";
    type.signature = {.rcs_front = 10, .rcs_side = 40, .rcs_rear = 15};
    const Radar radar{.scan_half_azimuth = radians(30), .scan_rate = 0.25};
    if ((equipment & kRadar) != 0) {
      type.index.radar = library->radars.add("radar", radar);
      type.index.iff = library->iffs.add("iff", {});
    }
    if ((equipment & kRwr) != 0)
      type.index.rwr = library->rwrs.add("rwr", {});
    if ((equipment & kVisual) != 0)
      type.index.visual = library->visuals.add("visual", {});
    if ((equipment & kDatalink) != 0)
      type.index.datalink = library->datalinks.add("datalink", {});
    library->aircraft.add("fighter", type);

    sim::SchemaBuilder schema;
    const AircraftColumns aircraft = AircraftColumns::define(schema, n);
    const MissileColumns missiles = MissileColumns::define(schema, 1);
    library->flights.resize((n + 3) / 4 + 2);
    for (std::uint32_t i = 0; i < n; ++i)
      library->flights[flight(i, n)].members.push_back(PlayerId{i + 1});
    sim::SimulationBuilder builder(schema.build());
    builder.add<sensor::SensorSystem>(aircraft, missiles, library, sim::kDefaultDt);
    builder.add<StraightOn>(aircraft);
    simulation = builder.build();
    world = std::make_unique<sim::World>(simulation->world(1));
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto born = world->spawn(aircraft.table);
      const bool red = i >= n / 2;
      const double east = si(6000, "ft") * (red ? i - n / 2 : i);
      world->rows(aircraft.kinematics)[born->row] = flying(red ? si(40, "nmi") : 0, east, red);
      world->rows(aircraft.fit)[born->row] = {.flight = flight(i, n),
                                              .side = red ? Side::red : Side::blue};
    }
  }
  static std::uint16_t flight(std::uint32_t i, std::uint32_t n) {
    const std::uint32_t half = n / 2;
    return static_cast<std::uint16_t>(i < half ? i / 4 : (half + 3) / 4 + (i - half) / 4);
  }

  std::shared_ptr<const sim::Simulation> simulation;
  std::unique_ptr<sim::World> world;
};

void sensors(benchmark::State& state) {
  const auto n = static_cast<std::uint32_t>(state.range(0));
  const LineAbreast scene(n, static_cast<int>(state.range(1)));
  sim::World world = *scene.world;
  sim::Workspace work(*scene.simulation, 1, 4096);
  for (int i = 0; i < 1000; ++i)  // 20 s: tracks are confirmed and identified
    static_cast<void>(scene.simulation->step(world, work));
  const sim::World warm = world;
  state.SetLabel(fmt::format("hash 0x{:016x}", warm.hash()));
  NoAllocation guard;
  guard.dismiss();
  for (auto _ : state) {
    if (world.step() == warm.step() + 2000) {
      state.PauseTiming();
      world = warm;
      state.ResumeTiming();
    }
    benchmark::DoNotOptimize(scene.simulation->step(world, work));
  }
  state.counters["allocs"] = static_cast<double>(guard.count());
  state.counters["ns_per_player_step"] = benchmark::Counter(
      static_cast<double>(n) * 1e-9,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(sensors)
    ->ArgNames({"n", "equipment"})
    ->Args({2, kAll})
    ->Args({6, kAll})
    ->Args({20, kAll})
    ->Args({100, kAll})
    ->Args({1000, kAll})
    ->Args({6, kNone})
    ->Args({6, kRadar})
    ->Args({6, kRwr})
    ->Args({6, kVisual})
    ->Args({6, kDatalink})
    ->Args({1000, kNone})
    ->Args({1000, kRadar})
    ->Args({1000, kRwr})
    ->Args({1000, kVisual})
    ->Args({1000, kDatalink});

void radar_look(benchmark::State& state) {
  const Radar radar;
  const Kinematics own = flying(0, 0, false), other = flying(60e3, 5e3, true);
  const Signature fighter;
  std::uint64_t step = 0;
  for (auto _ : state) {
    ++step;
    const sensor::Detector detector(radar);
    const double mean = mean_echo(radar, detector, own, fighter, other);
    Draw draw(1, PlayerId{1}, Stream::radar, step, 2);
    if (const auto echo = detector.echo(mean, draw.uniform()))
      benchmark::DoNotOptimize(measure(errors_of(radar, sensor::RadarMode::search, *echo), own,
                                       level_axes(own, own.heading), other, PlayerId{2},
                                       Draw(1, PlayerId{1}, Stream::radar_noise, step, 2)));
  }
}
BENCHMARK(radar_look);

void track_update(benchmark::State& state) {
  const auto contacts = static_cast<std::size_t>(state.range(0));
  const Tracker tracker;
  TrackFile file;
  track::TrackNewsList news;
  std::array<Contact, kMaxTracks> seen;
  double time = 0;
  for (auto _ : state) {
    time += 4;
    for (std::size_t i = 0; i < contacts; ++i) {
      Contact& c = seen[i];
      c.position = {60e3, 2000.0 * static_cast<double>(i), -6000};
      c.line = normalized(c.position, {1, 0, 0});
      c.sigma_along = 50;
      c.sigma_across = 300;
    }
    news.clear();
    track::update(file, {tracker, {}, time, 3, news}, std::span(seen).first(contacts));
    benchmark::DoNotOptimize(file);
  }
}
BENCHMARK(track_update)->Arg(1)->Arg(4)->Arg(16);

}  // namespace

BENCHMARK_MAIN();
