// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every pilot's decision: perceive, ask the tree, act. The decide phase of aircraft.
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "pilot/agent.hpp"
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "sim/order.hpp"
#include "sim/system.hpp"

namespace eyrie::pilot {

/// Orders that pilots carry out.
enum class OrderKind : std::uint16_t { none = 0, swap_tree = 1 };

using team::SwapTree;

/// From `step` on the player flies that tree, which begins with nothing remembered.
[[nodiscard]] sim::Order swap_tree_order(std::uint64_t step, PlayerId player, std::uint16_t tree);

/// Names the orders of pilots in a schema.
void add_orders(sim::SchemaBuilder& builder);

/// What the pilots of a scenario share.
struct PilotSetup {
  model::AircraftColumns aircraft;
  PilotColumns pilots;
  std::shared_ptr<const model::Library> library;
  std::shared_ptr<const Trees> trees;
  std::vector<FlightPlan> flights;  ///< by Fit::flight
  double dt = 0.02;                 ///< s
  std::uint32_t period = 5;         ///< steps between two decisions of one pilot
};

/// decide: each pilot writes his own command, request, agent row and the memory of his tree, and
/// tells phase, in_charge, defend, commit, lead_change, bingo and home. Orders: swap_tree; one that
/// names no tree of the scenario, or a player who is gone, is ignored.
class PilotSystem final : public sim::System {
 public:
  /// std::logic_error without library or trees, for a flight without a plan, and for no period.
  explicit PilotSystem(PilotSetup setup);

  [[nodiscard]] std::string_view name() const override { return "pilot"; }
  [[nodiscard]] TableId table() const override { return setup_.aircraft.table; }
  [[nodiscard]] std::span<const sim::OrderKind> accepts() const override;
  void apply_order(sim::World& world, const sim::StepInfo& info, const sim::Order& order,
                   sim::Outbox& out) const override;
  void decide(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
              sim::Outbox& out) const override;

  [[nodiscard]] const PilotSetup& setup() const { return setup_; }

  /// What the pilot of one aircraft decides on what he knows at this moment of `world`: asks his
  /// tree on a copy of its memory and records every node's answer. `trace` must have room for
  /// Trees::max_size() nodes. Nothing for a pilot without a tree. Allocates; for debriefs.
  [[nodiscard]] std::optional<Proposal> trace_decision(const sim::World& world,
                                                       const sim::StepInfo& info, std::size_t row,
                                                       Trace& trace) const;

  /// Calls `use` with what a pilot perceived when he decided in a step, exactly, from the worlds
  /// before and after it: what the sensors wrote in that step is taken from `after`, everything
  /// else from `before`. `orders` are those of the step. False if he had no decision due, no tree,
  /// or left in that step.
  bool revisit(const sim::World& before, const sim::World& after, PlayerId who,
               std::span<const sim::Order> orders, const team::UseMoment<State>& use) const;
  /// The decision that he made then.
  [[nodiscard]] std::optional<Proposal> trace_decision(
      const sim::World& before, const sim::World& after, PlayerId who, Trace& trace,
      std::span<const sim::Order> orders = {}) const;

 private:
  void perceive_again(const Cockpit& cockpit, const model::Fit& fit, const sim::StepInfo& info,
                      PlayerId who, std::span<const std::byte> memory,
                      const team::UseMoment<State>& use) const;

  PilotSetup setup_;
  team::Deciding<State, Action> deciding_;
};

}  // namespace eyrie::pilot
