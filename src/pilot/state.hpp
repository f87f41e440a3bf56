// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one pilot perceives at one decision: a view of his own rows, never of the truth.
#include "model/columns.hpp"
#include "model/library.hpp"
#include "pilot/agent.hpp"
#include "pilot/geometry.hpp"
#include "team/decision.hpp"
#include "team/member.hpp"

namespace eyrie::pilot {

/// One track as seen from the cockpit, carried on to the time of the decision.
struct Seen {
  const model::Track* track;
  Vec3 ned;      ///< m, from the ownship, north-east-down at the ownship
  double range;  ///< m

  [[nodiscard]] bool hostile() const {
    return track->confirmed && track->identity == model::Identity::hostile;
  }
  /// Confirmed and not a friend: a hostile, or nobody knows.
  [[nodiscard]] bool suspect() const {
    return track->confirmed && track->identity != model::Identity::friendly;
  }
  [[nodiscard]] TrackId id() const { return track->id; }
};

/// How far away somebody could hit this aircraft from, m.
struct Reach {
  double r_max, r_ne;
};

/// What the missiles on board can do about somebody.
struct OwnReach {
  double r_max = 0, r_ne = 0;  ///< m, the longest of them; 0: none reaches him
  /// Of those that may leave now and in whose zone he is, the one of the shortest r_max.
  std::optional<std::uint16_t> store;
};

/// What was found about one track in this decision, for who asks about the same one again.
template <typename T>
class LastAsked {
 public:
  /// What `find()` returns, which is called if the last one asked about was another.
  template <typename Find>
  const T& about(TrackId whom, Find find) const {
    if (whom_ != whom) {
      whom_ = whom;
      found_ = find();
    }
    return found_;
  }

 private:
  mutable TrackId whom_;  ///< whom found_ is about
  mutable T found_{};
};

/// The rows of one aircraft that its pilot reads.
struct Cockpit {
  const model::Kinematics& own;
  const model::Propulsion& propulsion;
  const model::Flying& flying;
  const model::Stores& stores;
  const model::GunState& gun;
  const model::Decoys& decoys;
  const model::TrackFile& tracks;
  const model::RwrState& rwr;
  const model::Threats& threats;
  const model::DatalinkState& datalink;
  const model::Command& command;  ///< the last one
  const Agent& agent;

  static constexpr auto columns() {
    using C = model::AircraftColumns;
    return Lines{&C::kinematics, &C::propulsion, &C::flying,  &C::stores,   &C::gun,    &C::decoys,
                 &C::tracks,     &C::rwr,        &C::threats, &C::datalink, &C::command};
  }
};

/// Where to point the nose so that the rounds meet the target.
struct Sight {
  Vec3 aim;             ///< unit vector, north-east-down at the ownship
  double off_nose = 0;  ///< rad, between `aim` and the nose
  double range = 0;     ///< m
  double time = 0;      ///< s, that a round flies
  model::Bearing body;  ///< rad, of `aim`, as LineOfSight has it
};

/// How the line of sight to somebody lies and turns, as the pilot sees it.
struct LineOfSight {
  model::Bearing body;       ///< rad, off the nose in the plane of the wings, and out of it
  double right = 0, up = 0;  ///< rad/s, at which it turns
};

/// One target as a fight sees it. Angles in rad in [0, pi].
struct Angles {
  double off_nose = 0;  ///< own flight path to the line of sight: 0 he is ahead
  double off_tail = 0;  ///< his tail to the line to here: 0 right behind him, pi in front of him
  double crossing = 0;  ///< between the two flight paths
};

/// Views into the pilot's own rows and what follows from them; good for one decision. Every track
/// in it is a belief: with a privileged player the beliefs happen to be true, and nothing here
/// knows the difference.
struct State : Cockpit {
  /// Carries every track on to `now`, counts the flight and chooses the target.
  State(const Cockpit& cockpit, const model::Library& models, const model::Fit& fit,
        const Formation& flown_in, double now);

  const model::Library& library;
  const model::AircraftType& type;
  const model::Flight& flight;
  const Formation& formation;
  double time;  ///< s

  std::uint32_t rank = 1;   ///< among the members believed alive, 1 leads
  std::uint32_t lost = 0;   ///< members believed lost; who fell silent near home has landed
  std::uint32_t alive = 0;  ///< bit i: member i is believed alive
  std::uint32_t seen_count = 0;
  std::int32_t target_index = -1;            ///< into seen; negative: nobody
  bool contested = false;                    ///< a better-ranked mate is on agent.target
  Vec3 velocity_ned;                         ///< m/s over the ground
  std::array<Seen, model::kMaxTracks> seen;  ///< the first seen_count are set

