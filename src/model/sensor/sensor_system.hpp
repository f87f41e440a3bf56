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
  /// The first of these rows of which a sensor may be due, or the end.
  [[nodiscard]] std::size_t first_due(const sim::World& world, std::uint64_t step,
                                      sim::Chunk chunk) const;
  void perceive_due(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const;
  void act_due(sim::World&, const sim::StepInfo&, sim::Chunk) const;
  [[nodiscard]] Scene scene(const sim::World& world, const sim::StepInfo& info) const;

  AircraftColumns aircraft_;
  MissileColumns missiles_;
  std::shared_ptr<const Library> library_;
  std::vector<SensorSuite> suites_;  ///< by Fit::type
  sim::Every any_steps_;             ///< divides those of all suites
};

}  // namespace eyrie::model::sensor
