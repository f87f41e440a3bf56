// SPDX-License-Identifier: MIT
#pragma once
#include "pilot/sort.hpp"
#include "pilot/state.hpp"
#include "pilot/trees.hpp"

namespace eyrie::pilot {

struct HoldMemory {
  double since = 0;  ///< s, since when it leaves the shot to a mate
  TrackId track;     ///< at whom
  std::uint32_t reserved = 0;
};

/// Recommends the release of a missile at the chosen target once it is inside the employment zone
/// of a missile on board, of several the one with the shortest reach. Never at a track that is not
/// identified as hostile. Fails when there is nothing to shoot.
///
/// One shooter per target first: while a mate says that he has a missile on its way to the target,
/// it holds fire; and it leaves the first shot to the nearest mate who has the same target and is
/// free (pilot/sort.hpp), for `patience` at most, for he may be out of missiles or look elsewhere.
/// It shoots again once the flight time of its first missile has passed, or at once up to `salvo`.
class ReleaseWeapon final : public ubf::WithMemory<Behavior, HoldMemory> {
 public:
  static constexpr std::string_view type_name = "release_weapon";
  static constexpr std::string_view help = "releases a missile inside its employment zone";
  static constexpr auto params() {
    using R = ReleaseWeapon;
    return std::tuple{
        param("vote", &R::vote_, range(0, 1000), "how strongly"),
        param("zone", &R::zone_, range(0, 1),
              "0: shoots inside the no-escape range; 1: as soon as the missile can reach a target "
              "that keeps its course"),
        param("off_boresight", &R::off_boresight_, "rad", range(0, 3.2),
              "largest angle between nose and target"),
        param("salvo", &R::salvo_, range(1, Agent::kShots),
              "own missiles on their way to one target at a time"),
        param("one_shooter", &R::one_shooter_,
              "false: shoots whatever the mates have done about the target"),
        param("patience", &R::patience_, "s", range(0, 600),
              "waits so long for a nearer mate to take the first shot"),
        param("max_age", &R::max_age_, "s", range(0, 60),
              "a track that nobody has updated for longer is not shot at"),
        param("max_error", &R::max_error_, "m", range(0, 100e3),
              "missiles that lock on after launch: no shot at a track that is worse than this, one "
              "standard deviation"),
        param("clear_cone", &R::clear_cone_, "rad", range(0, 0.5),
              "no friend may be within this angle of the line to the target, where the seeker of "
              "the missile will be looking"),
        param("clear_radius", &R::clear_radius_, "m", range(0, 50e3),
              "no friend may be so near to the target, give or take two standard deviations of its "
              "track: a seeker, or who tracks, may pass from one to the other")};
  }

  Status tick(const Tick& t, Proposal& out) const override;

 private:
  /// Why it must not shoot at a target whatever it shoots with; null if it may.
  [[nodiscard]] const char* why_not(const State& s, const Seen& target) const;
  /// Missiles enough are on their way to the target.
  [[nodiscard]] bool is_covered(const State& s, const Claims& claims) const;
  /// The store to release, an index into the Library.
  [[nodiscard]] std::optional<std::uint16_t> choose_store(const State& s, const Seen& target) const;
  /// A nearer mate has the first shot.
  [[nodiscard]] bool leaves_it(const State& s, const Seen& target, const Claims& claims,
                               HoldMemory& m) const;

  float vote_ = 60;
  double zone_ = 0.4;
  double off_boresight_ = si(40, "deg");
  std::uint8_t salvo_ = 1;
  bool one_shooter_ = true;
  double patience_ = 8;
  double max_age_ = 3;
  double max_error_ = 800;
  double clear_cone_ = si(5, "deg");
  double clear_radius_ = si(1, "nmi");
};

}  // namespace eyrie::pilot
