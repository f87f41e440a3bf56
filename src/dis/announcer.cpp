// SPDX-License-Identifier: MIT
#include "dis/announcer.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace eyrie::dis {
namespace {

using model::EventKind;

constexpr std::uint16_t kBlastFragmentation = 1620, kProximity = 3000, kHighExplosive = 1000,
                        kContact = 1000;   // UID 60 and 61
constexpr double kFarewell = 0.5;          // s
constexpr double kEmissionHeartbeat = 10;  // s, HBT_PDU_EE
constexpr double kBeamAngle = radians(1);  // EE_AZ_THRSH and EE_EL_THRSH
constexpr float kVoteStep = 5;             // a twentieth of the scale
constexpr std::uint8_t kTermination = 2;   // UID 67
constexpr std::size_t kLongestLabel = 60;  // characters, each of 16 bytes at most

Munition missile_of(const model::Library& library, float index) {
  const auto i = static_cast<std::size_t>(index);
  return {.type = *model::entity_type_of(library.missiles[i].entity_type),
          .warhead = kBlastFragmentation,
          .fuse = kProximity};
}

std::array<char, 11> marking_of(std::string_view name) {
  std::array<char, 11> marking{};
  for (std::size_t i = 0; i < std::min(name.size(), marking.size()); ++i)
    marking[i] = name[i] >= ' ' && name[i] <= '~' ? name[i] : '?';
  return marking;
}

Force force_of(model::Side side) {
  return side == model::Side::blue  ? Force::friendly
         : side == model::Side::red ? Force::opposing
                                    : Force::other;
}

}  // namespace

Announcer::Announcer(const scenario::Scenario& scenario, const Station& station, Send send,
                     const Others* others)
    : scenario_(scenario), station_(station), send_(std::move(send)), others_(others) {}

EntityId Announcer::id_of(PlayerId who) const {
  if (const auto* player = scenario_.roster.find(who); player && player->remote)
    return others_ ? others_->entity_of(who) : kNobody;
  return who && who.value < 0xFFFF ? station_.entity(static_cast<std::uint16_t>(who.value))
                                   : kNobody;
}

Announcer::Entity* Announcer::find(PlayerId who) {
  const auto at = entities_.find(who);
  return at == entities_.end() ? nullptr : &at->second;
}

Announcer::Entity* Announcer::ours(PlayerId who) {
  Entity* entity = find(who);
  return entity && !entity->theirs ? entity : nullptr;
}

ClockTime Announcer::clock() const {
  return {kFirstHour + static_cast<std::uint32_t>(time_ / 3600), timestamp_at(time_)};
}

void Announcer::send(Pdu pdu) {
  send_(time_,
        {.exercise = station_.exercise, .timestamp = timestamp_at(time_), .pdu = std::move(pdu)});
}

void Announcer::introduce(PlayerId who, model::Side side, std::string_view type,
                          std::string_view marking) {
  if (id_of(who) == kNobody) {
    ++nameless_;
    return;
  }
  EntityState& state = entities_[who].state;
  state.id = id_of(who);
  state.force = force_of(side);
  state.type = state.other_type = model::entity_type_of(type).value_or(model::EntityType{});
  state.marking = marking_of(marking);
  state.reckoning = Reckoning::rvw;
}

void Announcer::begin(const sim::World& world, double dt) {
  dt_ = dt;
  time_ = static_cast<double>(world.step()) * dt;
  const auto& players = scenario_.roster.players;
  for (std::size_t i = 0; i < players.size(); ++i)
    if (const PlayerId who{static_cast<std::uint32_t>(i + 1)}; players[i].remote)
      entities_[who].theirs = true;
    else
      introduce(who, players[i].side, players[i].entity_type, players[i].name);
  send(StartResume{.from = station_.entity(0),
                   .to = station_.entity(kEverybody.entity),
                   .real = clock(),
                   .simulated = clock()});
  look(world);
  tell_states();
  tell_emissions(world);
}

void Announcer::observe(const sim::World& world, const sim::StepInfo& info,
                        std::span<const sim::Event> events) {
  time_ = info.time_after();
  for (const sim::Event& e : events)  // before they are looked at
    if (record::kind_of(e) == EventKind::launch) {
      const auto* shooter = scenario_.roster.find(PlayerId{e.detail});
      if (!shooter || shooter->remote)
        continue;
      introduce(e.who, shooter->side,
                scenario_.library->missiles[static_cast<std::size_t>(e.values[1])].entity_type,
                fmt::format("{} {}", record::store_label(scenario_, e.values[1]), e.who.value));
    }
  look(world);
  tell_events(events);
  tell_states();
  tell_emissions(world);
  tell_decisions(world);
}

void Announcer::finish(const sim::World&) {
  for (auto& [who, entity] : entities_)
    if (entity.here && !entity.theirs)
      tell_state(entity, kDeactivated);
  for (const Farewell& farewell : farewells_)
    send(farewell.state);
  send(StopFreeze{.from = station_.entity(0),
                  .to = station_.entity(kEverybody.entity),
                  .real = clock(),
                  .reason = kTermination});
}

