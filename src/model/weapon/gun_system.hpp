// SPDX-License-Identifier: MIT
#pragma once
/// \file  Fires the guns whose trigger is pressed.
#include <memory>

#include "model/columns.hpp"
#include "model/library.hpp"
#include "model/weapon/gun.hpp"
#include "sim/system.hpp"

namespace eyrie::model::weapon {

/// interact: rounds leave while Request::trigger is pressed; who is in the sight, friend or foe,
/// may be hit. A hit counts at once: the flight of the rounds is in the lead and in the chance to
/// hit, not in the time of the event.
class GunSystem final : public sim::System {
 public:
  GunSystem(const AircraftColumns& aircraft, std::shared_ptr<const Library> library);

  [[nodiscard]] std::string_view name() const override { return "gun"; }
  [[nodiscard]] TableId table() const override { return aircraft_.table; }
  void interact(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                sim::Outbox& out) const override;

 private:
  AircraftColumns aircraft_;
  std::shared_ptr<const Library> library_;
};

}  // namespace eyrie::model::weapon
