// SPDX-License-Identifier: MIT
#include "model/sensor/sensor_system.hpp"

#include <algorithm>
#include <numeric>

#include "model/datalink/datalink.hpp"
#include "model/events.hpp"

namespace eyrie::model::sensor {
namespace {

using sim::due;

/// A tracker for those that name none.
constexpr track::Tracker kPlainTracker{};

/// The own missiles in the air that one message can tell of.
constexpr std::size_t kToldShots = 8;

template <class Model>
const Model* chosen(const Shelf<Model>& shelf, const std::optional<std::uint16_t>& index) {
  return index ? &shelf[*index] : nullptr;
}

SensorSuite suite_of(const Library& library, const AircraftType& type, double dt) {
  SensorSuite suite;
  const auto& index = type.index;
  suite.signature = &type.signature;
  suite.radar = chosen(library.radars, index.radar);
  suite.irst = chosen(library.irsts, index.irst);
  suite.rwr = chosen(library.rwrs, index.rwr);
  suite.visual = chosen(library.visuals, index.visual);
  suite.iff = chosen(library.iffs, index.iff);
  suite.datalink = chosen(library.datalinks, index.datalink);
  suite.jammer = chosen(library.jammers, index.jammer);
  suite.tracker = index.tracker ? &library.trackers[*index.tracker] : &kPlainTracker;

  std::uint32_t any = 0;
  const auto steps = [&](double rate) {
    const std::uint32_t period = sim::period_steps(rate, dt).steps;
    any = std::gcd(any, period);
    return sim::Every(period);
  };
  if (suite.radar != nullptr) {
    suite.radar_index = *index.radar;
    suite.detector.emplace(*suite.radar);
    suite.cos_half_azimuth = math::cos(suite.radar->scan_half_azimuth);
    suite.cos_half_beam = math::cos(suite.radar->beam_width / 2);
    suite.scan_steps = steps(suite.radar->scan_rate);
    suite.track_steps = steps(suite.radar->track_rate);
  }
  if (suite.irst != nullptr)
    suite.irst_steps = steps(suite.irst->rate);
  if (suite.rwr != nullptr) {
    suite.rwr_steps = steps(suite.rwr->search_rate);
    suite.seeker_steps = steps(suite.rwr->seeker_rate);
  }
  if (suite.visual != nullptr)
    suite.visual_steps = steps(suite.visual->rate);
  suite.upkeep_steps = steps(suite.tracker->rate);
  if (suite.datalink != nullptr)
    suite.datalink_steps = steps(suite.datalink->rate);
  suite.any_steps = any;
  return suite;
}

void publish(const Self& self) {
  for (const track::TrackNews& news : self.news.items()) {
    sim::Event event{.kind = EventKind::contact,
                     .who = self.id,
                     .whom = news.truth,
                     .place = self.kinematics.position};
    switch (news.what) {
      case track::TrackNews::What::confirmed:
        event.values = {static_cast<float>(news.value), static_cast<float>(news.bits)};
        break;
      case track::TrackNews::What::lost:
        event.kind = EventKind::track_lost;
        event.values = {static_cast<float>(news.value)};
        break;
      case track::TrackNews::What::identified:
        event.kind = EventKind::identified;
        event.values = {static_cast<float>(news.bits), static_cast<float>(news.value)};
        break;
    }
    self.out.emit(event);
  }
}

void perceive_one(const Scene& scene, Self& self) {
  const SensorSuite& suite = self.suite;
  const auto is_due = [step = scene.step, id = self.id](const sim::Every& period) {
    return due(step, id, period);
  };
  const bool upkeep_due = is_due(suite.upkeep_steps);
  const bool privileged = self.fit.privileged != 0;

  // what comes in
  if (suite.radar != nullptr && upkeep_due)
    steer_radar(scene, self);
  if (suite.radar != nullptr && !privileged) {
    if (self.radar.mode == RadarMode::search && is_due(suite.scan_steps))
      scan(scene, self);
    else if (self.radar.mode == RadarMode::track && is_due(suite.track_steps))
      track_target(scene, self);
  }
  if (suite.irst != nullptr && !privileged && is_due(suite.irst_steps))
    search_infrared(scene, self);
  if (suite.visual != nullptr && !privileged && is_due(suite.visual_steps))
    look_around(scene, self);
  if (suite.rwr != nullptr && is_due(suite.rwr_steps))
    listen_for_radars(scene, self);
  if (suite.rwr != nullptr && is_due(suite.seeker_steps) &&
      scene.world.rows(scene.missiles.table) != 0)
    listen_for_seekers(scene, self);

  // what is made of it
  if (!upkeep_due)
    return;
  if (self.fit.flight < scene.library.flights.size())
    read_datalink(scene, self);
  if (privileged) {
    perceive_truth(scene, self);
  } else {
    track::upkeep(self.tracks, self.context(scene.time));
    forget(self.threats, scene.time);
  }
  if (suite.rwr != nullptr)
    forget(self.rwr, *suite.rwr, scene.time);
}

/// What the aircraft in a row tells its flight now.
void report(const Scene& scene, std::size_t row, datalink::DatalinkSent& sent) {
  const auto own = [&](auto column) -> const auto& {
    return scene.world.rows(column)[row];
  };
  std::array<TrackId, kToldShots> shots;
  std::size_t count = 0;
  for (const weapon::MissileState& missile : scene.world.rows(scene.missiles.state))
    if (missile.shooter == scene.ids[row] && count < kToldShots)
      shots[count++] = missile.track;
  std::array<datalink::SharedSeeker, datalink::kSharedSeekers> seekers;
  const std::size_t heard = share(own(scene.aircraft.rwr), scene.time, seekers);
  datalink::transmit(sent,
                     {.time = scene.time,
                      .position = scene.kinematics[row].position,
                      .velocity = scene.kinematics[row].velocity,
                      .fuel = own(scene.aircraft.propulsion).fuel,
                      .target = own(scene.aircraft.request).target,
                      .shot_at = std::span(shots).first(count),
                      .seekers = std::span(seekers).first(heard)},
                     own(scene.aircraft.tracks), *scene.suite(row).tracker);
}

}  // namespace

SensorSystem::SensorSystem(const AircraftColumns& aircraft, const MissileColumns& missiles,
                           std::shared_ptr<const Library> library, double dt)
    : aircraft_(aircraft), missiles_(missiles), library_(std::move(library)) {
  EYRIE_THROW_UNLESS(problems_of(*library_, dt).empty(), "a sensor that does not fit the step");
  for (const Flight& flight : library_->flights)
    EYRIE_THROW_UNLESS(flight.members.size() <= kMaxFlight, "more members than a datalink carries");
  for (std::size_t i = 0; i < library_->aircraft.size(); ++i)
    suites_.push_back(suite_of(*library_, library_->aircraft[i], dt));
  std::uint32_t any = 0;
  for (const SensorSuite& suite : suites_)
    any = std::gcd(any, suite.any_steps.steps());
  any_steps_ = sim::Every(std::max(any, 1u));
}

Scene SensorSystem::scene(const sim::World& world, const sim::StepInfo& info) const {
  return {.library = *library_,
          .suites = suites_,
          .aircraft = aircraft_,
          .missiles = missiles_,
          .world = world,
          .ids = world.ids(aircraft_.table),
          .fit = world.rows(aircraft_.fit),
          .kinematics = world.rows(aircraft_.kinematics),
          .step = info.step,
          .seed = info.seed,
          .time = info.time()};
}

inline std::size_t SensorSystem::first_due(const sim::World& world, std::uint64_t step,
                                           sim::Chunk chunk) const {
  const auto ids = world.ids(aircraft_.table);
  std::size_t row = chunk.begin;
  while (row < chunk.end && !due(step, ids[row], any_steps_))
    ++row;
  return row;
}

void SensorSystem::perceive(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                            sim::Outbox& out) const {
  if (const std::size_t row = first_due(world, info.step, chunk); row < chunk.end)
    perceive_due(world, info, {row, chunk.end}, out);
}

void SensorSystem::perceive_due(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                                sim::Outbox& out) const {
  Scene all = scene(world, info);
  const RowBoxes boxes(all.kinematics);
  all.boxes = &boxes;
  const auto request = std::as_const(world).rows(aircraft_.request);
  const auto radar = world.rows(aircraft_.radar);
  const auto tracks = world.rows(aircraft_.tracks);
  const auto rwr = world.rows(aircraft_.rwr);
  const auto threats = world.rows(aircraft_.threats);
  const auto datalink = world.rows(aircraft_.datalink);
  track::TrackNewsList news;

  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    if (!all.senses(i))
      continue;
    news.clear();
    Self self{.row = i,
              .id = all.ids[i],
              .suite = all.suite(i),
              .fit = all.fit[i],
              .kinematics = all.kinematics[i],
              .request = request[i],
              .radar = radar[i],
              .tracks = tracks[i],
              .rwr = rwr[i],
              .threats = threats[i],
              .datalink = datalink[i],
              .news = news,
              .out = out};
    perceive_one(all, self);
    publish(self);
  }
}

void SensorSystem::act(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                       sim::Outbox&) const {
  if (const std::size_t row = first_due(world, info.step, chunk); row < chunk.end)
    act_due(world, info, {row, chunk.end});
}

void SensorSystem::act_due(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk) const {
  const Scene all = scene(world, info);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    if (!all.senses(i))
      continue;
    const SensorSuite& suite = all.suite(i);
    if (due(info.step, all.ids[i], suite.upkeep_steps))
      radiate(all, i, std::as_const(world).rows(aircraft_.radar)[i],
              std::as_const(world).rows(aircraft_.tracks)[i],
              std::as_const(world).rows(aircraft_.rwr)[i], world.rows(aircraft_.emission)[i]);
    if (suite.datalink != nullptr && due(info.step, all.ids[i], suite.datalink_steps))
      report(all, i, world.rows(aircraft_.sent)[i]);
  }
}

}  // namespace eyrie::model::sensor
