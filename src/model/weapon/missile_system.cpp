// SPDX-License-Identifier: MIT
#include "model/weapon/systems.hpp"

#include "model/events.hpp"
#include "model/weapon/flyout.hpp"
#include "model/weapon/homing.hpp"
#include "sim/system.hpp"

namespace eyrie::model::weapon {

namespace {

/// m/s, how fast a missile and an aircraft may close: twice what the motor gives is room for their
/// own speeds where it gives 2 km/s or more, and less gives no more than 4 km/s.
double fastest_closing(const Motor& motor) {
  return std::max(2 * motor.total_impulse() / std::ranges::min(motor.mass.values()), 4000.0);
}

/// s, so long a fuze does not look at the aircraft that it was released from, which is where it is.
constexpr double kLeaves = 1;

std::uint32_t link_period(double interval, double dt) {
  return static_cast<std::uint32_t>(std::max(std::nearbyint(interval / dt), 1.0));
}

/// Who passes within the fuze's range in this step, the nearest first.
struct Victim {
  std::uint32_t row = 0;
  ClosestApproach nearest;
};
std::optional<Victim> fuze_scan(const Warhead& warhead, double fastest, const Kinematics& k,
                                const TargetScene& scene, double time, double dt,
                                MissileState& state) {
  const std::span<const Kinematics> others = scene.kinematics;
  std::optional<Victim> victim;
  double nearest_other = std::numeric_limits<double>::infinity();
  for (std::uint32_t row = 0; row < others.size(); ++row) {
    const Vec3 apart = others[row].position - k.position;
    const double distance2 = norm2(apart);
    nearest_other = std::min(nearest_other, distance2);
    const double reach = warhead.fuze_range + fastest * dt;
    if (distance2 > reach * reach)
      continue;
    if (scene.ids[row] == state.shooter && time - state.launch_time < kLeaves)
      continue;
    const Passage pass = passage(apart, others[row].velocity - k.velocity, dt);
    if (pass.passing && pass.nearest.distance <= warhead.fuze_range &&
        (!victim || pass.nearest.distance < victim->nearest.distance))
      victim = Victim{row, pass.nearest};
  }
  // nobody can be here before: until then there is nothing to scan
  const double free = std::sqrt(nearest_other) - warhead.fuze_range;
  state.next_fuze_scan = time + std::clamp(free / fastest - dt, 0.0, 3600.0);
  return victim;
}

/// Whether a missile passes the towed decoy of aircraft `row` in this step, within its fuze's
/// range.
bool passes_decoy(const Warhead& warhead, const Kinematics& k, const TargetScene& scene,
                  std::size_t row, double dt) {
  const auto tow = scene.towed(row);
  if (!tow)
    return false;
  const Kinematics& target = scene.kinematics[row];
  const Passage pass =
      passage(target.position + tow->offset - k.position, target.velocity - k.velocity, dt);
  return pass.passing && pass.nearest.distance <= warhead.fuze_range;
}

}  // namespace

MissileSystem::MissileSystem(const AircraftColumns& aircraft, const MissileColumns& missiles,
                             std::shared_ptr<const Library> library, double dt)
    : aircraft_(aircraft), missiles_(missiles), library_(std::move(library)) {
  for (std::size_t i = 0; i < library_->missiles.size(); ++i) {
    const sim::Period period = sim::period_steps(library_->missiles[i].seeker.look_rate, dt);
    EYRIE_THROW_UNLESS(period, "the look rate of a seeker does not divide the step rate");
    look_period_.push_back(period.steps);
    fastest_closing_.push_back(fastest_closing(library_->missiles[i].motor));
  }
}

void MissileSystem::perceive(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                             sim::Outbox& out) const {
  const auto ids = world.ids(missiles_.table);
  const auto states = world.rows(missiles_.state);
  const auto kinematics = world.rows(missiles_.kinematics);
  const TargetScene scene = TargetScene::of(world, aircraft_, *library_, info.time());
  const double time = info.time();

  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    MissileState& state = states[i];
    if (state.remote != 0)
      continue;
    const Kinematics& k = kinematics[i];
    const MissileType& type = library_->missiles[state.type];
    if (switch_on(type, k, time, state))
      out.emit({.kind = EventKind::seeker_active,
                .who = ids[i],
                .whom = state.intended,
                .place = k.position,
                .values = {static_cast<float>(norm(believed_position(state, time) - k.position))}});
    if (state.active == 0 || !sim::due(info.step, ids[i], look_period_[state.type]))
      continue;
    const Draw noise(info.seed, ids[i], Stream::seeker, info.step);
    const DecoyLook decoy = look_at_decoys(type, k, time, scene, info.seed, ids[i], noise, state);
    if (decoy == DecoyLook::fell)
      out.emit({.kind = EventKind::decoyed,
                .who = ids[i],
                .whom = state.seen,
                .place = k.position,
                .values = {type.seeker.kind == SeekerKind::radar ? 1.0F : 2.0F}});
    if (decoy != DecoyLook::none)
      continue;
    if (const auto seen = look(type, k, time, scene, noise, state))
      out.emit({.kind = EventKind::seeker_acquired,
                .who = ids[i],
                .whom = seen->id,
                .place = k.position,
                .values = {static_cast<float>(seen->los.range)}});
  }
}

