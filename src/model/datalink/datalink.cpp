// SPDX-License-Identifier: MIT
#include "model/datalink/datalink.hpp"

#include <algorithm>

#include "model/track/filter.hpp"

namespace eyrie::model::datalink {
namespace {

/// A track counts as held by the own sensors for so long after their last contact (s).
constexpr double kHeld = 5;

bool held(const Track& track, double time) {
  return time - track.sensed_time <= kHeld || (track.fresh & kFromTruth) != 0;
}

std::uint8_t engagement(const Track& track, const OwnReport& own) {
  const bool shot = std::ranges::any_of(own.shot_at, [&](TrackId at) { return track.named(at); });
  return static_cast<std::uint8_t>((track.named(own.target) ? kTargeted : 0) |
                                   (shot ? kShotAt : 0));
}

SharedTrack share(const Track& track, const OwnReport& own, const track::Tracker& tracker,
                  track::Interval& ahead) {
  const Track now =
      track::carried_on(track, tracker, {own.position, own.velocity}, own.time, ahead);
  return {.position = narrow(now.position),
          .velocity = narrow(now.velocity),
          .along = now.along,
          .across = now.across,
          .turning = now.turning,
          .truth = track.truth,
          .identity = track.identity,
          .engagement = engagement(track, own),
          .sensed = held(track, own.time)};
}

/// Smaller goes first: what is shot at, the target, then by distance.
struct Merit {
  int group = 0;
  double distance2 = 0;
  std::uint32_t index = 0;
  friend auto operator<=>(const Merit&, const Merit&) = default;
};

}  // namespace

std::string_view Datalink::problem() const {
  if (delay * rate > static_cast<double>(kMessages - 2))
    return "the delay must not be longer than two messages are apart";
  if (timeout < delay + 1 / rate)
    return "the timeout must not be shorter than the delay and the time between two messages";
  return {};
}

void transmit(DatalinkSent& sent, const OwnReport& own, const TrackFile& tracks,
              const track::Tracker& tracker) {
  std::array<Merit, kMaxTracks> merits;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < tracks.count; ++i) {
    const Track& track = tracks.tracks[i];
    const std::uint8_t engaged = engagement(track, own);
    const bool worth_sharing =
        track.confirmed && track.identity != Identity::friendly && held(track, own.time);
    if (engaged == 0 && !worth_sharing)
      continue;
    merits[count++] = {(engaged & kShotAt) != 0 ? 0
                       : engaged != 0           ? 1
                                                : 2,
                       norm2(position_at(track, own.time) - own.position), i};
  }
  std::sort(merits.begin(), merits.begin() + static_cast<std::ptrdiff_t>(count));

  DatalinkMessage& message = sent.messages[sent.sent % kMessages];
  message = {};
  message.time = own.time;
  message.position = own.position;
  message.velocity = narrow(own.velocity);
  message.fuel = static_cast<float>(own.fuel);
  message.track_count = static_cast<std::uint32_t>(std::min(count, kSharedTracks));
  track::Interval ahead;
  for (std::uint32_t i = 0; i < message.track_count; ++i)
    message.tracks[i] = share(tracks.tracks[merits[i].index], own, tracker, ahead);
  EYRIE_ASSERT(own.seekers.size() <= kSharedSeekers);
  std::ranges::copy(own.seekers, message.seekers.begin());
  message.seeker_count = static_cast<std::uint32_t>(own.seekers.size());
  ++sent.sent;
}

