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

namespace eyrie::model::sensor {

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

}  // namespace eyrie::model::sensor
