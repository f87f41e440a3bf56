// SPDX-License-Identifier: MIT
#include "model/track/filter.hpp"

#include <algorithm>

namespace eyrie::model::track {
namespace {

/// The diagonal of a covariance that is turned by an angle with that sin^2 about a random axis
/// across the line: the trace of along + 2 across stays.
void turn(AxisState& along, AxisState& across, double sin2) {
  const auto mix = [sin2](double& a, double& b) {
    const double passed = sin2 * (a - b);
    a -= passed;
    b += passed / 2;
  };
  mix(along.position, across.position);
  mix(along.cross, across.cross);
  mix(along.velocity, across.velocity);
}

float worst_sigma(double a, double b) {
  return static_cast<float>(std::sqrt(std::max(a, b)));
}

void store(Track& track, const AxisState& along, const AxisState& across) {
  track.along = narrow(along);
  track.across = narrow(across);
  track.position_sigma = worst_sigma(along.position, across.position);
  track.velocity_sigma = worst_sigma(along.velocity, across.velocity);
}

void stamp(Track& track, const Contact& contact, double time) {
  track.time = time;
  track.sensed_time = time;
  if (contact.source == kFromVisual)
    track.seen_time = time;
  track.truth = contact.truth;
  track.sources = static_cast<std::uint8_t>(track.sources | contact.source);
  track.fresh = contact.source;
  if (track.hits < 255)
    ++track.hits;
}

}  // namespace

Prediction predict(const Track& track, const Tracker& tracker, const Ownship& ownship,
                   double time) {
  const double dt = time - track.time;
  Prediction result{position_at(track, time), track.velocity,
                    predicted(widen(track.along), dt, tracker.maneuver),
                    predicted(widen(track.across), dt, tracker.maneuver)};
  const Vec3 sight = result.position - ownship.position;
  const double range2 = norm2(sight);
  if (range2 > 0 && dt > 0) {
    const Vec3 turned = cross(sight, track.velocity - ownship.velocity) * (dt / range2);
    const double tangent2 = norm2(turned);  // the angle turned in dt, as its tangent, squared
    turn(result.along, result.across, tangent2 / (1 + tangent2));
  }
  return result;
}

double deviations_of(const Prediction& prediction, const Contact& contact) {
  const Vec3 residual = contact.position - prediction.position;
  const double along = dot(residual, contact.line);
  const double across2 = std::max(norm2(residual) - along * along, 0.0);
  const double along_variance =
      prediction.along.position + contact.sigma_along * contact.sigma_along;
  const double across_variance =
      prediction.across.position + contact.sigma_across * contact.sigma_across;
  return along * along / along_variance + across2 / across_variance;
}

void filter(Track& track, const Prediction& prediction, const Contact& contact, double time) {
  AxisState along = prediction.along, across = prediction.across;
  Vec3 position = prediction.position, velocity = prediction.velocity;

  // position, along and across the line of sight
  const Vec3 residual = contact.position - position;
  const Vec3 residual_along = dot(residual, contact.line) * contact.line;
  const Vec3 residual_across = residual - residual_along;
  const Gains a = update_position(along, contact.sigma_along * contact.sigma_along);
  const Gains b = update_position(across, contact.sigma_across * contact.sigma_across);
  position += a.position * residual_along + b.position * residual_across;
  velocity += a.velocity * residual_along + b.velocity * residual_across;

  // speed along the line, from the Doppler shift
  if (contact.sigma_speed > 0) {
    const double faster = contact.speed_along - dot(velocity, contact.line);
    const Gains c = update_velocity(along, contact.sigma_speed * contact.sigma_speed);
    position += (c.position * faster) * contact.line;
    velocity += (c.velocity * faster) * contact.line;
  }

  track.position = position;
  track.velocity = velocity;
  store(track, along, across);
  stamp(track, contact, time);
}

Track first_track(const Tracker& tracker, const Contact& contact, double time) {
  Track track;
  track.first_time = time;
  track.sensed_time = track.seen_time = kNever;
  track.position = contact.position;

  const double unknown = tracker.initial_speed * tracker.initial_speed;
  AxisState along{contact.sigma_along * contact.sigma_along, 0, unknown};
  AxisState across{contact.sigma_across * contact.sigma_across, 0, unknown};
  if (contact.sigma_speed > 0) {
    const Gains gains = update_velocity(along, contact.sigma_speed * contact.sigma_speed);
    track.velocity = (gains.velocity * contact.speed_along) * contact.line;
  }
  store(track, along, across);
  stamp(track, contact, time);
  return track;
}

void refresh_sigmas(Track& track, const Tracker& tracker, double time) {
  const double dt = time - track.time;
  const AxisState along = predicted(widen(track.along), dt, tracker.maneuver);
  const AxisState across = predicted(widen(track.across), dt, tracker.maneuver);
  track.position_sigma = worst_sigma(along.position, across.position);
  track.velocity_sigma = worst_sigma(along.velocity, across.velocity);
}

namespace {

/// The closest first, of equal ones the older track and then the earlier contact.
struct Pair {
  double deviations2;
  std::uint8_t track, contact;
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

}  // namespace

std::array<std::uint8_t, kMaxContacts> associate(const Tracker& tracker,
                                                 std::span<const Prediction> tracks,
                                                 std::span<const Contact> contacts) {
  EYRIE_ASSERT(tracks.size() <= kMaxTracks && contacts.size() <= kMaxContacts);

  // every pair within the gates
  std::array<Pair, kMaxTracks * kMaxContacts> pairs;
  std::size_t count = 0;
  const double gate2 = tracker.gate * tracker.gate;
  for (std::size_t t = 0; t < tracks.size(); ++t)
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      if (norm2(contacts[c].position - tracks[t].position) > reach2(tracker, contacts[c]))
        continue;
      const double deviations2 = deviations_of(tracks[t], contacts[c]);
      if (deviations2 <= gate2)
        pairs[count++] = {deviations2, static_cast<std::uint8_t>(t), static_cast<std::uint8_t>(c)};
    }

  // the closest first
  std::sort(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(count));
  std::array<std::uint8_t, kMaxContacts> track_of;
  track_of.fill(kNoTrack);
  std::uint32_t used = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Pair& pair = pairs[i];
    if (track_of[pair.contact] != kNoTrack || (used >> pair.track & 1) != 0)
      continue;
    track_of[pair.contact] = pair.track;
    used |= 1u << pair.track;
  }
  return track_of;
}

}  // namespace eyrie::model::track
