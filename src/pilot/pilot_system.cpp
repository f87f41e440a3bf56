// SPDX-License-Identifier: MIT
#include "pilot/pilot_system.hpp"

#include <algorithm>
#include <array>

#include "pilot/controller.hpp"
#include "pilot/teller.hpp"
#include "sim/rate.hpp"

namespace eyrie::pilot {
namespace {

constexpr std::array kOrders{sim::OrderKind(OrderKind::swap_tree)};

/// The columns that pilots read, looked up once per chunk.
struct Rows {
  Rows(const sim::World& world, const model::AircraftColumns& c)
      : fit(world.rows(c.fit)),
        kinematics(world.rows(c.kinematics)),
        propulsion(world.rows(c.propulsion)),
        flying(world.rows(c.flying)),
        stores(world.rows(c.stores)),
        gun(world.rows(c.gun)),
        tracks(world.rows(c.tracks)),
        rwr(world.rows(c.rwr)),
        threats(world.rows(c.threats)),
        datalink(world.rows(c.datalink)),
        command(world.rows(c.command)) {}

  /// What the pilot of `row` reads; what his sensors wrote is that of `sensed_row` of `sensed`.
  [[nodiscard]] Cockpit cockpit(std::size_t row, const Agent& agent, const Rows& sensed,
                                std::size_t sensed_row) const {
    return {kinematics[row],
            propulsion[row],
            flying[row],
            stores[row],
            gun[row],
            sensed.tracks[sensed_row],
            sensed.rwr[sensed_row],
            sensed.threats[sensed_row],
            sensed.datalink[sensed_row],
            command[row],
            agent};
  }

