// SPDX-License-Identifier: MIT
#pragma once
/// \file  The sort: who of a flight takes whom.
#include "pilot/state.hpp"

namespace eyrie::pilot {

/// Another hostile has to be nearer than this share of the range before the target is changed.
inline constexpr double kSwitchShare = 0.5;

/// A target is kept for so long at least: the longer, the farther away it is, because what mates
/// say of their targets comes late and names distant neighbors wrongly.
inline constexpr double kHoldSpeed = 1000;  ///< m/s, range over hold
inline constexpr double kLeastHold = 2;     ///< s
inline constexpr double kMostHold = 30;     ///< s

/// s. A mate's claim on the own target counts after so long: of aircraft abreast at long range what
/// he says may fall on the neighbor of whom he means, until his next words.
inline constexpr double kBelieved = 5;

/// m. Two hostile tracks nearer to each other than this may be one aircraft that is tracked twice:
/// what is said of one is then taken to be said of both.
inline constexpr double kSamePlace = si(0.5, "nmi");

/// What the flight has to do with a hostile track, or with what may be the same aircraft.
struct Claims {
  std::uint32_t targeted = 0;   ///< bit i: it is the target of member i
  std::uint32_t shot = 0;       ///< bit i: member i says that he has a missile on its way to it
  std::uint32_t own_shots = 0;  ///< own missiles believed on their way to it
  double last_left = model::kNever;     ///< s, when the own missile that left last left
  double last_arrived = model::kNever;  ///< s, when the own missile of before will have arrived
};
[[nodiscard]] Claims claims_on(const State& state, const Seen& hostile);

/// The target of this pilot, an index into State::seen, or -1 if no track is identified as hostile.
///
/// Every member takes the nearest hostile that fewest better-ranked members, believed alive, say
/// is their target; so each has his own as long as there are enough, and then they double up
/// evenly. Whoever takes one anew reckons that a mate who has not said whom he takes will do so by
/// the same rule from where he is: the word comes a second late. The target of before stays for a
/// while (kHoldSpeed) and while an own missile is on its way to it, and then unless another one is
/// less taken, for a while (kBelieved), or half as far. Ties go to the older track. All that is
/// known of the mates and their targets came over the datalink.
struct Choice {
  std::int32_t index = -1;
  bool contested = false;  ///< a better-ranked mate is said to be on the target of before
};
[[nodiscard]] Choice choose_target(const State& state);

/// Whether this pilot is the one to shoot first at his target: no mate who is believed alive, has
/// the same target and has no missile on its way to anybody is nearer to it. Of two at the
/// same range the better-ranked one is. A mate whose place is not known does not count.
[[nodiscard]] bool shoots_first(const State& state, const Seen& target);

}  // namespace eyrie::pilot
