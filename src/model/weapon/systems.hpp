// SPDX-License-Identifier: MIT
#pragma once
/// \file  What weapons do in a step: stores leave, missiles and rounds fly, hits become damage.
#include "model/columns.hpp"
#include "model/library.hpp"
#include "sim/event.hpp"
#include "sim/system.hpp"

namespace eyrie::model::weapon {

/// Whether the aircraft asks for a missile that stays on its rail at `time` (s): its seeker must be
/// locked on before launch and sees nobody where the track is.
[[nodiscard]] bool waits_for_lock(const sim::World& world, const AircraftColumns& aircraft,
                                  const Library& library, std::size_t row, double time);

/// act: a Request for a store becomes a release, and after the launch delay an eject; commit: each
/// eject becomes a missile. A missile that must be locked on before launch is not released while
/// its seeker sees nobody where the track is.
class StoresSystem final : public sim::System {
 public:
  StoresSystem(const AircraftColumns& aircraft, const MissileColumns& missiles,
               std::shared_ptr<const Library> library)
      : aircraft_(aircraft), missiles_(missiles), library_(std::move(library)) {}

  [[nodiscard]] std::string_view name() const override { return "stores"; }
  [[nodiscard]] TableId table() const override { return aircraft_.table; }
  void act(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void commit(sim::World&, const sim::StepInfo&, std::span<const sim::Event>,
              sim::CommitContext&) const override;

 private:
  void release(sim::World& world, double time, std::size_t row, sim::Outbox& out) const;
  void launch(sim::World& world, const sim::StepInfo& info, const sim::Event& eject,
              sim::CommitContext& context) const;
  void dispense(sim::World& world, const sim::StepInfo& info, std::size_t row,
                sim::Outbox& out) const;
  void lose_towed(sim::World& world, double time, PlayerId who) const;

  AircraftColumns aircraft_;
  MissileColumns missiles_;
  std::shared_ptr<const Library> library_;
};

/// perceive: seeker; decide: link and guidance; act: emission; move: flight; interact: fuze, ground
/// and the end; commit: removal of what has ended.
class MissileSystem final : public sim::System {
 public:
  /// `dt`: s, length of a step. std::logic_error if the look rate of a seeker does not divide 1/dt.
  MissileSystem(const AircraftColumns& aircraft, const MissileColumns& missiles,
                std::shared_ptr<const Library> library, double dt);

  [[nodiscard]] std::string_view name() const override { return "missile"; }
  [[nodiscard]] TableId table() const override { return missiles_.table; }
  void perceive(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void decide(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void act(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void move(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void interact(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;
  void commit(sim::World&, const sim::StepInfo&, std::span<const sim::Event>,
              sim::CommitContext&) const override;

 private:
  AircraftColumns aircraft_;
  MissileColumns missiles_;
  std::shared_ptr<const Library> library_;
  std::vector<sim::Every> look_period_;  ///< per missile type
  std::vector<double> fastest_closing_;  ///< m/s, likewise
};

/// One step of one missile through the air of `library`, and the vertical at its new place.
void move_missile(const MissileType& type, const Library& library, double time, double dt,
                  Kinematics& k, MissileState& state);

/// Why a missile ends at `time` without its fuze; none if it flies on.
[[nodiscard]] MissileEnd end_of(const MissileType& type, const Kinematics& k,
                                const MissileState& state, double time);

/// interact: rounds leave while Request::trigger is pressed; who is in the sight, friend or foe,
/// may be hit. A hit counts at once: the flight of the rounds is in the lead and in the chance to
/// hit, not in the time of the event.
class GunSystem final : public sim::System {
 public:
  GunSystem(const AircraftColumns& aircraft, std::shared_ptr<const Library> library)
      : aircraft_(aircraft), library_(std::move(library)) {}

  [[nodiscard]] std::string_view name() const override { return "gun"; }
  [[nodiscard]] TableId table() const override { return aircraft_.table; }
  void interact(sim::World&, const sim::StepInfo&, sim::Chunk, sim::Outbox&) const override;

 private:
  void use(sim::World& world, const sim::StepInfo& info, std::size_t self, sim::Outbox& out) const;

  AircraftColumns aircraft_;
  std::shared_ptr<const Library> library_;
};

/// Orders about who is in the run. An order of this kind has no payload.
enum class OrderKind : std::uint16_t { none = 0, lose = 3 };

/// The player leaves the run at `step`, lost to something outside it: a mine, a failure.
[[nodiscard]] sim::Order lose_order(std::uint64_t step, PlayerId player);

/// A table of players other than aircraft.
struct MovingTable {
  TableId table;
  sim::Column<Kinematics> kinematics;
};

/// commit, in the order of the events: every hit adds its damage; the one that brings it to 1 is
/// credited with the kill. Nobody leaves before all hits of the step are counted, so two who kill
/// each other in one step both do. Who crashed, is home or is lost by an order leaves once, without
/// a kill; so far nothing but an order takes a player of another table out of the run.
class DamageSystem final : public sim::System {
 public:
  explicit DamageSystem(const AircraftColumns& aircraft, std::vector<MovingTable> others = {})
      : aircraft_(aircraft), others_(std::move(others)) {}

  [[nodiscard]] std::string_view name() const override { return "damage"; }
  [[nodiscard]] TableId table() const override { return aircraft_.table; }
  [[nodiscard]] std::span<const sim::OrderKind> accepts() const override;
  void apply_order(sim::World&, const sim::StepInfo&, const sim::Order&,
                   sim::Outbox&) const override;
  void commit(sim::World&, const sim::StepInfo&, std::span<const sim::Event>,
              sim::CommitContext&) const override;

 private:
  AircraftColumns aircraft_;
  std::vector<MovingTable> others_;
};

}  // namespace eyrie::model::weapon
