// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every missile in flight: seeker, link, guidance, flight, fuze and end.
#include <cstdint>
#include <memory>
#include <vector>

#include "model/columns.hpp"
#include "model/library.hpp"
#include "sim/system.hpp"

namespace eyrie::model::weapon {

/// perceive: seeker; decide: link and guidance; act: emission; move: flight; interact: fuze, ground
/// and the end; commit: removal of what has ended.
class MissileSystem final : public sim::System {
 public:
  /// `dt`: s, length of a step. std::logic_error if the look rate of a seeker does not divide 1/dt.
  MissileSystem(const AircraftColumns& aircraft, const MissileColumns& missiles,
                std::shared_ptr<const Library> library, double dt);

  [[nodiscard]] std::string_view name() const override { return "missile"; }
  [[nodiscard]] TableId table() const override { return missiles_.table; }
  void perceive(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                sim::Outbox& out) const override;
  void decide(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
              sim::Outbox& out) const override;
  void act(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
           sim::Outbox& out) const override;
  void move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
            sim::Outbox& out) const override;
  void interact(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                sim::Outbox& out) const override;
  void commit(sim::World& world, const sim::StepInfo& info, std::span<const sim::Event> events,
              sim::CommitContext& context) const override;

 private:
  AircraftColumns aircraft_;
  MissileColumns missiles_;
  std::shared_ptr<const Library> library_;
  std::vector<std::uint32_t> look_period_;  ///< steps, per missile type
};

/// One step of one missile through the air of `library`, and the vertical at its new place.
void move_missile(const MissileType& type, const Library& library, double time, double dt,
                  Kinematics& k, MissileState& state);

/// Why a missile ends at `time` without its fuze; none if it flies on.
[[nodiscard]] MissileEnd end_of(const MissileType& type, const Kinematics& k,
                                const MissileState& state, double time);

}  // namespace eyrie::model::weapon