void MissileSystem::decide(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                           sim::Outbox&) const {
  const auto ids = world.ids(missiles_.table);
  const auto states = world.rows(missiles_.state);
  const auto kinematics = world.rows(missiles_.kinematics);
  const auto tracks = world.rows(aircraft_.tracks);

  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    MissileState& state = states[i];
    if (state.remote != 0)
      continue;
    const MissileType& type = library_->missiles[state.type];
    // midcourse: the shooter must be alive and still hold the track
    if (const auto& interval = type.guidance.link_interval;
        interval && sim::due(info.step, ids[i], link_period(*interval, info.dt)))
      if (const auto shooter = world.row(aircraft_.table, state.shooter))
        if (const Track* track = find(tracks[*shooter], state.track)) {
          state.track = track->id;  // another one if the two were merged
          hear(*track, state);
        }
    state.wanted = guide(type, kinematics[i], info.time(), state);
  }
}

void MissileSystem::act(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                        sim::Outbox&) const {
  const auto states = world.rows(missiles_.state);
  const auto kinematics = world.rows(missiles_.kinematics);
  const auto emissions = world.rows(missiles_.emission);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const MissileState& state = states[i];
    const MissileType& type = library_->missiles[state.type];
    if (state.active == 0 || type.seeker.kind != SeekerKind::radar || state.remote != 0)
      continue;  // a missile that was silent at birth has an empty row
    const Kinematics& k = kinematics[i];
    const bool locked = state.locked != 0;
    emissions[i] = {
        .position = k.position,
        .boresight =
            locked ? sight_at(state, info.time())
                   : normalized(believed_position(state, info.time()) - k.position, state.sight),
        .cos_half_angle = math::cos(type.seeker.field_of_view / 2),
        .figure = emission_figure(type.seeker.detection_range, type.seeker.reference_signature),
        .dwell = locked ? state.seen : PlayerId{},
        .type = state.type,
        .kind = EmissionKind::missile_seeker,
        .side = state.side};
  }
}

void MissileSystem::move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                         sim::Outbox&) const {
  const auto states = world.rows(missiles_.state);
  const auto kinematics = world.rows(missiles_.kinematics);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i)
    if (states[i].remote == 0)
      move_missile(library_->missiles[states[i].type], *library_, info.time(), info.dt,
                   kinematics[i], states[i]);
}

