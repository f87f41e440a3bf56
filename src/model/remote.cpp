// SPDX-License-Identifier: MIT
#include "model/remote.hpp"

#include "model/events.hpp"
#include "model/weapon/flyout.hpp"

namespace eyrie::model {
namespace {

constexpr std::array kOrders{
    sim::OrderKind(RemoteOrder::place),    sim::OrderKind(RemoteOrder::motion),
    sim::OrderKind(RemoteOrder::attitude), sim::OrderKind(RemoteOrder::beam),
    sim::OrderKind(RemoteOrder::launch),   sim::OrderKind(RemoteOrder::detonation),
    sim::OrderKind(RemoteOrder::rounds),   sim::OrderKind(RemoteOrder::leave)};

constexpr double kFar = 1e6;      // m from the reference point
constexpr double kFast = 5e3;     // m/s
constexpr double kHard = 1e3;     // m/s^2
constexpr double kLongest = 15;   // s that are reckoned
constexpr double kShotTime = 30;  // s in which who is destroyed was so by the last shot

/// All within; NaN is not.
bool bounded(const auto& numbers, double most) {
  for (const auto x : numbers)
    if (!(std::fabs(x) <= most))
      return false;
  return true;
}
std::array<double, 3> parts(const Vec3& v) {
  return {v.x, v.y, v.z};
}

/// The row of an aircraft or of a missile by its code.
Heard* find(sim::World& world, const AircraftColumns& aircraft, const RemoteColumns& heard,
            PlayerId who) {
  if (const auto row = world.row(aircraft.table, who))
    return std::as_const(world).rows(aircraft.fit)[*row].remote != 0
               ? &world.rows(heard.aircraft)[*row]
               : nullptr;
  for (Heard& missile : world.rows(heard.missiles))
    if (who.value >> 31 != 0 && remote_missile(missile.code) == who)
      return &missile;
  return nullptr;
}
Vec3 along(const Kinematics& k, float azimuth, float elevation) {
  const Axes body = body_axes(k);
  const auto [sa, ca] = math::sin_cos(azimuth);
  const auto [se, ce] = math::sin_cos(elevation);
  return ce * ca * body.forward + ce * sa * body.right - se * body.down;
}

/// Its beam. It rests on whom it was said to; a local direction to him is truer than what was
/// heard.
void point(const Heard& heard, const Kinematics& own, const Kinematics* target,
           Emission& emission) {
  emission.position = own.position;
  emission.boresight = target ? normalized(target->position - own.position, own.north)
                              : along(own, heard.azimuth, heard.elevation);
  emission.dwell = heard.dwell;
  emission.kind = heard.beam;
}

Kinematics nowhere(const Reference& reference) {
  Kinematics k;
  k.position = kNowhere;
  set_vertical(k, reference.vertical_at(k.position));
  return k;
}

void move_rows(std::span<const Heard> heard, std::span<Kinematics> kinematics, double time,
               const Library& library, sim::Chunk chunk, const auto& is_remote) {
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    if (!is_remote(i))
      continue;
    if (heard[i].here != 0)
      reckon(heard[i], time, library.reference, library.environment, kinematics[i]);
    else
      kinematics[i] = nowhere(library.reference);
  }
}

}  // namespace

void reckon(const Heard& h, double time, const Reference& reference, const Environment& environment,
            Kinematics& k) {
  const bool moves = h.algorithm >= 2 && h.algorithm <= 5;
  const bool turns = h.algorithm == 3 || h.algorithm == 4;
  const bool gathers = h.algorithm == 4 || h.algorithm == 5;
  const double t = std::clamp(time - h.time, -kLongest, kLongest);
  const Vec3 acceleration = gathers ? h.acceleration : Vec3{};
  k.position = h.position;
  k.velocity = h.velocity + t * acceleration;
  if (moves)
    k.position += t * h.velocity + t * t / 2 * acceleration;
  const Vertical at = reference.vertical_at(k.position);
  set_vertical(k, at);
  const Vec3 angles = turns ? euler_of(turn(h.spin, t) * attitude_of(h.angles)) : h.angles;
  k.heading = angles.x;
  k.pitch = angles.y;
  k.roll = angles.z;

  const Vec3 wind = environment.wind.at(k.altitude);
  k.speed = norm(k.velocity - from_ned(at, wind));
  k.mach = k.speed / environment.atmosphere.at(k.altitude).speed_of_sound;
  const Vec3 belly = body_axes(k).down;
  k.load_factor = dot(k.down, belly) - dot(acceleration, belly) / kGravity;
}

