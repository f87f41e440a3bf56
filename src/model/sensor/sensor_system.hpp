// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every aircraft's sensors, tracks and datalink: perceive, and what it radiates: act.
#include "model/columns.hpp"
#include "model/library.hpp"
#include "model/sensor/scene.hpp"
#include "sim/system.hpp"

namespace eyrie::model::sensor {

/// perceive: each aircraft writes its own radar, warnings, threats, tracks and datalink state.
/// act: its own emission and its own messages. Emits contact, track_lost, identified, rwr_warning
/// and missile_warning.
class SensorSystem final : public sim::System {
 public:
  /// `dt`: length of a step, s. std::logic_error if the library has problems_of(), or a flight of
  /// more than kMaxFlight.
  SensorSystem(const AircraftColumns& aircraft, const MissileColumns& missiles,
               std::shared_ptr<const Library> library, double dt);

  [[nodiscard]] std::string_view name() const override { return "sensors"; }
  [[nodiscard]] TableId table() const override { return aircraft_.table; }
  void perceive(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void act(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;

 private:
  [[nodiscard]] Scene scene(const sim::World& world, const sim::StepInfo& info) const;

  AircraftColumns aircraft_;
  MissileColumns missiles_;
  std::shared_ptr<const Library> library_;
  std::vector<SensorSuite> suites_;  ///< by Fit::type
};

}  // namespace eyrie::model::sensor
