// SPDX-License-Identifier: MIT
#pragma once
/// \file  The datalink inside a flight: who is where, who is alive, who shoots at what.
/// docs/models/datalink.md says what it is worth.
#include <cstdint>
#include <span>
#include <string_view>
#include <tuple>

#include "core/describe.hpp"
#include "core/draw.hpp"
#include "core/units.hpp"
#include "model/datalink/datalink_state.hpp"
#include "model/kinematics.hpp"
#include "model/track/track_file.hpp"

namespace eyrie::model::datalink {

/// Const and shared by the members of a flight.
struct Datalink {
  double rate = 1;
  double delay = 0.2;
  double timeout = 5;
  double range = si(200, "nmi");
  double loss = 0;

  static constexpr std::string_view type_name = "datalink";
  static constexpr std::string_view help = "messages between the members of a flight";
  static constexpr auto params() {
    return std::tuple{
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
  double time = 0;                   ///< s
  Vec3 position{};                   ///< m
  Vec3 velocity{};                   ///< m/s
  double fuel = 0;                   ///< kg
  TrackId target{};                  ///< none if none
  std::span<const TrackId> shot_at;  ///< tracks with an own missile on its way
};

/// Puts one message into the own ring: the own report, the target, what was shot at, and then the
/// nearest confirmed tracks of the own sensors that are not friends (those report themselves).
void transmit(DatalinkSent& sent, const OwnReport& own, const TrackFile& tracks);

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
/// mate holds becomes a track here, or replaces the estimate here if it is the better one; identity
/// is taken over where it is unknown, but hostile only where no member of the flight (`state`) may
/// be; claims (targeted, shot at) are marked with the mate's bit.
/// Estimates are chosen, not averaged: the mate's may contain what was learned from here.
void fuse(TrackFile& file, const track::TrackContext& context, const DatalinkMessage& message,
          const DatalinkState& state, std::uint32_t member);

/// The track that lies where the mate says it is, is the mate: an unknown one becomes friendly.
void recognize_mate(TrackFile& file, const track::TrackContext& context, const Mate& mate);

}  // namespace eyrie::model::datalink
