// SPDX-License-Identifier: MIT
#pragma once
/// \file  Flies every aircraft: autopilot, dynamics and fuel in move, the ground in interact.
#include <memory>
#include <vector>

#include "model/columns.hpp"
#include "model/flight/fly.hpp"
#include "model/library.hpp"
#include "sim/system.hpp"

namespace eyrie::model::flight {

/// Emits fuel_out when an aircraft's tanks run dry, and crash when it is below the ellipsoid (the
/// ground is at altitude 0 everywhere).
class FlightSystem final : public sim::System {
 public:
  FlightSystem(const AircraftColumns& columns, std::shared_ptr<const Library> library);

  [[nodiscard]] std::string_view name() const override { return "flight"; }
  [[nodiscard]] TableId table() const override { return columns_.table; }
  void move(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
            sim::Outbox& out) const override;
  void interact(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                sim::Outbox& out) const override;

  /// Mass and drag area of what hangs under an aircraft.
  [[nodiscard]] Load load_of(const weapon::Stores& stores) const;

 private:
  /// What a step needs of an AircraftType.
  struct Type {
    std::uint16_t airframe;
    Dynamics dynamics;
  };
  AircraftColumns columns_;
  std::shared_ptr<const Library> library_;
  std::vector<Type> types_;
  std::vector<PointMass> models_;  ///< one per airframe
  std::vector<Load> stores_;       ///< one per missile type
};

}  // namespace eyrie::model::flight