std::span<const sim::OrderKind> RemoteSystem::accepts() const {
  return kOrders;
}

void RemoteSystem::apply_order(sim::World& world, const sim::StepInfo& info,
                               const sim::Order& order, sim::Outbox& out) const {
  Heard* const heard = find(world, aircraft_, heard_, order.player);
  const bool flies = heard && heard->ended == 0;
  switch (order.kind.as<RemoteOrder>()) {
    case RemoteOrder::launch:
      return launch(world, info, order, out);
    case RemoteOrder::detonation:
      return detonate(world, info, order, out);
    case RemoteOrder::leave:
      return leave(world, info, order, out);
    case RemoteOrder::rounds:
      if (const auto [shooter, damage] = order.as<RemoteRounds>(); damage > 0 && damage <= 100)
        if (const auto row = world.row(aircraft_.table, order.player);
            row && world.rows(aircraft_.fit)[*row].remote == 0)
          out.emit({.kind = EventKind::hit,
                    .who = shooter,
                    .whom = order.player,
                    .place = world.rows(aircraft_.kinematics)[*row].position,
                    .values = {damage, kNothing}});
      return;
    case RemoteOrder::place:
      if (const auto said = order.as<RemotePlace>(); flies && bounded(parts(said.position), kFar) &&
                                                     bounded(std::array{said.since}, kLongest)) {
        heard->position = said.position;
        heard->time = info.time() + said.since;
        heard->algorithm = said.algorithm;
        heard->here = 1;
      }
      return;
    case RemoteOrder::motion:
      if (const auto said = order.as<RemoteMotion>();
          flies && bounded(said.velocity, kFast) && bounded(said.acceleration, kHard)) {
        heard->velocity = wide(said.velocity);
        heard->acceleration = wide(said.acceleration);
      }
      return;
    case RemoteOrder::attitude:
      if (const auto said = order.as<RemoteAttitude>();
          flies && bounded(said.angles, 7) && bounded(said.spin, 100)) {
        heard->angles = wide(said.angles);
        heard->spin = wide(said.spin);
      }
      return;
    case RemoteOrder::beam:
      if (const auto said = order.as<RemoteBeam>();
          flies && bounded(std::array{said.azimuth, said.elevation}, 7) &&
          said.kind <= EmissionKind::missile_seeker) {
        heard->azimuth = said.azimuth;
        heard->elevation = said.elevation;
        heard->dwell = said.dwell;
        heard->beam = said.kind;
        heard->jams = said.jams != 0 ? 1 : 0;
      }
  }
}

void RemoteSystem::launch(sim::World& world, const sim::StepInfo& info, const sim::Order& order,
                          sim::Outbox& out) const {
  const auto said = order.as<RemoteLaunch>();
  if (order.player.value >> 31 == 0 || said.type >= library_->missiles.size() ||
      said.side > Side::red || !bounded(std::array{said.range}, 1e7))
    return;
  if (Heard* known = find(world, aircraft_, heard_, order.player)) {
    const auto row = static_cast<std::size_t>(known - world.rows(heard_.missiles).data());
    world.rows(missiles_.state)[row].shooter = said.shooter;
    world.rows(missiles_.state)[row].intended = said.target;
    return;
  }
  const auto born = world.spawn(missiles_.table);
  if (!born)
    return;
  missiles_.set_defaults(world, born->row);
  Kinematics& k = world.rows(missiles_.kinematics)[born->row];
  const auto shooter = world.row(aircraft_.table, said.shooter);
  k = shooter ? world.rows(aircraft_.kinematics)[*shooter] : nowhere(library_->reference);
  world.rows(missiles_.state)[born->row] = {.launch_time = info.time(),
                                            .shooter = said.shooter,
                                            .intended = said.target,
                                            .type = said.type,
                                            .side = said.side,
                                            .remote = 1};
  world.rows(heard_.missiles)[born->row] = {.position = k.position,
                                            .velocity = k.velocity,
                                            .angles = {k.heading, k.pitch, k.roll},
                                            .time = info.time(),
                                            .code = order.player.value & 0x7FFF'FFFF,
                                            .here = shooter ? std::uint8_t{1} : std::uint8_t{0},
                                            .algorithm = 2};
  out.emit({.kind = EventKind::launch,
            .detail = said.shooter.value,
            .who = born->id,
            .whom = said.target,
            .place = k.position,
            .values = {said.range, static_cast<float>(said.type)}});
}

