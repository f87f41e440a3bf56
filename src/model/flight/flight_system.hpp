// SPDX-License-Identifier: MIT
#pragma once
/// \file  Flies every aircraft: the move phase.
#include "core/lanes.hpp"
#include "model/columns.hpp"
#include "model/environment.hpp"
#include "model/flight/airframe.hpp"
#include "model/flight/point_mass.hpp"
#include "model/frames.hpp"
#include "model/library.hpp"
#include "sim/system.hpp"

namespace eyrie::model::flight {

/// An aircraft in level flight at a place: local frame, heading (rad, true), true airspeed (m/s).
[[nodiscard]] Kinematics placed(const Reference& reference, const Environment& environment,
                                const Vec3& position, double heading, double speed);

/// Emits fuel_out when an aircraft's tanks run dry, and crash when it is below the ellipsoid (the
/// ground is at altitude 0 everywhere) or has collided with another one (flight/collision.hpp).
class FlightSystem final : public sim::System {
 public:
  /// Energy is told in the steps that pilots decide after, one in `period`: nobody else asks.
  FlightSystem(const AircraftColumns& columns, std::shared_ptr<const Library> library,
               std::uint32_t period);

  [[nodiscard]] std::string_view name() const override { return "flight"; }
  [[nodiscard]] TableId table() const override { return columns_.table; }
  void move(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void move_together(std::span<const sim::Share> shares) const override;
  void interact(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;

  /// Mass and drag area of what hangs under an aircraft.
  [[nodiscard]] Load load_of(const weapon::Stores& stores) const;

 private:
  AircraftColumns columns_;
  std::shared_ptr<const Library> library_;
  sim::Every period_;
  std::vector<PointMass> models_;               ///< one per airframe
  std::vector<std::span<const Route>> routes_;  ///< by flight; none of who has no flight
  std::vector<math::Lanes<2>> loads_;           ///< mass and drag area of a station
};

}  // namespace eyrie::model::flight
