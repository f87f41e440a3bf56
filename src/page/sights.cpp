// SPDX-License-Identifier: MIT
#include "page/sights.hpp"

#include <fmt/format.h>

#include "model/weapon/stores.hpp"
#include "ubf/state_fields.hpp"

namespace eyrie::page {
namespace {

/// What people look at: coarser than what is blended.
double quantum_seen(std::string_view unit) {
  return unit == "rad" ? 1e-3 : unit == "m" || unit == "kg" ? 1 : unit == "m/s" ? 0.1 : 1e-3;
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
    state_[i].add(fields[i].read(state));
}

void Sights::add_track(std::uint32_t id, PlayerId truth, model::Identity identity, bool target,
                       const Vec3& position, double age) {
  const OnMap at = on_map(scenario_.library->reference, position);
  const double player = scenario_.roster.find(truth) ? truth.value - 1.0 : -1.0;
  tracks_.add({static_cast<double>(id), player, static_cast<double>(identity), target ? 1.0 : 0.0,
               at.east, at.north, at.up, age});
}

void Sights::add_warning(const std::string& kind, double bearing, double range, PlayerId truth) {
  const std::string name = scenario_.roster.find(truth) ? scenario_.roster.name(truth)
                           : truth                      ? fmt::format("missile {}", truth.value)
                                                        : "?";
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

void Sights::add(const pilot::State& s, const model::RadarState* radar) {
  add_state(s);
  for (const pilot::Seen& seen : s.tracks_seen())
    add_track(seen.id().value, seen.track->truth, seen.track->identity, s.target() == &seen,
              position_at(*seen.track, s.time), s.time - seen.track->time);
  for (std::uint32_t i = 0; i < s.rwr.count; ++i) {
    const model::RwrWarning& warning = s.rwr.warnings[i];
    add_warning("radar " + std::string(enum_name(warning.kind)), warning.bearing, ubf::kNoValue,
                warning.emitter);
  }
  for (std::uint32_t i = 0; i < s.threats.count; ++i) {
    const model::InboundMissile& missile = s.threats.missiles[i];
    add_warning("missile", missile.bearing, missile.has_position ? missile.range : ubf::kNoValue,
                missile.truth);
  }
  track_counts_.add_rounded(static_cast<std::int64_t>(s.tracks_seen().size()));
  warning_counts_.add_rounded(s.rwr.count + s.threats.count);
  const model::RadarState off{};
  const model::RadarState& scan = radar ? *radar : off;
  scan_.add({static_cast<double>(scan.mode), scan.scan_azimuth, scan.scan_elevation});
  add_zone(s);
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
    state.push_back(put(bytes, column));
  const auto counted = [&](const Column& counts, const Columns& all) {
    Json j{{"count", put(bytes, counts)}};
    j.update(all.json(bytes));
    return j;
  };
  Json j{{"t", put(bytes, t_)}, {"state", std::move(state)}};
  j["tracks"] = counted(track_counts_, tracks_);
  j["warnings"] = counted(warning_counts_, warnings_);
  j["scan"] = scan_.empty() ? Json() : scan_.json(bytes);
  j["zone"] = zone_.empty() ? Json() : zone_.json(bytes);
  return j;
}

}  // namespace eyrie::page
