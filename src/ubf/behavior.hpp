// SPDX-License-Identifier: MIT
#pragma once
/// \file  The nouns of the Unified Behavior Framework: state, action, vote, proposal, behavior.
#include <fmt/format.h>

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/assert.hpp"
#include "core/check_values.hpp"
#include "core/draw.hpp"
#include "core/id.hpp"
#include "ubf/action_traits.hpp"
#include "ubf/any_trace.hpp"
#include "ubf/memory.hpp"
#include "ubf/proposal.hpp"
#include "ubf/transition.hpp"
#include "ubf/vote_curve.hpp"

namespace eyrie::ubf {

/// What a node says of its task. `failure` also means "not applicable now"; a plain UBF behavior
/// answers `running` as long as its recommendation stands.
enum class Status : std::uint8_t { failure, running, success };

[[nodiscard]] constexpr std::string_view to_text(Status status) {
  constexpr std::string_view kNames[] = {"failure", "running", "success"};
  return kNames[static_cast<std::size_t>(status)];
}

/// What sort of node a type is, for the catalog.
enum class Kind : std::uint8_t { behavior, condition, arbiter, control, decorator };

[[nodiscard]] constexpr std::string_view to_text(Kind kind) {
  constexpr std::string_view kNames[] = {"behavior", "condition", "arbiter", "control",
                                         "decorator"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// An answer that means nothing: a vote that is none, or a field that is NaN, infinite or beyond
/// what is plausible. Whoever gives it is taken to have failed.
struct Mistake {
  NodeIndex node = kNone;
  std::string what;  ///< "votes what means nothing: vote is nan"
};

/// Everything a node may look at during one tick. Nothing in it outlives the tick.
template <class State>
struct Tick {
  const State& state;            ///< what the agent perceives
  double time = 0;               ///< s, simulated
  double dt = 0;                 ///< s since this agent's previous tick
  std::uint64_t step = 0;        ///< of the world, for draws
  std::uint64_t seed = 0;        ///< of the run, for draws
  PlayerId player{};             ///< whose tick this is, for draws
  std::byte* memory = nullptr;   ///< this agent's slab, laid out by the tree
  AnyTrace* trace = nullptr;     ///< null when nobody watches
  TransitionLog* log = nullptr;  ///< null when nobody listens
  Mistake* mistake = nullptr;    ///< takes the first of the tick; null when nobody listens

  /// The same tick of an agent that looks at another state.
  [[nodiscard]] Tick in(const State& other) const {
    return {other, time, dt, step, seed, player, memory, trace, log, mistake};
  }
};

namespace detail {
/// Says whose answer means nothing, and why.
template <class State, class Action>
[[gnu::cold, gnu::noinline]] void note_mistake(const Tick<State>& t, NodeIndex node,
                                               const Proposal<Action>& out) {
  const std::size_t field = implausible_field(out.action);
  const bool votes = is_vote(out.vote);
  if (t.trace)
    t.trace->because(
        node, votes ? implausible_reason<Action>(field) : "its vote is no finite number from 0 up");
  if (t.mistake && t.mistake->node == kNone)
    *t.mistake = {node,
                  votes ? "recommends what means nothing: " + implausible_text(out.action, field)
                        : fmt::format("votes what means nothing: vote is {}", out.vote)};
}
}  // namespace detail

template <class State, class Action>
class Tree;
template <class State, class Action>
class Appraiser;
template <class State, class Action>
class Behavior;

/// A type of node at run time, described once by its `params()`.
template <class State, class Action>
struct NodeType {
  using Node = Behavior<State, Action>;

  std::string_view name = "behavior";  ///< under which it is registered
  Kind kind = Kind::behavior;
  /// Adds what is wrong with the values of a node's parameters.
  void (*check)(const Node&, std::vector<std::string>& problems) = nullptr;
  /// Adds the parameters of a node that have a value.
  void (*values)(const Node&, std::vector<ParamValue>& values) = nullptr;
};

/// A node of a tree. Nodes are set up once, then immutable and shared by every agent that uses
/// them; what a node must remember lives in the agent's slab (see WithMemory).
template <class State, class Action>
class Behavior {
 public:
  using StateType = State;
  using ActionType = Action;

  Behavior() = default;
  virtual ~Behavior() = default;
  Behavior(const Behavior&) = delete;
  Behavior& operator=(const Behavior&) = delete;

  /// No parameters, unless the type says otherwise (core/describe.hpp).
  [[nodiscard]] static constexpr auto params() { return std::tuple<>{}; }

  /// Recommends an action for this tick. `out` arrives empty; what is left in it when the answer
  /// is `failure` is ignored. Must not allocate, throw, lock or look at a clock.
  virtual Status tick(const Tick<State>& t, Proposal<Action>& out) const = 0;
  /// What it recommends, with the share of its vote that the state gives it. For parents.
  Status decide(const Tick<State>& t, Proposal<Action>& out) const {
    const Status status = tick(t, out);
    if (vote_curve_) [[unlikely]]
      weigh(t, out);
    return status;
  }

  [[nodiscard]] virtual std::span<const std::unique_ptr<Behavior>> children() const noexcept {
    return {};
  }
  /// Bytes of slab that this node alone needs; asked once, when the tree is laid out.
  [[nodiscard]] virtual std::size_t memory_bytes() const noexcept { return 0; }
  /// Whether what this node does depends on what it remembers. A node that only notes which child
  /// it has to halt does not, and may serve where every tick is the first.
  [[nodiscard]] virtual bool remembers() const noexcept { return memory_bytes() > 0; }
  /// Whether the node stays open although it answered success or failure, because it asks its
  /// children every time it is asked and their memory goes on: true for arbiters. Asked once, after
  /// the children were asked.
  [[nodiscard]] virtual bool stands() const noexcept { return false; }
  /// Which child is in charge according to a slab, kNone if the node does not remember that.
  [[nodiscard]] virtual NodeIndex active_child(const std::byte* /*slab*/) const noexcept {
    return kNone;
  }
  /// Whether the active child is a phase of the agent, worth telling: true for sequencers.
  [[nodiscard]] virtual bool is_sequencer() const noexcept { return false; }
  /// This node as one that judges candidates (ubf/appraiser.hpp), or null.
  [[nodiscard]] virtual const Appraiser<State, Action>* appraiser() const noexcept {
    return nullptr;
  }
  /// What is wrong with the parameters taken together, in words; empty if nothing is.
  [[nodiscard]] virtual std::string problem() const { return {}; }

  /// Pre-order position in the tree; the subtree is [index, end_index).
  [[nodiscard]] NodeIndex index() const noexcept { return index_; }
  [[nodiscard]] NodeIndex end_index() const noexcept { return end_index_; }
  /// What the user called this node; the type's name if he did not.
  [[nodiscard]] std::string_view label() const noexcept { return label_.empty() ? type() : label_; }
  /// The name under which the type is registered.
  [[nodiscard]] std::string_view type() const noexcept { return type_->name; }
  [[nodiscard]] Kind node_kind() const noexcept { return type_->kind; }
  /// Its parameters that have a value.
  [[nodiscard]] std::vector<ParamValue> values() const {
    std::vector<ParamValue> all;
    if (type_->values)
      type_->values(*this, all);
    return all;
  }

  void set_label(std::string label) { label_ = std::move(label); }
  void set_type(const NodeType<State, Action>& type) { type_ = &type; }

  /// How its vote follows the state; null if it does not.
  [[nodiscard]] const VoteCurve* vote_curve() const noexcept { return vote_curve_.get(); }
  void set_vote_curve(VoteCurve curve) {
    vote_curve_ = std::make_unique<const VoteCurve>(std::move(curve));
  }

 protected:
  /// `failure`, and why for whoever traces the tick: a literal, said at no cost to others.
  [[nodiscard]] Status fails(const Tick<State>& t, const char* why) const {
    if (t.trace) [[unlikely]]
      t.trace->because(index_, why);
    return Status::failure;
  }
  /// Random numbers of this node in this step: a pure function of seed, player, step and node.
  [[nodiscard]] Draw draw(const Tick<State>& t) const {
    return Draw(t.seed, t.player, Stream::behavior, t.step, index_);
  }
  [[nodiscard]] std::size_t memory_begin() const noexcept { return memory_begin_; }

 private:
  template <class, class>
  friend class Tree;
  template <class, class>
  friend class Composite;

  [[gnu::noinline]] void weigh(const Tick<State>& t, Proposal<Action>& out) const {
    VoteCurve::Scores scores{};
    const StateField<State>* fields = StateFields<State>::all().data();
    out.vote *= static_cast<float>(
        vote_curve_->share([&](std::uint32_t i) { return fields[i].read(t.state); }, scores));
    if (t.trace)
      t.trace->weighed(index_, scores);
  }

  NodeIndex index_ = 0, end_index_ = 1;
  bool stands_ = false;
  std::uint32_t memory_begin_ = 0, memory_end_ = 0;  ///< of the subtree
  std::unique_ptr<const VoteCurve> vote_curve_;
  static constexpr NodeType<State, Action> kAny{};
  const NodeType<State, Action>* type_ = &kAny;
  std::string label_;
};

/// A node that only looks: it holds or it does not, and recommends nothing.
template <class State, class Action>
class Condition : public Behavior<State, Action> {
 public:
  [[nodiscard]] virtual bool holds(const Tick<State>& t) const = 0;

  Status tick(const Tick<State>& t, Proposal<Action>& /*out*/) const final {
    return holds(t) ? Status::success : Status::failure;
  }
};

/// A node with memory: `class BreakTurn : public WithMemory<Behavior<State, Action>, Phase>`.
/// `Memory` is zero bytes when the agent starts and again whenever the node loses control.
template <class Base, NodeMemory Memory>
class WithMemory : public Base {
 public:
  using Base::Base;
  using TickType = Tick<typename Base::StateType>;

  [[nodiscard]] std::size_t memory_bytes() const noexcept override { return sizeof(Memory); }

 protected:
  [[nodiscard]] Memory& memory(const TickType& t) const noexcept {
    EYRIE_ASSERT(t.memory != nullptr);
    return *reinterpret_cast<Memory*>(t.memory + this->memory_begin());
  }
  [[nodiscard]] const Memory& memory(const std::byte* slab) const noexcept {
    return *reinterpret_cast<const Memory*>(slab + this->memory_begin());
  }
};

/// What sort of node `B` says that it is; without a word a condition, an arbiter if it has
/// children, or else a behavior.
template <class B>
[[nodiscard]] consteval Kind kind_of() {
  if constexpr (requires { B::kind; })
    return B::kind;
  else if constexpr (requires { typename B::Children; })
    return Kind::arbiter;
  else if constexpr (std::derived_from<B, Condition<typename B::StateType, typename B::ActionType>>)
    return Kind::condition;
  else
    return Kind::behavior;
}

template <class B>
inline constexpr NodeType<typename B::StateType, typename B::ActionType> kNodeType{
    .name = B::type_name,
    .kind = kind_of<B>(),
    .check =
        [](const auto& node, std::vector<std::string>& problems) {
          if constexpr (Described<B>)
            check_values(static_cast<const B&>(node), "", problems);
        },
    .values =
        [](const auto& node, std::vector<ParamValue>& values) {
          if constexpr (Described<B>)
            list_values(static_cast<const B&>(node), "", values);
        }};

/// Makes a node of a registered type in code; arguments go to its constructor.
///   auto root = make<WinnerTakesAll<S, A>>(make<Pursue>(), make<Navigate>());
template <class Node, class... Arguments>
[[nodiscard]] std::unique_ptr<Node> make(Arguments&&... arguments) {
  auto node = std::make_unique<Node>(std::forward<Arguments>(arguments)...);
  node->set_type(kNodeType<Node>);
  return node;
}

}  // namespace eyrie::ubf