void Announcer::hold() {
  for (auto& [who, entity] : entities_)
    if (entity.here && !entity.theirs)
      tell_state(entity, kFrozen);
}

void Announcer::look(const sim::World& world) {
  for (auto& [who, entity] : entities_)
    entity.here = false;
  scenario_.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
    look(id, fleet.motion(world, row));
  });
  for (std::size_t i = 0; i < world.rows(scenario_.missiles.table); ++i)
    look(world.ids(scenario_.missiles.table)[i], world.rows(scenario_.missiles.kinematics)[i]);
}

void Announcer::look(PlayerId who, const model::Kinematics& k) {
  Entity* entity = find(who);
  if (!entity)
    return;
  const Reference& earth = scenario_.library->reference;
  const model::Axes body = model::body_axes(k);
  Motion now{.position = earth.to_ecef(k.position),
             .velocity = earth.turned_to_ecef(k.velocity),
             .attitude = {earth.turned_to_ecef(body.forward), earth.turned_to_ecef(body.right),
                          earth.turned_to_ecef(body.down)}};
  if (entity->moved) {
    now.acceleration = (now.velocity - entity->now.velocity) / dt_;
    now.spin = spin_between(entity->now.attitude, now.attitude, dt_);
  }
  entity->moved = entity->here = true;
  entity->now = now;
}

void Announcer::tell_events(std::span<const sim::Event> events) {
  for (const sim::Event& e : events) {
    const auto fate = record::fate_of(e);
    switch (record::kind_of(e)) {
      case EventKind::launch:
        launch(e);
        break;
      case EventKind::gun_burst:
        burst(e);
        break;
      case EventKind::detonation:
        // of another program's aircraft that program says what became of it
        end_of_missile(
            e, fate->end == "kill" || e.values[2] < 0 ? Result::proximate : Result::end_game_miss);
        break;
      case EventKind::timeout: {
        const auto end = static_cast<model::weapon::MissileEnd>(e.values[0]);
        end_of_missile(e, end == model::weapon::MissileEnd::ground  ? Result::ground_impact
                          : end == model::weapon::MissileEnd::decoy ? Result::end_game_miss
                                                                    : Result::fly_out_miss);
        break;
      }
      default:
        break;
    }
    if (fate && fate->end != "home")
      if (Entity* entity = find(fate->who))
        entity->destroyed = true;
  }
}

void Announcer::launch(const sim::Event& e) {
  Entity* missile = ours(e.who);
  if (!missile)
    return;
  missile->shot = {station_.site, station_.application, ++shots_};
  missile->shooter = id_of(PlayerId{e.detail});
  send(Fire{.shooter = missile->shooter,
            .target = id_of(e.whom),
            .munition = missile->state.id,
            .event = missile->shot,
            .location = missile->now.position,
            .what = missile_of(*scenario_.library, e.values[1]),
            .velocity = narrow(missile->now.velocity),
            .range = e.values[0]});
}

void Announcer::end_of_missile(const sim::Event& e, Result result) {
  Entity* missile = find(e.who);
  if (!missile)
    return;
  Detonation end{
      .shooter = missile->shooter,
      .target = id_of(e.whom),
      .munition = missile->state.id,
      .event = missile->shot,
      .velocity = narrow(missile->now.velocity),
      .location = scenario_.library->reference.to_ecef(e.place),
      .what = {.type = missile->state.type, .warhead = kBlastFragmentation, .fuse = kProximity},
      .result = result};
  if (const Entity* target = find(e.whom)) {
    const Vec3 there = target->now.attitude * (end.location - target->now.position);
    // the fuze works within the step, the target is where it is after it: the miss is that of the
    // event
    const bool fuzed = record::kind_of(e) == EventKind::detonation && norm(there) > 0;
    end.place = narrow(fuzed ? double{e.values[0]} / norm(there) * there : there);
  }
  send(std::move(end));
}

/// A burst is told at its end, and its hits together.
void Announcer::burst(const sim::Event& e) {
  const Entity* shooter = find(e.who);
  if (!shooter)
    return;
  const model::Library& library = *scenario_.library;
  const auto type = library.aircraft.find(scenario_.roster.find(e.who)->type);
  const model::GunType& gun = library.guns[*library.aircraft[*type].index.gun];
  const EventId event{station_.site, station_.application, ++shots_};
  Munition rounds{.type = *model::entity_type_of(gun.entity_type),
                  .warhead = kHighExplosive,
                  .fuse = kContact,
                  .quantity = static_cast<std::uint16_t>(e.values[0]),
                  .rate = static_cast<std::uint16_t>(60 * gun.rate)};
  const Vec3f velocity =
      narrow(shooter->now.velocity + gun.muzzle_velocity * shooter->now.attitude.row_x);
  send(Fire{.shooter = shooter->state.id,
            .target = id_of(e.whom),
            .event = event,
            .location = scenario_.library->reference.to_ecef(e.place),
            .what = rounds,
            .velocity = velocity,
            .range = e.whom ? e.values[1] : 0});  // 0: unknown
  const Entity* target = find(e.whom);
  if (!target || e.values[2] < 1)
    return;
  rounds.quantity = static_cast<std::uint16_t>(e.values[2]);
  send(Detonation{.shooter = shooter->state.id,
                  .target = id_of(e.whom),
                  .event = event,
                  .velocity = velocity,
                  .location = target->now.position,
                  .what = rounds,
                  .result = Result::impact});
}

