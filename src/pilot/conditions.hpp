// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a pilot may ask about himself, the situation, the enemy's shots and his own.
#include "model/weapon/stores.hpp"
#include "pilot/danger.hpp"
#include "pilot/sort.hpp"
#include "pilot/trees.hpp"
#include "team/member.hpp"
#include "ubf/memory.hpp"

namespace eyrie::pilot {

struct Bingo final : Condition {
  static constexpr std::string_view type_name = "bingo";
  static constexpr std::string_view help =
      "fuel is down to the pilot's bingo, at which he is to go home";
  [[nodiscard]] bool holds(const Tick& t) const override { return t.state.bingo(); }
};

struct Winchester final : Condition {
  static constexpr std::string_view type_name = "winchester";
  static constexpr std::string_view help = "no missile is left, and no round if the gun counts";
  static constexpr auto params() {
    return Lines{param("gun", &Winchester::gun, "true: with rounds left it does not hold")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    return model::weapon::missiles_left(t.state.stores) == 0 && (!gun || t.state.gun.rounds == 0);
  }

  bool gun = false;
};

/// As the datalink tells: a mate that is not heard any more counts as lost.
struct Losses final : Condition {
  static constexpr std::string_view type_name = "losses";
  static constexpr std::string_view help = "so many of the flight are believed lost";
  static constexpr auto params() {
    return Lines{param("at_least", &Losses::at_least, range(1, 8), "members of the own flight")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override { return t.state.lost >= at_least; }

  std::uint32_t at_least = 2;
};

struct NearHome final : Condition {
  static constexpr std::string_view type_name = "near_home";
  static constexpr std::string_view help = "home is within a range";
  static constexpr auto params() {
    return Lines{param("within", &NearHome::within, "m", range(0, 1e6), "along the ground")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    const auto distance = t.state.home_distance();
    return distance && *distance <= within;
  }

  double within = si(10, "nmi");
};

using IsLead = team::IsLead<Platform>;
using RouteDone = team::RouteDone<Platform>;

/// A confirmed track that is hostile, or might be, is near enough.
struct HostileTrack final : Condition {
  static constexpr std::string_view type_name = "hostile_track";
  static constexpr std::string_view help = "a hostile track is within a range";
  static constexpr auto params() {
    return Lines{param("within", &HostileTrack::within, "m", range(0, 1e6), "from here"),
                 param("identified", &HostileTrack::identified,
                       "false: a track that nobody has identified counts as hostile here")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    for (const Seen& seen : t.state.tracks_seen())
      if ((identified ? seen.hostile() : seen.suspect()) && seen.range <= within)
        return true;
    return false;
  }

  double within = si(60, "nmi");
  bool identified = true;
};

/// A hostile is seen by eye, or so near that it might as well be.
struct InSight final : Condition {
  static constexpr std::string_view type_name = "in_sight";
  static constexpr std::string_view help = "a hostile is seen by eye or within a range";
  static constexpr auto params() {
    return Lines{
        param("within", &InSight::within, "m", range(0, 100e3), "counts as seen in any case"),
        param("memory", &InSight::memory, "s", range(0, 60), "a glance is good for so long")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    for (const Seen& seen : t.state.tracks_seen())
      if (seen.hostile() &&
          (seen.range <= within || t.state.time - seen.track->seen_time <= memory))
        return true;
    return false;
  }

  double within = si(5, "nmi");
  double memory = 5;
};

struct ClearSince {
  double time = 0;          ///< s, when the area became clear
  double known = 0;         ///< s, when somebody was last known in it; 0: nobody was
  Vec3 place{};             ///< m, local frame, where he was
  std::uint32_t clear = 0;  ///< 1: it is
  std::uint32_t reserved = 0;
};

/// No hostile and no unknown track inside a radius for some time, and no missile perceived. A radar
/// that is heard does not count: nobody knows how far it is. With `memory` nobody is gone because
/// one has turned away from him: where he was last known has to be looked at.
struct AreaClear final : ubf::WithMemory<Condition, ClearSince> {
  static constexpr std::string_view type_name = "area_clear";
  static constexpr std::string_view help =
      "nobody but friends within a range, and no missile perceived, for some time";
  static constexpr auto params() {
    return Lines{
        param("within", &AreaClear::within, "m", range(0, 1e6), "from here"),
        param("for", &AreaClear::duration, "s", range(0, 3600), "how long it must have been clear"),
        param("memory", &AreaClear::remembered, "s", range(0, 3600),
              "who was lost while he was more than 60° off the nose counts for so long, "
              "or until his place is nearer to it")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    ClearSince& m = memory(t);
    const State& s = t.state;
    bool clear = s.threats.count == 0;
    for (const Seen& seen : s.tracks_seen())
      if (seen.suspect() && seen.range <= within) {
        m.known = s.time;
        m.place = position_at(*seen.track, s.time);
        clear = false;
      }
    const bool remembers = m.known > 0 && !ubf::passed(s.time, m.known, remembered);
    if (!clear || (remembers && s.off_nose(to_ned(s.own, m.place - s.own.position)) > kLooked)) {
      m.clear = 0;
      return false;
    }
    if (!m.clear) {
      m.time = s.time;
      m.clear = 1;
    }
    return ubf::passed(s.time, m.time, duration);
  }

  static constexpr double kLooked = si(60, "deg");  ///< off the nose, what a radar covers
  double within = si(60, "nmi");
  double duration = 20;
  double remembered = 0;
};

struct Threatened final : Condition {
  static constexpr std::string_view type_name = "threatened";
  static constexpr std::string_view help = "a missile is believed to come for this aircraft";
  [[nodiscard]] bool holds(const Tick& t) const override { return t.state.threats.count > 0; }
};

struct HasTarget final : Condition {
  static constexpr std::string_view type_name = "has_target";
  static constexpr std::string_view help = "a target is chosen";
  static constexpr auto params() {
    return Lines{param("within", &HasTarget::within, "m", range(0, 1e6), "from here")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    const Seen* target = t.state.target();
    return target && target->range <= within;
  }

  double within = 1e6;
};

/// An own missile is believed on its way to the chosen target, or to anybody.
struct ShotInFlight final : Condition {
  static constexpr std::string_view type_name = "shot_in_flight";
  static constexpr std::string_view help = "an own missile is believed on its way";
  static constexpr auto params() {
    return Lines{
        param("any", &ShotInFlight::any, "true: to whomever; false: to the chosen target")};
  }
  [[nodiscard]] bool holds(const Tick& t) const override {
    const State& s = t.state;
    if (any)
      return std::any_of(s.agent.shots.begin(), s.agent.shots.end(), [&](const Shot& shot) {
        return shot.flies(s.time) && s.find(shot.track);
      });
    const Seen* target = s.target();
    return target && claims_on(s, *target).own_shots > 0;
  }

  bool any = false;
};

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