namespace {

/// Slack for sums of binary fractions when a time is compared with a delay (s).
constexpr double kClockSlack = 1e-9;

/// What a mate says about itself counts as one of the own tracks only if it fits as well as this.
constexpr double kRecognized = 2;       ///< standard deviations
constexpr double kRecognizedFar = 1e3;  ///< m
constexpr double kSpeedSlack = 30;      ///< m/s, for the turn the mate made since its message

/// A remote track nearer to the own aircraft than this is the own aircraft, seen by the mate.
constexpr double kSelf = 500;  ///< m

/// What the mate believes, now and as seen from here.
struct Estimate {
  track::Prediction place;
  track::Covariance covariance;
};
Estimate estimate_of(const SharedTrack& shared, const DatalinkMessage& message,
                     const track::TrackContext& context, track::Interval& ahead) {
  const Track told{.position = wide(shared.position),
                   .velocity = wide(shared.velocity),
                   .time = message.time,
                   .along = shared.along,
                   .across = shared.across,
                   .turning = shared.turning};
  track::Prediction theirs = track::predict(
      told, context.tracker, {message.position, wide(message.velocity)}, context.time, ahead);
  track::Covariance covariance = covariance_of(theirs);
  const Vec3 from_there = normalized(theirs.position - message.position, {1, 0, 0});
  const Vec3 from_here = normalized(theirs.position - context.ownship.position, {1, 0, 0});
  track::turn_sight(theirs, covariance, norm2(cross(from_there, from_here)));
  return {theirs, covariance};
}

Contact as_contact(const Estimate& theirs, const track::TrackContext& context) {
  Contact contact;
  contact.position = theirs.place.position;
  const Vec3 sight = contact.position - context.ownship.position;
  contact.range = norm(sight);
  contact.line = normalized(sight, {1, 0, 0});
  contact.sigma_along = std::sqrt(theirs.covariance.along.position);
  contact.sigma_across = std::sqrt(theirs.covariance.across.position);
  contact.source = kFromDatalink;
  return contact;
}

/// The own tracks as they are believed to be now, each predicted when it is asked for.
class Now {
 public:
  Now(const TrackFile& file, const track::TrackContext& context) : file_(file), context_(context) {}

  const track::Prediction& of(std::size_t i) {
    if (const track::Prediction* known = predictions_[i])
      return *known;
    return predictions_.set(i, track::predict(file_.tracks[i], context_.tracker, context_.ownship,
                                              context_.time, ahead_));
  }
  /// That track is another one since.
  void forget(std::size_t i) { predictions_.forget(i); }
  void forget_all() { predictions_.forget_all(); }

  /// The track that fits best, or kMaxTracks.
  std::size_t nearest(const Contact& contact, double& best) {
    std::size_t nearest = kMaxTracks;
    const double far2 = track::reach2(context_.tracker, contact);
    for (std::size_t i = 0; i < file_.count; ++i) {
      if (norm2(position_at(file_.tracks[i], context_.time) - contact.position) > far2)
        continue;
      const double deviations2 = track::match(of(i), contact).deviations2();
      if (deviations2 < best) {
        nearest = i;
        best = deviations2;
      }
    }
    return nearest;
  }

 private:
  const TrackFile& file_;
  const track::TrackContext& context_;
  track::Predictions predictions_;
  track::Interval ahead_;
};

/// Where a mate says it is, carried on to now.
Contact reported(const Mate& mate, const track::TrackContext& context) {
  Contact contact;
  contact.position = position_at(mate, context.time);
  contact.line = normalized(contact.position - context.ownship.position, {1, 0, 0});
  contact.sigma_along = contact.sigma_across = kSpeedSlack * (context.time - mate.time);
  return contact;
}

/// Whether the track could be a member of the own flight, as far as its places tell.
bool may_be_mate(const track::Prediction& place, const DatalinkState& state,
                 const track::TrackContext& context) {
  const double gate = context.tracker.gate;
  return any_mate(state, [&](const Mate& mate) {
    const Contact contact = reported(mate, context);
    return norm2(contact.position - place.position) <= track::reach2(context.tracker, contact) &&
           track::match(place, contact).deviations2() <= gate * gate;
  });
}

Track remote_track(const SharedTrack& shared, const track::TrackContext& context,
                   const Estimate& theirs) {
  Track track;
  track::set(track, theirs.place, theirs.covariance, context.time);
  track.first_time = context.time;
  track.sensed_time = track.seen_time = kNever;
  track.truth = shared.truth;
  track.sources = track.fresh = kFromDatalink;
  track.hits = static_cast<std::uint8_t>(std::min(context.tracker.confirm_hits, 255u));
  track.confirmed = 1;  // the sender has confirmed it
  return track;
}

}  // namespace

const DatalinkMessage* newest_arrived(const DatalinkSent& sent, double delay, double time,
                                      std::uint32_t& number) {
  const std::uint32_t kept = std::min<std::uint32_t>(sent.sent, kMessages);
  for (std::uint32_t back = 0; back < kept; ++back) {
    number = sent.sent - back;
    const DatalinkMessage& message = sent.messages[(number - 1) % kMessages];
    if (time - message.time >= delay - kClockSlack)
      return &message;
  }
  number = 0;
  return nullptr;
}

void start(DatalinkState& state, std::span<const PlayerId> members, PlayerId self, double time) {
  EYRIE_ASSERT(members.size() <= kMaxFlight);
  state = {};
  state.count = static_cast<std::uint32_t>(members.size());
  for (std::uint32_t i = 0; i < state.count; ++i) {
    Mate& mate = state.members[i];
    mate.id = members[i];
    mate.time = mate.heard_time = time;
    mate.alive = 1;
    if (members[i] == self)
      state.self = i;
  }
}

