// SPDX-License-Identifier: MIT
#include "record/paths.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "record/fate.hpp"

namespace eyrie::record {
using model::EventKind;

void Paths::keep(std::uint32_t id) {
  Last& last = last_[id];
  Path& path = all_[id];
  if (last.kept >= time_ && !path.points.empty())
    return;
  last.kept = time_;
  if (path.points.size() >= most_)
    halve(path, last);
  path.points.push_back({time_, scenario_.library->reference.to_geodetic(last.position)});
}

void Paths::halve(Path& path, Last& last) const {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < path.points.size(); i += 2)
    path.points[kept++] = path.points[i];
  path.points.resize(kept);
  const std::uint64_t every = path.kind == "missile" ? missiles_every_ : players_every_;
  last.pause = 2 * std::max(last.pause, static_cast<double>(every) * dt_);
}

void Paths::see(PlayerId id, const Vec3& position, bool keep_it) {
  Last& last = last_[id.value];
  last.position = position;
  const bool due = keep_it && time_ - last.kept > last.pause - 1e-6;
  if (due || all_[id.value].points.empty())
    keep(id.value);
}

void Paths::look(const sim::World& world, bool players, bool missiles) {
  scenario_.each_player(world, [&](const scenario::Fleet& fleet, PlayerId id, std::size_t row) {
    see(id, fleet.motion(world, row).position, players);
    const team::LastDecision last = fleet.agents->last_decision(world, row);
    if (!last.ticks)
      return;
    const std::string behavior = fleet.leader(world, row);
    auto& led = all_[id.value].led;
    if (led.empty() || led.back().behavior != behavior || led.back().vote != last.vote)
      led.push_back({time_, behavior, last.vote});
  });
  for (std::size_t i = 0; i < world.rows(scenario_.missiles.table); ++i)
    see(world.ids(scenario_.missiles.table)[i],
        world.rows(scenario_.missiles.kinematics)[i].position, missiles);
}

void Paths::begin(const sim::World& world, double dt) {
  const auto steps = [&](double seconds) {
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(seconds / dt + 0.5));
  };
  players_every_ = steps(1);
  missiles_every_ = steps(0.2);
  time_ = static_cast<double>(world.step()) * dt;
  dt_ = dt;
  for (std::size_t i = 0; i < scenario_.roster.players.size(); ++i) {
    const auto& player = scenario_.roster.players[i];
    Path& path = all_[static_cast<std::uint32_t>(i + 1)];
    path.name = player.name;
    path.type = player.label;
    path.side = player.side;
    path.kind = scenario_.fleets[player.fleet]->words.name;
  }
  look(world, true, true);
}

void Paths::happened(const sim::Event& e) {
  if (kind_of(e) == EventKind::launch) {
    const auto* shooter = scenario_.roster.find(PlayerId{e.detail});
    Path& path = all_[e.who.value];
    path.kind = "missile";
    path.type = store_label(scenario_, e.values[1]);
    path.name = fmt::format("{} of {}", path.type, scenario_.roster.name(PlayerId{e.detail}));
    path.side = shooter ? shooter->side : model::Side::none;
    path.target = scenario_.roster.name(e.whom);
  }
  const auto fate = fate_of(e);
  const auto at = fate ? all_.find(fate->who.value) : all_.end();
  if (at == all_.end() || !at->second.end.empty())
    return;
  at->second.end = fate->end;
  keep(fate->who.value);
}

void Paths::observe(const sim::World& world, const sim::StepInfo& info,
                    std::span<const sim::Event> events) {
  time_ = info.time() + info.dt;
  for (const sim::Event& e : events)
    happened(e);
  look(world, world.step() % players_every_ == 0, world.step() % missiles_every_ == 0);
}

void Paths::finish(const sim::World& world) {
  for (auto& [id, last] : last_)
    last.pause = 0;  // the end is kept
  look(world, true, true);
}

}  // namespace eyrie::record
