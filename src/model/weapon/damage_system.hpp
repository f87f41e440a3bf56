// SPDX-License-Identifier: MIT
#pragma once
/// \file  Turns hits into damage, damage into kills, and takes aircraft out of the run.
#include "model/columns.hpp"
#include "sim/system.hpp"

namespace eyrie::model {

/// commit, in the order of the events: every hit adds its damage; the one that brings it to 1 is
/// credited with the kill. Nobody leaves before all hits of the step are counted, so two who kill
/// each other in one step both do. Aircraft that crashed or are home leave without a kill.
class DamageSystem final : public sim::System {
 public:
  explicit DamageSystem(const AircraftColumns& aircraft) : aircraft_(aircraft) {}

  [[nodiscard]] std::string_view name() const override { return "damage"; }
  [[nodiscard]] TableId table() const override { return aircraft_.table; }
  void commit(sim::World& world, const sim::StepInfo& info, std::span<const sim::Event> events,
              sim::CommitContext& context) const override;

 private:
  AircraftColumns aircraft_;
};

}  // namespace eyrie::model
