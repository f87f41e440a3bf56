// SPDX-License-Identifier: MIT
#pragma once
/// \file  Maneuvers of a fight within visual range, each a small behavior. Which of them is flown
/// is the tree's choice: by votes, and by guards over `off_nose`, `off_tail`, `closing` ...
/// Their geometry: Shaw, Fighter Combat (1985), ch. 2; not seen: derived in the tests.
#include "pilot/fight.hpp"
#include "ubf/memory.hpp"

namespace eyrie::pilot {

/// Points ahead of the target, where the paths meet; nearer than `gun_range` where the rounds of
/// the gun would meet him. Closes, and brings the gun to bear: for the last `cash_in` off the nose
/// it pays with speed.
class LeadPursuit final : public Maneuver {
 public:
  static constexpr std::string_view type_name = "lead_pursuit";
  static constexpr std::string_view help = "points ahead of the target, where the paths meet";
  static constexpr auto params() {
    using L = LeadPursuit;
    return joined(Maneuver::params(),
                  Lines{param("gun_range", &L::gun_range_, "m", range(0, 10e3),
                              "nearer than this it aims the gun"),
                        param("overtake", &L::overtake_, "m/s", range(0, 500),
                              "nearer than gun_range, at most so much faster than the target; "
                              "null: never slows"),
                        param("cash_in", &L::cash_in_, "rad", range(0, 85, "deg"),
                              "nearer to the aim it pulls all that the wing gives")});
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double gun_range_ = 2000;
  std::optional<double> overtake_;
  double cash_in_ = si(25, "deg");
};

/// A shot in passing: the aim point crosses faster than the nose can follow it, so the nose waits
/// where it will pass, and the trigger is down from `ahead` before until it has. Silent when the
/// gun can be kept on the target: that is shoot_gun's.
class Snapshot final : public Maneuver {
 public:
  static constexpr std::string_view type_name = "snapshot";
  static constexpr std::string_view help = "fires the gun as a target that crosses passes the nose";
  static constexpr auto params() {
    using S = Snapshot;
    return joined(
        Maneuver::params(),
        Lines{param("within", &S::within_, "m", range(50, 5000), "fires no farther"),
              param("wait", &S::wait_, "s", range(0, 20), "for the target to pass the nose"),
              param("ahead", &S::ahead_, "s", range(0, 5), "fires so long before it does"),
              param("max_age", &S::max_age_, "s", range(0, 60),
                    "not at a target that nobody has seen for longer"),
              param("clear_cone", &S::clear_cone_, "rad", range(0, 30, "deg"),
                    "no friend may be within this angle of the line of fire")});
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double within_ = 800;
  double wait_ = 1.5;
  double ahead_ = 0.2;
  double max_age_ = 2;
  double clear_cone_ = si(3, "deg");
};

/// Points at the target: brings missiles to bear, and turns the hardest into an attacker.
class PurePursuit final : public Maneuver {
 public:
  static constexpr std::string_view type_name = "pure_pursuit";
  static constexpr std::string_view help = "points at the target";
  Status tick(const Tick& t, Proposal& out) const override;
};

/// Points where the target was. Keeps the place behind him without passing him.
class LagPursuit final : public Maneuver {
 public:
  static constexpr std::string_view type_name = "lag_pursuit";
  static constexpr std::string_view help = "points behind the target, where he was";
  static constexpr auto params() {
    return joined(Maneuver::params(), Lines{param("lag", &LagPursuit::lag_, "s", range(0.1, 20),
                                                  "points where the target was so long ago")});
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double lag_ = 2;
};

/// Would pass behind and outside the target's turn: pulls up out of his plane, which takes closing
/// speed and keeps it as height, with the lift on the place he leaves. Silent unless it is behind
/// him, closes faster than `closing` and crosses his path at more than `crossing`.
class HighYoYo final : public Maneuver {
 public:
  static constexpr std::string_view type_name = "high_yo_yo";
  static constexpr std::string_view help = "pulls up out of the target's turn instead of passing";
  static constexpr auto params() {
    using H = HighYoYo;
    return joined(
        Maneuver::params(),
        Lines{param("angle", &H::angle_, "rad", range(0, 85, "deg"), "points so far above him"),
              param("closing", &H::closing_, "m/s", range(0, 1000), "slower closing is kept"),
              param("crossing", &H::crossing_, "rad", range(0, 180, "deg"),
                    "flatter crossing is kept"),
              param("within", &H::within_, "m", range(0, 50e3), "of the target")});
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double angle_ = si(35, "deg");
  double closing_ = 60;
  double crossing_ = si(30, "deg");
  double within_ = 2000;
};

/// Cannot get its nose around: cuts inside the target's turn below him, which turns height into
/// speed. Silent unless it is behind his wings, he is off the nose, and it closes slower than
/// `closing`.
class LowYoYo final : public Maneuver {
 public:
  static constexpr std::string_view type_name = "low_yo_yo";
  static constexpr std::string_view help = "cuts inside the target's turn, below him";
  static constexpr auto params() {
    using L = LowYoYo;
    return joined(
        Maneuver::params(),
        Lines{param("angle", &L::angle_, "rad", range(0, 85, "deg"), "points so far below him"),
              param("closing", &L::closing_, "m/s", range(-1000, 1000),
                    "faster closing needs no help"),
              param("off_nose", &L::off_nose_, "rad", range(0, 180, "deg"),
                    "nearer to the nose he needs no help")});
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double angle_ = si(20, "deg");
  double closing_ = 20;
  double off_nose_ = si(25, "deg");
};

/// Which way round after a pass.
enum class Circle : std::uint8_t {
  one,   ///< nose to nose: both turn on one circle, and the smaller radius wins
  two,   ///< nose to tail: each on his own circle, and the higher rate wins
  best,  ///< one below corner speed or against who is faster, else two
};
constexpr auto names_of(Circle) {
  return names_from_zero<Circle>("one", "two", "best");
}

struct TurnMemory {
  double side = 0;  ///< 1 to the right, -1 to the left, 0 not chosen
};

/// After the pass: turns round at the energy it has, nose high with more than corner speed and nose
/// low with less. The side is chosen at the pass and kept until the target is before the wings
/// again. Silent while he is.
class MergeTurn final : public ubf::WithMemory<Maneuver, TurnMemory> {
 public:
  static constexpr std::string_view type_name = "merge_turn";
  static constexpr std::string_view help = "turns round after the pass, on one circle or on two";
  static constexpr auto params() {
    using M = MergeTurn;
    return joined(Maneuver::params(),
                  Lines{param("circle", &M::circle_, "one, two or best"),
                        param("off_nose", &M::off_nose_, "rad", range(5, 177, "deg"),
                              "he has been passed when he is farther off the nose"),
                        param("within", &M::within_, "m", range(0, 50e3), "of the target")});
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  Circle circle_ = Circle::best;
  double off_nose_ = si(80, "deg");
  double within_ = si(5, "nmi");
};

struct LostMemory {
  double time = 0;  ///< s, when the target was last known; 0: none was
  Vec3 position{};  ///< m, local frame, where it was then
  Vec3 velocity{};  ///< m/s
};

/// The target is lost: turns to where it must be by now, if it has not turned for long. Silent
/// while there is a target, and `memory` seconds after there was one; with `radar` it turns then to
/// one that tracks this aircraft.
class Reacquire final : public ubf::WithMemory<Maneuver, LostMemory> {
 public:
  static constexpr std::string_view type_name = "reacquire";
  static constexpr std::string_view help =
      "turns to where a lost target was last known; for arbiters, which ask it while it is known";
  static constexpr auto params() {
    using R = Reacquire;
    return joined(Maneuver::params(),
                  Lines{param("memory", &R::memory_, "s", range(0, 600), "looks for so long"),
                        param("extrapolated", &R::extrapolated_, "s", range(0, 600),
                              "believes for so long that the target kept its course"),
                        param("within", &R::within_, "m", range(0, 500e3),
                              "a target that was lost farther away is let go"),
                        param("radar", &R::radar_,
                              "looks for who tracks this aircraft if nobody was lost lately")});
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double memory_ = 30;
  double extrapolated_ = 4;
  double within_ = si(10, "nmi");
  bool radar_ = false;
};

struct JinkMemory {
  double since = 0;  ///< s, when this pull began
  double side = 0;   ///< 1 up and out, -1 down and out, 0 none
};

/// An enemy behind has his nose on this aircraft within gun range: leaves his plane of turn, one
/// way and then the other. Silent otherwise.
class Jink final : public ubf::WithMemory<Maneuver, JinkMemory> {
 public:
  static constexpr std::string_view type_name = "jink";
  static constexpr std::string_view help = "spoils the aim of a gun behind";
  static constexpr auto params() {
    using J = Jink;
    return joined(
        Maneuver::params(),
        Lines{param("within", &J::within_, "m", range(0, 10e3), "reach of his gun"),
              param("cone", &J::cone_, "rad", range(0, 85, "deg"), "his nose is this near"),
              param("period", &J::period_, "s", range(0.1, 20), "of one pull")});
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double within_ = 1000;
  double cone_ = si(20, "deg");
  double period_ = 2;
};

/// Leaves: unloads, nose a little low, straight away from the target, as fast as it can. What a
/// bug-out and an acceleration to come back have in common.
class Extend final : public Maneuver {
 public:
  static constexpr std::string_view type_name = "extend";
  static constexpr std::string_view help = "unloads and runs straight away from the target";
  static constexpr auto params() {
    return joined(Maneuver::params(), Lines{param("dive", &Extend::dive_, "rad",
                                                  range(0, 85, "deg"), "below the horizontal")});
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  double dive_ = si(10, "deg");
};

struct CollisionMemory {
  double time = 0;  ///< s, when somebody last came too near; 0: nobody has
  Vec3 away{};      ///< north-east-down, where it turned to then
};

/// Keeps clear of everybody, friend or foe: when the paths will pass nearer than `miss` within
/// `warning` seconds, turns away from where the other will be; both to the right if he comes
/// straight on. From who is abreast or behind it turns away from where he is, and gently if he is
/// nearer than `miss` and comes no nearer. Goes on for `recovery`, or it would turn away and back
/// with every look. Fails otherwise.
class AvoidCollision final : public ubf::WithMemory<Behavior, CollisionMemory> {
 public:
  static constexpr std::string_view type_name = "avoid_collision";
  static constexpr std::string_view help = "keeps clear of other aircraft";
  static constexpr auto params() {
    using A = AvoidCollision;
    return Lines{param("vote", &A::vote_, range(0, 1000), "how strongly"),
                 param("miss", &A::miss_, "m", range(10, 5e3), "smallest distance to pass at"),
                 param("warning", &A::warning_, "s", range(0.1, 60), "how far ahead it looks"),
                 param("recovery", &A::recovery_, "s", range(0, 60),
                       "goes on for so long after nobody comes too near"),
                 param("load_factor", &A::load_factor_, range(1, 12), "g, the most it turns with"),
                 param("floor", &A::floor_, "m", range(0, 25e3), "dives no lower")};
  }
  Status tick(const Tick& t, Proposal& out) const override;

 private:
  float vote_ = 90;
  double miss_ = si(500, "ft");
  double warning_ = 4;
  double recovery_ = 1.5;
  double load_factor_ = 6;
  double floor_ = si(1500, "ft");
};

}  // namespace eyrie::pilot
