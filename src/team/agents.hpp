// SPDX-License-Identifier: MIT
#pragma once
/// \file  The agents of a platform, for who does not know their states and actions.
#include "sim/event.hpp"
#include "sim/system.hpp"
#include "team/decision.hpp"
#include "ubf/action_traits.hpp"

namespace eyrie::team {

/// No tree: nobody decides.
inline constexpr std::uint16_t kNoTree = ubf::kNone;

/// What an agent's row says of its last decision.
struct LastDecision {
  std::uint32_t ticks = 0;  ///< decisions so far
  float vote = 0;
  std::uint16_t tree = kNoTree, node = ubf::kNone;
};

/// What another tree would have recommended at a decision.
struct Comparison {
  ubf::NodeIndex flown = ubf::kNone, other = ubf::kNone;  ///< who led, who would have
  std::vector<Changed> fields;                            ///< none: the same decision
  /// A run with the other tree would have ended here: one of its nodes threw, or answered what
  /// means nothing.
  std::optional<sim::Fault> fault = {};
};

class Agents;

/// A decision that is looked at again: a Moment of whatever platform. Good during the call that
/// gets it.
class AnyMoment {
 public:
  AnyMoment(const sim::StepInfo& when, PlayerId agent, std::uint16_t its_tree,
            std::span<const std::byte> remembered)
      : info(when), who(agent), tree(its_tree), memory(remembered) {}
  virtual ~AnyMoment() = default;
  AnyMoment(const AnyMoment&) = delete;
  AnyMoment& operator=(const AnyMoment&) = delete;

  const sim::StepInfo& info;
  PlayerId who;
  std::uint16_t tree;
  std::span<const std::byte> memory;  ///< of its tree, before the decision

  /// The decision again, with every node's answer.
  [[nodiscard]] virtual Decision decision() const = 0;
  /// Asks the tree of this number of `other`, agents of the same platform, too; it works on `slab`,
  /// which is as large as it needs.
  [[nodiscard]] virtual Comparison compare(const Agents& other, std::byte* slab) const = 0;
};

/// What AgentSystem is whatever its platform.
class Agents : public sim::System {
 public:
  [[nodiscard]] virtual LastDecision last_decision(const sim::World& world,
                                                   std::size_t row) const = 0;
  /// From `step` on the player uses that tree, which begins with nothing remembered.
  [[nodiscard]] virtual sim::Order order_tree(std::uint64_t step, PlayerId player,
                                              std::uint16_t tree) const = 0;
  /// The memory of a row's tree.
  [[nodiscard]] virtual std::span<std::byte> memory(sim::World& world, std::size_t row) const = 0;
  /// What an action of theirs consists of.
  [[nodiscard]] virtual std::span<const ubf::ActionFieldInfo> action_fields() const = 0;
  /// Whether two rows of controls have the same bytes.
  [[nodiscard]] virtual bool want_alike(const sim::World& a, std::size_t row, const sim::World& b,
                                        std::size_t other_row) const = 0;
  /// Calls `use` with what an agent perceived when it decided in a step, as
  /// AgentSystem::revisit. False if it did not decide then.
  virtual bool look_again(const sim::World& before, const sim::World& after, PlayerId who,
                          std::span<const sim::Order> orders,
                          const std::function<void(const AnyMoment&)>& use) const = 0;
};

}  // namespace eyrie::team