void RemoteSystem::detonate(sim::World& world, const sim::StepInfo& info, const sim::Order& order,
                            sim::Outbox& out) const {
  const auto said = order.as<RemoteDetonation>();
  if (said.type >= library_->missiles.size() || !bounded(said.place, 2e7) ||
      !(said.miss >= 0 && said.miss <= kFar))
    return;
  PlayerId missile{};
  const auto heard = world.rows(heard_.missiles);
  for (std::size_t row = 0; row < heard.size(); ++row)
    if (heard[row].code != 0 && remote_missile(heard[row].code) == order.player) {
      if (std::exchange(heard[row].ended, std::uint8_t{1}) != 0)
        return;
      missile = world.ids(missiles_.table)[row];
    }
  sim::Event event{.kind = EventKind::timeout,
                   .who = missile,
                   .whom = said.target,
                   .place = wide(said.place),
                   .values = {static_cast<float>(std::min<std::uint8_t>(said.ending, 5)), 0}};
  const auto target = world.row(aircraft_.table, said.target);
  if (!target || said.lethal == 0) {
    if (missile)
      out.emit(event);
    return;
  }
  // whose the target is says what became of it
  const bool ours = world.rows(aircraft_.fit)[*target].remote == 0;
  const double pk = weapon::kill_probability(library_->missiles[said.type].warhead, said.miss);
  Draw draw(info.seed, missile ? missile : said.target, Stream::lethality, info.step);
  const double drawn = ours ? draw.uniform() : -1;
  event.kind = EventKind::detonation;
  event.values = {said.miss, static_cast<float>(pk), static_cast<float>(drawn)};
  if (missile)
    out.emit(event);
  if (ours && drawn < pk)
    out.emit({.kind = EventKind::hit,
              .detail = missile.value,
              .who = said.shooter,
              .whom = said.target,
              .place = event.place,
              .values = {1, said.miss}});
}

void RemoteSystem::leave(sim::World& world, const sim::StepInfo& info, const sim::Order& order,
                         sim::Outbox& out) const {
  Heard* heard = find(world, aircraft_, heard_, order.player);
  if (!heard || heard->ended != 0)
    return;
  const RemoteEnd end = order.as<RemoteLeave>().end;
  const auto row = world.row(aircraft_.table, order.player);
  if (!row) {  // a missile
    const auto i = static_cast<std::size_t>(heard - world.rows(heard_.missiles).data());
    const weapon::MissileState& state = world.rows(missiles_.state)[i];
    heard->ended = 1;
    out.emit({.kind = EventKind::timeout,
              .who = world.ids(missiles_.table)[i],
              .whom = state.intended,
              .place = world.rows(missiles_.kinematics)[i].position,
              .values = {static_cast<float>(weapon::MissileEnd::lost),
                         static_cast<float>(info.time() - state.launch_time)}});
    return;
  }
  if (end == RemoteEnd::vanished) {
    heard->here = 0;
    heard->beam = EmissionKind::none;
    heard->jams = 0;
    return;
  }
  heard->ended = 1;
  const bool shot = info.time() - heard->shot_time < kShotTime && heard->shooter;
  const Vec3 place = world.rows(aircraft_.kinematics)[*row].position;
  if (end == RemoteEnd::destroyed && shot)
    out.emit({.kind = EventKind::kill,
              .detail = heard->missile.value,
              .who = heard->shooter,
              .whom = order.player,
              .place = place});
  else
    out.emit({.kind = end == RemoteEnd::gone ? EventKind::home : EventKind::loss,
              .who = order.player,
              .place = place});
}

