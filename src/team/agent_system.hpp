// SPDX-License-Identifier: MIT
#pragma once
/// \file  Every agent's decision, whatever the platform: perceive, ask the tree, act.
#include "model/events.hpp"
#include "model/library.hpp"
#include "sim/columns.hpp"
#include "team/deciding.hpp"
#include "team/explain.hpp"
#include "team/outside.hpp"

namespace eyrie::team {

/// What the agents of one platform share.
template <class Platform>
struct AgentSetup {
  typename Platform::Columns columns;
  AgentColumns<typename Platform::Agent> agents;
  std::shared_ptr<const model::Library> library;
  std::shared_ptr<const ubf::Trees<typename Platform::State, typename Platform::Action>> trees;
  std::vector<typename Platform::Plan> plans;  ///< by Fit::flight
  double dt = 0.02;                            ///< s
  std::uint32_t period = 5;                    ///< steps between two decisions of one agent
};

/// decide: each agent writes its own controls, its row and the memory of its tree, and tells what
/// there is to tell. Orders: to use another tree; one that names no tree of the scenario, or a
/// player who is gone, is ignored.
///
/// `Platform` says what that is on one platform (see pilot/pilot_system.hpp):
///   * State, made of (view, library, fit, plan, time); Action, Agent, Columns, and Plan: what does
///     not change about one flight;
///   * View and Controls: the columns that an agent reads and that it writes (sim/columns.hpp);
///   * Teller: constructed from who, a state and an outbox; notice() before the tree is asked,
///     changes() after it;
///   * account(state, agent): what an agent takes note of before it decides; execute(action, state,
///     controls, agent); rest(controls): in every step, before the decision if one is due;
///   * swap_tree: its kind of order; if there are more, Outside (see pilot::Outside): what is asked
///     from outside, and what that does to a decision.
template <class Platform>
class AgentSystem final : public Agents {
 public:
  using State = typename Platform::State;
  using Action = typename Platform::Action;
  using Agent = typename Platform::Agent;
  using Setup = AgentSetup<Platform>;
  using Outside = typename OutsideOf<Platform>::Type;
  using Asked = typename Outside::Asked;

  /// std::logic_error without library or trees, for a flight without a plan, and for no period.
  explicit AgentSystem(Setup setup)
      : setup_(std::move(setup)), deciding_(setup_.trees, setup_.period) {
    EYRIE_THROW_UNLESS(setup_.library != nullptr, "agents need a library");
    EYRIE_THROW_UNLESS(setup_.plans.size() >= setup_.library->flights.size(),
                       "every flight needs a plan");
  }

  /// From `step` on the player uses that tree, which begins with nothing remembered.
  [[nodiscard]] static sim::Order swap_tree_order(std::uint64_t step, PlayerId player,
                                                  std::uint16_t tree) {
    return sim::order_for(step, player, Platform::swap_tree, SwapTree{.tree = tree});
  }

  [[nodiscard]] std::string_view name() const override { return Agent::system; }
  [[nodiscard]] TableId table() const override { return setup_.columns.table; }
  [[nodiscard]] std::span<const sim::OrderKind> accepts() const override { return kOrders; }
  void apply_order(sim::World& world, const sim::StepInfo&, const sim::Order& order,
                   sim::Outbox& out) const override {
    const auto row = world.row(setup_.columns.table, order.player);
    if (!row || world.rows(setup_.columns.fit)[*row].remote != 0)
      return;
    Agent& agent = world.rows(setup_.agents.agent)[*row];
    if (obey(order, agent, world.bytes(setup_.agents.brain, *row), asked_of(world)[*row]) ==
        Obeyed::told)
      Telling(order.player, world.rows(setup_.columns.kinematics)[*row].position, out)
          .tell(model::EventKind::order, {}, agent.tree, order.kind.value, Outside::detail(order));
  }

