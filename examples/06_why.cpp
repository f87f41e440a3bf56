// SPDX-License-Identifier: MIT
/// Why does eagle1 do what it does? Its decision again, with every node's answer.
#include <fmt/format.h>

#include "debrief/decision.hpp"
#include "scenario/mission.hpp"

using namespace eyrie;

int main() {
  const auto sweep = scenario::load({"scenarios/sweep.yaml", {}}, scenario::Source::disk("."));
  scenario::Mission mission(sweep, 1);
  while (mission.run().time() < 7 * 60)
    mission.step();

  std::optional<debrief::Decision> why;
  while (!why) {  // its next one
    const sim::World before = mission.run().world();
    mission.step();
    why =
        debrief::explain(*sweep, before, mission.run().world(), *sweep->roster.find("eagle1"), {});
  }
  for (const debrief::Answer& node : why->nodes)
    if (node.asked)
      fmt::print("{:{}}{:<{}} {:<8} {:g}\n", "", 2 * node.depth, node.label, 30 - 2 * node.depth,
                 ubf::to_text(node.status), node.vote);
  fmt::print("in charge: {}\n", why->nodes[why->leader].path);
  for (const debrief::Won& won : why->action)
    fmt::print("  {} {} from {}\n", won.value.name, won.value.text, why->nodes[won.winner].label);
}
