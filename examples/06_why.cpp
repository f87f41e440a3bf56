// SPDX-License-Identifier: MIT
/// Why does eagle1 do what it does? Its decision again, with every node's answer.
#include <fmt/format.h>

#include "pilot/pilot_system.hpp"
#include "scenario/mission.hpp"

using namespace eyrie;

int main() {
  const auto sweep = scenario::load({"scenarios/sweep.yaml", {}}, scenario::Source::disk("."));
  scenario::Mission mission(sweep, 1);
  while (mission.run().time() < 7 * 60)
    mission.step();

  const pilot::PilotSystem* pilots = nullptr;
  for (const auto& system : sweep->simulation->systems())
    if (system->name() == "pilot")
      pilots = dynamic_cast<const pilot::PilotSystem*>(system.get());

  const sim::World& world = mission.run().world();
  pilot::Trace trace(sweep->trees->max_size());
  const auto decided = pilots->trace_decision(
      world, {.step = world.step(), .seed = world.seed(), .dt = 0.02}, 0, trace);
  const auto& tree = (*sweep->trees)[world.rows(sweep->pilots.agent)[0].tree];

  for (std::size_t i = 0; i < trace.rows().size(); ++i) {
    const auto node = static_cast<ubf::NodeIndex>(i);
    const auto& row = trace.row(node);
    if (row.ticked)
      fmt::print("{:{}}{:<{}} {:<8} {:g}\n", "", 2 * tree.depth(node), tree.node(node).label(),
                 30 - 2 * tree.depth(node), ubf::to_text(row.status), row.proposal.vote);
  }
  fmt::print("in charge: {}\n", tree.path(decided->leader));
  ubf::for_each_field<pilot::Action>([&](const auto& field, auto i) {
    if (const auto from = trace.row(0).supplier[i]; from != ubf::kNone)
      fmt::print("  {} from {}\n", field.name, tree.node(from).label());
  });
}
