// SPDX-License-Identifier: MIT
#include "driver/driver_system.hpp"

#include <array>

namespace eyrie::driver {
namespace {

using model::EventKind;

constexpr std::array kOrders{sim::OrderKind(OrderKind::swap_tree)};

void tell_changes(const team::Telling& telling, const State& state, const Agent& before,
                  const Agent& agent) {
  telling.in_charge(before, agent);
  if (agent.call == Call::scatter && before.call != Call::scatter) {
    const model::Sighted* aircraft = state.watched();
    telling.tell(EventKind::scatter, aircraft ? aircraft->truth : PlayerId{}, 0,
                 aircraft ? state.range_to(*aircraft) : 0);
  }
}

}  // namespace

sim::Order swap_tree_order(std::uint64_t step, PlayerId player, std::uint16_t tree) {
  return sim::order_for(step, player, OrderKind::swap_tree, team::SwapTree{.tree = tree});
}

void add_orders(sim::SchemaBuilder& builder) {
  builder.add_order<team::SwapTree>(OrderKind::swap_tree, "swap_driver_tree");
}

DriverSystem::DriverSystem(DriverSetup setup)
    : setup_(std::move(setup)), deciding_(setup_.trees, setup_.period) {
  EYRIE_THROW_UNLESS(setup_.library != nullptr, "drivers need a library");
  EYRIE_THROW_UNLESS(setup_.convoys.size() >= setup_.library->flights.size(),
                     "every convoy needs a plan");
}

std::span<const sim::OrderKind> DriverSystem::accepts() const {
  return kOrders;
}

void DriverSystem::apply_order(sim::World& world, const sim::StepInfo&, const sim::Order& order,
                               sim::Outbox& out) const {
  const auto row = world.row(setup_.vehicles.table, order.player);
  const auto tree = order.as<team::SwapTree>().tree;
  if (!row || tree >= setup_.trees->size())
    return;
  team::use_tree(world.rows(setup_.drivers.agent)[*row], world.bytes(setup_.drivers.brain, *row),
                 tree);
  const team::Telling telling(order.player, world.rows(setup_.vehicles.kinematics)[*row].position,
                              out);
  telling.tell(EventKind::order, {}, tree, order.kind.value);
}

void DriverSystem::decide(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                          sim::Outbox& out) const {
  const sim::World& rows = world;
  const auto ids = rows.ids(setup_.vehicles.table);
  const auto fit = rows.rows(setup_.vehicles.fit);
  const auto kinematics = rows.rows(setup_.vehicles.kinematics);
  const auto driving = rows.rows(setup_.vehicles.driving);
  const auto lookout = rows.rows(setup_.vehicles.lookout);
  const auto datalink = rows.rows(setup_.vehicles.datalink);
  const auto agents = world.rows(setup_.drivers.agent);
  const auto commands = world.rows(setup_.vehicles.command);
  for (std::size_t row = chunk.begin; row < chunk.end; ++row) {
    Agent& agent = agents[row];
    if (!deciding_.due(info, ids[row], agent.tree))
      continue;

    // perceive
    const State state({kinematics[row], driving[row], lookout[row], datalink[row], agent},
                      *setup_.library, fit[row], setup_.convoys[fit[row].flight], info.time());
    const team::Telling telling(ids[row], state.own.position, out);
    if (const PlayerId led = team::taken_over_from(agent.lead, state.datalink, ids[row]))
      telling.tell(EventKind::lead_change, led, 0, fit[row].flight);

    // decide
    ubf::TransitionLog log;
    Proposal decided;
    if (!deciding_.ask(agent.tree, state, info, ids[row], world.bytes(setup_.drivers.brain, row),
                       log, decided, out)) [[unlikely]]
      return;

    // act
    const Agent before = agent;
    team::keep_decision(agent, decided, info.step);
    execute(decided.action, commands[row], agent);
    telling.transitions(log, deciding_.outermost(agent.tree), agent);
    tell_changes(telling, state, before, agent);
  }
}

bool DriverSystem::revisit(const sim::World& before, const sim::World& after, PlayerId who,
                           std::span<const sim::Order> orders,
                           const team::UseMoment<State>& use) const {
  const model::VehicleColumns& c = setup_.vehicles;
  const auto row = before.row(c.table, who), sensed = after.row(c.table, who);
  const sim::StepInfo info{.step = before.step(), .seed = before.seed(), .dt = setup_.dt};
  if (!row || !sensed || !sim::due(info.step, who, setup_.period))
    return false;
  const auto [agent, memory] =
      team::recall(before, setup_.drivers, *row, who, orders, sim::OrderKind(OrderKind::swap_tree),
                   setup_.trees->size());
  if (agent.tree == team::kNoTree)
    return false;
  const model::Fit& fit = before.rows(c.fit)[*row];
  const State state({before.rows(c.kinematics)[*row], before.rows(c.driving)[*row],
                     after.rows(c.lookout)[*sensed], after.rows(c.datalink)[*sensed], agent},
                    *setup_.library, fit, setup_.convoys[fit.flight], info.time());
  use(deciding_.moment(state, info, who, memory));
  return true;
}

}  // namespace eyrie::driver
