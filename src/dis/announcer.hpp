// SPDX-License-Identifier: MIT
#pragma once
/// \file  Tells other simulations of a mission as it is flown: docs/dis.md says what, and when.
#include <map>

#include "dis/others.hpp"
#include "record/names.hpp"
#include "scenario/scenario.hpp"
#include "sim/system.hpp"
#include "team/agents.hpp"

namespace eyrie::dis {

/// The full hour of the first step: 2026-01-01, 12:00 UTC, in hours since 1970, as in flight.acmi.
inline constexpr std::uint32_t kFirstHour = 490908;

/// Numbers of the datums that tell of decisions; free for use by the exercise.
enum Datum : std::uint32_t {
  kVote = 0xE1000001,      ///< as a 32-bit float
  kNode = 0xE1000002,      ///< index in its tree of the behavior in charge
  kTree = 0xE1000003,      ///< index of the tree among those of its kind of player
  kBehavior = 0xE1000004,  ///< its label
  kDecision = 0xE1000005,  ///< a sentence for people
};

// Radars, seekers and jammers of a world as systems and beams of an Emission (emissions.cpp).

/// The number in the exercise of a player.
using IdOf = std::function<EntityId(PlayerId)>;

/// A beam that tracks more says that it is crowded, and lists none.
inline constexpr std::size_t kMostTargets = 10;

/// Of an aircraft: its radar, which is there with no beam while it is silent, and its jammer.
[[nodiscard]] std::vector<Emission::System> systems_of(const scenario::Scenario& scenario,
                                                       const sim::World& world, std::size_t row,
                                                       const IdOf& id_of);
/// Of a missile: its seeker, from when it is active.
[[nodiscard]] std::vector<Emission::System> seeker_of(const scenario::Scenario& scenario,
                                                      const sim::World& world, std::size_t row,
                                                      const IdOf& id_of);

/// Whether others must hear of the change: another beam, function or target, or a beam that points
/// elsewhere by more than `angle` (rad).
[[nodiscard]] bool differs(std::span<const Emission::System> a, std::span<const Emission::System> b,
                           double angle);

/// Makes packets of a run; the same ones whatever the number of workers.
class Announcer final : public sim::Observer {
 public:
  /// Called with each packet and its time (s).
  using Send = std::function<void(double time, const Packet& packet)>;
  /// `others`: who knows by what numbers remote players go; null if there are none. Nothing is told
  /// of these: their own program does.
  Announcer(const scenario::Scenario& scenario, const Station& station, Send send,
            const Others* others = nullptr);

  void begin(const sim::World& world, double dt) override;
  void observe(const sim::World& world, const sim::StepInfo& info,
               std::span<const sim::Event> events) override;
  void finish(const sim::World& world) override;
  /// The mission stands still: everybody is where he was last. To be said every heartbeat.
  void hold();

  /// Players and missiles that have no number of 16 bits and so are not told of.
  [[nodiscard]] std::size_t nameless() const { return nameless_; }

 private:
  struct Entity {
    EntityState state;  ///< as it was told last, and how it moves by it
    Motion reckoned;
    double told = -1e9;  ///< s; before the run if never
    Motion now;
    bool moved = false;  ///< `now` has been taken twice: its acceleration and spin are known
    bool here = false;   ///< it has a row in this step
    bool destroyed = false;
    bool theirs = false;  ///< remote
    Emission emission;
    double radiated = -1e9;  ///< s
    team::LastDecision decision;
    EventId shot;  ///< of a missile, and by whom
    EntityId shooter;
  };

  /// The last words of somebody, which are said again for who did not hear them.
  struct Farewell {
    EntityState state;
    double next = 0;  ///< s
    int left = 2;
  };

  [[nodiscard]] EntityId id_of(PlayerId who) const;
  [[nodiscard]] Entity* find(PlayerId who);
  [[nodiscard]] Entity* ours(PlayerId who);
  void look(const sim::World& world);
  void look(PlayerId who, const model::Kinematics& k);
  void introduce(PlayerId who, model::Side side, std::string_view type, std::string_view marking);
  void tell_events(std::span<const sim::Event> events);
  void launch(const sim::Event& e);
  void burst(const sim::Event& e);
  void end_of_missile(const sim::Event& e, Result result);
  void tell_states();
  void tell_state(Entity& entity, std::uint32_t appearance);
  void tell_emission(PlayerId who, std::vector<Emission::System> systems);
  void tell_emissions(const sim::World& world);
  void tell_decisions(const sim::World& world);
  void tell_decision(Entity& entity, const scenario::Fleet& fleet, const team::LastDecision& now);
  void send(Pdu pdu);
  [[nodiscard]] ClockTime clock() const;

  const scenario::Scenario& scenario_;
  Station station_;
  Send send_;
  const Others* others_;
  std::map<PlayerId, Entity> entities_;
  std::vector<Farewell> farewells_;  ///< if there are others
  double time_ = 0, dt_ = 0;
  std::uint16_t shots_ = 0, emissions_ = 0;
  std::size_t nameless_ = 0;
};

}  // namespace eyrie::dis
