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
    suite.cos_half_azimuth = math::cos(suite.radar->scan_half_azimuth);
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

void use_radar(const Scene& scene, Self& self, bool upkeep_due) {
  if (upkeep_due)
    steer_radar(scene, self);
  if (self.fit.privileged != 0)
    return;
  const RadarMode mode = self.radar.mode;
  if (mode == RadarMode::search && due(scene.step, self.id, self.suite.scan_steps))
    scan(scene, self);
  else if (mode == RadarMode::track && due(scene.step, self.id, self.suite.track_steps))
    track_target(scene, self);
}

void perceive_one(const Scene& scene, Self& self) {
  const SensorSuite& suite = self.suite;
  const bool upkeep_due = due(scene.step, self.id, suite.upkeep_steps);
  const bool privileged = self.fit.privileged != 0;

  // what comes in
  if (suite.radar != nullptr)
    use_radar(scene, self, upkeep_due);
  if (suite.irst != nullptr && !privileged && due(scene.step, self.id, suite.irst_steps))
    search_infrared(scene, self);
  if (suite.visual != nullptr && !privileged && due(scene.step, self.id, suite.visual_steps))
    look_around(scene, self);
  if (suite.rwr != nullptr && due(scene.step, self.id, suite.rwr_steps))
    listen_for_radars(scene, self);
  if (suite.rwr != nullptr && due(scene.step, self.id, suite.seeker_steps))
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

/// The rows of which some sensor is due.
struct Due {
  std::span<const PlayerId> ids;
  std::span<const Fit> fit;
  std::span<const SensorSuite> suites;
  std::uint64_t step;
  std::size_t end;

  /// The first from this row on, or the end.
  [[nodiscard]] std::size_t from(std::size_t row) const {
    while (row < end &&
           (fit[row].remote != 0 || !due(step, ids[row], suites[fit[row].type].any_steps)))
      ++row;
    return row;
  }
};

}  // namespace

SensorSystem::SensorSystem(const AircraftColumns& aircraft, const MissileColumns& missiles,
                           std::shared_ptr<const Library> library, double dt)
    : aircraft_(aircraft), missiles_(missiles), library_(std::move(library)) {
  EYRIE_THROW_UNLESS(problems_of(*library_, dt).empty(), "a sensor that does not fit the step");
  for (const Flight& flight : library_->flights)
    EYRIE_THROW_UNLESS(flight.members.size() <= kMaxFlight, "more members than a datalink carries");
  for (std::size_t i = 0; i < library_->aircraft.size(); ++i)
    suites_.push_back(suite_of(*library_, library_->aircraft[i], dt));
}

Scene SensorSystem::scene(const sim::World& world, const sim::StepInfo& info) const {
  return {.library = *library_,
          .suites = suites_,
          .table = aircraft_.table,
          .world = world,
          .ids = world.ids(aircraft_.table),
          .fit = world.rows(aircraft_.fit),
          .kinematics = world.rows(aircraft_.kinematics),
          .propulsion = world.rows(aircraft_.propulsion),
          .emission = world.rows(aircraft_.emission),
          .missile_ids = world.ids(missiles_.table),
          .missile_kinematics = world.rows(missiles_.kinematics),
          .missile_state = world.rows(missiles_.state),
          .missile_emission = world.rows(missiles_.emission),
          .sent = world.rows(aircraft_.sent),
          .step = info.step,
          .seed = info.seed,
          .time = info.time()};
}

void SensorSystem::perceive(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                            sim::Outbox& out) const {
  const Due due_rows{world.ids(aircraft_.table), world.rows(aircraft_.fit), suites_, info.step,
                     chunk.end};
  const std::size_t first = due_rows.from(chunk.begin);
  if (first == chunk.end)
    return;
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

  for (std::size_t i = first; i < chunk.end; i = due_rows.from(i + 1)) {
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
  const Due due_rows{world.ids(aircraft_.table), world.rows(aircraft_.fit), suites_, info.step,
                     chunk.end};
  const std::size_t first = due_rows.from(chunk.begin);
  if (first == chunk.end)
    return;
  const Scene all = scene(world, info);
  const auto request = std::as_const(world).rows(aircraft_.request);
  const auto radar = std::as_const(world).rows(aircraft_.radar);
  const auto tracks = std::as_const(world).rows(aircraft_.tracks);
  const auto rwr = std::as_const(world).rows(aircraft_.rwr);
  const auto propulsion = std::as_const(world).rows(aircraft_.propulsion);
  const auto emission = world.rows(aircraft_.emission);
  const auto sent = world.rows(aircraft_.sent);

  for (std::size_t i = first; i < chunk.end; i = due_rows.from(i + 1)) {
    const PlayerId id = all.ids[i];
    const SensorSuite& suite = all.suite(i);
    if (due(all.step, id, suite.upkeep_steps))
      emission[i] = radiate(all, i, radar[i], tracks[i], rwr[i]);

    if (suite.datalink == nullptr || !due(all.step, id, suite.datalink_steps))
      continue;
    std::array<TrackId, kToldShots> shots;
    std::size_t count = 0;
    for (const weapon::MissileState& missile : all.missile_state)
      if (missile.shooter == id && count < kToldShots)
        shots[count++] = missile.track;
    std::array<datalink::SharedSeeker, datalink::kSharedSeekers> seekers;
    const std::size_t heard = share(rwr[i], all.time, seekers);
    datalink::transmit(sent[i],
                       {.time = all.time,
                        .position = all.kinematics[i].position,
                        .velocity = all.kinematics[i].velocity,
                        .fuel = propulsion[i].fuel,
                        .target = request[i].target,
                        .shot_at = std::span(shots).first(count),
                        .seekers = std::span(seekers).first(heard)},
                       tracks[i], *suite.tracker);
  }
}

}  // namespace eyrie::model::sensor
