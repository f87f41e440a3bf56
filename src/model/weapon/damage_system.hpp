// SPDX-License-Identifier: MIT
#pragma once
/// \file  Turns hits into damage, damage into kills, and takes aircraft out of the run.
#include <utility>
#include <vector>

#include "model/columns.hpp"
#include "sim/event.hpp"
#include "sim/system.hpp"

namespace eyrie::model::weapon {

/// Orders about who is in the run. An order of this kind has no payload.
enum class OrderKind : std::uint16_t { none = 0, lose = 3 };

/// The player leaves the run at `step`, lost to something outside it: a mine, a failure.
[[nodiscard]] sim::Order lose_order(std::uint64_t step, PlayerId player);
/// Names them in a schema.
void add_orders(sim::SchemaBuilder& builder);

/// A table of players other than aircraft.
struct MovingTable {
  TableId table;
  sim::Column<Kinematics> kinematics;
};

/// commit, in the order of the events: every hit adds its damage; the one that brings it to 1 is
/// credited with the kill. Nobody leaves before all hits of the step are counted, so two who kill
/// each other in one step both do. Who crashed, is home or is lost by an order leaves without a
/// kill; so far nothing but an order takes a player of another table out of the run.
class DamageSystem final : public sim::System {
 public:
  explicit DamageSystem(const AircraftColumns& aircraft, std::vector<MovingTable> others = {})
      : aircraft_(aircraft), others_(std::move(others)) {}

  [[nodiscard]] std::string_view name() const override { return "damage"; }
  [[nodiscard]] TableId table() const override { return aircraft_.table; }
  [[nodiscard]] std::span<const sim::OrderKind> accepts() const override;
  void apply_order(sim::World& world, const sim::StepInfo& info, const sim::Order& order,
                   sim::Outbox& out) const override;
  void commit(sim::World& world, const sim::StepInfo& info, std::span<const sim::Event> events,
              sim::CommitContext& context) const override;

 private:
  AircraftColumns aircraft_;
  std::vector<MovingTable> others_;
};

}  // namespace eyrie::model::weapon
