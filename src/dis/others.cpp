// SPDX-License-Identifier: MIT
#include "dis/others.hpp"

#include <algorithm>

#include "model/frames.hpp"

namespace eyrie::dis {
namespace {

using model::RemoteOrder;

constexpr double kPlausible = 1e6;     // m from the reference point
constexpr double kFireWait = 0.3;      // s, for the Fire of a missile that is heard of before it
constexpr double kShooterRange = 2e3;  // m, from a missile to who may have launched it

model::Side side_of(Force force) {
  return force == Force::friendly   ? model::Side::blue
         : force == Force::opposing ? model::Side::red
                                    : model::Side::none;
}
std::string_view marking_of(const EntityState& state) {
  const std::string_view all(state.marking.data(), state.marking.size());
  return all.substr(0, std::min(all.find('\0'), all.size()));
}
bool within(const Vec3f& v, double most) {
  return norm(wide(v)) <= most;
}
bool lethal(Result result) {
  return result == Result::impact || result == Result::proximate || result == Result{5};
}
model::weapon::MissileEnd ending_of(Result result) {
  return result == Result::ground_impact ? model::weapon::MissileEnd::ground
                                         : model::weapon::MissileEnd::lost;
}

}  // namespace

std::vector<sim::Order> Others::orders(const sim::World& world, double clock) {
  std::vector<sim::Order> orders;
  const Now now{world, clock, orders};
  for (const Received& heard : incoming_.take())
    std::visit([&](const auto& pdu) { take(now, heard.valid, pdu); }, heard.pdu);
  for (auto& [id, entity] : entities_)
    if (entity.early && (entity.who || rate_ * (clock - entity.heard) > kFireWait)) {
      const EntityState state = *std::exchange(entity.early, std::nullopt);
      const model::Side side = side_of(state.force);
      if (!entity.who)
        shoot(now, entity,
              nearest(world, scenario_.library->reference.from_ecef(state.location), side), {},
              side, 0);
      follow(now, entity, state, entity.valid);
    }
  // of many of one entity the newest, and one in each step, for how long ever that is waited for:
  // what is kept of the exercise grows with its steps alone
  for (auto& [id, entity] : entities_) {
    if (!entity.who || entity.gone) {
      entity.said.reset();
      entity.radiates = false;
    }
    if (entity.said && entity.followed == world.step())
      entity.heard = clock;
    else if (const auto said = std::exchange(entity.said, std::nullopt))
      follow(now, entity, *said, entity.said_valid);
    if (entity.radiates && entity.radiated != world.step()) {
      entity.radiated = world.step();
      entity.radiates = false;
      give(now, entity.who, RemoteOrder::beam, entity.beam);
    }
  }
  for (auto& [id, entity] : entities_)
    if (entity.here && rate_ * (clock - entity.heard) > station_.thresholds.timeout()) {
      leave(now, entity, model::RemoteEnd::vanished);
      entity.gone = entity.munition != 0;
      entity.named = clock;
      ++incoming_.counts.vanished;
    }
  return orders;
}

EntityId Others::entity_of(PlayerId who) const {
  const auto at = named_.find(who);
  return at == named_.end() ? kNobody : at->second;
}

bool Others::names_us(const EntityId& id) const {
  const auto one = [](std::uint16_t named, std::uint16_t own) {
    return named == own || named == 0xFFFF;
  };
  return one(id.site, station_.site) && one(id.application, station_.application);
}

PlayerId Others::player_of(const EntityId& id) const {
  if (id.site == station_.site && id.application == station_.application) {
    const auto* player = scenario_.roster.find(PlayerId{id.entity});
    return player && !player->remote ? PlayerId{id.entity} : PlayerId{};
  }
  const auto at = entities_.find(id);
  return at == entities_.end() || at->second.munition != 0 ? PlayerId{} : at->second.who;
}

/// The one of that number, or else one of its subcategory, of its kind.
std::uint16_t Others::missile_of(const model::EntityType& type) const {
  const auto& missiles = scenario_.library->missiles;
  std::uint16_t best = 0;
  int likeness = 0;
  for (std::size_t i = 0; i < missiles.size(); ++i) {
    const auto mine = model::entity_type_of(missiles[i].entity_type).value_or(model::EntityType{});
    int alike = 1;
    if (mine.country == type.country && mine.category == type.category)
      alike += mine.subcategory == type.subcategory ? 2 : 1;
    if (mine == type)
      alike += 2;
    if (alike > likeness) {
      likeness = alike;
      best = static_cast<std::uint16_t>(i + 1);
    }
  }
  return best;
}

PlayerId Others::nearest(const sim::World& world, const Vec3& place, model::Side side) const {
  PlayerId found{};
  double best = kShooterRange * kShooterRange;
  const auto fit = world.rows(scenario_.aircraft.fit);
  for (std::size_t i = 0; i < fit.size(); ++i)
    if (const double d = norm2(world.rows(scenario_.aircraft.kinematics)[i].position - place);
        fit[i].remote != 0 && fit[i].side == side && d < best) {
      best = d;
      found = world.ids(scenario_.aircraft.table)[i];
    }
  return found;
}

void Others::take(const Now& now, double valid, const EntityState& state) {
  HeardCounts& counts = incoming_.counts;
  const Vec3 place_here = scenario_.library->reference.from_ecef(state.location);
  if (!(norm(place_here) <= kPlausible) || !within(state.velocity, 5e3) ||
      !within(state.acceleration, 1e3) || !within(state.orientation, 20) ||
      !within(state.spin, 100)) {
    ++counts[Unused::implausible];
    return;
  }
  const auto [known, fresh] = entity_called(now, state.id);
  if (!known)
    return;
  ++counts.states;
  Entity& entity = *known;
  const bool last = (state.appearance & kDeactivated) != 0;
  if (fresh || (!entity.who && entity.munition == 0))
    place(entity, state);
  if (state.type.kind == 2 && fresh)
    entity.munition = missile_of(state.type);
  if (!entity.who && entity.munition != 0 && !entity.gone && !last) {
    if (fresh)
      entity.heard = now.clock;
    entity.early = state;
    entity.valid = valid;
    return;
  }
  if (!entity.who) {
    ++counts[Unused::no_place];
    return;
  }
  if (entity.gone)
    return;
  if (last) {
    const bool destroyed = (state.appearance & kDestroyed) != 0;
    leave(now, entity, destroyed ? model::RemoteEnd::destroyed : model::RemoteEnd::gone);
    entity.gone = true;
    return;
  }
  entity.said = state;
  entity.said_valid = valid;
}

std::pair<Others::Entity*, bool> Others::entity_called(const Now& now, const EntityId& id) {
  auto at = entities_.find(id);
  if (at != entities_.end() && is_past(at->second, now.clock))
    at = (entities_.erase(at), entities_.end());
  const auto may_go = [&](const Entity& one) {  // nobody of the roster
    return is_past(one, now.clock) || (!one.who && now.clock - one.named > kLongAgo);
  };
  if (at == entities_.end() && !Incoming::has_room(entities_, tidied_, now.clock, may_go)) {
    ++incoming_.counts[Unused::crowded];
    return {nullptr, false};
  }
  const auto [made, fresh] = entities_.try_emplace(id);
  made->second.named = now.clock;
  if (fresh)
    ++incoming_.counts.entities;
  return {&made->second, fresh};
}

/// Finds out which remote player it is.
void Others::place(Entity& entity, const EntityState& state) {
  if (state.type.kind == 2)
    return;
  const auto& players = scenario_.roster.players;
  const std::string_view marking = marking_of(state);
  const auto is_namesake = [&](std::size_t i) {
    return players[i].remote && std::string_view(players[i].name).substr(0, 11) == marking;
  };
  const auto take_place = [&](std::size_t i) {
    const PlayerId who{static_cast<std::uint32_t>(i + 1)};
    if (const auto other = named_.find(who); other != named_.end())
      entities_[other->second].who = {};
    named_[who] = state.id;
    entity.who = who;
    entity.namesake = is_namesake(i);
  };
  for (std::size_t i = 0; i < players.size(); ++i)
    if (is_namesake(i) && !named_.contains(PlayerId{static_cast<std::uint32_t>(i + 1)}))
      return take_place(i);
  for (std::size_t i = 0; i < players.size(); ++i)
    if (is_namesake(i)) {  // from a stranger, or from who was him before
      const Entity& holder = entities_[named_[PlayerId{static_cast<std::uint32_t>(i + 1)}]];
      if (!holder.namesake || !holder.here)
        return take_place(i);
    }
  for (std::size_t i = 0; i < players.size(); ++i)
    if (players[i].remote && players[i].side == side_of(state.force) &&
        !named_.contains(PlayerId{static_cast<std::uint32_t>(i + 1)}))
      return take_place(i);
}

void Others::follow(const Now& now, Entity& entity, const EntityState& state, double valid) {
  const Reference& reference = scenario_.library->reference;
  const Motion motion = motion_of(state);
  if (entity.here && entity.reckoning != Reckoning::fixed)
    incoming_.counts.error.add(
        norm(motion.position -
             reckon(entity.reckoning, entity.last, rate_ * (valid - entity.valid)).position));
  entity.followed = now.world.step();
  entity.last = motion;
  entity.valid = valid;
  entity.reckoning = state.reckoning;
  entity.here = true;
  entity.heard = now.clock;

  const Vec3 position = reference.from_ecef(motion.position);
  const Vertical at = reference.vertical_at(position);
  const auto local = [&](const Vec3& axis) { return to_ned(at, reference.turned_from_ecef(axis)); };
  const Mat3& body = motion.attitude;
  // the world after this step is that of now
  const double since = scenario_.simulation->dt() + rate_ * (valid - now.clock);
  give(now, entity.who, RemoteOrder::place,
       model::RemotePlace{.position = position,
                          .since = static_cast<float>(std::clamp(since, -10.0, 10.0)),
                          .algorithm = static_cast<std::uint8_t>(state.reckoning)});
  give(now, entity.who, RemoteOrder::motion,
       model::RemoteMotion{narrow(reference.turned_from_ecef(motion.velocity)),
                           narrow(reference.turned_from_ecef(motion.acceleration))});
  give(now, entity.who, RemoteOrder::attitude,
       model::RemoteAttitude{
           narrow(euler_of({local(body.row_x), local(body.row_y), local(body.row_z)})),
           narrow(motion.spin)});
}

void Others::leave(const Now& now, Entity& entity, model::RemoteEnd end) {
  entity.here = false;
  give(now, entity.who, RemoteOrder::leave, model::RemoteLeave{end});
}

void Others::shoot(const Now& now, Entity& munition, PlayerId shooter, PlayerId target,
                   model::Side side, float range) {
  if (munition.munition == 0)
    return;
  if (!munition.who)
    munition.who = model::remote_missile(++missiles_);
  munition.heard = now.clock;
  munition.here = true;
  if (!munition.early)
    munition.valid = now.clock;
  give(now, munition.who, RemoteOrder::launch,
       model::RemoteLaunch{.shooter = shooter,
                           .target = target,
                           .range = std::clamp(range, 0.0F, 1e7F),
                           .type = static_cast<std::uint16_t>(munition.munition - 1),
                           .side = side});
}

void Others::take(const Now& now, double, const Fire& fire) {
  if (fire.munition == kNobody) {  // rounds: their Detonation says whom they hit
    ++incoming_.counts.shots;
    return;
  }
  const auto [known, fresh] = entity_called(now, fire.munition);
  // one entity is one shot, whatever the number of the event
  if (known && now.clock - known->fired < kLongAgo) {
    ++incoming_.counts[Unused::twice];
    return;
  }
  ++incoming_.counts.shots;
  if (!known || known->gone)
    return;
  Entity& munition = *known;
  munition.fired = now.clock;
  if (fresh)
    munition.munition = missile_of(fire.what.type);
  const PlayerId shooter = player_of(fire.shooter);
  const auto* player = scenario_.roster.find(shooter);
  const Motion at_launch{.position = fire.location, .velocity = wide(fire.velocity)};
  if (fresh)
    munition.last = at_launch;
  shoot(now, munition, shooter, player_of(fire.target), player ? player->side : model::Side::none,
        fire.range);
}

void Others::take(const Now& now, double, const Detonation& end) {
  ++incoming_.counts.ends;
  const PlayerId shooter = player_of(end.shooter), target = player_of(end.target);
  if (end.munition == kNobody) {
    const auto* player = scenario_.roster.find(shooter);
    const auto& library = *scenario_.library;
    const auto type = player ? library.aircraft.find(player->type) : std::nullopt;
    const auto gun = type ? library.aircraft[*type].index.gun : std::nullopt;
    if (gun && target)
      give(now, target, RemoteOrder::rounds,
           model::RemoteRounds{shooter, static_cast<float>(std::min<int>(end.what.quantity, 1000) *
                                                           library.guns[*gun].damage)});
    return;
  }
  const auto at = entities_.find(end.munition);
  const bool known =
      at != entities_.end() && at->second.munition != 0 && !is_past(at->second, now.clock);
  if (known && at->second.gone)
    return;
  const std::uint16_t type = known ? at->second.munition : missile_of(end.what.type);
  if (type == 0)
    return;
  const Vec3 place = scenario_.library->reference.from_ecef(end.location);
  if (!(norm(place) <= kPlausible) || !within(end.place, kPlausible)) {
    ++incoming_.counts[Unused::implausible];
    return;
  }
  if (known) {
    at->second.gone = true;
    at->second.here = false;
    at->second.named = now.clock;
  }
  give(now, known ? at->second.who : model::remote_missile(0x7FFF'FFFF), RemoteOrder::detonation,
       model::RemoteDetonation{.shooter = shooter,
                               .target = target,
                               .place = narrow(place),
                               .miss = static_cast<float>(norm(wide(end.place))),
                               .type = static_cast<std::uint16_t>(type - 1),
                               .lethal = lethal(end.result) && target,
                               .ending = static_cast<std::uint8_t>(ending_of(end.result))});
}

void Others::take(const Now&, double, const Emission& emission) {
  ++incoming_.counts.emissions;
  const auto at = entities_.find(emission.emitter);
  if (at == entities_.end() || !at->second.who || at->second.gone)
    return;
  Entity& entity = at->second;
  model::RemoteBeam beam;
  for (const Emission::System& system : emission.systems)
    for (const Emission::Beam& said : system.beams) {
      using enum BeamFunction;
      if (said.off != 0 || !std::isfinite(said.azimuth) || !std::isfinite(said.elevation))
        continue;
      if (said.function == jamming) {
        beam.jams = 1;
        continue;
      }
      const bool follows = said.function == tracking || said.function == missile_seeker;
      beam.kind = said.function == missile_seeker ? model::EmissionKind::missile_seeker
                  : follows                       ? model::EmissionKind::track
                                                  : model::EmissionKind::search;
      beam.azimuth = static_cast<float>(wrap_pi(double{said.azimuth}));
      beam.elevation = static_cast<float>(wrap_pi(double{said.elevation}));
      beam.dwell = follows && !said.targets.empty() ? player_of(said.targets[0].who) : PlayerId{};
    }
  if (std::memcmp(&beam, &entity.beam, sizeof beam) == 0)
    return;
  entity.beam = beam;
  entity.radiates = true;
}

void Others::take(const Now&, double, const StartResume& start) {
  ++incoming_.counts.management;
  if (names_us(start.to) && asked_.size() < 64)
    asked_.push_back({.from = start.from, .request = start.request});
}

void Others::take(const Now&, double, const StopFreeze& stop) {
  ++incoming_.counts.management;
  if (names_us(stop.to) && asked_.size() < 64)
    asked_.push_back(
        {.from = stop.from, .request = stop.request, .stop = true, .over = stop.reason == 2});
}

}  // namespace eyrie::dis
