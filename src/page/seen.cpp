// SPDX-License-Identifier: MIT
#include "page/seen.hpp"

#include <algorithm>
#include <cmath>

#include "core/angle.hpp"
#include "model/weapon/stores.hpp"
#include "record/event_table.hpp"
#include "ubf/state_fields.hpp"

namespace eyrie::page {
namespace {

/// What people look at: coarser than what is blended, and finer than what they read.
double quantum_seen(std::string_view unit) {
  return unit == "rad" ? 1e-4 : unit == "m" || unit == "kg" || unit == "m/s" ? 0.01 : 1e-3;
}

}  // namespace

OnMap on_map(const Reference& reference, const Vec3& position) {
  const Geodetic place = reference.to_geodetic(position);
  const MapPlace at = Map(reference.origin()).at(place);
  return {at.east, at.north, place.altitude, at.turn};
}

Sights::Sights(const scenario::Scenario& scenario, TextBook& texts)
    : scenario_(scenario), texts_(texts) {}

template <class State>
void Sights::add_state(const State& state) {
  last_time_ = state.time;
  t_.add(state.time);
  const auto fields = ubf::StateFields<State>::all();
  if (state_.empty())
    for (const auto& field : fields)
      state_.emplace_back(field.info.kind == ubf::FieldKind::number
                              ? quantum_seen(field.info.unit.si_symbol)
                              : 1.0);
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (const double value = fields[i].read(state); std::isinf(value))
      state_[i].add_rounded(Column::kNever);
    else
      state_[i].add(value);
}

void Sights::add_track(std::uint32_t id, PlayerId truth, model::Identity identity, bool target,
                       const Vec3& position, double age) {
  const OnMap at = on_map(scenario_.library->reference, position);
  const double player = index_of(scenario_.roster, truth);
  tracks_.add({static_cast<double>(id), player, static_cast<double>(identity), target ? 1.0 : 0.0,
               at.east, at.north, at.up, age});
}

void Sights::add_warning(const sim::World& world, const std::string& kind, double bearing,
                         double range, PlayerId truth) {
  const std::string name = truth ? record::name_in(scenario_, world, truth) : "?";
  const auto kind_number = static_cast<double>(texts_.number(kind));
  warnings_.add({kind_number, wrap_tau(bearing), range, static_cast<double>(texts_.number(name))});
}

void Sights::add_zone(const pilot::State& s) {
  model::weapon::EmploymentZone zone;  // of what reaches farthest of what is on board
  if (const pilot::Seen* target = s.target())
    for (const model::Station& station : s.stores.stations)
      if (station.store && station.count) {
        const auto one = s.zone(static_cast<std::uint16_t>(station.store - 1), *target);
        if (one.possible() && one.r_max > zone.r_max)
          zone = one;
      }
  zone_.add({zone.r_min, zone.r_ne, zone.r_max});
}

void Sights::add(const pilot::State& s, const sim::World& world, PlayerId who) {
  add_state(s);
  named_.clear();
  for (const pilot::Seen& seen : s.tracks_seen()) {
    named_.emplace_back(seen.id(), seen.track->truth);
    add_track(seen.id().value, seen.track->truth, seen.track->identity, s.target() == &seen,
              position_at(*seen.track, s.time), s.time - seen.track->time);
  }
  for (std::uint32_t i = 0; i < s.rwr.count; ++i) {
    const model::RwrWarning& warning = s.rwr.warnings[i];
    add_warning(world, "radar " + std::string(enum_name(warning.kind)), warning.bearing,
                ubf::kNoValue, warning.emitter);
  }
  for (std::uint32_t i = 0; i < s.threats.count; ++i) {
    const model::InboundMissile& missile = s.threats.missiles[i];
    add_warning(world, "missile", missile.bearing,
                missile.has_position ? missile.range : ubf::kNoValue, missile.truth);
  }
  track_counts_.add_rounded(static_cast<std::int64_t>(s.tracks_seen().size()));
  warning_counts_.add_rounded(s.rwr.count + s.threats.count);
  const auto row = world.row(scenario_.aircraft.table, who);
  const model::RadarState scan =
      row ? world.rows(scenario_.aircraft.radar)[*row] : model::RadarState{};
  scan_.add({static_cast<double>(scan.mode), scan.scan_azimuth, scan.scan_elevation});
  add_zone(s);
}

bool Sights::names_others(const pilot::State& s) const {
  return !std::ranges::equal(s.tracks_seen(), named_, [](const pilot::Seen& seen, const auto& was) {
    return seen.id() == was.first && seen.track->truth == was.second;
  });
}

void Sights::add(const driver::State& s) {
  add_state(s);
  std::uint32_t number = 0;
  for (const model::Sighted& seen : s.lookout.all())
    add_track(++number, seen.truth, seen.identity, s.watched() == &seen, seen.position,
              s.time - seen.time);
  track_counts_.add_rounded(number);
  warning_counts_.add_rounded(0);
}

Json Sights::json(ColumnBytes& bytes) const {
  Json state = Json::array();
  for (const Column& column : state_)
    state.push_back(bytes.put(column));
  const auto counted = [&](const Column& counts, const Columns& all) {
    Json j{{"count", bytes.put(counts)}};
    j.update(all.json(bytes));
    return j;
  };
  Json j{{"t", bytes.put(t_)}, {"state", std::move(state)}};
  j["tracks"] = counted(track_counts_, tracks_);
  j["warnings"] = counted(warning_counts_, warnings_);
  j["scan"] = scan_.empty() ? Json() : scan_.json(bytes);
  j["zone"] = zone_.empty() ? Json() : zone_.json(bytes);
  return j;
}

void Sights::forget() {
  for (Column* column : {&t_, &track_counts_, &warning_counts_})
    column->forget();
  for (Column& column : state_)
    column.forget();
  for (Columns* columns : {&tracks_, &warnings_, &scan_, &zone_})
    columns->forget();
}

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
    player.heard = time_;
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
  time_ = info.time_after();
  for (const sim::Event& e : events)
    happened(e, world);
}

