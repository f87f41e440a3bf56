// SPDX-License-Identifier: MIT
#pragma once
/// \file  Identification friend or foe: an interrogator that rides on the radar's looks.
#include <cstdint>
#include <string_view>
#include <tuple>

#include "core/describe.hpp"
#include "core/draw.hpp"
#include "core/units.hpp"
#include "model/fit.hpp"
#include "model/track.hpp"

namespace eyrie::model {

/// Const and shared by every aircraft that carries it. Everybody carries a transponder.
struct Iff {
  double range = si(100, "nmi");
  double reply_probability = 0.95;
  std::uint32_t tries = 3;

  static constexpr std::string_view type_name = "iff";
  static constexpr std::string_view help = "interrogator: a friend answers, nobody else does";
  static constexpr auto params() {
    return std::tuple{
        param("range", &Iff::range, "m", eyrie::range(0, 1e6), "asks no target beyond"),
        param("reply_probability", &Iff::reply_probability, eyrie::range(0, 1),
              "chance that a friend's reply is received and decoded"),
        param("tries", &Iff::tries, eyrie::range(0, 255),
              "so many interrogations in a row without a reply declare a track hostile; 0: never")};
  }
};

/// Whether the player that gave an echo answers to `asking`.
[[nodiscard]] inline bool answers(const Iff& iff, Side asking, Side asked, Draw draw) {
  return asking == asked && asking != Side::none && draw.chance(iff.reply_probability);
}

/// The declared rule. A reply makes a friend, even of a track that was held for hostile: a track
/// may have passed from one aircraft to another. `tries` interrogations in a row without a reply
/// make a hostile of an unknown, and an unknown again of a friend, for the same reason. A hostile
/// stays one.
constexpr void conclude(Track& track, std::uint32_t tries, bool reply) {
  if (reply) {
    track.identity = Identity::friendly;
    track.unanswered = 0;
    return;
  }
  if (track.unanswered < 255)
    ++track.unanswered;
  if (tries == 0 || track.unanswered < tries || track.identity == Identity::hostile)
    return;
  const bool was_friendly = track.identity == Identity::friendly;
  track.identity = was_friendly ? Identity::unknown : Identity::hostile;
  if (was_friendly)
    track.unanswered = 0;
}

}  // namespace eyrie::model
