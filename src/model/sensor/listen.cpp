// SPDX-License-Identifier: MIT
// The warning receiver and the datalink at work.
#include <algorithm>

#include "model/events.hpp"
#include "model/sensor/scene.hpp"

namespace eyrie::model::sensor {
namespace {

bool beyond_horizon(const Kinematics& own, const Emission& emission, double altitude) {
  const double range = horizon_range(own.altitude, altitude, kRadioEarth);
  return norm2(emission.position - own.position) > range * range;
}

/// The more urgent kinds first, then the stronger: smaller goes first.
double demerit(const Emission& emission, double strength) {
  return 1 / (1 + strength) - static_cast<double>(emission.kind);
}

void tell(const Self& self, const RwrWarning& warning) {
  self.out.emit(
      {.kind = EventKind::rwr_warning,
       .who = self.id,
       .whom = warning.emitter,
       .place = self.kinematics.position,
       .values = {static_cast<float>(warning.kind), static_cast<float>(warning.bearing)}});
}

/// What a mate hears of the seekers that are heard here, too: on whom of the two each rests.
void compare_seekers(const Scene& scene, Self& self, const datalink::Mate& mate,
                     const datalink::DatalinkMessage& message) {
  const Kinematics& own = self.kinematics;
  const Vec3 path =
      position_at(mate, scene.time - kLevelAge) - (own.position - kLevelAge * own.velocity);
  const Vec3 offset = to_ned(own, path);
  for (std::uint32_t i = 0; i < message.seeker_count; ++i) {
    const datalink::SharedSeeker& theirs = message.seekers[i];
    const RwrWarning* ours = find(self.rwr, theirs.emitter);
    if (ours == nullptr ||
        !rests_on_mate(*ours, theirs, scene.time - message.time, offset, scene.time))
      continue;
    for (std::uint32_t k = 0; k < self.threats.count; ++k)
      if (self.threats.missiles[k].emitter == theirs.emitter)
        self.threats.missiles[k].at_mate = scene.time;
  }
}

}  // namespace

void listen_for_radars(const Scene& scene, Self& self) {
  const Rwr& rwr = *self.suite.rwr;
  const RwrAntenna antenna = aim(rwr, self.kinematics, self.fit.side);

  // the most urgent and strongest of what is heard
  const auto emission = scene.world.rows(scene.aircraft.emission);
  Nearest<kMaxWarnings> heard(kMaxWarnings);
  for (std::size_t j = 0; j < emission.size(); ++j)
    if (j != self.row)
      if (const double strength = hear(rwr, antenna, emission[j]); strength > 0)
        if (const double d = demerit(emission[j], strength);
            heard.wants(d) &&
            !beyond_horizon(self.kinematics, emission[j], scene.kinematics[j].altitude))
          heard.offer({d, static_cast<std::uint32_t>(j)});

  for (const Candidate& c : heard.items()) {
    const PlayerId emitter = scene.ids[c.row];
    const double strength = hear(rwr, antenna, emission[c.row]);
    const RwrWarning warning = warn(rwr, antenna, self.kinematics, emission[c.row], strength,
                                    emitter, scene.time, scene.draw(self.id, Stream::rwr, emitter));
    if (show(self.rwr, warning))
      tell(self, warning);
  }
}

void listen_for_seekers(const Scene& scene, Self& self) {
  const auto emissions = scene.world.rows(scene.missiles.emission);
  const auto ids = scene.world.ids(scene.missiles.table);
  const auto kinematics = scene.world.rows(scene.missiles.kinematics);
  const Rwr& rwr = *self.suite.rwr;
  const RwrAntenna antenna = aim(rwr, self.kinematics, self.fit.side);
  ThreatUpdate threats(self.threats, scene.time);
  for (std::size_t m = 0; m < emissions.size(); ++m) {
    const Emission& emission = emissions[m];
    const double strength = hear(rwr, antenna, emission);
    if (strength == 0 || beyond_horizon(self.kinematics, emission, kinematics[m].altitude))
      continue;
    const PlayerId emitter = ids[m];
    const RwrWarning warning = warn(rwr, antenna, self.kinematics, emission, strength, emitter,
                                    scene.time, scene.draw(self.id, Stream::rwr, emitter));
    show(self.rwr, warning);
    if (self.fit.privileged != 0)
      continue;  // knows better
    // a display that is full of others has no filter for it
    const RwrWarning* known = find(self.rwr, emitter);
    Sighting sighting{.bearing = known != nullptr ? known->bearing : warning.bearing,
                      .truth = emitter,
                      .emitter = emitter,
                      .source = kThreatFromRwr,
                      .begins_anew = known != nullptr && !has_line(*known)};
    if (const auto left = known != nullptr ? time_to_go(*known, rwr) : std::nullopt)
      sighting.arrival = scene.time + *left;
    if (threats.note(sighting))
      tell_missile(self, sighting);
  }
}

void read_datalink(const Scene& scene, Self& self) {
  datalink::DatalinkState& state = self.datalink;
  const auto& members = scene.library.flights[self.fit.flight].members;
  if (state.count == 0)
    start(state, members, self.id, scene.time);

  const datalink::Datalink* datalink = self.suite.datalink;
  for (std::uint32_t i = 0; i < state.count; ++i) {
    datalink::Mate& mate = state.members[i];
    if (i == state.self)
      continue;
    const auto row = scene.row(mate.id);
    // without a datalink, here or there, a mate calls on the radio, and one that is gone does not
    if (datalink == nullptr)
      mate.alive = row.has_value();
    if (row && (datalink == nullptr || scene.suite(*row).datalink == nullptr)) {
      mate.called = 1;
      mate.position = scene.kinematics[*row].position;
      mate.heard_time = scene.time;
      continue;
    }
    if (!row || datalink == nullptr)
      continue;
    const datalink::DatalinkSent& sent = scene.world.rows(scene.aircraft.sent)[*row];
    if (sent.sent == mate.received)
      continue;  // nothing since the last look
    const Kinematics& other = scene.kinematics[*row];
    const double reach = std::min(
        datalink->range, horizon_range(self.kinematics.altitude, other.altitude, kRadioEarth));
    const bool in_reach = norm2(other.position - self.kinematics.position) <= reach * reach;
    const datalink::DatalinkMessage* message =
        datalink::receive(mate, *datalink, sent, in_reach, scene.time,
                          scene.draw(self.id, Stream::datalink, mate.id));
    if (message != nullptr) {
      const track::TrackContext context = self.context(scene.time);
      datalink::fuse(self.tracks, context, *message, state, i);
      datalink::recognize_mate(self.tracks, context, mate);
      compare_seekers(scene, self, mate, *message);
    }
  }
  if (datalink != nullptr)
    if (const std::uint8_t lost = datalink::check_silence(state, *datalink, scene.time))
      datalink::forget_claims(self.tracks, lost);
}

}  // namespace eyrie::model::sensor
