// SPDX-License-Identifier: MIT
/// \file  What a decision costs. The reference tree is winner_takes_all over three
/// winner_takes_all of three leaves each: 13 nodes; with one level more it has 27 leaves. "tick"
/// is the time of one tick of one agent, "allocs" counts heap allocations per tick, "slab" is the
/// memory of one agent in bytes; the label is a hash of the decisions, which must be the same on
/// every machine and for every compiler.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/draw.hpp"
#include "core/hash.hpp"
#include "scenario/yaml.hpp"
#include "support/no_allocation.hpp"
#include "ubf/agent.hpp"
#include "ubf/standard_nodes.hpp"
#include "ubf/testing_document.hpp"

namespace robot {

/// What a robot perceives.
struct State {
  double heading = 0;   ///< rad
  double altitude = 0;  ///< m
  double speed = 0;     ///< m/s
  double bearing = 0;   ///< rad, of what it is after
  double range = 0;     ///< m, to what it is after
  double danger = 0;    ///< m, to the nearest obstacle
};

struct Action {
  std::optional<double> heading{};   ///< rad
  std::optional<double> altitude{};  ///< m
  std::optional<double> speed{};     ///< m/s
  std::optional<std::uint32_t> release{};
};

}  // namespace robot

template <>
struct eyrie::ubf::ActionTraits<robot::Action> {
  using A = robot::Action;
  static constexpr auto fields = std::tuple{field<blend::Angle>("heading", &A::heading, "rad"),
                                            field<blend::Mean>("altitude", &A::altitude, "m"),
                                            field<blend::Mean>("speed", &A::speed, "m/s"),
                                            field<blend::Strongest>("release", &A::release)};
};

template <>
struct eyrie::ubf::StateFields<robot::State> {
  [[nodiscard]] static std::span<const StateField<robot::State>> all() {
    static constexpr std::array kFields = std::to_array<StateField<robot::State>>({
        {{.name = "range", .kind = FieldKind::number, .unit = "m", .help = "to the goal"},
         [](const robot::State& s) { return s.range; }},
        {{.name = "altitude", .kind = FieldKind::number, .unit = "m", .help = "own"},
         [](const robot::State& s) { return s.altitude; }},
        {{.name = "close", .kind = FieldKind::flag, .unit = "", .help = "an obstacle is near"},
         [](const robot::State& s) { return s.danger < 1000 ? 1. : 0.; }},
    });
    return kFields;
  }
};
/// Four places to go to.
template <>
struct eyrie::ubf::StateLists<robot::State> {
  [[nodiscard]] static std::span<const StateList<robot::State>> all() {
    static constexpr std::array kLists{StateList<robot::State>{
        "places", "to go to", [](const robot::State&) { return std::size_t{4}; },
        [](robot::State& s, std::size_t i) { s.range = 3000. * static_cast<double>(i); }}};
    return kLists;
  }
};

namespace robot {

using namespace eyrie;
using Node = ubf::Behavior<State, Action>;
using Tick = ubf::Tick<State>;
using Proposal = ubf::Proposal<Action>;
using Status = ubf::Status;
using Tree = ubf::Tree<State, Action>;

/// Always applicable.
class Cruise final : public Node {
 public:
  static constexpr std::string_view type_name = "cruise";
  static constexpr std::string_view help = "flies on";
  static constexpr auto params() {
    return std::tuple{param("vote", &Cruise::vote, range(0, 1000), "its vote")};
  }
  float vote = 1;

  Status tick(const Tick& t, Proposal& out) const override {
    out.action.heading = t.state.heading;
    out.action.altitude = t.state.altitude;
    out.action.speed = 200;
    out.vote = vote;
    return Status::running;
  }
};

/// Applicable for one robot in three.
class Avoid final : public Node {
 public:
  static constexpr std::string_view type_name = "avoid";
  static constexpr std::string_view help = "turns away from what is near";
  static constexpr auto params() {
    return std::tuple{param("vote", &Avoid::vote, range(0, 1000), "its vote")};
  }
  float vote = 1;

  Status tick(const Tick& t, Proposal& out) const override {
    if (t.state.danger > 1000)
      return Status::failure;
    out.action.heading = t.state.heading + 1;
    out.vote = vote;
    return Status::running;
  }
};

/// Applicable for two robots in three; votes the more the nearer.
class Chase final : public Node {
 public:
  static constexpr std::string_view type_name = "chase";
  static constexpr std::string_view help = "goes after it";
  static constexpr auto params() {
    return std::tuple{param("vote", &Chase::vote, range(0, 1000), "its vote at range 0")};
  }
  float vote = 1;

