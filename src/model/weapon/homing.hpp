// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a missile's seeker finds among the aircraft, and how the missile homes on it.
#include "model/columns.hpp"
#include "model/kinematics.hpp"
#include "model/library.hpp"
#include "model/track.hpp"
#include "model/weapon/missile.hpp"
#include "model/weapon/seeker.hpp"
#include "sim/world.hpp"

namespace eyrie::model::weapon {

/// A view of the rows of all aircraft. Good in phases in which nobody writes them: perceive, decide
/// and act.
struct TargetScene {
  std::span<const PlayerId> ids;
  std::span<const Kinematics> kinematics;
  std::span<const Fit> fit;
  std::span<const flight::Propulsion> propulsion;
  std::span<const Decoys> decoys;
  std::span<const Emission> emission;
  const Library& library;
  double time = 0;  ///< s

  [[nodiscard]] static TargetScene of(const sim::World& world, const AircraftColumns& columns,
                                      const Library& library, double time);

  /// Radar cross section (m^2) or radiant intensity (W/sr) of aircraft `row` seen along `direction`
  /// (unit vector from the observer to it).
  [[nodiscard]] double signature(SeekerKind kind, std::size_t row, const Vec3& direction) const;

  /// The decoy that aircraft `row` tows.
  struct Towed {
    Vec3 offset;         ///< m, from the aircraft
    double section = 0;  ///< m^2
  };
  [[nodiscard]] std::optional<Towed> towed(std::size_t row) const;
};

/// Where a seeker searches.
struct SearchVolume {
  Vec3 direction{1, 0, 0};         ///< unit vector: middle of the field of view
  std::optional<Vec3> place = {};  ///< m, of a radar: near it; without it the angle decides
  PlayerId except{};               ///< who is not looked at
};

/// An aircraft that a seeker sees.
struct Detected {
  std::uint32_t row = 0;  ///< of the aircraft table
  PlayerId id;
  LineOfSight los;
  double reach = std::numeric_limits<double>::infinity();  ///< m, at which it is just detected
  bool on_jam = false;  ///< by its jamming: a direction, and no more
};

/// Whether the seeker can rest on aircraft `row`, and how it sees it then: by its echo, by its
/// heat, or, where that drowns in jamming, a radar by the jamming of that aircraft (home on jam).
[[nodiscard]] std::optional<Detected> look_at(const SeekerType& seeker, const SeekerView& view,
                                              const TargetScene& scene, std::uint32_t row);

/// The aircraft in the field of view that is nearest to the expected place, friend or foe: a
/// missile does not ask. Between equals the first row wins.
[[nodiscard]] std::optional<Detected> search(const SeekerType& seeker, const SeekerView& view,
                                             const TargetScene& scene, const SearchVolume& volume);

/// Where the missile believes its target to be at `time` (s), m.
[[nodiscard]] Vec3 believed_position(const MissileState& state, double time);

/// Switches an active radar seeker on when the target is believed to be near enough. True at that
/// moment.
[[nodiscard]] bool switch_on(const MissileType& type, const Kinematics& k, double time,
                             MissileState& state);

/// One look of a seeker that is on: follows whom it rests on or searches where it believes the
/// target. What it now sees for the first time, if anybody.
[[nodiscard]] std::optional<Detected> look(const MissileType& type, const Kinematics& k,
                                           double time, const TargetScene& scene, Draw noise,
                                           MissileState& state);

/// Whether the seeker rests on a decoy of whom it sees, chaff or a flare, and follows that in this
/// look. It goes for one that is one echo, or one spot, with its aircraft (countermeasures.hpp), by
/// a number that is drawn once for each missile and decoy; and it rests there until that is over or
/// behind it. Then it sees nobody, and searches anew from there.
enum class DecoyLook : std::uint8_t { none, fell, rests };
[[nodiscard]] DecoyLook look_at_decoys(const MissileType& type, const Kinematics& k, double time,
                                       const TargetScene& scene, std::uint64_t seed, PlayerId self,
                                       Draw noise, MissileState& state);

/// Takes over what the shooter's track says, if it is newer and the seeker sees nobody itself.
void hear(const Track& track, MissileState& state);

/// The acceleration that guidance asks for, m/s^2: none until the missile is clear of its aircraft,
/// along the seeker's line of sight while it sees somebody (and while an infrared missile remembers
/// where that was), otherwise towards the believed target, lofted if it can.
[[nodiscard]] Vec3 guide(const MissileType& type, const Kinematics& k, double time,
                         const MissileState& state);

}  // namespace eyrie::model::weapon
