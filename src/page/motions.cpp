// SPDX-License-Identifier: MIT
#include "page/motions.hpp"

#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "record/names.hpp"

namespace eyrie::page {
using model::EventKind;

void Motion::add(double time, const Reference& reference, const model::Kinematics& k) {
  if (time <= last_time_)
    return;
  const OnMap at = on_map(reference, k.position);
  last_time_ = time;
  t_.add(time);
  east_.add(at.east);
  north_.add(at.north);
  up_.add(at.up);
  heading_.add(wrap_tau(k.heading + at.turn));
  pitch_.add(k.pitch);
  roll_.add(wrap_pi(k.roll));
}

Json Motion::json(ColumnBytes& bytes) const {
  return {
      {"t", put(bytes, t_)},      {"east", put(bytes, east_)},       {"north", put(bytes, north_)},
      {"up", put(bytes, up_)},    {"heading", put(bytes, heading_)}, {"pitch", put(bytes, pitch_)},
      {"roll", put(bytes, roll_)}};
}

Motions::Motions(const scenario::Scenario& scenario, double period)
    : scenario_(scenario), period_(period), players_(scenario.roster.players.size()) {}

void Motions::sample(Flown& player, double time, const model::Kinematics& k, double fuel) {
  if (time <= player.motion.last_time())
    return;
  player.motion.add(time, scenario_.library->reference, k);
  player.speed.add(k.speed);
  player.mach.add(k.mach);
  player.load_factor.add(k.load_factor);
  player.fuel.add(fuel);
}

void Motions::look(const sim::World& world, bool players, bool missiles) {
  const auto see = [&](PlayerId id, const model::Kinematics& k, double fuel) {
    Flown& player = players_[id.value - 1];
    if (!player.born) {
      player.born = true;
      player.born_time = time_;
    }
    player.last = k;
    player.last_fuel = fuel;
    if (players)
      sample(player, time_, k, fuel);
  };
  scenario_.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
    see(id, fleet.motion(world, row), fleet.gauges(world, row).fuel.value_or(ubf::kNoValue));
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
  dt_ = dt;
  const auto steps = [&](double seconds) {
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(seconds / dt + 0.5));
  };
  players_every_ = steps(period_);
  missiles_every_ = steps(period_ / 5);
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
    if (player.gone >= 0)
      return;
    player.gone = time_;
    player.end = fate.end;
    if (player.born)
      sample(player, time_, player.last, player.last_fuel);
  } else if (const auto at = missiles_.find(fate.who.value);
             fate.end != "lost" && at != missiles_.end() && at->second.gone < 0) {
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
  time_ = info.time() + info.dt;
  for (const sim::Event& e : events)
    happened(e, world);
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
  Json j{{"born", p.born_time}, {"gone", gone(p.gone)}, {"end", p.end}};
  j["motion"] = p.motion.json(bytes);
  j["gauges"] = {{"speed", put(bytes, p.speed)},
                 {"mach", put(bytes, p.mach)},
                 {"load_factor", put(bytes, p.load_factor)},
                 {"fuel", put(bytes, p.fuel)}};
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
                     {"born", m.born},
                     {"gone", gone(m.gone)},
                     {"active", number_or_null(m.active)},
                     {"end", m.end},
                     {"motion", m.motion.json(bytes)}});
  return all;
}

}  // namespace eyrie::page
