// SPDX-License-Identifier: MIT
#pragma once
/// \file  A small robot for the tests of this library: its state says what each probe shall answer.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ubf/standard_nodes.hpp"

namespace eyrie::ubf::testing {

/// What a robot can be asked to do.
struct Action {
  std::optional<double> heading{};         ///< rad
  std::optional<double> altitude{};        ///< m
  std::optional<float> speed{};            ///< m/s
  std::optional<std::uint32_t> release{};  ///< number of what is to be dropped
  std::optional<std::uint8_t> mode{};
};

/// What a probe is to answer in this tick.
struct Cue {
  Status status = Status::failure;
  float vote = 0;
  Action action{};
};

struct State {
  static constexpr std::size_t kCues = 32;
  std::array<Cue, kCues> cues{};
  double range = 0;     ///< m; NaN: unknown
  double altitude = 0;  ///< m
  double count = 0;
  bool alarm = false;
  std::array<double, 4> things{};  ///< m, ranges
  std::size_t thing_count = 0;
  std::uint8_t phase = 0;  ///< into kPhases
  static constexpr std::array<std::string_view, 3> kPhases{"search", "fetch", "home"};
};

}  // namespace eyrie::ubf::testing

template <>
struct eyrie::ubf::ActionTraits<eyrie::ubf::testing::Action> {
  using Action = testing::Action;
  static constexpr auto fields = std::tuple{
      field<blend::Angle>("heading", &Action::heading, "rad"),
      field<blend::Mean>("altitude", &Action::altitude, "m"),
      field<blend::Mean>("speed", &Action::speed, "m/s"),
      field<blend::Strongest>("release", &Action::release),
      field<blend::Agreed>("mode", &Action::mode),
  };
};

template <>
struct eyrie::ubf::StateFields<eyrie::ubf::testing::State> {
  using State = testing::State;
  [[nodiscard]] static std::span<const StateField<State>> all();
};

/// Things by their range, which is then `range`, and which probe 0 says as its vote.
template <>
struct eyrie::ubf::StateLists<eyrie::ubf::testing::State> {
  using State = testing::State;
  [[nodiscard]] static std::span<const StateList<State>> all();
};

namespace eyrie::ubf::testing {

using Node = Behavior<State, Action>;
using Child = std::unique_ptr<Node>;
using Children = std::vector<Child>;
using RobotTree = Tree<State, Action>;
using Wta = WinnerTakesAll<State, Action>;
using RobotTick = Tick<State>;
using RobotTrace = Trace<Action>;
using RobotProposal = Proposal<Action>;
using RobotRegistry = Registry<State, Action>;

/// How often a probe was asked since it was fresh.
struct ProbeMemory {
  std::uint32_t asked = 0;
};

/// A leaf that answers as its cue says and counts.
class Probe final : public WithMemory<Node, ProbeMemory> {
 public:
  static constexpr std::string_view type_name = "probe";
  static constexpr std::string_view help = "answers as its cue says";
  static constexpr auto params() {
    return std::tuple{
        param("cue", &Probe::cue, range(0, State::kCues - 1), "which cue it follows").required(),
        param("bias", &Probe::bias, range(0, 100), "added to its vote")};
  }

  Probe() = default;
  explicit Probe(std::uint32_t number) : cue(number) {}

  std::uint32_t cue = 0;
  float bias = 0;

  Status tick(const RobotTick& t, RobotProposal& out) const override {
    EYRIE_DEMAND(out.is_empty(), "what a behavior is given to write to is not empty");
    ++memory(t).asked;
    const Cue& told = t.state.cues[cue];
    out.action = told.action;
    out.vote = told.vote + bias;
    return told.status;
  }
  [[nodiscard]] std::uint32_t asked(const std::byte* slab) const { return memory(slab).asked; }
};

/// A condition that holds as long as its cue says success.
class Check final : public Condition<State, Action> {
 public:
  static constexpr std::string_view type_name = "check";
  static constexpr std::string_view help = "holds if its cue says success";
  static constexpr auto params() {
    return std::tuple{
        param("cue", &Check::cue, range(0, State::kCues - 1), "which cue it follows").required()};
  }

