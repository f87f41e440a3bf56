// SPDX-License-Identifier: MIT
#include "model/vehicle/lookout.hpp"

#include <algorithm>

namespace eyrie::model::vehicle {

void look_up(const sensor::Visual& visual, const Watcher& watcher, const Sky& sky,
             Lookout& lookout) {
  const sensor::Eyes eyes = sensor::eyes_of(watcher.own);
  for (std::size_t j = 0; j < sky.ids.size(); ++j) {
    const Kinematics& other = sky.kinematics[j];
    const double range = norm(other.position - eyes.position);
    if (range > visual.range || range <= 0)
      continue;
    const auto draw = [&](Stream stream) {
      return Draw(watcher.seed, watcher.id, stream, watcher.step, sky.ids[j].value);
    };
    const Sighted* known = lookout.find(sky.ids[j]);
    const sensor::Cue cue = !known ? sensor::Cue::none
                            : watcher.time - known->seen_time <= visual.hold_time
                                ? sensor::Cue::held
                                : sensor::Cue::cued;
    const Signature& signature = *sky.signatures[sky.fit[j].type];
    if (!sensor::glimpsed(visual, eyes, other, signature, range, cue,
                          draw(Stream::visual).uniform()))
      continue;
    const Contact contact =
        estimate(visual, eyes, other.position, sky.ids[j], draw(Stream::visual_noise));
    sight(lookout, eyes.position,
          {.position = contact.position,
           .time = watcher.time,
           .seen_time = watcher.time,
           .truth = sky.ids[j],
           .identity = sensor::recognized(visual, eyes, other, signature, range, watcher.side,
                                          sky.fit[j].side)});
  }
  forget(lookout, watcher.time);
}

void sight(Lookout& lookout, const Vec3& eyes, const Sighted& seen) {
  if (Sighted* known = lookout.find(seen.truth)) {
    if (seen.time < known->time)
      return;
    const Sighted before = *known;
    *known = seen;
    known->seen_time = std::max(seen.seen_time, before.seen_time);
    if (before.identity != Identity::unknown)
      known->identity = before.identity;
    return;
  }
  if (lookout.count < Lookout::kAircraft) {
    lookout.sighted[lookout.count++] = seen;
    return;
  }
  const auto place = std::ranges::max_element(
      lookout.sighted, {}, [&](const Sighted& known) { return norm2(known.position - eyes); });
  if (norm2(seen.position - eyes) < norm2(place->position - eyes))
    *place = seen;
}

void warn(Lookout& lookout, const Vec3& eyes, const datalink::DatalinkMessage& message) {
  for (std::uint32_t i = 0; i < message.track_count; ++i) {
    const datalink::SharedTrack& track = message.tracks[i];
    sight(lookout, eyes,
          {.position = wide(track.position),
           .time = message.time,
           .truth = track.truth,
           .identity = track.identity});
  }
}

TrackFile as_tracks(const Lookout& lookout) {
  TrackFile file;
  for (const Sighted& seen : lookout.all()) {
    Track& track = file.tracks[file.count++];
    track.id = TrackId{file.count};  // none would be the target of who has none
    track.position = seen.position;
    track.time = seen.time;
    track.sensed_time = seen.seen_time;
    track.truth = seen.truth;
    track.identity = seen.identity;
    track.confirmed = 1;
  }
  return file;
}

void forget(Lookout& lookout, double time) {
  drop_if(lookout.sighted, lookout.count,
          [&](const Sighted& seen) { return time - seen.time > kSightedMemory; });
}

}  // namespace eyrie::model::vehicle
