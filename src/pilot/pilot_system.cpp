// SPDX-License-Identifier: MIT
#include "pilot/pilot_system.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "model/events.hpp"
#include "pilot/controller.hpp"
#include "sim/rate.hpp"

namespace eyrie::pilot {
namespace {

using model::EventKind;

constexpr std::array kOrders{sim::OrderKind(OrderKind::swap_tree)};

/// What one decision told, as events of one pilot.
struct Teller {
  PlayerId who;
  const model::Kinematics& own;
  sim::Outbox& out;

  void tell(EventKind kind, PlayerId whom, std::uint16_t aux, double a = 0, double b = 0,
            double c = 0) const {
    out.emit({.kind = kind,
              .aux = aux,
              .who = who,
              .whom = whom,
              .place = own.position,
              .values = {static_cast<float>(a), static_cast<float>(b), static_cast<float>(c)}});
  }
};

void tell_transitions(const ubf::TransitionLog& log, const Agent& agent, const Teller& teller) {
  for (const ubf::Transition& t : log.entries())
    teller.tell(EventKind::phase, {}, agent.tree, t.from == ubf::kNone ? -1 : t.from, t.to, t.node);
}

/// Who leads, fuel: what the pilot notices whatever his tree says.
void notice(const State& s, Agent& agent, const Teller& teller) {
  const model::Mate* lead = s.lead();
  const PlayerId now = lead ? lead->id : teller.who;
  if (agent.lead && agent.lead != now && now == teller.who)
    teller.tell(EventKind::lead_change, agent.lead, 0);
  agent.lead = now;
  if (!agent.said_bingo && s.bingo()) {
    agent.said_bingo = 1;
    teller.tell(EventKind::bingo, {}, 0, s.propulsion.fuel);
  }
}

void tell_changes(const State& s, const Agent& before, Agent& agent, const Proposal& decided,
                  const Teller& teller) {
  if (agent.node != before.node || agent.ticks == 1)
    teller.tell(EventKind::in_charge, {}, agent.tree, agent.node, decided.vote);
  if (agent.target && !before.target)
    for (const Seen& seen : s.tracks_seen())
      if (seen.id() == agent.target)
        teller.tell(EventKind::commit, seen.track->truth, 0, seen.range);
  const Call call = decided.action.call.value_or(Call::none);
  if (call != before.call) {
    if (call == Call::defend_far || call == Call::defend_near)
      teller.tell(EventKind::defend, s.threats.count ? s.threats.missiles[0].truth : PlayerId{}, 0,
                  call == Call::defend_far ? 1 : 2);
    if (call == Call::land)
      teller.tell(EventKind::home, {}, 0);
  }
  agent.call = call;
}

}  // namespace

sim::Order swap_tree_order(std::uint64_t step, PlayerId player, std::uint16_t tree) {
  return sim::order_for(step, player, OrderKind::swap_tree, SwapTree{.tree = tree});
}

void add_orders(sim::SchemaBuilder& builder) {
  builder.add_order<SwapTree>(OrderKind::swap_tree, "swap_tree");
}

PilotColumns PilotColumns::define(sim::SchemaBuilder& builder, TableId aircraft,
                                  std::uint32_t brain_bytes) {
  return {.agent = builder.add_column<Agent>(aircraft, "agent"),
          .brain = builder.add_bytes(aircraft, "brain", std::max<std::uint32_t>(brain_bytes, 8))};
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
  Agent& agent = world.rows(setup_.pilots.agent)[*row];
  agent.tree = tree;
  agent.node = ubf::kNone;
  agent.call = Call::none;
  const auto memory = world.bytes(setup_.pilots.brain, *row);
  std::memset(memory.data(), 0, memory.size());
  out.emit({.kind = EventKind::order,
            .aux = tree,
            .who = order.player,
            .place = world.rows(setup_.aircraft.kinematics)[*row].position,
            .values = {static_cast<float>(order.kind.value)}});
}

State PilotSystem::state_of(const sim::World& world, std::size_t row, double time) const {
  const model::AircraftColumns& c = setup_.aircraft;
  const model::Fit& fit = world.rows(c.fit)[row];
  return pilot::perceive(
      {world.rows(c.kinematics)[row], world.rows(c.propulsion)[row], world.rows(c.flying)[row],
       world.rows(c.stores)[row], world.rows(c.gun)[row], world.rows(c.tracks)[row],
       world.rows(c.threats)[row], world.rows(c.datalink)[row], world.rows(c.command)[row],
       world.rows(setup_.pilots.agent)[row]},
      *setup_.library, fit, setup_.flights[fit.flight], time);
}

void PilotSystem::decide(sim::World& world, const sim::StepInfo& info, sim::Chunk chunk,
                         sim::Outbox& out) const {
  const auto ids = world.ids(setup_.aircraft.table);
  const auto agents = world.rows(setup_.pilots.agent);
  const auto commands = world.rows(setup_.aircraft.command);
  const auto requests = world.rows(setup_.aircraft.request);
  for (std::size_t row = chunk.begin; row < chunk.end; ++row) {
    Agent& agent = agents[row];
    requests[row].shoot_at = {};  // a release is asked for once, not until the next decision
    if (agent.tree == kNoTree || !sim::due(info.step, ids[row], setup_.period))
      continue;

    // perceive
    const State state = state_of(world, row, info.time());
    const Teller teller{ids[row], state.own, out};
    const Agent before = agent;
    notice(state, agent, teller);

    // decide
    ubf::TransitionLog log;
    Proposal decided;
    (*setup_.trees)[agent.tree].tick({.state = state,
                                      .time = info.time(),
                                      .dt = setup_.period * info.dt,
                                      .step = info.step,
                                      .seed = info.seed,
                                      .player = ids[row],
                                      .memory = world.bytes(setup_.pilots.brain, row).data(),
                                      .log = &log},
                                     decided);

    // act
    ++agent.ticks;
    agent.node = decided.leader;
    agent.vote = decided.vote;
    execute(decided.action, state, commands[row], requests[row], agent);
    tell_transitions(log, agent, teller);
    tell_changes(state, before, agent, decided, teller);
  }
}

Proposal PilotSystem::trace_decision(const sim::World& world, const sim::StepInfo& info,
                                     std::size_t row, Trace& trace) const {
  const Agent& agent = world.rows(setup_.pilots.agent)[row];
  Proposal decided;
  if (agent.tree == kNoTree)
    return decided;
  const State state = state_of(world, row, info.time());
  const auto memory = world.bytes(setup_.pilots.brain, row);
  std::vector<std::uint64_t> copy((memory.size() + 7) / 8);
  std::memcpy(copy.data(), memory.data(), memory.size());
  (*setup_.trees)[agent.tree].tick({.state = state,
                                    .time = info.time(),
                                    .dt = setup_.period * info.dt,
                                    .step = info.step,
                                    .seed = info.seed,
                                    .player = world.ids(setup_.aircraft.table)[row],
                                    .memory = reinterpret_cast<std::byte*>(copy.data()),
                                    .trace = &trace},
                                   decided);
  return decided;
}

}  // namespace eyrie::pilot