  std::span<const model::Fit> fit;
  std::span<const model::Kinematics> kinematics;
  std::span<const model::Propulsion> propulsion;
  std::span<const model::Flying> flying;
  std::span<const model::Stores> stores;
  std::span<const model::GunState> gun;
  std::span<const model::TrackFile> tracks;
  std::span<const model::RwrState> rwr;
  std::span<const model::Threats> threats;
  std::span<const model::DatalinkState> datalink;
  std::span<const model::Command> command;
};

}  // namespace

sim::Order swap_tree_order(std::uint64_t step, PlayerId player, std::uint16_t tree) {
  return sim::order_for(step, player, OrderKind::swap_tree, SwapTree{.tree = tree});
}

void add_orders(sim::SchemaBuilder& builder) {
  builder.add_order<SwapTree>(OrderKind::swap_tree, "swap_tree");
}

PilotSystem::PilotSystem(PilotSetup setup)
    : setup_(std::move(setup)), deciding_(setup_.trees, setup_.period) {
  EYRIE_THROW_UNLESS(setup_.library != nullptr, "pilots need a library");
  EYRIE_THROW_UNLESS(setup_.flights.size() >= setup_.library->flights.size(),
                     "every flight needs a plan");
}

std::span<const sim::OrderKind> PilotSystem::accepts() const {
  return kOrders;
}

void PilotSystem::apply_order(sim::World& world, const sim::StepInfo&, const sim::Order& order,
                              sim::Outbox& out) const {
  const auto row = world.row(setup_.aircraft.table, order.player);
  const auto tree = order.as<SwapTree>().tree;
  if (!row || tree >= setup_.trees->size())
    return;
  team::use_tree(world.rows(setup_.pilots.agent)[*row], world.bytes(setup_.pilots.brain, *row),
                 tree);
  out.emit({.kind = model::EventKind::order,
            .aux = tree,
            .who = order.player,
            .place = world.rows(setup_.aircraft.kinematics)[*row].position,
            .values = {static_cast<float>(order.kind.value)}});
}

void PilotSystem::decide(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                         sim::Outbox& out) const {
  const Rows rows(world, setup_.aircraft);
  const auto ids = world.ids(setup_.aircraft.table);
  const auto agents = world.rows(setup_.pilots.agent);
  const auto commands = world.rows(setup_.aircraft.command);
  const auto requests = world.rows(setup_.aircraft.request);
  for (std::size_t row = chunk.begin; row < chunk.end; ++row) {
    Agent& agent = agents[row];
    requests[row].shoot_at = {};  // a release is asked for once, not until the next decision
    requests[row].store = 0;
    if (!deciding_.due(info, ids[row], agent.tree))
      continue;

    // perceive
    const model::Fit& fit = rows.fit[row];
    const State state = pilot::perceive(rows.cockpit(row, agent, rows, row), *setup_.library, fit,
                                        setup_.flights[fit.flight], info.time());
    const Teller teller(ids[row], state, out);
    account_for_shots(state, agent);
    teller.notice(agent, fit);

    // decide
    ubf::TransitionLog log;
    Proposal decided;
    if (!deciding_.ask(agent.tree, state, info, ids[row], world.bytes(setup_.pilots.brain, row),
                       log, decided, out)) [[unlikely]]
      return;

    // act
    const Agent before = agent;
    team::keep_decision(agent, decided, info.step);
    execute(decided.action, state, commands[row], requests[row], agent);
    teller.transitions(log, deciding_.outermost(agent.tree), agent);
    teller.changes(before, decided, agent);
  }
}

void PilotSystem::perceive_again(const Cockpit& cockpit, const model::Fit& fit,
                                 const sim::StepInfo& info, PlayerId who,
                                 std::span<const std::byte> memory,
                                 const team::UseMoment<State>& use) const {
  Agent agent = cockpit.agent;
  const Cockpit copied{cockpit.own,      cockpit.propulsion, cockpit.flying, cockpit.stores,
                       cockpit.gun,      cockpit.tracks,     cockpit.rwr,    cockpit.threats,
                       cockpit.datalink, cockpit.command,    agent};
  const State state =
      pilot::perceive(copied, *setup_.library, fit, setup_.flights[fit.flight], info.time());
  account_for_shots(state, agent);
  use(deciding_.moment(state, info, who, memory));
}

std::optional<Proposal> PilotSystem::trace_decision(const sim::World& world,
                                                    const sim::StepInfo& info, std::size_t row,
                                                    Trace& trace) const {
  const Agent& agent = world.rows(setup_.pilots.agent)[row];
  if (agent.tree == kNoTree)
    return std::nullopt;
  const Rows rows(world, setup_.aircraft);
  std::optional<Proposal> decided;
  perceive_again(rows.cockpit(row, agent, rows, row), rows.fit[row], info,
                 world.ids(setup_.aircraft.table)[row], world.bytes(setup_.pilots.brain, row),
                 [&](const team::Moment<State>& m) {
                   decided = team::ask_again((*setup_.trees)[agent.tree], m, &trace);
                 });
  return decided;
}

bool PilotSystem::revisit(const sim::World& before, const sim::World& after, PlayerId who,
                          std::span<const sim::Order> orders,
                          const team::UseMoment<State>& use) const {
  const auto row = before.row(setup_.aircraft.table, who);
  const auto sensed_row = after.row(setup_.aircraft.table, who);
  const sim::StepInfo info{.step = before.step(), .seed = before.seed(), .dt = setup_.dt};
  if (!row || !sensed_row || !sim::due(info.step, who, setup_.period))
    return false;
  const auto [agent, memory] =
      team::recall(before, setup_.pilots, *row, who, orders, sim::OrderKind(OrderKind::swap_tree),
                   setup_.trees->size());
  if (agent.tree == team::kNoTree)
    return false;
  const Rows rows(before, setup_.aircraft), sensed(after, setup_.aircraft);
  perceive_again(rows.cockpit(*row, agent, sensed, *sensed_row), rows.fit[*row], info, who, memory,
                 use);
  return true;
}

std::optional<Proposal> PilotSystem::trace_decision(const sim::World& before,
                                                    const sim::World& after, PlayerId who,
                                                    Trace& trace,
                                                    std::span<const sim::Order> orders) const {
  std::optional<Proposal> decided;
  revisit(before, after, who, orders, [&](const team::Moment<State>& m) {
    decided = team::ask_again((*setup_.trees)[m.state.agent.tree], m, &trace);
  });
  return decided;
}

}  // namespace eyrie::pilot
