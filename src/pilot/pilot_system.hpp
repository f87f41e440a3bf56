// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every pilot's decision: perceive, ask the tree, act. The decide phase of aircraft.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pilot/columns.hpp"
#include "pilot/state.hpp"
#include "pilot/trees.hpp"
#include "sim/order.hpp"
#include "sim/system.hpp"

namespace eyrie::pilot {

/// Orders that pilots carry out.
enum class OrderKind : std::uint16_t { none = 0, swap_tree = 1 };

struct SwapTree {
  std::uint16_t tree = 0;
  std::uint16_t reserved[3] = {};
  static constexpr auto fields() {
    return field_list(field("tree", &SwapTree::tree), field("reserved", &SwapTree::reserved));
  }
};

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

/// Emits phase, in_charge, defend, commit, lead_change, bingo, home and order events.
class PilotSystem final : public sim::System {
 public:
  explicit PilotSystem(PilotSetup setup) : setup_(std::move(setup)) {}

  [[nodiscard]] std::string_view name() const override { return "pilot"; }
  [[nodiscard]] TableId table() const override { return setup_.aircraft.table; }
  [[nodiscard]] std::span<const sim::OrderKind> accepts() const override;
  void apply_order(sim::World& world, const sim::StepInfo& info, const sim::Order& order,
                   sim::Outbox& out) const override;
  void decide(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
              sim::Outbox& out) const override;

  [[nodiscard]] const PilotSetup& setup() const { return setup_; }

  /// Ticks the tree of one aircraft as its pilot would now, on a copy of its memory, and records
  /// every node's answer. `trace` must have room for Trees::max_size() nodes. Gives the proposal.
  [[nodiscard]] Proposal trace_decision(const sim::World& world, const sim::StepInfo& info,
                                        std::size_t row, Trace& trace) const;

 private:
  [[nodiscard]] State state_of(const sim::World& world, std::size_t row, double time) const;

  PilotSetup setup_;
};

}  // namespace eyrie::pilot