void MissileSystem::interact(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                             sim::Outbox& out) const {
  const auto ids = world.ids(missiles_.table);
  const auto states = world.rows(missiles_.state);
  const auto kinematics = world.rows(missiles_.kinematics);
  const double time = info.time() + info.dt;  // where everybody is now
  const TargetScene scene = TargetScene::of(world, aircraft_, *library_, time);

  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    MissileState& state = states[i];
    if (state.remote != 0)
      continue;
    const Kinematics& k = kinematics[i];
    const MissileType& type = library_->missiles[state.type];
    const double age = time - state.launch_time;

    // fuze
    if (age >= type.warhead.arming_time && time >= state.next_fuze_scan)
      if (const auto victim = fuze_scan(type.warhead, fastest_closing_[state.type], k, scene, time,
                                        info.dt, state)) {
        const PlayerId whom = scene.ids[victim->row];
        const double miss = victim->nearest.distance;
        const double pk = kill_probability(type.warhead, miss);
        Draw draw(info.seed, ids[i], Stream::lethality, info.step);
        const bool theirs = scene.fit[victim->row].remote != 0;
        const double drawn = theirs ? -1 : draw.uniform();
        const Vec3 place = k.position + victim->nearest.time * k.velocity;
        out.emit({.kind = EventKind::detonation,
                  .who = ids[i],
                  .whom = whom,
                  .place = place,
                  .values = {static_cast<float>(miss), static_cast<float>(pk),
                             static_cast<float>(drawn)}});
        if (drawn < pk && !theirs)
          out.emit({.kind = EventKind::hit,
                    .detail = ids[i].value,
                    .who = state.shooter,
                    .whom = whom,
                    .place = place,
                    .values = {1, static_cast<float>(miss)}});
        continue;
      }

    // the end without it
    MissileEnd end = end_of(type, k, state, time);
    if (const auto row = world.row(aircraft_.table, state.seen);
        row && age >= type.warhead.arming_time &&
        passes_decoy(type.warhead, k, scene, *row, info.dt))
      end = MissileEnd::decoy;
    if (end != MissileEnd::none)
      out.emit({.kind = EventKind::timeout,
                .who = ids[i],
                .whom = end == MissileEnd::decoy ? state.seen : state.intended,
                .place = k.position,
                .values = {static_cast<float>(end), static_cast<float>(age)}});
  }
}

void MissileSystem::commit(sim::World&, const sim::StepInfo&, std::span<const sim::Event> events,
                           sim::CommitContext& context) const {
  for (const sim::Event& event : events)
    if (event.kind == EventKind::detonation || event.kind == EventKind::timeout)
      context.remove(event.who);
}

void move_missile(const MissileType& type, const Library& library, double time, double dt,
                  Kinematics& k, MissileState& state) {
  const Air air = library.environment.atmosphere.at(k.altitude);
  const Vec3 wind = from_ned(k, library.environment.wind.at(k.altitude));
  Flyout flyout{.position = k.position, .velocity = k.velocity, .lift = state.lift};
  fly(type, air, wind, k.down, time - state.launch_time, dt, state.wanted, flyout);
  k.position = flyout.position;
  k.velocity = flyout.velocity;
  state.lift = flyout.lift;

  set_vertical(k, library.reference.vertical_at(k.position));
  const Vec3 through_air = k.velocity - wind;
  k.speed = norm(through_air);
  k.mach = k.speed / air.speed_of_sound;
  k.load_factor = norm(flyout.lift) / kGravity;
  k.heading = math::atan2(dot(through_air, k.east), dot(through_air, k.north));
  k.pitch = math::asin(std::clamp(-dot(through_air, k.down) / k.speed, -1.0, 1.0));
}

MissileEnd end_of(const MissileType& type, const Kinematics& k, const MissileState& state,
                  double time) {
  const double age = time - state.launch_time;
  if (k.altitude <= 0)
    return MissileEnd::ground;
  if (age > type.motor.burn_time() && k.speed < type.least_speed)
    return MissileEnd::speed;
  if (age > type.greatest_time)
    return MissileEnd::time;
  const double last_news = std::max(state.sight_time, state.target_time);
  if (state.active != 0 && state.locked == 0 && time - last_news > type.seeker.memory)
    return MissileEnd::lost;
  return MissileEnd::none;
}

}  // namespace eyrie::model::weapon