  Status tick(const Tick& t, Proposal& out) const override {
    if (t.state.range > 8000)
      return Status::failure;
    out.action.heading = t.state.heading + t.state.bearing;
    out.action.speed = t.state.speed + 20;
    if (t.state.range < 2000)
      out.action.release = 1;
    out.vote = vote * static_cast<float>(1 - t.state.range / 8000);
    return Status::running;
  }
};

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

/// The same states for everyone who measures.
std::vector<State> states(std::size_t count) {
  std::vector<State> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    Draw draw(1, PlayerId{static_cast<std::uint32_t>(i + 1)}, Stream::test, 0);
    result[i] = {.heading = draw.uniform(0, 6),
                 .altitude = draw.uniform(1000, 9000),
                 .speed = draw.uniform(150, 300),
                 .bearing = draw.uniform(-1, 1),
                 .range = draw.uniform(0, 12000),
                 .danger = draw.uniform(0, 3000)};
  }
  return result;
}

/// Many agents that share one tree.
class Swarm {
 public:
  Swarm(const Tree& tree, std::size_t count)
      : tree_(tree),
        words_(tree.memory_bytes() / 8),
        states_(states(count)),
        slabs_(count * words_),
        proposals_(count) {}

  void tick(ubf::Trace<Action>* trace = nullptr) {
    for (std::size_t i = 0; i < states_.size(); ++i)
      tree_.tick({.state = states_[i],
                  .time = 0.1 * static_cast<double>(step_),
                  .dt = 0.1,
                  .step = step_,
                  .memory = reinterpret_cast<std::byte*>(slabs_.data() + i * words_),
                  .trace = trace},
                 proposals_[i]);
    ++step_;
  }
  [[nodiscard]] std::string hash() const {
    Hasher hasher;
    for (const Proposal& proposal : proposals_) {
      ubf::PackedAction<Action>(proposal.action).hash(hasher);
      hasher.bytes(&proposal.vote, sizeof proposal.vote);
      hasher.word(proposal.leader);
    }
    return fmt::format("{:016x}", hasher.value());
  }

 private:
  const Tree& tree_;
  std::size_t words_;
  std::vector<State> states_;
  std::vector<std::uint64_t> slabs_;
  std::vector<Proposal> proposals_;
  std::uint64_t step_ = 0;
};

void run(benchmark::State& state, const Tree& tree, bool traced) {
  const auto agents = static_cast<std::size_t>(state.range(0));
  Swarm swarm(tree, agents);
  ubf::Trace<Action> trace(tree.size());
  swarm.tick(traced ? &trace : nullptr);
  NoAllocation guard;
  guard.dismiss();
  for (auto _ : state) {
    swarm.tick(traced ? &trace : nullptr);
    benchmark::ClobberMemory();
  }
  const auto allocations = static_cast<double>(guard.count());
  const double ticks = static_cast<double>(state.iterations()) * static_cast<double>(agents);
  state.counters["tick"] =
      benchmark::Counter(ticks, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["allocs"] = allocations / ticks;
  state.counters["slab"] = static_cast<double>(tree.memory_bytes());
  state.SetLabel(swarm.hash());
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

ubf::Registry<State, Action> standard_registry() {
  ubf::Registry<State, Action> registry;
  ubf::add_standard_nodes(registry);
  registry.add<Cruise>();
  registry.add<Avoid>();
  registry.add<Chase>();
  return registry;
}

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
    auto tree =
        registry.build_tree(info.name, ubf::testing::Document::parse(text->second), diagnostics);
    EYRIE_DEMAND(tree.has_value(), diagnostics.text().c_str());
    const auto shared = std::make_shared<Tree>(std::move(*tree));
    benchmark::RegisterBenchmark(("node/" + info.name).c_str(), [shared](benchmark::State& state) {
      run(state, *shared, false);
    })->Arg(1000);
  }
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
  Value document = scenario::parse_yaml(text, "bench.yaml", diagnostics);
  std::size_t nodes = 0;
  for (auto _ : state) {
    if (from_text)
      document = scenario::parse_yaml(text, "bench.yaml", diagnostics);
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

}  // namespace robot

int main(int argc, char** argv) {
  robot::register_nodes();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
