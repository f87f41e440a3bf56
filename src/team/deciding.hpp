// SPDX-License-Identifier: MIT
#pragma once
/// \file  One decision of one agent inside a simulation, whatever the platform.
#include "model/events.hpp"
#include "model/fit.hpp"
#include "sim/event.hpp"
#include "sim/schema.hpp"
#include "sim/system.hpp"
#include "team/agents.hpp"
#include "team/member.hpp"
#include "team/moment.hpp"
#include "ubf/agent.hpp"
#include "ubf/watch.hpp"

namespace eyrie::team {

/// What agents add to the table of what they steer. `Agent::system` is the system that writes it.
template <class Agent>
struct AgentColumns {
  sim::Column<Agent> agent;
  sim::ByteColumn brain;  ///< memory of the tree, large enough for every tree of the scenario

  [[nodiscard]] static AgentColumns define(sim::SchemaBuilder& builder, TableId table,
                                           std::uint32_t brain_bytes) {
    const AgentColumns keys{
        .agent = builder.add_column<Agent>(table, "agent"),
        .brain = builder.add_bytes(table, "brain", std::max<std::uint32_t>(brain_bytes, 8))};
    const std::array writers{sim::WrittenBy{Agent::system, sim::Phase::orders},
                             sim::WrittenBy{Agent::system, sim::Phase::decide}};
    builder.set_writers(keys.agent.index, writers);
    builder.set_writers(keys.brain.index, writers);
    return keys;
  }
};

/// The payload of an order to use another tree.
struct SwapTree {
  std::uint16_t tree = 0;
};

/// From now on an agent uses another tree, which begins with nothing remembered.
template <class Agent>
void use_tree(Agent& agent, std::span<std::byte> memory, std::uint16_t tree) {
  agent.tree = tree;
  agent.node = agent.phase = ubf::kNone;
  agent.call = {};
  std::memset(memory.data(), 0, memory.size());
}

/// The trees of one kind of platform and how often its agents ask them.
template <class State, class Action>
class Deciding {
 public:
  using Trees = ubf::Trees<State, Action>;
  using Proposal = ubf::Proposal<Action>;

  /// std::logic_error without trees and for no period.
  Deciding(std::shared_ptr<const Trees> trees, std::uint32_t period)
      : trees_(std::move(trees)), period_(period) {
    EYRIE_THROW_UNLESS(trees_ != nullptr, "whoever decides needs trees");
    EYRIE_THROW_UNLESS(period_.steps() > 0, "a decision every 0 steps");
    for (const auto& tree : *trees_) {
      std::size_t node = 0;
      while (node < tree.size() && !tree.node(static_cast<ubf::NodeIndex>(node)).is_sequencer())
        ++node;
      outermost_.push_back(node < tree.size() ? static_cast<ubf::NodeIndex>(node) : ubf::kNone);
    }
  }

  [[nodiscard]] const Trees& trees() const { return *trees_; }
  [[nodiscard]] bool due(const sim::StepInfo& info, PlayerId who, std::uint16_t tree) const {
    return tree != kNoTree && sim::due(info.step, who, period_);
  }
  /// The first sequencer of a tree, kNone if it has none.
  [[nodiscard]] ubf::NodeIndex outermost(std::uint16_t tree) const { return outermost_[tree]; }

  /// What a tree recommends in a state; works on `memory`. False, and a fault in `out`, if a node
  /// threw or answered what means nothing: then nothing of it may be used. A tree takes such a node
  /// as one that failed; a run is ended, because whoever reads its results could not see that.
  [[nodiscard]] bool ask(std::uint16_t tree, const State& state, const sim::StepInfo& info,
                         PlayerId who, std::span<std::byte> memory,
                         std::span<const ubf::NodeVote> votes, ubf::TransitionLog& log,
                         Proposal& decided, sim::Outbox& out) const {
    EYRIE_ASSERT(tree < trees_->size());
    EYRIE_ASSERT((*trees_)[tree].memory_bytes() <= memory.size());
    const KeptMemory before(memory.first((*trees_)[tree].memory_bytes()));
    const Underway underway{who, info.step, info.time(), (*trees_)[tree].name()};
    const UnderwayGuard guard(underway);
    ubf::Mistake mistake;
    try {
      (*trees_)[tree].tick({.state = state,
                            .time = info.time(),
                            .dt = period_.steps() * info.dt,
                            .step = info.step,
                            .seed = info.seed,
                            .player = who,
                            .memory = memory.data(),
                            .log = &log,
                            .mistake = &mistake,
                            .votes = votes},
                           decided);
    } catch (...) {
      out.fail(fault_of(
          (*trees_)[tree], who, exception_text(),
          who_threw((*trees_)[tree], moment(state, info, who, before.bytes(memory), votes))));
      return false;
    }
    if (mistake.node != ubf::kNone) [[unlikely]] {
      out.fail(fault_of((*trees_)[tree], who, std::move(mistake.what), mistake.node));
      return false;
    }
    return true;
  }
  /// The moment of a decision.
  [[nodiscard]] Moment<State> moment(const State& state, const sim::StepInfo& info, PlayerId who,
                                     std::span<const std::byte> memory,
                                     std::span<const ubf::NodeVote> votes) const {
    return {state, info, period_.steps() * info.dt, who, memory, votes};
  }

 private:
  std::shared_ptr<const Trees> trees_;
  sim::Every period_;
  std::vector<ubf::NodeIndex> outermost_;
};

/// Writes into the agent's row what was decided.
template <class Agent, class Proposal>
void keep_decision(Agent& agent, const Proposal& decided, std::uint64_t step) {
  agent.decided = step;
  ++agent.ticks;
  agent.node = decided.leader;
  agent.vote = decided.vote;
}

/// Emits what one agent's decision has to tell on every platform.
class Telling {
 public:
  Telling(PlayerId who, const Vec3& place, sim::Outbox& out)
      : who_(who), place_(place), out_(out) {}

  void tell(model::EventKind kind, PlayerId whom = {}, std::uint16_t aux = 0, double a = 0,
            double b = 0, double c = 0) const {
    out_.emit({.kind = kind,
               .aux = aux,
               .who = who_,
               .whom = whom,
               .place = place_,
               .values = {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)}});
  }
  /// Every change of a sequencer; that of the `outermost` one is kept in the agent's phase.
  template <class Agent>
  void transitions(const ubf::TransitionLog& log, ubf::NodeIndex outermost, Agent& agent) const {
    for (const ubf::Transition& t : log.entries()) {
      tell(model::EventKind::phase, {}, agent.tree, t.from == ubf::kNone ? -1.0 : t.from, t.to,
           t.node);
      if (t.node == outermost)
        agent.phase = t.to;
    }
  }
  /// That the agent leads now.
  template <class Agent>
  void new_lead(Agent& agent, const model::DatalinkState& datalink, const model::Fit& fit) const {
    if (const PlayerId before = taken_over_from(agent.lead, datalink, who_))
      tell(model::EventKind::lead_change, before, 0, fit.flight);
  }
  /// A new behavior in charge.
  template <class Agent>
  void in_charge(const Agent& before, const Agent& agent) const {
    if (agent.node != before.node || before.ticks == 0)
      tell(model::EventKind::in_charge, {}, agent.tree,
           agent.node == ubf::kNone ? -1.0 : agent.node, static_cast<double>(agent.vote));
  }

 protected:
  PlayerId who_;
  Vec3 place_;
  sim::Outbox& out_;
};

}  // namespace eyrie::team
