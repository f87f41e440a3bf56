// SPDX-License-Identifier: MIT
#pragma once
/// \file  The others of an exercise: from what is heard of them to orders (model/remote.hpp).
#include "dis/dead_reckoning.hpp"
#include "dis/incoming.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::dis {

/// Knows which entity is which remote player, by its marking, and makes orders of what is heard.
/// An entity that is nobody of the scenario takes the first place of a remote player of its force
/// that nobody has taken. Who is not heard of for the time-out of the station vanishes, until he is
/// heard of again.
class Others {
 public:
  /// `rate`: seconds of the mission in one of the clock. The scenario must outlive it.
  Others(const scenario::Scenario& scenario, const Station& station, double rate = 1)
      : scenario_(scenario), station_(station), rate_(rate), incoming_(station, rate) {}

  /// A datagram that came at `came` (s since 1970).
  void hear(std::span<const std::byte> datagram, double came) { incoming_.hear(datagram, came); }
  /// Orders for the step that begins with `world` at `now` (s since 1970), of all that was heard.
  [[nodiscard]] std::vector<sim::Order> orders(const sim::World& world, double now);

  /// The mission stands still at `now`: nobody is missed for not being heard of.
  void hold(double now) {
    for (auto& [id, entity] : entities_)
      entity.heard = now;
  }

  /// What others call a remote player; kNobody if it has not been heard of.
  [[nodiscard]] EntityId entity_of(PlayerId who) const;
  [[nodiscard]] const HeardCounts& counts() const { return incoming_.counts; }

  /// What somebody asked of all of us, and was not answered yet. 7.5.4, 7.5.5.
  struct Asked {
    EntityId from;
    std::uint32_t request = 0;
    bool stop = false;  ///< else start or resume
    bool over = false;  ///< a stop for good
  };
  [[nodiscard]] std::vector<Asked> asked() { return std::exchange(asked_, {}); }

 private:
  struct Entity {
    PlayerId who{};              ///< none: it has no place
    std::uint16_t munition = 0;  ///< 1 + index of the MissileType; 0: it is none
    bool here = false, gone = false, namesake = false;
    bool radiates = false;             ///< `beam` is new
    double heard = 0;                  ///< s since 1970, when it was last put where it is
    double named = 0;                  ///< s since 1970, when anybody last spoke of it
    double fired = 0;                  ///< s since 1970, when its Fire came
    std::optional<EntityState> early;  ///< of a missile whose Fire has not come
    std::optional<EntityState> said;   ///< the newest of those that came since the last step
    std::optional<std::uint64_t> followed, radiated;  ///< the last steps that have orders of it
    Motion last;
    double valid = 0;       ///< s since 1970, of `last`
    double said_valid = 0;  ///< and of `said`
    Reckoning reckoning = Reckoning::fixed;
    model::RemoteBeam beam;
  };
  struct Now {
    const sim::World& world;
    double clock;  ///< s since 1970
    std::vector<sim::Order>& orders;
  };

  void take(const Now& now, double valid, const EntityState& state);
  void take(const Now& now, double valid, const Fire& fire);
  void take(const Now& now, double valid, const Detonation& end);
  void take(const Now& now, double valid, const Emission& emission);
  void take(const Now& now, double valid, const StartResume& start);
  void take(const Now& now, double valid, const StopFreeze& stop);
  void take(const Now&, double, const auto&) { ++incoming_.counts.words; }

  /// What it is from now on, and whether that is new: nobody has spoken of it, or of a missile long
  /// before, which has ended. Null if there is no room.
  [[nodiscard]] std::pair<Entity*, bool> entity_called(const Now& now, const EntityId& id);
  [[nodiscard]] static bool is_past(const Entity& entity, double clock) {
    return entity.gone && entity.munition != 0 && clock - entity.named > kLongAgo;
  }
  void place(Entity& entity, const EntityState& state);
  void shoot(const Now& now, Entity& munition, PlayerId shooter, PlayerId target, model::Side side,
             float range);
  void follow(const Now& now, Entity& entity, const EntityState& state, double valid);
  void leave(const Now& now, Entity& entity, model::RemoteEnd end);
  [[nodiscard]] PlayerId player_of(const EntityId& id) const;
  [[nodiscard]] bool names_us(const EntityId& id) const;
  [[nodiscard]] std::uint16_t missile_of(const model::EntityType& type) const;
  [[nodiscard]] PlayerId nearest(const sim::World& world, const Vec3& place,
                                 model::Side side) const;
  void give(const Now& now, PlayerId who, model::RemoteOrder kind, const auto& payload) const {
    now.orders.push_back(sim::order_for(now.world.step(), who, sim::OrderKind(kind), payload));
  }

  const scenario::Scenario& scenario_;
  Station station_;
  double rate_;
  Incoming incoming_;
  std::map<EntityId, Entity> entities_;
  double tidied_ = 0;                   ///< s since 1970
  std::map<PlayerId, EntityId> named_;  ///< of players of the roster
  std::uint32_t missiles_ = 0;
  std::vector<Asked> asked_;
};

}  // namespace eyrie::dis