  Check() = default;
  explicit Check(std::uint32_t number) : cue(number) {}

  std::uint32_t cue = 0;

  [[nodiscard]] bool holds(const RobotTick& t) const override {
    return t.state.cues[cue].status == Status::success;
  }
};

[[nodiscard]] inline Child probe(std::uint32_t cue) {
  return make<Probe>(cue);
}
[[nodiscard]] inline Child check(std::uint32_t cue) {
  return make<Check>(cue);
}
/// Probes 0 ... count - 1.
[[nodiscard]] inline Children probes(std::size_t count) {
  Children children;
  for (std::size_t i = 0; i < count; ++i)
    children.push_back(probe(static_cast<std::uint32_t>(i)));
  return children;
}

/// A tree with everything around it that one agent needs. Tests set cues, tick, and look.
class Robot {
 public:
  explicit Robot(Child root) : Robot(RobotTree("test", std::move(root))) {}
  explicit Robot(RobotTree made)
      : tree(std::move(made)), slab(tree.memory_bytes()), trace(tree.size()) {}

  /// One tick, 0.1 s after the last one.
  Status tick() {
    time += 0.1;
    return tick_at(time);
  }
  Status tick_at(double when) {
    time = when;
    ++step;
    log.clear();
    status = tree.tick({.state = state,
                        .time = time,
                        .dt = 0.1,
                        .step = step,
                        .memory = slab.data(),
                        .trace = &trace,
                        .log = &log},
                       out);
    return status;
  }
  Cue& cue(std::size_t i) { return state.cues[i]; }
  void say(std::size_t i, Status answer, float vote = 0) {
    state.cues[i].status = answer;
    state.cues[i].vote = vote;
  }
  [[nodiscard]] const RobotTrace::Row& row(const std::string& path) const {
    const auto index = tree.find(path);
    EYRIE_DEMAND(index.has_value(), "no node of that path");
    return trace.row(*index);
  }
  [[nodiscard]] NodeIndex node(const std::string& path) const {
    const auto index = tree.find(path);
    EYRIE_DEMAND(index.has_value(), "no node of that path");
    return *index;
  }
  /// How often a probe was asked since it last forgot.
  [[nodiscard]] std::uint32_t asked(const std::string& path) const {
    return static_cast<const Probe&>(tree.node(node(path))).asked(slab.data());
  }
  [[nodiscard]] bool asked_now(const std::string& path) const { return row(path).ticked; }
  [[nodiscard]] int halts(const std::string& path) const { return row(path).halts; }
  /// The path of the leaf that led, "" if there is no proposal.
  [[nodiscard]] std::string leader() const {
    return out.leader == kNone ? "" : tree.path(out.leader);
  }
  /// The path of the node that supplied a field of the final action, "" if it is empty.
  [[nodiscard]] std::string supplier(std::size_t field) const {
    const NodeIndex node = trace.row(0).supplier[field];
    return node == kNone ? "" : tree.path(node);
  }

  RobotTree tree;
  std::vector<std::byte> slab;
  RobotTrace trace;
  TransitionLog log;
  State state;
  RobotProposal out;
  Status status = Status::failure;
  double time = 0;
  std::uint64_t step = 0;
};

inline constexpr Status kFailure = Status::failure;
inline constexpr Status kRunning = Status::running;
inline constexpr Status kSuccess = Status::success;

}  // namespace eyrie::ubf::testing

// compiled once for all tests (testing.cpp)
namespace eyrie::ubf {
extern template class Tree<testing::State, testing::Action>;
extern template class Trace<testing::Action>;
extern template void add_standard_nodes(Registry<testing::State, testing::Action>&);
}  // namespace eyrie::ubf
