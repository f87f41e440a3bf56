// SPDX-License-Identifier: MIT
#pragma once
/// \file  The datalink inside a flight: who is where, who is alive, who shoots at what.
/// docs/models/datalink.md says what it is worth.
#include "core/draw.hpp"
#include "model/fit.hpp"
#include "model/kinematics.hpp"
#include "model/track.hpp"
#include "model/track/track_file.hpp"

namespace eyrie::model::datalink {

inline constexpr std::size_t kSharedTracks = 4;
inline constexpr std::size_t kMessages = 4;
inline constexpr std::size_t kSharedSeekers = 4;

/// What the sender says about one of its tracks, as bits of SharedTrack::engagement.
enum TrackEngagement : std::uint8_t {
  kTargeted = 1,  ///< it is the sender's target
  kShotAt = 2,    ///< the sender has a missile on its way to it
};

/// One track of the sender, at the time of the message. Single precision: 0.03 m at 500 km.
struct SharedTrack {
  Vec3f position{};         ///< m, local frame
  Vec3f velocity{};         ///< m/s
  AxisCovariance along{};   ///< along the line of sight from the sender, as Track::along
  AxisCovariance across{};  ///< as Track::across
  Turning turning{};        ///< as Track::turning
  PlayerId truth{};         ///< passed on for debrief only
  Identity identity = Identity::unknown;
  std::uint8_t engagement = 0;  ///< bits of TrackEngagement
  std::uint8_t sensed = 0;      ///< 1: held by a sensor of the sender, worth fusing
  std::uint8_t reserved = 0;

  static constexpr auto fields() {
    using S = SharedTrack;
    return field_list(field("position", &S::position, "m"), field("velocity", &S::velocity, "m/s"),
                      field("along", &S::along), field("across", &S::across),
                      field("turning", &S::turning), field("truth", &S::truth),
                      field("identity", &S::identity), field("engagement", &S::engagement),
                      field("sensed", &S::sensed), field("reserved", &S::reserved));
  }
};

/// A missile seeker that the sender hears, at the time of the message.
struct SharedSeeker {
  PlayerId emitter{};        ///< fingerprint of its pulse train
  float faintness = 0;       ///< as RwrWarning::faintness
  float faintness_rate = 0;  ///< 1/s

  static constexpr auto fields() {
    using S = SharedSeeker;
    return field_list(field("emitter", &S::emitter), field("faintness", &S::faintness),
                      field("faintness_rate", &S::faintness_rate, "Hz"));
  }
};

/// What one aircraft tells its flight.
struct DatalinkMessage {
  double time = 0;   ///< s, when it was sent and what it describes
  Vec3 position{};   ///< m, local frame
  Vec3f velocity{};  ///< m/s
  float fuel = 0;    ///< kg
  std::array<SharedTrack, kSharedTracks> tracks{};
  std::array<SharedSeeker, kSharedSeekers> seekers{};
  std::uint32_t track_count = 0;
  std::uint32_t seeker_count = 0;

  static constexpr auto fields() {
    using D = DatalinkMessage;
    return field_list(field("time", &D::time, "s"), field("position", &D::position, "m"),
                      field("velocity", &D::velocity, "m/s"), field("fuel", &D::fuel, "kg"),
                      field("tracks", &D::tracks), field("seekers", &D::seekers),
                      field("track_count", &D::track_count),
                      field("seeker_count", &D::seeker_count));
  }
};

/// The last messages of one aircraft, written in act by the sender alone; its mates read it in
/// perceive. Message n lies in slot n modulo kMessages.
struct DatalinkSent {
  std::array<DatalinkMessage, kMessages> messages{};
  std::uint32_t sent = 0;  ///< messages so far
  std::uint8_t reserved[4] = {};

  static constexpr auto fields() {
    return field_list(field("messages", &DatalinkSent::messages),
                      field("sent", &DatalinkSent::sent),
                      field("reserved", &DatalinkSent::reserved));
  }
};

/// What one aircraft knows of one member of its flight.
struct Mate {
  Vec3 position{};             ///< m, local frame, at `time`
  Vec3f velocity{};            ///< m/s
  float fuel = 0;              ///< kg
  double time = 0;             ///< s, of the last message, when it was sent
  double heard_time = 0;       ///< s, when the last message arrived
  PlayerId id{};               ///< none: no such member
  std::uint32_t received = 0;  ///< messages of it looked at so far (its `sent`)
  std::uint8_t alive = 0;      ///< 1: believed alive
  std::uint8_t reported = 0;   ///< 1: position, velocity and fuel are known
  std::uint8_t called = 0;     ///< 1: by radio, without a datalink; of the rest its position
  std::uint8_t reserved[5] = {};

  static constexpr auto fields() {
    return field_list(field("position", &Mate::position, "m"),
                      field("velocity", &Mate::velocity, "m/s"), field("fuel", &Mate::fuel, "kg"),
                      field("time", &Mate::time, "s"), field("heard_time", &Mate::heard_time, "s"),
                      field("id", &Mate::id), field("received", &Mate::received),
                      field("alive", &Mate::alive), field("reported", &Mate::reported),
                      field("called", &Mate::called), field("reserved", &Mate::reserved));
  }
};

/// The flight as one of its members believes it to be. Index = rank at birth - 1; the own entry
/// has the own id and is always alive.
struct DatalinkState {
  std::array<Mate, kMaxFlight> members{};
  std::uint32_t count = 0;  ///< members of the flight
  std::uint32_t self = 0;   ///< own index

