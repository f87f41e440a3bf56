// SPDX-License-Identifier: MIT
#pragma once
/// \file  What the benchmarks of trees share: a robot, its behaviors, and many of it that share one
/// tree. "tick" is the time of one tick of one agent, "allocs" counts heap allocations per tick,
/// "slab" is the memory of one agent in bytes; the label is a hash of the decisions, which must be
/// the same on every machine and for every compiler.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/draw.hpp"
#include "core/hash.hpp"
#include "support/no_allocation.hpp"
#include "ubf/agent.hpp"
#include "ubf/standard_nodes.hpp"

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

/// The nodes of the library and the three behaviors.
inline ubf::Registry<State, Action> standard_registry() {
  ubf::Registry<State, Action> registry;
  ubf::add_standard_nodes(registry);
  registry.add<Cruise>();
  registry.add<Avoid>();
  registry.add<Chase>();
  return registry;
}

/// The same states for everyone who measures.
inline std::vector<State> states(std::size_t count) {
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
      const ubf::PackedAction<Action> packed(proposal.action);
      hasher.bytes(&packed, sizeof packed);
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

inline void run(benchmark::State& state, const Tree& tree, bool traced) {
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

}  // namespace robot
