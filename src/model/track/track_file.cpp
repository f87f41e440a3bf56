// SPDX-License-Identifier: MIT
#include "model/track/track_file.hpp"

#include <algorithm>

namespace eyrie::model::track {
namespace {

constexpr std::uint8_t kOwnSensors = kFromRadar | kFromVisual | kFromInfrared;

double range_of(const Track& track, const TrackContext& context) {
  return norm(position_at(track, context.time) - context.ownship.position);
}

void tell(const Track& track, const TrackContext& context, TrackNews::What what, std::uint8_t bits,
          double value) {
  context.news.add(
      {.what = what, .bits = bits, .id = track.id, .truth = track.truth, .value = value});
}

void drop(TrackFile& file, std::size_t index, const TrackContext& context) {
  if (file.tracks[index].confirmed)
    tell_lost(file.tracks[index], context);
  const auto end = file.tracks.begin() + file.count;
  std::copy(file.tracks.begin() + static_cast<std::ptrdiff_t>(index) + 1, end,
            file.tracks.begin() + static_cast<std::ptrdiff_t>(index));
  file.tracks[--file.count] = {};
}

void confirm_if_due(Track& track, const TrackContext& context) {
  if (track.confirmed || track.hits < context.tracker.confirm_hits)
    return;
  track.confirmed = 1;
  tell_confirmed(track, context);
}

/// What the look said about who it is: the eye is believed always, a reply or its absence counts.
void take_identity(Track& track, const Contact& contact, const TrackContext& context) {
  if (contact.interrogated) {
    Track asked = track;
    conclude(asked, context.iff_tries, contact.identity == Identity::friendly);
    track.unanswered = asked.unanswered;
    if (asked.identity == Identity::unknown)
      track.identity = Identity::unknown;
    else
      identify(track, asked.identity, context);
  } else if (contact.identity != Identity::unknown) {
    identify(track, contact.identity, context);
  }
}

/// The track that makes room for a newcomer at `range` (m), or kMaxTracks.
std::size_t least_worth(const TrackFile& file, const TrackContext& context, double range) {
  std::size_t farthest = kMaxTracks, stalest = kMaxTracks;
  double farthest_range = range, stalest_age = context.tracker.coast_time / 2;
  for (std::size_t i = 0; i < file.count; ++i) {
    const Track& track = file.tracks[i];
    if (!track.confirmed) {
      if (const double r = range_of(track, context); r > farthest_range) {
        farthest = i;
        farthest_range = r;
      }
    } else if (const double age = context.time - track.time; age > stalest_age) {
      stalest = i;
      stalest_age = age;
    }
  }
  return farthest != kMaxTracks ? farthest : stalest;
}

/// Whether two tracks may be one target: never if one sensor goes on holding both, because a sensor
/// that gives two contacts in one look has seen two targets. Eyes look at everything at once; a
/// radar comes by at different times. A friend is no hostile.
bool may_be_one(const Track& a, const Track& b, const TrackContext& context) {
  if (a.identity != b.identity && a.identity != Identity::unknown &&
      b.identity != Identity::unknown)
    return false;
  if (a.time == b.time && (a.fresh & b.fresh) != 0)
    return false;
  if (!a.confirmed || !b.confirmed || (a.sources & b.sources & kOwnSensors) == 0)
    return true;
  const double apart = std::fabs(a.sensed_time - b.sensed_time);
  const bool by_eye = a.fresh == kFromVisual && b.fresh == kFromVisual;
  return apart >= (by_eye ? context.tracker.glance_time : context.tracker.coast_time / 4);
}

bool coincide(const Prediction& a, const Prediction& b, const Covariance& of_a,
              const Covariance& of_b, const TrackContext& context) {
  const double gate2 = context.tracker.merge_gate * context.tracker.merge_gate;
  const Vec3 apart = a.position - b.position;
  const Vec3 line = normalized(a.position - context.ownship.position, {1, 0, 0});
  const double along = dot(apart, line), across2 = std::max(norm2(apart) - along * along, 0.0);
  if (across2 > context.tracker.max_gate * context.tracker.max_gate)
    return false;
  if (along * along / (of_a.along.position + of_b.along.position) +
          across2 / (of_a.across.position + of_b.across.position) >
      gate2)
    return false;
  const double speed_variance = std::max(of_a.along.velocity, of_a.across.velocity) +
                                std::max(of_b.along.velocity, of_b.across.velocity);
  return norm2(a.velocity - b.velocity) <= gate2 * speed_variance;
}

/// `into` is the older one and keeps its id.
void absorb(Track& into, const Track& from, bool from_is_better, const TrackContext& context) {
  if (from_is_better) {
    into.position = from.position;
    into.velocity = from.velocity;
    into.time = from.time;
    into.along = from.along;
    into.across = from.across;
    into.turning = from.turning;
    into.truth = from.truth;
    into.fresh = from.fresh;
  }
  into.first_time = std::min(into.first_time, from.first_time);
  into.sensed_time = std::max(into.sensed_time, from.sensed_time);
  into.seen_time = std::max(into.seen_time, from.seen_time);
  into.sources = static_cast<std::uint8_t>(into.sources | from.sources);
  into.hits = static_cast<std::uint8_t>(std::min(255, into.hits + from.hits));
  into.unanswered = std::max(into.unanswered, from.unanswered);
  into.targeted_by |= from.targeted_by;
  into.shot_by |= from.shot_by;
  into.absorbed = {from.id, from.absorbed[0] ? from.absorbed[0] : into.absorbed[0]};
  if (into.identity == Identity::unknown)
    identify(into, from.identity, context);
  if (from.confirmed && !into.confirmed)
    into.hits = std::max(into.hits, static_cast<std::uint8_t>(context.tracker.confirm_hits));
  confirm_if_due(into, context);
}

/// Where a track is now, and the square of how far off it may be.
struct Place {
  Vec3 position;
  double variance;
};
Place place_of(const Track& track, double time) {
  const auto sigma = static_cast<double>(track.position_sigma);
  return {position_at(track, time), sigma * sigma};
}

/// Farther apart than this no two tracks can be one: cheap, and true of nearly all pairs.
bool far_apart(const Place& a, const Place& b, double gate) {
  return norm2(a.position - b.position) > gate * gate * (a.variance + b.variance) * (1 + 1e-6);
}

/// Needs sigmas of now.
void merge_duplicates(TrackFile& file, const TrackContext& context, Interval& ahead) {
  if (file.count < 2)
    return;
  std::array<Place, kMaxTracks> places;
  for (std::size_t i = 0; i < file.count; ++i)
    places[i] = place_of(file.tracks[i], context.time);

  for (std::size_t i = 0; i + 1 < file.count; ++i)
    for (std::size_t j = i + 1; j < file.count;) {
      Track &older = file.tracks[i], &newer = file.tracks[j];
      if (far_apart(places[i], places[j], context.tracker.merge_gate) ||
          !may_be_one(older, newer, context)) {
        ++j;
        continue;
      }
      const Prediction a = predict(older, context.tracker, context.ownship, context.time, ahead);
      const Prediction b = predict(newer, context.tracker, context.ownship, context.time, ahead);
      const Covariance of_a = covariance_of(a), of_b = covariance_of(b);
      if (!coincide(a, b, of_a, of_b, context)) {
        ++j;
        continue;
      }
      const bool newer_is_better = of_b.along.position + 2 * of_b.across.position <
                                   of_a.along.position + 2 * of_a.across.position;
      absorb(older, newer, newer_is_better, context);
      refresh_sigmas(older, context.tracker, context.time, ahead);
      newer.confirmed = 0;  // it is not lost, it lives on in the older one
      drop(file, j, context);
      std::copy(places.begin() + j + 1, places.begin() + file.count + 1, places.begin() + j);
      places[i] = place_of(older, context.time);
    }
}

}  // namespace

void identify(Track& track, Identity identity, const TrackContext& context) {
  if (identity == track.identity || identity == Identity::unknown)
    return;
  track.identity = identity;
  track.unanswered = 0;
  tell(track, context, TrackNews::What::identified, static_cast<std::uint8_t>(identity),
       range_of(track, context));
}

void tell_confirmed(const Track& track, const TrackContext& context) {
  tell(track, context, TrackNews::What::confirmed, track.sources, range_of(track, context));
}

void tell_lost(const Track& track, const TrackContext& context) {
  tell(track, context, TrackNews::What::lost, track.sources, context.time - track.time);
}

std::size_t add_track(TrackFile& file, const TrackContext& context, const Track& track) {
  if (file.count == kMaxTracks) {
    const std::size_t victim = least_worth(file, context, range_of(track, context));
    if (victim == kMaxTracks)
      return kMaxTracks;
    drop(file, victim, context);
  }
  const std::size_t index = file.count++;
  file.next_id = std::max(file.next_id, 1u);  // a row is born as zeros
  file.tracks[index] = track;
  file.tracks[index].id = TrackId{file.next_id++};
  return index;
}

void update(TrackFile& file, const TrackContext& context, std::span<const Contact> contacts) {
  EYRIE_ASSERT(contacts.size() <= kMaxContacts);
  if (contacts.empty())
    return;

  // only where a contact is anywhere near
  Predictions predictions;
  Interval ahead;
  std::uint32_t hostile = 0;
  for (std::size_t i = 0; i < file.count; ++i) {
    hostile |= (file.tracks[i].identity == Identity::hostile ? 1u : 0u) << i;
    const Vec3 position = position_at(file.tracks[i], context.time);
    const bool near = std::ranges::any_of(contacts, [&](const Contact& c) {
      return norm2(c.position - position) <= reach2(context.tracker, c);
    });
    if (near)
      predictions.set(
          i, predict(file.tracks[i], context.tracker, context.ownship, context.time, ahead));
  }
  const auto track_of = associate(context.tracker, predictions, contacts, hostile);

  // known tracks first: a newcomer may push one out
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (track_of[c] == kNoTrack)
      continue;
    Track& track = file.tracks[track_of[c]];
    filter(track, *predictions[track_of[c]], contacts[c], context.time);
    take_identity(track, contacts[c], context);
    confirm_if_due(track, context);
  }

  for (std::size_t c = 0; c < contacts.size(); ++c) {
    if (track_of[c] != kNoTrack)
      continue;
    const std::size_t index =
        add_track(file, context, first_track(context.tracker, contacts[c], context.time));
    if (index == kMaxTracks)
      continue;
    take_identity(file.tracks[index], contacts[c], context);
    confirm_if_due(file.tracks[index], context);
  }
}

void upkeep(TrackFile& file, const TrackContext& context) {
  for (std::size_t i = 0; i < file.count;) {
    const Track& track = file.tracks[i];
    const double patience =
        track.confirmed ? context.tracker.coast_time : context.tracker.tentative_time;
    if (context.time - track.time > patience)
      drop(file, i, context);
    else
      ++i;
  }
  Interval ahead;
  for (std::size_t i = 0; i < file.count; ++i)
    refresh_sigmas(file.tracks[i], context.tracker, context.time, ahead);
  merge_duplicates(file, context, ahead);
}

}  // namespace eyrie::model::track