const DatalinkMessage* receive(Mate& mate, const Datalink& datalink, const DatalinkSent& sent,
                               bool in_reach, double time, Draw draw) {
  std::uint32_t number = 0;
  const DatalinkMessage* message = newest_arrived(sent, datalink.delay, time, number);
  if (message == nullptr || number <= mate.received)
    return nullptr;
  mate.received = number;
  if (!in_reach || (datalink.loss > 0 && draw.chance(datalink.loss)))
    return nullptr;
  mate.position = message->position;
  mate.velocity = message->velocity;
  mate.fuel = message->fuel;
  mate.time = message->time;
  mate.heard_time = time;
  mate.alive = 1;
  mate.reported = 1;
  return message;
}

std::uint8_t check_silence(DatalinkState& state, const Datalink& datalink, double time) {
  std::uint8_t lost = 0;
  for (std::uint32_t i = 0; i < state.count; ++i) {
    Mate& mate = state.members[i];
    if (i == state.self || !mate.alive || time - mate.heard_time <= datalink.timeout + kClockSlack)
      continue;
    mate.alive = 0;
    lost = static_cast<std::uint8_t>(lost | 1u << i);
  }
  return lost;
}

void forget_claims(TrackFile& tracks, std::uint8_t members) {
  const auto others = static_cast<std::uint8_t>(~members);
  for (std::uint32_t t = 0; t < tracks.count; ++t) {
    tracks.tracks[t].targeted_by &= others;
    tracks.tracks[t].shot_by &= others;
  }
}

void fuse(TrackFile& file, const track::TrackContext& context, const DatalinkMessage& message,
          const DatalinkState& state, std::uint32_t member) {
  const auto bit = static_cast<std::uint8_t>(1u << member);
  forget_claims(file, bit);

  Now now(file, context);
  track::Interval ahead;
  for (std::uint32_t i = 0; i < message.track_count; ++i) {
    const SharedTrack& shared = message.tracks[i];
    const Estimate theirs = estimate_of(shared, message, context, ahead);
    const Contact contact = as_contact(theirs, context);
    const double unsure = std::max(contact.sigma_along, contact.sigma_across);
    if (contact.range < kSelf + context.tracker.gate * unsure)
      continue;

    double best = context.tracker.gate * context.tracker.gate;
    std::size_t index = now.nearest(contact, best);
    if (index == kMaxTracks) {
      if (!shared.sensed)
        continue;
      index = track::add_track(file, context, remote_track(shared, context, theirs));
      now.forget_all();  // somebody may have made room for it
      if (index == kMaxTracks)
        continue;
      track::tell_confirmed(file.tracks[index], context);
    } else if (shared.sensed) {
      Track& track = file.tracks[index];
      if (track::take_in(track, now.of(index), theirs.place, context.ownship, context.time)) {
        now.forget(index);
        track.truth = shared.truth;
        track.fresh = kFromDatalink;
      }
      track.sources = static_cast<std::uint8_t>(track.sources | kFromDatalink);
    }

    Track& track = file.tracks[index];
    // the two may be neighbors: who stands where a friend may be is not called hostile for that
    if (track.identity == Identity::unknown &&
        (shared.identity != Identity::hostile || !may_be_mate(now.of(index), state, context)))
      track::identify(track, shared.identity, context);
    if ((shared.engagement & kTargeted) != 0)
      track.targeted_by |= bit;
    if ((shared.engagement & kShotAt) != 0)
      track.shot_by |= bit;
  }
}

void recognize_mate(TrackFile& file, const track::TrackContext& context, const Mate& mate) {
  if (!mate.reported)
    return;
  const Contact contact = reported(mate, context);
  const auto may_be = [&](const Track& track) {
    const double speed_slack =
        kSpeedSlack + kRecognized * static_cast<double>(track.velocity_sigma);
    return track.identity == Identity::unknown &&
           norm(position_at(track, context.time) - contact.position) <= kRecognizedFar &&
           norm(track.velocity - velocity_of(mate)) <= speed_slack;
  };
  if (std::none_of(file.tracks.begin(), file.tracks.begin() + file.count, may_be))
    return;
  double best = kRecognized * kRecognized;
  const std::size_t index = Now(file, context).nearest(contact, best);
  if (index != kMaxTracks && may_be(file.tracks[index]))
    track::identify(file.tracks[index], Identity::friendly, context);
}

}  // namespace eyrie::model::datalink
