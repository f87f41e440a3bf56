// SPDX-License-Identifier: MIT
/// \file  What a decision costs. The reference tree is winner_takes_all over three
/// winner_takes_all of three leaves each: 13 nodes; with one level more it has 27 leaves.
#include "core/yaml.hpp"
#include "robot.hpp"

namespace robot {
namespace {

std::unique_ptr<Node> leaf(int number) {
  const float vote = static_cast<float>(1 + number * 7 % 10);
  const auto voting = [&](auto node) -> std::unique_ptr<Node> {
    node->vote = vote;
    return node;
  };
  switch (number % 3) {
    case 0:
      return voting(ubf::make<Cruise>());
    case 1:
      return voting(ubf::make<Avoid>());
    default:
      return voting(ubf::make<Chase>());
  }
}

/// `levels` levels of three children each.
template <class Arbiter>
std::unique_ptr<Node> three_by_three(int levels, int& leaves) {
  if (levels == 0)
    return leaf(leaves++);
  typename Arbiter::Children children;
  for (int i = 0; i < 3; ++i)
    children.push_back(three_by_three<Arbiter>(levels - 1, leaves));
  return ubf::make<Arbiter>(std::move(children));
}

template <class Arbiter>
Tree tree_of(int levels) {
  int leaves = 0;
  return Tree("bench", three_by_three<Arbiter>(levels, leaves));
}

template <template <class, class> class Arbiter>
void tick_tree(benchmark::State& state, int levels, bool traced) {
  run(state, tree_of<Arbiter<State, Action>>(levels), traced);
}

/// A commitment around the reference tree's three branches, which remembers in the slab.
void tick_commitment(benchmark::State& state) {
  int leaves = 0;
  using Wta = ubf::WinnerTakesAll<State, Action>;
  auto root = ubf::make<ubf::Commitment<State, Action>>(three_by_three<Wta>(1, leaves),
                                                        three_by_three<Wta>(1, leaves),
                                                        three_by_three<Wta>(1, leaves));
  root->margin = 2;
  root->hold = 1;
  run(state, Tree("bench", std::move(root)), false);
}

/// A thousand nodes as a file writes them.
std::string thousand_nodes() {
  std::string text = "winner_takes_all:\n";
  for (int i = 0; i < 333; ++i)
    text += "  - selector:\n      - chase: {vote: 7}\n      - cruise: {vote: 5}\n";
  return text;
}

/// From the text of a file to a tree that can be ticked, or only its second half: from the
/// document.
void build_thousand(benchmark::State& state, bool from_text) {
  const auto registry = standard_registry();
  const std::string text = thousand_nodes();
  Diagnostics diagnostics;
  Value document = eyrie::parse_yaml(text, "bench.yaml", diagnostics);
  std::size_t nodes = 0;
  for (auto _ : state) {
    if (from_text)
      document = eyrie::parse_yaml(text, "bench.yaml", diagnostics);
    nodes = registry.build_tree("bench", document, diagnostics)->size();
  }
  state.SetLabel(fmt::format("{} nodes", nodes));
}

constexpr const auto& kWta = tick_tree<ubf::WinnerTakesAll>;
constexpr const auto& kPerField = tick_tree<ubf::PerField>;
constexpr const auto& kFusion = tick_tree<ubf::Fusion>;

// clang-format off
BENCHMARK_CAPTURE(kWta, tree_13, 2, false)->Name("winner_takes_all/13_nodes")->Arg(6)->Arg(1000)->Arg(100'000);
BENCHMARK_CAPTURE(kWta, tree_13_traced, 2, true)->Name("winner_takes_all/13_nodes/traced")->Arg(6)->Arg(1000);
BENCHMARK_CAPTURE(kWta, leaves_27, 3, false)->Name("winner_takes_all/27_leaves")->Arg(6)->Arg(1000);
BENCHMARK_CAPTURE(kWta, leaves_27_traced, 3, true)->Name("winner_takes_all/27_leaves/traced")->Arg(6)->Arg(1000);
BENCHMARK_CAPTURE(kPerField, tree_13, 2, false)->Name("per_field/13_nodes")->Arg(1000);
BENCHMARK_CAPTURE(kFusion, tree_13, 2, false)->Name("fusion/13_nodes")->Arg(1000);
BENCHMARK(tick_commitment)->Name("commitment/13_nodes")->Arg(1000);
BENCHMARK_CAPTURE(build_thousand, text, true)->Name("build/from_text")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(build_thousand, document, false)->Name("build/from_document")->Unit(benchmark::kMicrosecond);
// clang-format on

}  // namespace
}  // namespace robot

BENCHMARK_MAIN();
