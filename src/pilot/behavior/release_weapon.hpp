// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/gunnery.hpp"
#include "pilot/sort.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

struct HoldMemory {
  double since = 0;    ///< s, since when it leaves the shot to a mate
  double arrived = 0;  ///< s, when it last knew a missile on its way to `busy`
  TrackId track;       ///< at whom it leaves the shot
  TrackId busy;        ///< whom it last knew a missile on its way to
};

/// Recommends the release of a missile at the chosen target once it is inside the employment zone
/// of a missile on board, of several the one with the shortest reach. Never at a track that is not
/// identified as hostile. Fails when there is nothing to shoot, and says why.
///
/// When: `zone` and `of` say how far out, which is also how probable a kill has to be
/// (docs/models/missile.md); `least_mach` how fast it must be, and `least_f_pole` how far away it
/// will be when the missile arrives. Both are asked for only where the target can escape: inside
/// the no-escape range it shoots as it is.
///
/// How many: `ripple` missiles one after the other, `ripple_interval` apart; then it looks what
/// they did. One is the doctrine shoot-look-shoot. Missiles of mates, as they tell over the
/// datalink, count up to `flight_ripple`. After the last has arrived, by its time of flight, it
/// waits for an own look at the target that is `assess` younger: who is dead is not seen again. It
/// leaves the first shot to the nearest mate who has the same target and is free (pilot/sort.hpp),
/// for `patience` at most, for he may be out of missiles or look elsewhere.
///
/// Never where a friend may be taken for the target: near it, or in the basket of the seeker.
class ReleaseWeapon final : public ubf::WithMemory<Behavior, HoldMemory> {
 public:
  static constexpr std::string_view type_name = "release_weapon";
  static constexpr std::string_view help = "releases a missile inside its employment zone";
  static constexpr auto params() {
    using R = ReleaseWeapon;
    return Lines{
        param("vote", &R::vote_, range(0, 1000), "how strongly"),
        param("zone", &R::zone_, range(0.1, 5),
              "how far out it shoots, in multiples of a range of the zone, and no farther than "
              "r_max: the fewer the more probable a kill; 1.4 of r_ne: who turns away only when he "
              "hears the seeker is just reached"),
        param("of", &R::of_,
              "r_ne, r_tr or r_max: the range that no escape, turning away at launch, or keeping "
              "its course leaves the target in reach"),
        param("least_mach", &R::least_mach_, range(0, 3),
              "own Mach number at which it shoots beyond the no-escape range"),
        param("least_f_pole", &R::least_f_pole_, "m", range(0, 100e3),
              "beyond the no-escape range: no shot if the target will be nearer when the missile "
              "arrives, should both keep their course"),
        param("off_boresight", &R::off_boresight_, "rad", range(0, 180, "deg"),
              "largest angle between nose and target"),
        param("ripple", &R::ripple_, range(1, Agent::kShots),
              "own missiles on their way to one target before it looks what they did; 1: "
              "shoot-look-shoot"),
        param("ripple_interval", &R::ripple_interval_, "s", range(0, 60),
              "between two missiles of a ripple"),
        param("flight_ripple", &R::flight_ripple_, range(1, 8),
              "missiles of the flight on their way to one target at a time, own and mates'"),
        param(
            "assess", &R::assess_, "s", range(0, 60),
            "after a missile has arrived it shoots again only at a track that an own sensor or eye "
            "has seen this much later"),
        param("one_shooter", &R::one_shooter_,
              "false: shoots whatever the mates have done about the target"),
        param("patience", &R::patience_, "s", range(0, 600),
              "waits so long for a nearer mate to take the first shot"),
        param("max_age", &R::max_age_, "s", range(0, 60),
              "a track that nobody has updated for longer is not shot at"),
        param("max_error", &R::max_error_, "m", range(0, 100e3),
              "missiles that lock on after launch: no shot at a track that is worse than this, one "
              "standard deviation"),
        param("clear_cone", &R::clear_cone_, "rad", range(0, 30, "deg"),
              "no friend may be within this angle of the line from the missile to the target, from "
              "where its seeker is switched on; at least half of its field of view"),
        param("clear_turn", &R::clear_turn_, range(0, 9),
              "g, with which friends may leave their course until then"),
        param("clear_radius", &R::clear_radius_, "m", range(0, 50e3),
              "no friend may be so near to the target, give or take two standard deviations of its "
              "track: a seeker, or who tracks, may pass from one to the other")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  /// Why it must not shoot at a target whatever it shoots with; null if it may.
  [[nodiscard]] const char* why_not(const State& s, const Seen& target) const;
  /// Why enough was shot at the target for now; null if not.
  [[nodiscard]] const char* why_wait(const State& s, const Seen& target, const Claims& claims,
                                     HoldMemory& m) const;
  /// The store to release, an index into the Library; or why there is none.
  struct Choice {
    std::optional<std::uint16_t> store;
    const char* why_none = "no missile on board sees the target or may leave";
  };
  [[nodiscard]] Choice choose_store(const State& s, const Seen& target) const;
  /// Why a missile must not go to a target that is in its zone; null if it may.
  [[nodiscard]] const char* why_not(const State& s, const Seen& target,
                                    const model::MissileType& missile,
                                    const model::weapon::EmploymentZone& zone) const;
  /// A nearer mate has the first shot.
  [[nodiscard]] bool leaves_it(const State& s, const Seen& target, const Claims& claims,
                               HoldMemory& m) const;

  float vote_ = 60;
  double zone_ = 1.4;
  model::weapon::ZoneRange of_ = model::weapon::ZoneRange::r_ne;
  double least_mach_ = 0;
  double least_f_pole_ = 0;
  double off_boresight_ = si(40, "deg");
  std::uint8_t ripple_ = 1;
  double ripple_interval_ = 4;
  std::uint8_t flight_ripple_ = 1;
  double assess_ = 4;
  bool one_shooter_ = true;
  double patience_ = 8;
  double max_age_ = 3;
  double max_error_ = 800;
  double clear_cone_ = si(5, "deg");
  double clear_turn_ = 2;
  double clear_radius_ = si(1, "nmi");
};

}  // namespace eyrie::pilot