  [[nodiscard]] std::span<const Seen> tracks_seen() const { return {seen.data(), seen_count}; }
  /// The chosen target (pilot/sort.hpp), or null. Identified as hostile, unless a loop over all
  /// tracks looks at another one.
  [[nodiscard]] const Seen* target() const {
    return target_index < 0 ? nullptr : &seen[static_cast<std::size_t>(target_index)];
  }
  /// The track of that name, or the one with which it was merged; null if it is lost, or no name.
  [[nodiscard]] const Seen* find(TrackId id) const { return id ? find_named(id) : nullptr; }
  [[nodiscard]] bool leads() const { return rank == 1; }
  /// The member believed to lead; null if the datalink has not come up.
  [[nodiscard]] const model::Mate* lead() const { return model::datalink::lead(datalink); }
  /// Where the lead is: by datalink, or else by a privileged player's track of him.
  [[nodiscard]] std::optional<team::Leader> leader() const;
  /// The own place in the wall, m forward, right and down of the lead's course.
  [[nodiscard]] Vec3 place() const { return formation_offset(formation, rank); }
  [[nodiscard]] double forward_of(const team::Leader& who) const {
    return bearing_of(to_ned(own, who.velocity));
  }
  [[nodiscard]] std::span<const model::Route> routes() const { return flight.routes; }
  [[nodiscard]] model::NavState nav() const { return flying.nav; }
  [[nodiscard]] bool bingo() const { return propulsion.fuel <= agent.bingo; }
  /// m, to the home of the flight along the ground; nothing if it has none.
  [[nodiscard]] std::optional<double> home_distance() const;
  /// The missile to worry about: the nearest one of known range, or else the one known longest.
  [[nodiscard]] const model::InboundMissile* threat() const;

  /// The wind here, m/s, north-east-down.
  [[nodiscard]] Vec3 wind() const { return library.environment.wind.at(own.altitude); }
  [[nodiscard]] const model::Airframe& airframe() const {
    return library.airframes[type.index.airframe];
  }
  [[nodiscard]] const model::flight::GuidanceGains& guidance() const {
    return airframe().autopilot.guidance;
  }
  /// m/s over the ground, north-east-down at the ownship.
  [[nodiscard]] Vec3 velocity_of(const Seen& one) const { return to_ned(own, one.track->velocity); }
  /// m/s, positive if the range shrinks.
  [[nodiscard]] double closing_on(const Seen& one) const;
  /// The employment zone of a missile type against a track, from here and now.
  [[nodiscard]] model::weapon::EmploymentZone zone(std::uint16_t store, const Seen& against) const {
    return library.missiles[store].zone.at(launch_situation(against));
  }
  /// Nose, right wing and belly in the local frame. Found once a decision.
  [[nodiscard]] const model::Axes& body() const;
  /// Unit vector of the nose, north-east-down. Found once a decision.
  [[nodiscard]] const Vec3& nose() const;
  /// From where a track, as it flies now, could hit this aircraft. Nobody knows what it carries: it
  /// is the farthest-reaching radar missile that the library knows. Found once a decision.
  [[nodiscard]] const Reach& reach_of(const Seen& one) const;
  /// What the missiles on board can do about a track. Found once a decision for the last one asked.
  [[nodiscard]] const OwnReach& own_reach(const Seen& one) const;
  /// The gun's lead on a target that keeps its velocity (model/weapon/gun.hpp); nothing without a
  /// gun. Found once a decision for the last one asked.
  [[nodiscard]] const std::optional<Sight>& gun_sight(const Seen& target) const;
  /// Found once a decision for the last one asked.
  [[nodiscard]] const Angles& angles(const Seen& one) const;
  /// Found once a decision for the last one asked.
  [[nodiscard]] const LineOfSight& line_of_sight(const Seen& one) const;
  /// To the target, and inside the gun's reach to where its rounds would meet him; between one and
  /// two reaches from the one to the other. Without a target as one flies.
  [[nodiscard]] model::Bearing aim() const;
  /// The situation of a launch at a track, from here and now, for model/weapon/launch_zone.hpp.
  [[nodiscard]] model::weapon::LaunchSituation launch_situation(const Seen& target) const;
  /// Angle between the nose and a direction in NED axes, rad in [0, pi].
  [[nodiscard]] double off_nose(const Vec3& ned) const;
  /// The altitude to ask for (m) so that the autopilot's altitude hold flies a climb angle (rad):
  /// it turns an error of altitude into a climb rate by a time constant.
  [[nodiscard]] double altitude_for(double climb_angle) const;

 private:
  [[nodiscard]] const Seen* find_named(TrackId id) const;
  [[nodiscard]] Vec3 through_air(const Vec3& velocity) const;
  /// A direction (NED) from the nose in the plane of the wings, and out of it.
  [[nodiscard]] model::Bearing in_body(const Vec3& ned) const;
  [[nodiscard]] model::weapon::LaunchParty party(const Seen& one) const;

  mutable std::optional<model::Axes> body_;
  mutable std::optional<Vec3> nose_;
  mutable std::uint32_t reaches_found_ = 0;  ///< bit i: of seen[i]
  mutable std::array<Reach, model::kMaxTracks> reaches_;
  LastAsked<OwnReach> own_reach_;
  LastAsked<std::optional<Sight>> gun_sight_;
  LastAsked<Angles> angles_;
  LastAsked<LineOfSight> line_of_sight_;
  LastAsked<model::Bearing> aim_;
};

/// What is in a state, for debriefs.
[[nodiscard]] std::vector<team::Perceived> perceived(const State& state);

}  // namespace eyrie::pilot
