// SPDX-License-Identifier: MIT
#include "page/motions.hpp"

#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "record/names.hpp"

namespace eyrie::page {
using model::EventKind;

bool Motion::add(double time, const Reference& reference, const model::Kinematics& k) {
  if (time <= last_time_)
    return false;
  const OnMap at = on_map(reference, k.position);
  last_time_ = time;
  columns_.add(
      {time, at.east, at.north, at.up, wrap_tau(k.heading + at.turn), k.pitch, wrap_pi(k.roll)});
  return true;
}

Motions::Motions(const scenario::Scenario& scenario, double period)
    : scenario_(scenario), period_(period), players_(scenario.roster.players.size()) {}

void Motions::sample(Flown& player) const {
  const model::Kinematics& k = player.last;
  if (player.motion.add(time_, scenario_.library->reference, k))
    player.gauges.add({k.speed, k.mach, k.load_factor, player.last_fuel});
}

void Motions::look(const sim::World& world, bool players, bool missiles) {
  scenario_.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
    Flown& player = players_[id.value - 1];
    if (!player.born)
      player.born = time_;
    player.last = fleet.motion(world, row);
    player.last_fuel = fleet.gauges(world, row).fuel.value_or(ubf::kNoValue);
    if (players)
      sample(player);
  });
  const auto ids = world.ids(scenario_.missiles.table);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    Missile& missile = missiles_[ids[i].value];
    missile.last = world.rows(scenario_.missiles.kinematics)[i];
    if (missiles || missile.motion.empty())
      missile.motion.add(time_, scenario_.library->reference, missile.last);
  }
}

void Motions::begin(const sim::World& world, double dt) {
  players_every_ = record::steps_in(period_, dt);
  missiles_every_ = record::steps_in(period_ / 5, dt);
  time_ = static_cast<double>(world.step()) * dt;
  look(world, true, true);
}

void Motions::launched(const sim::Event& e, const sim::World& world) {
  const auto* shooter = scenario_.roster.find(PlayerId{e.detail});
  Missile& missile = missiles_[e.who.value];
  missile.type = record::store_label(scenario_, e.values[1]);
  missile.side = shooter ? shooter->side : model::Side::none;
  missile.shooter = PlayerId{e.detail};
  missile.target = e.whom;
  missile.born = time_;
  if (const auto row = world.row(scenario_.missiles.table, e.who))
    missile.last = world.rows(scenario_.missiles.kinematics)[*row];
}

void Motions::left(const record::Fate& fate) {
  if (scenario_.roster.find(fate.who)) {
    Flown& player = players_[fate.who.value - 1];
    if (player.gone)
      return;
    player.gone = time_;
    player.end = fate.end;
    if (player.born)
      sample(player);
  } else if (const auto at = missiles_.find(fate.who.value);
             fate.end != "lost" && at != missiles_.end() && !at->second.gone) {
    Missile& missile = at->second;
    missile.gone = time_;
    missile.end = fate.end;
    if (!missile.motion.empty())
      missile.motion.add(time_, scenario_.library->reference, missile.last);
  }
}

void Motions::happened(const sim::Event& e, const sim::World& world) {
  if (record::kind_of(e) == EventKind::launch)
    launched(e, world);
  if (record::kind_of(e) == EventKind::seeker_active)
    if (const auto at = missiles_.find(e.who.value); at != missiles_.end())
      at->second.active = time_;
  if (const auto fate = record::fate_of(e))
    left(*fate);
}

void Motions::observe(const sim::World& world, const sim::StepInfo& info,
                      std::span<const sim::Event> events) {
  remember(world, info, events);
  look(world, world.step() % players_every_ == 0, world.step() % missiles_every_ == 0);
}

void Motions::remember(const sim::World& world, const sim::StepInfo& info,
                       std::span<const sim::Event> events) {
  time_ = info.time() + info.dt;
  for (const sim::Event& e : events)
    happened(e, world);
}

void Motions::finish(const sim::World& world) {
  look(world, true, true);
}

Json Motions::player(std::size_t index, ColumnBytes& bytes) const {
  const Flown& p = players_[index];
  Json j{{"born", p.born.value_or(0)}, {"gone", p.gone.value_or(time_)}, {"end", p.end}};
  j["motion"] = p.motion.json(bytes);
  j["gauges"] = p.gauges.json(bytes);
  return j;
}

Json Motions::missiles(ColumnBytes& bytes) const {
  const auto index = [&](PlayerId id) {
    return scenario_.roster.find(id) ? static_cast<int>(id.value) - 1 : -1;
  };
  Json all = Json::array();
  for (const auto& [id, m] : missiles_)
    if (!m.motion.empty())
      all.push_back({{"id", id},
                     {"type", m.type},
                     {"side", scenario::side_name(m.side)},
                     {"shooter", index(m.shooter)},
                     {"target", index(m.target)},
                     {"born", m.born.value_or(0)},
                     {"gone", m.gone.value_or(time_)},
                     {"active", std::isnan(m.active) ? Json() : Json(m.active)},
                     {"end", m.end.empty() ? "flying" : m.end},
                     {"motion", m.motion.json(bytes)}});
  return all;
}

}  // namespace eyrie::page
