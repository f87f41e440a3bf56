// SPDX-License-Identifier: MIT
/// \file  What each node of the library costs: a row for every one that is registered.
#include <map>
#include <string_view>

#include "core/yaml.hpp"
#include "robot.hpp"

namespace robot {
namespace {

/// One tree per kind of node, over the same three leaves where it takes several.
const std::map<std::string_view, std::string_view>& node_trees() {
  static const std::map<std::string_view, std::string_view> kTrees{
      {"holds", "{holds: range < 8 km and not close or altitude > 6 km}"},
      {"winner_takes_all", "{winner_takes_all: [cruise, avoid, chase]}"},
      {"per_field", "{per_field: [cruise, avoid, chase]}"},
      {"fusion", "{fusion: [cruise, avoid, chase]}"},
      {"paper_fusion", "{paper_fusion: {high_vote: 1, children: [cruise, avoid, chase]}}"},
      {"commitment", "{commitment: {hold: 1 s, children: [cruise, avoid, chase]}}"},
      {"priority", "{priority: [avoid, chase, cruise]}"},
      {"suppress", "{suppress: {by: avoid, hold: 1 s, child: cruise}}"},
      {"inhibit", "{inhibit: {by: avoid, hold: 1 s, child: cruise}}"},
      {"weighted_random", "{weighted_random: {keep: 1 s, children: [cruise, avoid, chase]}}"},
      {"verify",
       "{verify: {bounds: {altitude: {max: 8 km}}, refuse: [action.speed < 150 kt and "
       "close], fallback: true, children: [chase, avoid, cruise]}}"},
      {"motor_schema",
       "{motor_schema: {direction: heading, magnitude: speed, unit_vote: 1, "
       "children: [cruise, avoid, chase]}}"},
      {"vote_grid",
       "{vote_grid: {grid: {heading: {from: 0 deg, to: 360 deg, steps: 36, reach: 60 "
       "deg}}, children: [cruise, avoid, chase]}}"},
      {"utility",
       "{utility: {grid: {heading: {from: 0 deg, to: 360 deg, steps: 36, reach: 60 deg, "
       "spread: 10 deg}}, children: [cruise, avoid, chase]}}"},
      {"always_success", "always_success"},
      {"always_failure", "always_failure"},
      {"selector", "{selector: [avoid, chase, cruise]}"},
      {"sequence", "{sequence: [{holds: close}, avoid]}"},
      {"selector_with_memory", "{selector_with_memory: [avoid, chase, cruise]}"},
      {"sequence_with_memory", "{sequence_with_memory: [not close, chase]}"},
      {"parallel", "{parallel: {success_count: 2, children: [cruise, avoid, chase]}}"},
      {"parallel_all", "{parallel_all: [cruise, avoid, chase]}"},
      {"random_selector", "{random_selector: [avoid, chase, cruise]}"},
      {"if_then_else", "{if_then_else: {if: {holds: close}, then: avoid, else: cruise}}"},
      {"while", "{while: {when: {holds: close}, do: avoid, else: cruise}}"},
      {"switch", "{switch: {on: close, cases: {true: avoid}, default: cruise}}"},
      {"sequencer",
       "{sequencer: {start: a, trees: {a: cruise, b: chase}, transitions: [{from: a, to: "
       "b, when: range < 4 km}, {from: b, to: a, when: range > 4 km}]}}"},
      {"inverter", "{inverter: {holds: close}}"},
      {"force_success", "{force_success: avoid}"},
      {"force_failure", "{force_failure: avoid}"},
      {"timeout", "{timeout: {after: 5 s, child: cruise}}"},
      {"cooldown", "{cooldown: {duration: 5 s, child: avoid}}"},
      {"guard", "{guard: {when: {holds: close}, child: avoid}}"},
      {"repeat", "{repeat: {holds: close}}"},
      {"retry", "{retry: {holds: close}}"},
      {"run_once", "{run_once: cruise}"},
      {"rate_limit", "{rate_limit: {period: 1 s, child: {holds: close}}}"},
      {"delay", "{delay: {duration: 1 s, child: cruise}}"},
      {"for_each", "{for_each: {over: places, child: chase}}"},
  };
  return kTrees;
}

/// A row for each node of the library; one without a tree here ends the program.
void register_nodes() {
  const auto registry = standard_registry();
  for (const ubf::NodeInfo& info : registry.catalog()) {
    if (info.kind == ubf::Kind::behavior)
      continue;
    const auto text = node_trees().find(info.name);
    EYRIE_DEMAND(text != node_trees().end(), "a node has no row in the table");
    Diagnostics diagnostics;
    auto tree = registry.build_tree(info.name, parse_yaml(text->second, "test.yaml", diagnostics),
                                    diagnostics);
    EYRIE_DEMAND(tree.has_value(), diagnostics.text().c_str());
    const auto shared = std::make_shared<Tree>(std::move(*tree));
    benchmark::RegisterBenchmark(("node/" + info.name).c_str(), [shared](benchmark::State& state) {
      run(state, *shared, false);
    })->Arg(1000);
  }
}

}  // namespace
}  // namespace robot

int main(int argc, char** argv) {
  robot::register_nodes();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
