// SPDX-License-Identifier: MIT
#include <algorithm>

#include "model/datalink/datalink.hpp"

namespace eyrie::model::datalink {
namespace {

std::array<float, 3> narrow(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

/// A track counts as held by the own sensors for so long after their last contact (s).
constexpr double kHeld = 5;

bool held(const Track& track, double time) {
  return time - track.sensed_time <= kHeld || (track.fresh & kFromTruth) != 0;
}

std::uint8_t engagement(const Track& track, const OwnReport& own) {
  const bool shot =
      std::find(own.shot_at.begin(), own.shot_at.end(), track.id) != own.shot_at.end();
  return static_cast<std::uint8_t>((track.id == own.target ? kTargeted : 0) | (shot ? kShotAt : 0));
}

SharedTrack share(const Track& track, const OwnReport& own) {
  return {.position = narrow(position_at(track, own.time)),
          .velocity = narrow(track.velocity),
          .position_sigma = track.position_sigma,
          .velocity_sigma = track.velocity_sigma,
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
  return {};
}

void transmit(DatalinkSent& sent, const OwnReport& own, const TrackFile& tracks) {
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
  for (std::uint32_t i = 0; i < message.track_count; ++i)
    message.tracks[i] = share(tracks.tracks[merits[i].index], own);
  ++sent.sent;
}

}  // namespace eyrie::model::datalink