  static constexpr auto fields() {
    return field_list(field("members", &DatalinkState::members),
                      field("count", &DatalinkState::count), field("self", &DatalinkState::self));
  }
};

/// Rank among the members believed alive: 1 for the lead.
[[nodiscard]] constexpr std::uint32_t living_rank(const DatalinkState& state) {
  std::uint32_t rank = 1;
  for (std::uint32_t i = 0; i < state.self; ++i)
    rank += state.members[i].alive;
  return rank;
}

/// The member believed to lead: the first one alive. Null before the first upkeep.
[[nodiscard]] constexpr const Mate* lead(const DatalinkState& state) {
  for (std::uint32_t i = 0; i < state.count; ++i)
    if (state.members[i].alive)
      return &state.members[i];
  return nullptr;
}

/// m/s, as of its last message.
[[nodiscard]] constexpr Vec3 velocity_of(const Mate& mate) {
  return wide(mate.velocity);
}
/// Where a mate is believed to be at `time` (s); needs Mate::reported.
[[nodiscard]] constexpr Vec3 position_at(const Mate& mate, double time) {
  return mate.position + (time - mate.time) * velocity_of(mate);
}

/// Whether `holds` of any other member that is believed alive and has said where it is.
template <class Holds>
constexpr bool any_mate(const DatalinkState& state, const Holds& holds) {
  for (std::uint32_t i = 0; i < state.count; ++i)
    if (const Mate& mate = state.members[i];
        i != state.self && mate.alive && mate.reported && holds(mate))
      return true;
  return false;
}

/// Const and shared by the members of a flight.
struct Datalink {
  double rate = 1;                ///< Hz
  double delay = 0.2;             ///< s
  double timeout = 5;             ///< s
  double range = si(200, "nmi");  ///< m
  double loss = 0;

  static constexpr std::string_view type_name = "datalink";
  static constexpr std::string_view help = "messages between the members of a flight";
  static constexpr auto params() {
    return Lines{
        param("rate", &Datalink::rate, "Hz", eyrie::range(0.05, 50), "messages per second"),
        param("delay", &Datalink::delay, "s", eyrie::range(0, 60),
              "from what a message describes to its use by the receiver"),
        param("timeout", &Datalink::timeout, "s", eyrie::range(0.1, 600),
              "a mate not heard for so long is believed lost"),
        param("range", &Datalink::range, "m", eyrie::range(0, 1e6),
              "nothing is received from farther away"),
        param("loss", &Datalink::loss, eyrie::range(0, 1), "chance that a message is lost")};
  }

  /// What does not go together, in words; empty if all is well. A sender keeps its last kMessages
  /// messages, so the delay must not be longer than they span.
  [[nodiscard]] std::string_view problem() const;
};

/// What one aircraft says about itself.
struct OwnReport {
  double time = 0;                          ///< s
  Vec3 position{};                          ///< m
  Vec3 velocity{};                          ///< m/s
  double fuel = 0;                          ///< kg
  TrackId target{};                         ///< none if none
  std::span<const TrackId> shot_at;         ///< tracks with an own missile on its way
  std::span<const SharedSeeker> seekers{};  ///< at most kSharedSeekers
};

/// Puts one message into the own ring: the own report, the target, what was shot at, and then the
/// nearest confirmed tracks of the own sensors that are not friends (those report themselves).
void transmit(DatalinkSent& sent, const OwnReport& own, const TrackFile& tracks,
              const track::Tracker& tracker = {});

/// The newest message that has had time to arrive, or null. `sent` counts as in DatalinkSent.
[[nodiscard]] const DatalinkMessage* newest_arrived(const DatalinkSent& sent, double delay,
                                                    double time, std::uint32_t& number);

/// Fills in the flight at the first upkeep: everybody is believed alive until the timeout.
void start(DatalinkState& state, std::span<const PlayerId> members, PlayerId self, double time);

/// One mate's ring is looked at: takes over the newest message that has arrived and was not looked
/// at before, unless it is out of reach or lost by draw. Returns it for the tracks, or null.
const DatalinkMessage* receive(Mate& mate, const Datalink& datalink, const DatalinkSent& sent,
                               bool in_reach, double time, Draw draw);

/// Believes mates lost that have been silent for longer than the timeout; gives those of this time,
/// bit i for member i.
std::uint8_t check_silence(DatalinkState& state, const Datalink& datalink, double time);
/// Forgets the claims of members on tracks, bit i for member i.
void forget_claims(TrackFile& tracks, std::uint8_t members);

/// What mate number `member` said about tracks goes into the own file: a track that a sensor of the
/// mate holds becomes a track here, or makes the estimate here better; identity is taken over where
/// it is unknown, but hostile only where no member of the flight (`state`) may be; claims
/// (targeted, shot at) are marked with the mate's bit. Estimates are joined by covariance
/// intersection: the mate's may contain what was learned from here.
void fuse(TrackFile& file, const track::TrackContext& context, const DatalinkMessage& message,
          const DatalinkState& state, std::uint32_t member);

/// The track that lies where the mate says it is, is the mate: an unknown one becomes friendly.
void recognize_mate(TrackFile& file, const track::TrackContext& context, const Mate& mate);

}  // namespace eyrie::model::datalink
