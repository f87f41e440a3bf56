// SPDX-License-Identifier: MIT
#pragma once
/// \file  Ground vehicles in the world: radio and eyes in perceive and act, driving in move.
#include "model/columns.hpp"
#include "model/library.hpp"
#include "sim/system.hpp"

namespace eyrie::model::vehicle {

/// Everything about vehicles but their drivers' decisions.
class VehicleSystem final : public sim::System {
 public:
  /// std::logic_error if the library has problems_of().
  VehicleSystem(const VehicleColumns& vehicles, const AircraftColumns& aircraft,
                std::shared_ptr<const Library> library, double dt);

  [[nodiscard]] std::string_view name() const override { return "vehicle"; }
  [[nodiscard]] TableId table() const override { return vehicles_.table; }
  void perceive(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void act(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void move(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;

 private:
  /// What a step needs of a VehicleType; what is null is not on board.
  struct Suite {
    const sensor::Visual* visual = nullptr;
    const datalink::Datalink* datalink = nullptr;
    sim::Every visual_steps, datalink_steps;
  };

  VehicleColumns vehicles_;
  AircraftColumns aircraft_;
  std::shared_ptr<const Library> library_;
  std::vector<Suite> suites_;                 ///< by Fit::type
  std::vector<const Signature*> signatures_;  ///< of aircraft, by Fit::type
};

}  // namespace eyrie::model::vehicle
