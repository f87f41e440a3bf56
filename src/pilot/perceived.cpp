// SPDX-License-Identifier: MIT
#include "core/angle.hpp"
#include "pilot/action.hpp"
#include "pilot/state.hpp"
#include "team/values.hpp"

namespace eyrie::pilot {

std::vector<team::Perceived> perceived(const State& s) {
  std::vector<team::Perceived> all;
  for (const Seen& seen : s.tracks_seen()) {
    const bool chosen = s.target() == &seen;
    all.push_back({chosen ? "target" : "track",
                   seen.id().value,
                   seen.track->truth,
                   {team::action_value("identity", {}, seen.track->identity),
                    team::number_value("range", "m", seen.range),
                    team::number_value("bearing", "rad", wrap_tau(bearing_of(seen.ned))),
                    team::number_value("altitude", "m", altitude_of(s.own, seen.ned)),
                    team::number_value("closing", "m/s", s.closing_on(seen)),
                    team::number_value("age", "s", s.time - seen.track->time)}});
  }
  for (std::uint32_t i = 0; i < s.rwr.count; ++i) {
    const model::RwrWarning& warning = s.rwr.warnings[i];
    all.push_back({"radar",
                   i + 1,
                   warning.emitter,
                   {team::action_value("kind", {}, warning.kind),
                    team::number_value("bearing", "rad", wrap_tau(warning.bearing)),
                    team::number_value("known for", "s", s.time - warning.first_time)}});
  }
  for (std::uint32_t i = 0; i < s.threats.count; ++i) {
    const model::InboundMissile& m = s.threats.missiles[i];
    all.push_back({"missile",
                   i + 1,
                   m.truth,
                   {team::number_value("bearing", "rad", wrap_tau(m.bearing)),
                    team::number_value("range", "m", m.has_position ? m.range : ubf::kNoValue),
                    team::number_value("known for", "s", s.time - m.first_time)}});
  }
  return all;
}

}  // namespace eyrie::pilot