void Motions::finish(const sim::World& world) {
  look(world, true, true);
}

Json Motions::now() const {
  Json all{{"players", Json::array()}, {"missiles", Json::array()}};
  const auto put = [&](const Mover& mover, Json& row) {
    const model::Kinematics& k = mover.last;
    const OnMap at = on_map(scenario_.library->reference, k.position);
    for (const double value : {time_, at.east, at.north, at.up, wrap_tau(k.heading + at.turn),
                               double{k.pitch}, wrap_pi(k.roll)})
      row.push_back(value);
  };
  for (const Flown& player : players_) {
    Json& row = all["players"].emplace_back();
    if (!player.born || player.gone || player.heard < time_)
      continue;
    put(player, row);
    const model::Kinematics& k = player.last;
    for (const double gauge : {double{k.speed}, double{k.mach}, double{k.load_factor}})
      row.push_back(gauge);
    row.push_back(std::isnan(player.last_fuel) ? Json() : Json(player.last_fuel));
  }
  for (const auto& [id, missile] : missiles_)
    if (!missile.gone && !missile.motion.empty())
      put(missile, all["missiles"].emplace_back(Json::array({id})));
  return all;
}

void Motions::forget() {
  for (Flown& player : players_) {
    player.motion.forget();
    player.gauges.forget();
  }
  for (auto& [id, missile] : missiles_) {
    missile.motion.forget();
    missile.told = missile.gone.has_value();
  }
}

Json Motions::player(std::size_t index, ColumnBytes& bytes) const {
  const Flown& p = players_[index];
  constexpr double kNever = 1e9;
  const double heard = p.born ? p.heard : kNever;
  const bool is_away = !p.gone && p.born && heard < time_;
  Json j{{"born", p.born.value_or(p.gone ? 0 : kNever)},
         {"gone", p.gone.value_or(heard)},
         {"end", is_away ? "unheard" : p.end}};
  j["motion"] = p.motion.json(bytes);
  j["gauges"] = p.gauges.json(bytes);
  return j;
}

Json Motions::missiles(ColumnBytes& bytes) const {
  Json all = Json::array();
  for (const auto& [id, m] : missiles_)
    if (!m.motion.empty() && !m.told)
      all.push_back({{"id", id},
                     {"type", m.type},
                     {"side", scenario::side_name(m.side)},
                     {"shooter", index_of(scenario_.roster, m.shooter)},
                     {"target", index_of(scenario_.roster, m.target)},
                     {"born", m.born.value_or(0)},
                     {"gone", m.gone.value_or(time_)},
                     {"active", std::isnan(m.active) ? Json() : Json(m.active)},
                     {"end", m.end.empty() ? "flying" : m.end},
                     {"motion", m.motion.json(bytes)}});
  return all;
}

}  // namespace eyrie::page