void RemoteSystem::act(sim::World& world, const sim::StepInfo&, sim::Chunk chunk,
                       sim::Outbox&) const {
  const auto fit = world.rows(aircraft_.fit);
  const auto kinematics = std::as_const(world).rows(aircraft_.kinematics);
  const auto heard = world.rows(heard_.aircraft);
  const auto emissions = world.rows(aircraft_.emission);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    if (fit[i].remote == 0)
      continue;
    const Heard& h = heard[i];
    const AircraftType& type = library_->aircraft[fit[i].type];
    Emission emission{.boresight = kinematics[i].north, .side = fit[i].side};
    if (h.jams != 0 && type.index.jammer)
      emission.jamming = library_->jammers[*type.index.jammer].density();
    emission.position = kinematics[i].position;
    if (h.beam != EmissionKind::none && type.index.radar) {
      const Radar& radar = library_->radars[*type.index.radar];
      const auto target = world.row(aircraft_.table, h.dwell);
      point(h, kinematics[i], target ? &kinematics[*target] : nullptr, emission);
      emission.type = *type.index.radar;
      emission.figure = emission_figure(radar.reference_range, radar.reference_rcs);
      const bool tracks = h.beam == EmissionKind::track;
      emission.cos_half_angle = math::cos(tracks ? radar.beam_width / 2 : radar.scan_half_azimuth);
      if (!tracks)
        sensor::sweep(radar, kinematics[i].down, emission);
    }
    emissions[i] = emission;
  }
}

void RemoteSystem::move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                        sim::Outbox&) const {
  const auto fit = std::as_const(world).rows(aircraft_.fit);
  move_rows(std::as_const(world).rows(heard_.aircraft), world.rows(aircraft_.kinematics),
            info.time() + info.dt, *library_, chunk, [&](std::size_t i) { return fit[i].remote; });
}

void RemoteSystem::commit(sim::World& world, const sim::StepInfo& info,
                          std::span<const sim::Event> events, sim::CommitContext& context) const {
  const auto fit = world.rows(aircraft_.fit);
  for (const sim::Event& e : events) {
    const bool shot = e.kind == EventKind::detonation || e.kind == EventKind::gun_burst;
    if (!shot && e.kind != EventKind::kill)
      continue;
    const auto row = world.row(aircraft_.table, e.whom);
    if (!row || fit[*row].remote == 0)
      continue;
    if (e.kind == EventKind::kill) {
      context.remove(aircraft_.table, *row);
    } else if (e.kind == EventKind::detonation || e.values[2] > 0) {
      Heard& heard = world.rows(heard_.aircraft)[*row];
      const auto missile = e.kind == EventKind::detonation ? world.row(missiles_.table, e.who)
                                                           : std::optional<std::uint32_t>{};
      heard.shot_time = info.time();
      heard.shooter = missile ? world.rows(missiles_.state)[*missile].shooter : e.who;
      heard.missile = missile ? e.who : PlayerId{};
    }
  }
}

void RemoteMissiles::act(sim::World& world, const sim::StepInfo&, sim::Chunk chunk,
                         sim::Outbox&) const {
  const auto states = std::as_const(world).rows(missiles_.state);
  const auto kinematics = std::as_const(world).rows(missiles_.kinematics);
  const auto heard = std::as_const(world).rows(heard_);
  const auto emissions = world.rows(missiles_.emission);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const weapon::SeekerType& seeker = library_->missiles[states[i].type].seeker;
    if (states[i].remote == 0)
      continue;
    emissions[i] = {};
    if (heard[i].beam == EmissionKind::none || seeker.kind != weapon::SeekerKind::radar)
      continue;
    point(heard[i], kinematics[i], nullptr, emissions[i]);
    emissions[i].kind = EmissionKind::missile_seeker;
    emissions[i].cos_half_angle = math::cos(seeker.field_of_view / 2);
    emissions[i].figure = emission_figure(seeker.detection_range, seeker.reference_signature);
    emissions[i].type = states[i].type;
    emissions[i].side = states[i].side;
  }
}

void RemoteMissiles::move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                          sim::Outbox&) const {
  const auto states = std::as_const(world).rows(missiles_.state);
  move_rows(std::as_const(world).rows(heard_), world.rows(missiles_.kinematics),
            info.time() + info.dt, *library_, chunk,
            [&](std::size_t i) { return states[i].remote; });
}

}  // namespace eyrie::model
