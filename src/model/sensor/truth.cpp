// SPDX-License-Identifier: MIT
// Privileged players perceive the truth, in the same rows as everybody else.
#include <algorithm>

#include "model/sensor/scene.hpp"
#include "model/sensor/visual.hpp"

namespace eyrie::model::sensor {
namespace {

Identity true_identity(const Scene& scene, const Self& self, std::size_t j) {
  return identity_of(self.fit.side, scene.fit[j].side);
}

Track true_track(const Scene& scene, const Self& self, std::size_t j, const Track& before) {
  const Kinematics& other = scene.kinematics[j];
  Track track = before;
  track.position = other.position;
  track.velocity = other.velocity;
  track.time = track.sensed_time = scene.time;
  track.along = track.across = {};
  track.turning = {};
  track.position_sigma = track.velocity_sigma = 0;
  track.truth = scene.ids[j];
  track.sources |= kFromTruth;
  track.fresh = kFromTruth;
  track.hits = 255;
  track.confirmed = 1;
  track.identity = true_identity(scene, self, j);
  return track;
}

/// m^2, on top for a friend: a crowd of friends must not push the enemy out of the tracks.
constexpr double kFriendLast = 1e16;

void know_aircraft(const Scene& scene, Self& self) {
  Nearest<kMaxTracks> nearest(kMaxTracks);
  for (std::size_t j = 0; j < scene.kinematics.size(); ++j) {
    if (j == self.row || is_nowhere(scene.kinematics[j]))
      continue;
    const bool is_friend = true_identity(scene, self, j) == Identity::friendly;
    nearest.offer({norm2(scene.kinematics[j].position - self.kinematics.position) +
                       (is_friend ? kFriendLast : 0),
                   static_cast<std::uint32_t>(j)});
  }

  // those known before keep their names; the others go
  std::array<bool, kMaxTracks> known{};
  TrackFile& file = self.tracks;
  const track::TrackContext context = self.context(scene.time);
  drop_if(file.tracks, file.count, [&](Track& track) {
    std::size_t n = 0;
    const auto items = nearest.items();
    while (n < items.size() && scene.ids[items[n].row] != track.truth)
      ++n;
    if (n == items.size() || known[n]) {
      track::tell_lost(track, context);
      return true;
    }
    known[n] = true;
    track = true_track(scene, self, items[n].row, track);
    return false;
  });

  for (std::size_t n = 0; n < nearest.items().size(); ++n) {
    if (known[n])
      continue;
    Track fresh{.first_time = scene.time, .seen_time = kNever};
    const Track track = true_track(scene, self, nearest.items()[n].row, fresh);
    if (const std::size_t i = track::add_track(file, context, track); i != kMaxTracks)
      track::tell_confirmed(file.tracks[i], context);
  }
}

/// The missiles that were launched at the own aircraft or whose seeker rests on it.
void know_missiles(const Scene& scene, Self& self) {
  const auto ids = scene.world.ids(scene.missiles.table);
  const auto kinematics = scene.world.rows(scene.missiles.kinematics);
  const auto state = scene.world.rows(scene.missiles.state);
  const auto emission = scene.world.rows(scene.missiles.emission);
  Nearest<kMaxThreats> nearest(kMaxThreats);
  for (std::size_t m = 0; m < ids.size(); ++m)
    if (state[m].intended == self.id || emission[m].dwell == self.id)
      nearest.offer({norm2(kinematics[m].position - self.kinematics.position),
                     static_cast<std::uint32_t>(m)});

  const Threats before = self.threats;
  self.threats = {};
  for (const Candidate& c : nearest.items()) {
    const Kinematics& missile = kinematics[c.row];
    const Vec3 sight = missile.position - self.kinematics.position;
    const Bearing bearing = bearing_of(self.kinematics, normalized(sight, self.kinematics.north));
    InboundMissile inbound{.bearing = bearing.azimuth,
                           .elevation = bearing.elevation,
                           .range = std::sqrt(c.distance2),
                           .time = scene.time,
                           .first_time = scene.time,
                           .position_time = scene.time,
                           .truth = ids[c.row],
                           .has_position = 1,
                           .sources = kThreatFromTruth};
    const double opening = dot(sight, missile.velocity - self.kinematics.velocity);
    inbound.closing = opening < 0;
    if (opening < 0)
      inbound.arrival = scene.time - c.distance2 / opening;

    const auto old = std::span(before.missiles).first(before.count);
    const auto known = std::ranges::find(old, inbound.truth, &InboundMissile::truth);
    if (known != old.end())
      inbound.first_time = known->first_time;
    else
      tell_missile(self, {.bearing = inbound.bearing, .truth = inbound.truth});
    self.threats.missiles[self.threats.count++] = inbound;
  }
}

void know_flight(const Scene& scene, Self& self) {
  datalink::DatalinkState& state = self.datalink;
  for (std::uint32_t i = 0; i < state.count; ++i) {
    datalink::Mate& mate = state.members[i];
    const auto row = scene.row(mate.id);
    mate.alive = row.has_value();
    if (!row)
      continue;
    const Kinematics& k = scene.kinematics[*row];
    mate.position = k.position;
    mate.velocity = narrow(k.velocity);
    mate.time = mate.heard_time = scene.time;
    mate.reported = 1;
  }
}

}  // namespace

void perceive_truth(const Scene& scene, Self& self) {
  know_aircraft(scene, self);
  know_missiles(scene, self);
  know_flight(scene, self);
}

}  // namespace eyrie::model::sensor
