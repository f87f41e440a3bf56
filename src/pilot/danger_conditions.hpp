// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a pilot may ask about the enemy's shots and his own: when to defend, leave, support.
#include "pilot/danger.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

/// The warning receiver hears a radar that rests on this aircraft. With `search` also one that
/// searches, from where a hostile stands who could hit from there: one that tracks while it scans
/// shoots without ever resting.
struct Spiked final : Condition {
  static constexpr std::string_view type_name = "spiked";
  static constexpr std::string_view help = "a radar tracks this aircraft";
  static constexpr auto params() {
    return Lines{
        param("for", &Spiked::duration, "s", range(0, 60),
              "tracks for so long at least; with `search` its search counts, too"),
        param("search", &Spiked::search, "true: or one searches, of a hostile who could hit now")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    const model::RwrWarning* warning = spike(t.state);
    if (!warning && search)
      warning = scanned(t.state);
    return warning &&
           t.state.time - (search ? warning->first_time : warning->kind_time) >= duration;
  }

  double duration = 0;
  bool search = false;
};

/// A missile comes for this aircraft, not for a mate (pilot/danger.hpp), and is here soon.
struct MissileInbound final : Condition {
  static constexpr std::string_view type_name = "missile_inbound";
  static constexpr std::string_view help = "a missile that comes for this aircraft is here soon";
  static constexpr auto params() {
    return Lines{param("within", &MissileInbound::within, "s", range(0, 120), "time to go")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    return inbound(t.state, within) != nullptr;
  }

  double within = 8;
};

/// A hostile is nearer than so many times the range inside which his missile could not be escaped,
/// as he flies now. What he carries is not known: the farthest-reaching missile in the library.
struct AbortRange final : Condition {
  static constexpr std::string_view type_name = "abort_range";
  static constexpr std::string_view help = "a hostile is near enough to hit whatever one does";
  static constexpr auto params() {
    return Lines{param("factor", &AbortRange::factor, range(0, 20),
                       "of the no-escape range of his missile against this aircraft")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override { return exposed(t.state, factor); }

  double factor = 1.2;
};

/// More hostiles than living members of the own flight.
struct Outnumbered final : Condition {
  static constexpr std::string_view type_name = "outnumbered";
  static constexpr std::string_view help = "more hostiles within a range than the flight has left";
  static constexpr auto params() {
    return Lines{param("by", &Outnumbered::by, range(1, 16), "so many more at least"),
                 param("within", &Outnumbered::within, "m", range(0, 1e6), "from here")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    const State& s = t.state;
    int more = -std::max(std::popcount(s.alive), 1);
    for (const Seen& seen : s.tracks_seen())
      more += seen.hostile() && seen.range <= within;
    return more >= static_cast<int>(by);
  }

  std::uint32_t by = 1;
  double within = si(40, "nmi");
};

/// An own missile flies that still needs the radar: its seeker is not on yet, as the pilot reckons.
struct SupportNeeded final : Condition {
  static constexpr std::string_view type_name = "support_needed";
  static constexpr std::string_view help = "an own missile still needs the radar's support";
  [[nodiscard]] bool holds(const Tick& t) const override { return support_needed(t.state); }
};

/// Own missiles fly, and each has switched on its own seeker, as the pilot reckons ("pitbull").
struct ShotActive final : Condition {
  static constexpr std::string_view type_name = "shot_active";
  static constexpr std::string_view help = "own missiles fly and none needs the radar any more";
  [[nodiscard]] bool holds(const Tick& t) const override {
    const auto& shots = t.state.agent.shots;
    return !support_needed(t.state) &&
           std::any_of(shots.begin(), shots.end(),
                       [&](const Shot& shot) { return shot.flies(t.state.time); });
  }
};

}  // namespace eyrie::pilot
