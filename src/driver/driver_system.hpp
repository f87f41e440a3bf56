// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every driver's decision: perceive, ask the tree, act. The decide phase of vehicles.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "driver/agent.hpp"
#include "driver/state.hpp"
#include "driver/trees.hpp"
#include "sim/order.hpp"
#include "sim/system.hpp"

namespace eyrie::driver {

/// Orders that drivers carry out.
enum class OrderKind : std::uint16_t { none = 0, swap_tree = 2 };

/// From `step` on the player drives by that tree, which begins with nothing remembered.
[[nodiscard]] sim::Order swap_tree_order(std::uint64_t step, PlayerId player, std::uint16_t tree);

/// Names the orders of drivers in a schema.
void add_orders(sim::SchemaBuilder& builder);

/// What the drivers of a scenario share.
struct DriverSetup {
  model::VehicleColumns vehicles;
  DriverColumns drivers;
  std::shared_ptr<const model::Library> library;
  std::shared_ptr<const Trees> trees;
  std::vector<ConvoyPlan> convoys;  ///< by Fit::flight
  double dt = 0.02;                 ///< s
  std::uint32_t period = 5;         ///< steps between two decisions of one driver
};

/// decide: each driver writes his own command, agent row and the memory of his tree, and tells
/// phase, in_charge, lead_change and scatter. Orders: swap_tree; one that names no tree of the
/// scenario, or a player who is gone, is ignored.
class DriverSystem final : public sim::System {
 public:
  /// std::logic_error without library or trees, for a convoy without a plan, and for no period.
  explicit DriverSystem(DriverSetup setup);

  [[nodiscard]] std::string_view name() const override { return "driver"; }
  [[nodiscard]] TableId table() const override { return setup_.vehicles.table; }
  [[nodiscard]] std::span<const sim::OrderKind> accepts() const override;
  void apply_order(sim::World& world, const sim::StepInfo& info, const sim::Order& order,
                   sim::Outbox& out) const override;
  void decide(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
              sim::Outbox& out) const override;

  /// As PilotSystem::revisit: what a driver perceived when he decided in a step.
  bool revisit(const sim::World& before, const sim::World& after, PlayerId who,
               std::span<const sim::Order> orders, const team::UseMoment<State>& use) const;

 private:
  DriverSetup setup_;
  team::Deciding<State, Action> deciding_;
};

}  // namespace eyrie::driver