  void decide(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
              sim::Outbox& out) const override {
    const sim::Views<typename Platform::Controls, sim::World> controls(world, setup_.columns);
    const auto ids = world.ids(setup_.columns.table);
    const auto agents = world.rows(setup_.agents.agent);
    const auto asked_rows = asked_of(world);
    for (std::size_t row = chunk.begin; row < chunk.end; ++row)
      Platform::rest(controls.at(row));
    const auto decides = [&](std::size_t row) {
      return deciding_.due(info, ids[row], agents[row].tree) && !Outside::sleeps(asked_rows[row]);
    };
    std::size_t row = chunk.begin;
    while (row < chunk.end && !decides(row))
      ++row;
    if (row == chunk.end)
      return;

    const Rows rows(std::as_const(world), setup_.columns);
    const auto fits = std::as_const(world).rows(setup_.columns.fit);
    for (; row < chunk.end; ++row) {
      if (!decides(row))
        continue;
      // perceive
      Agent& agent = agents[row];
      const auto mine = controls.at(row);
      auto& asked = asked_rows[row];
      const model::Fit& fit = fits[row];
      const State state(rows.at(row, agent), *setup_.library, fit, setup_.plans[fit.flight],
                        info.time());
      const typename Platform::Teller teller(ids[row], state, out);
      Platform::account(state, agent);
      teller.notice(agent, fit);

      // decide
      ubf::TransitionLog log;
      ubf::Scratch<Action> scratch(ubf::ClearedLater{});  // a tree begins with that
      ubf::Proposal<Action>& decided = scratch.get();
      if (!deciding_.ask(agent.tree, state, info, ids[row], world.bytes(setup_.agents.brain, row),
                         Outside::votes(asked).span(), log, decided, out)) [[unlikely]]
        return;

      // act
      const Agent before = agent;
      keep_decision(agent, decided, info.step);
      if (Outside::says(asked)) [[unlikely]] {
        Outside::overrule(asked, state, decided.action);
        Outside::done(asked, state);
      }
      Platform::execute(decided.action, state, mine, agent);
      teller.transitions(log, deciding_.outermost(agent.tree), agent);
      teller.changes(before, decided, agent);
    }
  }

  [[nodiscard]] LastDecision last_decision(const sim::World& world,
                                           std::size_t row) const override {
    const Agent& agent = world.rows(setup_.agents.agent)[row];
    return {.ticks = agent.ticks, .vote = agent.vote, .tree = agent.tree, .node = agent.node};
  }
  [[nodiscard]] std::span<std::byte> memory(sim::World& world, std::size_t row) const override {
    return world.bytes(setup_.agents.brain, row);
  }
  [[nodiscard]] std::span<const ubf::ActionFieldInfo> action_fields() const override {
    return ubf::action_fields<Action>();
  }
  [[nodiscard]] sim::Order order_tree(std::uint64_t step, PlayerId player,
                                      std::uint16_t tree) const override {
    return swap_tree_order(step, player, tree);
  }
  [[nodiscard]] bool want_alike(const sim::World& a, std::size_t row, const sim::World& b,
                                std::size_t other_row) const override {
    const auto alike = [&](auto member) {
      const auto column = setup_.columns.*member;
      return std::memcmp(&a.rows(column)[row], &b.rows(column)[other_row],
                         sizeof(a.rows(column)[row])) == 0;
    };
    return with_lines(lines_of(Platform::Controls::columns()),
                      [&](auto... member) { return (alike(member) && ...); });
  }
  bool look_again(const sim::World& before, const sim::World& after, PlayerId who,
                  std::span<const sim::Order> orders,
                  const std::function<void(const AnyMoment&)>& use) const override {
    return revisit_asked(before, after, who, orders,
                         [&](const auto& m, const auto& asked) { use(Again(*this, m, asked)); });
  }

  [[nodiscard]] const Setup& setup() const { return setup_; }

  /// Calls `use` with what an agent perceived when it decided in a step, exactly, from the worlds
  /// before and after it: what was sensed in that step is taken from `after`, everything else from
  /// `before`. `orders` are those of the step. False if it had no decision due, no tree, or left
  /// in that step.
  bool revisit(const sim::World& before, const sim::World& after, PlayerId who,
               std::span<const sim::Order> orders, const UseMoment<State>& use) const {
    return revisit_asked(before, after, who, orders, [&](const auto& m, const auto&) { use(m); });
  }

