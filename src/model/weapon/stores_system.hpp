// SPDX-License-Identifier: MIT
#pragma once
/// \file  Releases stores as pilots ask and gives birth to missiles.
#include <memory>

#include "model/columns.hpp"
#include "model/library.hpp"
#include "sim/system.hpp"

namespace eyrie::model::weapon {

/// act: a Request for a store becomes a release, and after the launch delay an eject; commit: each
/// eject becomes a missile. A missile that must be locked on before launch is not released while
/// its seeker sees nobody where the track is.
class StoresSystem final : public sim::System {
 public:
  StoresSystem(const AircraftColumns& aircraft, const MissileColumns& missiles,
               std::shared_ptr<const Library> library);

  [[nodiscard]] std::string_view name() const override { return "stores"; }
  [[nodiscard]] TableId table() const override { return aircraft_.table; }
  void act(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
           sim::Outbox& out) const override;
  void commit(sim::World& world, const sim::StepInfo& info, std::span<const sim::Event> events,
              sim::CommitContext& context) const override;

 private:
  void launch(sim::World& world, const sim::StepInfo& info, const sim::Event& eject,
              sim::CommitContext& context) const;

  AircraftColumns aircraft_;
  MissileColumns missiles_;
  std::shared_ptr<const Library> library_;
};

}  // namespace eyrie::model::weapon
