// SPDX-License-Identifier: MIT
#include <algorithm>

#include "model/track/mixture.hpp"

namespace eyrie::model::track {
namespace {

float worst_sigma(double a, double b) {
  return static_cast<float>(std::sqrt(std::max(a, b)));
}

/// A straight flight that becomes a turn: some acceleration, nobody knows which.
AxisState with_acceleration(const AxisState& c, double variance) {
  return {
      .position = c.position, .cross = c.cross, .velocity = c.velocity, .acceleration = variance};
}

double variance_of(const Motion& motion) {
  return motion.maneuver * motion.maneuver;
}

void carry(Mode& mode, const Transition& t) {
  mode.position += t.dt * mode.velocity + t.to_position * mode.acceleration;
  mode.velocity += t.to_velocity * mode.acceleration;
  mode.acceleration = t.kept * mode.acceleration;
  mode.along = predicted(mode.along, t);
  mode.across = predicted(mode.across, t);
}

void store(Track& track, const Mode& straight, const Mode& turning, const Weights& weights,
           const Covariance& covariance) {
  track.position = weights.mean(straight.position, turning.position);
  track.velocity = weights.mean(straight.velocity, turning.velocity);
  track.along = narrow(straight.along);
  track.across = narrow(straight.across);
  track.turning = {.along = turning.along.as<float>(),
                   .across = turning.across.as<float>(),
                   .position = narrow(turning.position - straight.position),
                   .velocity = narrow(turning.velocity - straight.velocity),
                   .acceleration = narrow(turning.acceleration),
                   .probability = static_cast<float>(turning.probability)};
  track.position_sigma = worst_sigma(covariance.along.position, covariance.across.position);
  track.velocity_sigma = worst_sigma(covariance.along.velocity, covariance.across.velocity);
}

void store(Track& track, const Mode& straight, const Mode& turning, const Vec3& line) {
  const Weights weights(straight, turning);
  store(track, straight, turning, weights, covariance_of(straight, turning, weights, line));
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

/// Variance of a contact along its line: what a bearing alone knows there it has said at birth.
double along_variance(const Contact& contact) {
  constexpr double kNothing = 1e18;  // m^2
  return contact.bearing_only ? kNothing : contact.sigma_along * contact.sigma_along;
}

/// Variance across, where a mode is: a bearing alone is as wide there as the mode is far.
double across_variance(const Mode& mode, const Contact& contact) {
  if (!contact.bearing_only)
    return contact.sigma_across * contact.sigma_across;
  const Vec3 sensor = contact.position - contact.range * contact.line;
  const double angle = contact.sigma_across / contact.range;
  return angle * angle * norm2(mode.position - sensor);
}

/// How far a contact is from where a mode expects it.
struct Residual {
  Vec3 along, across;  ///< m
  double faster = 0;   ///< m/s along the line, after the position is known
  double speed = 0;    ///< m^2/s^2, variance of that
  Surprise surprise;
};
Residual residual_of(const Mode& mode, const Contact& contact) {
  const double along_total = mode.along.position + along_variance(contact);
  const double across_total = mode.across.position + across_variance(mode, contact);
  const Vec3 apart = contact.position - mode.position;
  const double ahead = dot(apart, contact.line);
  Residual r{.along = ahead * contact.line};
  r.across = apart - r.along;
  r.surprise = {ahead * ahead / along_total + norm2(r.across) / across_total,
                along_total * across_total * across_total};
  if (contact.sigma_speed > 0) {
    const double gain = mode.along.cross / along_total;
    r.faster = contact.speed_along - dot(mode.velocity, contact.line) - gain * ahead;
    r.speed =
        mode.along.velocity - gain * mode.along.cross + contact.sigma_speed * contact.sigma_speed;
    r.surprise.deviations2 += r.faster * r.faster / r.speed;
    r.surprise.volume *= r.speed;
  }
  return r;
}

/// A mode after a contact: position along and across the line of sight, then the speed along it.
Surprise update(Mode& mode, const Contact& contact) {
  const Residual r = residual_of(mode, contact);
  const Gains a = update_position(mode.along, along_variance(contact));
  const Gains b = update_position(mode.across, across_variance(mode, contact));
  mode.position += a.position * r.along + b.position * r.across;
  mode.velocity += a.velocity * r.along + b.velocity * r.across;
  mode.acceleration += a.acceleration * r.along + b.acceleration * r.across;
  if (contact.sigma_speed > 0) {
    const Gains c = update_velocity(mode.along, contact.sigma_speed * contact.sigma_speed);
    const Vec3 faster = r.faster * contact.line;
    mode.position += c.position * faster;
    mode.velocity += c.velocity * faster;
    mode.acceleration += c.acceleration * faster;
  }
  return r.surprise;
}

/// exp() of more than that is not needed to be sure.
constexpr double kSure = 100;

/// The likeliest first, of equal ones the older track and then the earlier contact.
struct Pair {
  double misfit;
  std::uint8_t track, contact;
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

/// The diagonal of a covariance that is turned by an angle with that sin^2 about a random axis
/// across the line: the trace of along + 2 across stays.
void turn_sight(AxisState& along, AxisState& across, double sin2) {
  const AxisState passed = plus(plus({}, sin2, along), -sin2, across);
  along = plus(along, -1, passed);
  across = plus(across, 0.5, passed);
}

}  // namespace

Covariance covariance_of(const Prediction& p) {
  return covariance_of(p.straight, p.turning, Weights(p.straight, p.turning), p.line);
}

void turn_sight(Prediction& prediction, Covariance& covariance, double sin2) {
  turn_sight(covariance.along, covariance.across, sin2);
  turn_sight(prediction.straight.along, prediction.straight.across, sin2);
  turn_sight(prediction.turning.along, prediction.turning.across, sin2);
}

Prediction predict(const Track& track, const Tracker& tracker, const Ownship& ownship,
                   double time) {
  Interval ahead;
  return predict(track, tracker, ownship, time, ahead);
}

Prediction predict(const Track& track, const Tracker& tracker, const Ownship& ownship, double time,
                   Interval& ahead) {
  const double dt = time - track.time;
  if (ahead.straight.dt != dt)
    ahead = interval(tracker.motion, dt);
  const double turns = static_cast<double>(track.turning.probability);

  // what each model said at the last update
  const Vec3 aside = wide(track.turning.position), faster = wide(track.turning.velocity);
  Mode straight{.position = track.position - turns * aside,
                .velocity = track.velocity - turns * faster,
                .along = wide(track.along),
                .across = wide(track.across),
                .probability = 1 - turns};
  Mode turning{.position = straight.position + aside,
               .velocity = straight.velocity + faster,
               .acceleration = wide(track.turning.acceleration),
               .along = track.turning.along.as<double>(),
               .across = track.turning.across.as<double>(),
               .probability = turns};

  // as the line of sight lies now
  const Vec3 sight = position_at(track, time) - ownship.position;
  const double range2 = norm2(sight);
  const Vec3 line = normalized(sight, {1, 0, 0});
  if (range2 > 0 && dt > 0) {
    const Vec3 turned = cross(sight, track.velocity - ownship.velocity) * (dt / range2);
    const double tangent2 = norm2(turned);  // the angle turned in dt, as its tangent, squared
    const double sin2 = tangent2 / (1 + tangent2);
    turn_sight(straight.along, straight.across, sin2);
    turn_sight(turning.along, turning.across, sin2);
  }

  // some may have begun a turn meanwhile, or ended one
  if (dt > 0) {
    Mode begun = straight, ended = turning;
    begun.probability *= ahead.begins;
    begun.along = with_acceleration(begun.along, variance_of(tracker.motion));
    begun.across = with_acceleration(begun.across, variance_of(tracker.motion));
    ended.probability *= ahead.ends;
    straight.probability *= 1 - ahead.begins;
    turning.probability *= 1 - ahead.ends;
    straight = mixture<false>(straight, ended, line);
    turning = mixture(turning, begun, line);
    carry(straight, ahead.straight);
    carry(turning, ahead.turning);
  }

  const Weights weights(straight, turning);
  return {.position = weights.mean(straight.position, turning.position),
          .velocity = weights.mean(straight.velocity, turning.velocity),
          .straight = straight,
          .turning = turning,
          .line = line};
}

Match match(const Prediction& prediction, const Contact& contact) {
  return {residual_of(prediction.straight, contact).surprise,
          residual_of(prediction.turning, contact).surprise};
}

double misfit(const Prediction& prediction, const Match& match) {
  const auto of = [](const Surprise& f, double probability) {
    return f.deviations2 + math::log(f.volume / std::max(probability * probability, 1e-12));
  };
  return std::min(of(match.straight, prediction.straight.probability),
                  of(match.turning, prediction.turning.probability));
}

std::array<std::uint8_t, kMaxContacts> associate(const Tracker& tracker, const Predictions& tracks,
                                                 std::span<const Contact> contacts,
                                                 std::uint32_t hostile) {
  EYRIE_ASSERT(contacts.size() <= kMaxContacts);

  // every pair within the gates
  std::array<Pair, kMaxTracks * kMaxContacts> pairs;
  std::size_t count = 0;
  const double gate2 = tracker.gate * tracker.gate;
  for (std::size_t t = 0; t < kMaxTracks; ++t) {
    const Prediction* track = tracks[t];
    for (std::size_t c = 0; track != nullptr && c < contacts.size(); ++c) {
      if (contacts[c].mate && (hostile >> t & 1) != 0)
        continue;
      if (norm2(contacts[c].position - track->position) > reach2(tracker, contacts[c]))
        continue;
      const Match m = match(*track, contacts[c]);
      if (m.deviations2() <= gate2)
        pairs[count++] = {misfit(*track, m), static_cast<std::uint8_t>(t),
                          static_cast<std::uint8_t>(c)};
    }
  }

  // the likeliest first
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

void filter(Track& track, const Prediction& prediction, const Contact& contact, double time) {
  Mode straight = prediction.straight, turning = prediction.turning;
  const Surprise a = update(straight, contact), b = update(turning, contact);

  // who foretold it better is believed more
  const double better = std::clamp((a.deviations2 - b.deviations2) / 2, -kSure, kSure);
  const double odds = std::sqrt(a.volume / b.volume) * math::exp(better) * turning.probability;
  turning.probability = odds / (odds + straight.probability);
  straight.probability = 1 - turning.probability;

  store(track, straight, turning, contact.line);
  stamp(track, contact, time);
}

Track first_track(const Tracker& tracker, const Contact& contact, double time) {
  const double unknown = tracker.initial_speed * tracker.initial_speed;
  Mode straight{.position = contact.position,
                .along = {contact.sigma_along * contact.sigma_along, 0, unknown},
                .across = {contact.sigma_across * contact.sigma_across, 0, unknown}};
  if (contact.sigma_speed > 0) {
    const Gains gains = update_velocity(straight.along, contact.sigma_speed * contact.sigma_speed);
    straight.velocity = (gains.velocity * contact.speed_along) * contact.line;
  }

  // both models start from the same place
  Mode turning = straight;
  turning.probability = tracker.motion.turning();
  straight.probability = 1 - turning.probability;
  turning.along = with_acceleration(turning.along, variance_of(tracker.motion));
  turning.across = with_acceleration(turning.across, variance_of(tracker.motion));
  Track track;
  store(track, straight, turning, contact.line);
  track.first_time = time;
  track.sensed_time = track.seen_time = kNever;
  stamp(track, contact, time);
  return track;
}

void set(Track& track, const Prediction& prediction, const Covariance& covariance, double time) {
  const Mode &straight = prediction.straight, &turning = prediction.turning;
  store(track, straight, turning, Weights(straight, turning), covariance);
  track.time = time;
}

Track carried_on(const Track& track, const Tracker& tracker, const Ownship& ownship, double time,
                 Interval& ahead) {
  Track later = track;
  const Prediction then = predict(track, tracker, ownship, time, ahead);
  set(later, then, covariance_of(then), time);
  return later;
}

namespace {

/// Moves one axis of a mode, the one along the line or those across it.
void join(Mode& own, const Mode& theirs, const Vec3& line, bool along, const Intersection& axis) {
  const auto part = [&](const Vec3& v) {
    const Vec3 on_line = dot(v, line) * line;
    return along ? on_line : v - on_line;
  };
  const Vec3 apart = part(theirs.position - own.position);
  const Vec3 faster = part(theirs.velocity - own.velocity);
  const Vec3 step = axis.position_position * apart + axis.position_velocity * faster;
  const Vec3 change = axis.velocity_position * apart + axis.velocity_velocity * faster;
  own.position += step;
  own.velocity += change;
  own.acceleration += axis.acceleration_position * step + axis.acceleration_velocity * change;
  (along ? own.along : own.across) = axis.covariance;
}

}  // namespace

bool take_in(Track& track, const Prediction& own, const Prediction& theirs, const Ownship& ownship,
             double time) {
  const Vec3 line = normalized(own.position - ownship.position, {1, 0, 0});
  Prediction joint = own;
  bool learned = false;
  const auto learn = [&](Mode& mode, const Mode& other) {
    const Intersection along = intersect(mode.along, other.along);
    const Intersection across = intersect(mode.across, other.across);
    join(mode, other, line, true, along);
    join(mode, other, line, false, across);
    learned = learned || along.worth_it || across.worth_it;
  };
  learn(joint.straight, theirs.straight);
  learn(joint.turning, theirs.turning);
  if (!learned)
    return false;

  // nobody knows how far the two beliefs in a turn depend on each other: the mean of their log odds
  const double turns = std::sqrt(own.turning.probability * theirs.turning.probability);
  const double not_so = std::sqrt(own.straight.probability * theirs.straight.probability);
  if (turns + not_so > 0) {
    joint.turning.probability = turns / (turns + not_so);
    joint.straight.probability = 1 - joint.turning.probability;
  }
  store(track, joint.straight, joint.turning, line);
  track.time = time;
  return true;
}

void refresh_sigmas(Track& track, const Tracker& tracker, double time, Interval& ahead) {
  const double dt = time - track.time;
  if (ahead.straight.dt != dt)
    ahead = interval(tracker.motion, dt);
  const double turns = static_cast<double>(track.turning.probability);
  const double begun = (1 - turns) * ahead.begins, stays = (1 - turns) - begun;
  const double fresh = variance_of(tracker.motion);

  // the variance is the mean over those that fly straight, turn, and have begun a turn
  double worst_place = 0, worst_speed = 0;
  const auto take = [&](const AxisState& straight, const AxisState& turning) {
    const AxisState begins = with_acceleration(straight, fresh);
    worst_place = std::max(worst_place, stays * later_position(straight, ahead.straight) +
                                            turns * later_position(turning, ahead.turning) +
                                            begun * later_position(begins, ahead.turning));
    worst_speed = std::max(worst_speed, stays * later_velocity(straight, ahead.straight) +
                                            turns * later_velocity(turning, ahead.turning) +
                                            begun * later_velocity(begins, ahead.turning));
  };
  take(wide(track.along), track.turning.along.as<double>());
  take(wide(track.across), track.turning.across.as<double>());

  // and the spread of their means
  const Vec3 faster =
      wide(track.turning.velocity) + ahead.turning.to_velocity * wide(track.turning.acceleration);
  const Vec3 aside = wide(track.turning.position) + dt * wide(track.turning.velocity) +
                     ahead.turning.to_position * wide(track.turning.acceleration);
  const double apart = turns * (1 - turns);
  track.position_sigma = worst_sigma(worst_place + apart * norm2(aside), 0);
  track.velocity_sigma = worst_sigma(worst_speed + apart * norm2(faster), 0);
}

}  // namespace eyrie::model::track