 private:
  /// The same, also with what is asked of it from outside.
  template <class Use>
  bool revisit_asked(const sim::World& before, const sim::World& after, PlayerId who,
                     std::span<const sim::Order> orders, Use use) const {
    const auto row = before.row(table(), who), sensed_row = after.row(table(), who);
    const sim::StepInfo info{.step = before.step(), .seed = before.seed(), .dt = setup_.dt};
    if (!row || !sensed_row || !sim::due(info.step, who, setup_.period) ||
        before.rows(setup_.columns.fit)[*row].remote != 0)
      return false;
    Agent agent = before.rows(setup_.agents.agent)[*row];
    const auto slab = before.bytes(setup_.agents.brain, *row);
    std::vector<std::byte> memory(slab.begin(), slab.end());
    auto asked = asked_of(before)[*row];
    for (const sim::Order& order : orders)
      if (order.player == who)
        obey(order, agent, memory, asked);
    if (agent.tree == kNoTree || Outside::sleeps(asked))
      return false;
    const Rows rows(before, setup_.columns), sensed(after, setup_.columns);
    const model::Fit& fit = before.rows(setup_.columns.fit)[*row];
    const State state(rows.at_both(*row, sensed, *sensed_row, agent), *setup_.library, fit,
                      setup_.plans[fit.flight], info.time());
    Platform::account(state, agent);
    const auto votes = Outside::votes(asked);
    use(deciding_.moment(state, info, who, memory, votes.span()), asked);
    return true;
  }

  class Again final : public AnyMoment {
   public:
    Again(const AgentSystem& agents, const Moment<State>& m, const Asked& asked)
        : AnyMoment(m.info, m.who, m.state.agent.tree, m.memory),
          agents_(agents),
          m_(m),
          asked_(asked) {}
    [[nodiscard]] Decision decision() const override {
      return decision_of(m_, tree_of(agents_), [&](Action& action) {
        if (Outside::says(asked_))
          Outside::overrule(asked_, m_.state, action);
      });
    }
    [[nodiscard]] Comparison compare(const Agents& other, std::byte* slab) const override {
      const auto was = ask_again(tree_of(agents_), m_);
      ubf::Proposal<Action> would;
      ubf::TransitionLog log;
      sim::Outbox out;
      const auto& others = static_cast<const AgentSystem&>(other);  // of this platform
      // what was said of a node goes to the one of its path
      std::vector<ubf::NodeVote> votes;
      for (const ubf::NodeVote& vote : m_.votes)
        if (const auto node = tree_of(other).find(tree_of(agents_).path(vote.node)))
          votes.push_back({*node, vote.vote});
      if (!others.deciding_.ask(tree, m_.state, info, who, {slab, tree_of(other).memory_bytes()},
                                votes, log, would, out)) {
        sim::Fault fault = *out.take_fault();
        fault.step = info.step;
        return {.flown = was.leader, .other = ubf::kNone, .fields = {}, .fault = std::move(fault)};
      }
      return {was.leader, would.leader, changes(was.action, would.action)};
    }

   private:
    [[nodiscard]] const auto& tree_of(const Agents& agents) const {
      return (*static_cast<const AgentSystem&>(agents).setup_.trees)[tree];  // of this platform
    }

    const AgentSystem& agents_;
    const Moment<State>& m_;
    const Asked& asked_;
  };

  [[nodiscard]] auto asked_of(auto& world) const {
    if constexpr (std::is_same_v<Outside, NoOutside>)
      return NoOutside::Rows{};
    else
      return world.rows(setup_.columns.*Outside::column);
  }
  Obeyed obey(const sim::Order& order, Agent& agent, std::span<std::byte> memory,
              Asked& asked) const {
    if (order.kind != sim::OrderKind(Platform::swap_tree))
      return Outside::obey(
          order, asked,
          {agent.tree, agent.tree == kNoTree ? 0 : (*setup_.trees)[agent.tree].size()});
    const auto tree = order.as<SwapTree>().tree;
    if (tree >= setup_.trees->size())
      return Obeyed::no;
    use_tree(agent, memory, tree);
    Outside::forget_votes(asked);
    return Obeyed::told;
  }

  using Rows = sim::Views<typename Platform::View, const sim::World>;
  static constexpr auto kOrders = [] {
    std::array<sim::OrderKind, 1 + Outside::orders.size()> kinds{
        sim::OrderKind(Platform::swap_tree)};
    std::copy(Outside::orders.begin(), Outside::orders.end(), kinds.begin() + 1);
    return kinds;
  }();

  Setup setup_;
  Deciding<State, Action> deciding_;
};

}  // namespace eyrie::team