void Announcer::tell_states() {
  const Thresholds& limits = station_.thresholds;
  for (auto at = entities_.begin(); at != entities_.end();) {
    Entity& entity = at->second;
    const double since = time_ - entity.told;
    if (entity.theirs) {
      ++at;
      continue;
    }
    if (!entity.here) {
      if (entity.told >= 0)
        tell_state(entity, entity.destroyed ? kDeactivated | kDestroyed : kDeactivated);
      if (entity.told >= 0 && others_)
        farewells_.push_back({entity.state, time_ + kFarewell});
      at = entities_.erase(at);
      continue;
    }
    if (since > limits.heartbeat - dt_ / 2 ||
        apart(entity.now, reckon(Reckoning::rvw, entity.reckoned, since), limits))
      tell_state(entity, 0);
    ++at;
  }
  for (Farewell& farewell : farewells_)
    if (time_ >= farewell.next && farewell.left > 0) {
      --farewell.left;
      farewell.next += kFarewell;
      send(farewell.state);
    }
  std::erase_if(farewells_, [](const Farewell& f) { return f.left == 0; });
}

void Announcer::tell_state(Entity& entity, std::uint32_t appearance) {
  EntityState& state = entity.state;
  state.location = entity.now.position;
  state.velocity = narrow(entity.now.velocity);
  state.acceleration = narrow(entity.now.acceleration);
  state.orientation = narrow(euler_of(entity.now.attitude));
  state.spin = narrow(entity.now.spin);
  state.appearance = appearance;
  if ((appearance & kFrozen) != 0)
    state.velocity = state.acceleration = state.spin = {};
  entity.reckoned = motion_of(state);
  entity.told = time_;
  send(state);
}

void Announcer::tell_emissions(const sim::World& world) {
  const IdOf id = [this](PlayerId who) { return id_of(who); };
  const auto ids = world.ids(scenario_.aircraft.table);
  for (std::size_t row = 0; row < ids.size(); ++row)
    tell_emission(ids[row], systems_of(scenario_, world, row, id));
  const auto missiles = world.ids(scenario_.missiles.table);
  for (std::size_t row = 0; row < missiles.size(); ++row)
    tell_emission(missiles[row], seeker_of(scenario_, world, row, id));
}

void Announcer::tell_emission(PlayerId who, std::vector<Emission::System> systems) {
  Entity* entity = ours(who);
  if (!entity)
    return;
  Emission& told = entity->emission;
  const bool changed = differs(told.systems, systems, kBeamAngle);
  const bool again = !systems.empty() && time_ - entity->radiated > kEmissionHeartbeat - dt_ / 2;
  if (!changed && !again)
    return;
  told = {.emitter = entity->state.id,
          .event = {station_.site, station_.application, ++emissions_},
          .changed = changed,
          .systems = std::move(systems)};
  entity->radiated = time_;
  send(told);
}

void Announcer::tell_decisions(const sim::World& world) {
  scenario_.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
    const team::LastDecision now = fleet.agents->last_decision(world, row);
    if (Entity* entity = ours(id); entity && now.ticks && now.tree < fleet.trees.size())
      tell_decision(*entity, fleet, now);
  });
}

void Announcer::tell_decision(Entity& entity, const scenario::Fleet& fleet,
                              const team::LastDecision& now) {
  const team::LastDecision& before = entity.decision;
  const bool other = now.tree != before.tree || now.node != before.node;
  if (!other && std::fabs(now.vote - before.vote) < kVoteStep)
    return;
  entity.decision = now;
  const ubf::AnyTree& tree = *fleet.trees[now.tree];
  const std::string behavior = printable(tree.label(now.node), kLongestLabel);
  if (other)
    send(Comment{.from = entity.state.id,
                 .to = kEverybody,
                 .datums = {.variable = {{kDecision, fmt::format("{} decides, vote {:.0f}",
                                                                 behavior, now.vote)}}}});
  send(Data{.from = entity.state.id,
            .to = kEverybody,
            .datums = {.fixed = {{kVote, std::bit_cast<std::uint32_t>(now.vote)},
                                 {kNode, now.node},
                                 {kTree, now.tree}},
                       .variable = {{kBehavior, behavior}}}});
}

}  // namespace eyrie::dis
