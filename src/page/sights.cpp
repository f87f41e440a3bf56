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

void Sights::add_track(std::int64_t id, PlayerId truth, model::Identity identity, bool target,
                       const Vec3& position, double age) {
  const OnMap at = on_map(scenario_.library->reference, position);
  ++track_count_;
  tracks_.id.add_rounded(id);
  tracks_.truth.add_rounded(scenario_.roster.find(truth) ? std::int64_t{truth.value} - 1 : -1);
  tracks_.identity.add_rounded(static_cast<std::int64_t>(identity));
  tracks_.target.add_rounded(target);
  tracks_.east.add(at.east);
  tracks_.north.add(at.north);
  tracks_.up.add(at.up);
  tracks_.age.add(age);
}

void Sights::add_warning(const std::string& kind, double bearing, double range, PlayerId truth) {
  ++warning_count_;
  warnings_.kind.add_rounded(texts_.number(kind));
  warnings_.bearing.add(wrap_tau(bearing));
  warnings_.range.add(range);
  const std::string name = scenario_.roster.find(truth) ? scenario_.roster.name(truth)
                                                        : fmt::format("missile {}", truth.value);
  warnings_.name.add_rounded(texts_.number(truth ? name : "?"));
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
  least_.add(zone.r_min);
  no_escape_.add(zone.r_ne);
  most_.add(zone.r_max);
}

void Sights::end_sight() {
  tracks_.count.add_rounded(track_count_);
  warnings_.count.add_rounded(warning_count_);
  track_count_ = warning_count_ = 0;
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
  mode_.add_rounded(radar ? static_cast<std::int64_t>(radar->mode) : 0);
  azimuth_.add(radar ? radar->scan_azimuth : 0);
  elevation_.add(radar ? radar->scan_elevation : 0);
  add_zone(s);
  end_sight();
}

void Sights::add(const driver::State& s) {
  add_state(s);
  std::int64_t number = 0;
  for (const model::Sighted& seen : s.lookout.all())
    add_track(++number, seen.truth, seen.identity, s.watched() == &seen, seen.position,
              s.time - seen.time);
  end_sight();
}

Json Sights::json(ColumnBytes& bytes) const {
  Json state = Json::array();
  for (const Column& column : state_)
    state.push_back(put(bytes, column));
  Json j{{"t", put(bytes, t_)}, {"state", std::move(state)}};
  j["tracks"] = {{"count", put(bytes, tracks_.count)},   {"id", put(bytes, tracks_.id)},
                 {"truth", put(bytes, tracks_.truth)},   {"identity", put(bytes, tracks_.identity)},
                 {"target", put(bytes, tracks_.target)}, {"east", put(bytes, tracks_.east)},
                 {"north", put(bytes, tracks_.north)},   {"up", put(bytes, tracks_.up)},
                 {"age", put(bytes, tracks_.age)}};
  j["warnings"] = {{"count", put(bytes, warnings_.count)},
                   {"kind", put(bytes, warnings_.kind)},
                   {"bearing", put(bytes, warnings_.bearing)},
                   {"range", put(bytes, warnings_.range)},
                   {"name", put(bytes, warnings_.name)}};
  const bool pilots = mode_.size() > 0;
  j["scan"] = pilots ? Json{{"mode", put(bytes, mode_)},
                            {"azimuth", put(bytes, azimuth_)},
                            {"elevation", put(bytes, elevation_)}}
                     : Json();
  j["zone"] = pilots ? Json{{"min", put(bytes, least_)},
                            {"no_escape", put(bytes, no_escape_)},
                            {"max", put(bytes, most_)}}
                     : Json();
  return j;
}

}  // namespace eyrie::page
