// SPDX-License-Identifier: MIT
#include "model/flight/flight_system.hpp"

#include <cstring>

#include "model/events.hpp"
#include "model/flight/abreast.hpp"
#include "model/flight/collision.hpp"

namespace eyrie::model::flight {
namespace {

constexpr std::size_t kAbreast = 32;

std::size_t station_index(const weapon::Station& station) {
  return station.store * std::size_t{256} + station.count;
}

}  // namespace

Kinematics placed(const Reference& reference, const Environment& environment, const Vec3& position,
                  double heading, double speed) {
  Kinematics k;
  k.position = position;
  set_vertical(k, reference.vertical_at(position));
  const Vec3 wind = environment.wind.at(k.altitude);
  const auto [sine, cosine] = math::sin_cos(heading);
  k.heading = wrap_pi(heading);
  k.speed = speed;
  k.velocity = (speed * cosine + wind.x) * k.north + (speed * sine + wind.y) * k.east;
  k.mach = speed / environment.atmosphere.at(k.altitude).speed_of_sound;
  return k;
}

FlightSystem::FlightSystem(const AircraftColumns& columns, std::shared_ptr<const Library> library,
                           std::uint32_t period)
    : columns_(columns), library_(std::move(library)), period_(period) {
  for (std::size_t i = 0; i < library_->airframes.size(); ++i)
    models_.emplace_back(library_->airframes[i]);
  for (const Flight& flight : library_->flights)
    routes_.emplace_back(flight.routes);
  routes_.emplace_back();
  loads_.resize(station_index({static_cast<std::uint8_t>(library_->missiles.size()), 255}) + 1,
                math::Lanes<2>(0));
  for (std::size_t i = 0; i < library_->missiles.size(); ++i)
    for (std::size_t count = 0; count <= 255; ++count)
      loads_[station_index({static_cast<std::uint8_t>(i + 1), static_cast<std::uint8_t>(count)})] =
          math::Lanes<2>(static_cast<double>(count)) *
          math::Lanes<2>(math::Lanes<2>::Vector{library_->missiles[i].motor.launch_mass(),
                                                library_->missiles[i].carriage_drag_area});
  for (std::size_t i = 0; i < library_->aircraft.size(); ++i)
    EYRIE_THROW_UNLESS(library_->aircraft[i].index.airframe < models_.size(),
                       "an aircraft without an airframe");
}

Load FlightSystem::load_of(const weapon::Stores& stores) const {
  constexpr std::size_t kTogether = sizeof(std::uint64_t) / sizeof(weapon::Station);
  static_assert(weapon::kMaxStations % kTogether == 0);
  math::Lanes<2> load(0);
  for (std::size_t i = 0; i < weapon::kMaxStations; i += kTogether) {
    std::uint64_t stations = 0;
    std::memcpy(&stations, &stores.stations[i], sizeof stations);
    for (std::size_t next = i; stations != 0 && next < i + kTogether; ++next)
      load += loads_[station_index(stores.stations[next])];
  }
  return {.mass = load.v[0], .drag_area = load.v[1]};
}

void FlightSystem::move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                        sim::Outbox& out) const {
  move_together(std::array{sim::Share{&world, info, chunk, &out}});
}

void FlightSystem::move_together(std::span<const sim::Share> shares) const {
  if (shares.empty())
    return;
  const Sky sky{library_->reference, library_->environment, shares.front().info.dt};
  /// One of those who fly at once.
  struct Seat {
    Flyer flyer;
    sim::Outbox* out;
    PlayerId who;
  };
  std::array<Seat, kAbreast> seats;
  std::array<Flyer*, kAbreast> abreast;  // those of point_mass
  std::size_t seated = 0, count = 0;
  const auto fly_all = [&] {
    // who aims is steered by other equations: lanes of one kind leave out those of the other
    const auto flyers = std::span(abreast).first(count);
    std::partition(flyers.begin(), flyers.end(),
                   [](const Flyer* f) { return f->command->mode == AutopilotMode::aim; });
    fly(sky, flyers);
    for (const Seat& seat : std::span(seats).first(seated))
      if (seat.flyer.ran_dry) [[unlikely]]
        seat.out->emit({.kind = EventKind::fuel_out,
                        .who = seat.who,
                        .place = seat.flyer.kinematics->position});
    seated = count = 0;
  };
  for (const sim::Share& share : shares) {
    sim::World& world = *share.world;
    const auto ids = world.ids(columns_.table);
    const auto fit = world.rows(columns_.fit);
    const auto command = world.rows(columns_.command);
    const auto stores = world.rows(columns_.stores);
    const auto kinematics = world.rows(columns_.kinematics);
    const auto flying = world.rows(columns_.flying);
    const auto propulsion = world.rows(columns_.propulsion);
    const double time = share.info.time();
    for (std::size_t i = share.chunk.begin; i < share.chunk.end; ++i) {
      if (fit[i].remote != 0)
        continue;
      const AircraftType& type = library_->aircraft[fit[i].type];
      Seat& seat = seats[seated];
      seat.out = share.out;
      seat.who = ids[i];
      Flyer& f = seat.flyer;
      f.model = &models_[type.index.airframe];
      f.kinematics = &kinematics[i];
      f.flying = &flying[i];
      f.propulsion = &propulsion[i];
      f.command = &command[i];
      f.routes = routes_[std::min<std::size_t>(fit[i].flight, routes_.size() - 1)];
      f.time = time;
      if (type.dynamics == Dynamics::laero) {
        fly_laero(sky, f);
      } else {
        f.load = load_of(stores[i]);
        f.tells_energy = sim::due(share.info.step + 1, ids[i], period_);
        abreast[count++] = &f;
      }
      if (++seated == kAbreast)
        fly_all();
    }
  }
  fly_all();
}

void FlightSystem::interact(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                            sim::Outbox& out) const {
  const auto kinematics = world.rows(columns_.kinematics);
  const auto crash = [&](std::size_t i, PlayerId into) {
    if (world.rows(columns_.fit)[i].remote == 0)
      out.emit({.kind = EventKind::crash,
                .who = world.ids(columns_.table)[i],
                .whom = into,
                .place = kinematics[i].position});
  };
  for (std::size_t i = chunk.begin; i < chunk.end; ++i)
    if (kinematics[i].altitude < 0) [[unlikely]]
      crash(i, {});

  // ten times a second, over the way flown since the last time
  const auto every = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(0.1 / info.dt + 0.5));
  const auto flown = std::min<std::uint64_t>(every, info.step + 1);
  if (info.step % every == 0)
    for_each_collision(
        kinematics, chunk.begin, chunk.end, static_cast<double>(flown) * info.dt,
        [&](std::size_t i, std::size_t other) { crash(i, world.ids(columns_.table)[other]); });
}

}  // namespace eyrie::model::flight
