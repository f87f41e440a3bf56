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

/// An action together with how strongly it is recommended. The vote is finite and not negative; a
/// vote of 0 abstains from every arbiter. A proposal that means nothing is a failure (Mistake).
template <class Action>
struct Proposal {
  Action action{};
  float vote = 0;
  /// The node that this comes from: the behavior that recommended it, of several mixed field by
  /// field the strongest, or the arbiter that blended it; kNone for no proposal. Filled in on the
  /// way up, not by behaviors, so that it is known without a trace.
  NodeIndex leader = kNone;

  void clear() noexcept {
    // Many small writes are what a tick waits for: few large ones, unless a field is large.
    if constexpr (sizeof(Proposal) <= 16 * (kFields<Action> + 2)) {
      static constexpr Proposal kEmpty{};
      std::memcpy(static_cast<void*>(this), &kEmpty, sizeof kEmpty);
    } else {
      ubf::clear(action);
      vote = 0;
      leader = kNone;
    }
  }
  /// What plain assignment does, faster just after the other was written.
  void copy(const Proposal& other) noexcept {
    ubf::copy(other.action, action);
    vote = other.vote;
    leader = other.leader;
  }
  /// Neither a vote nor any field: this is no proposal.
  [[nodiscard]] bool is_empty() const noexcept { return vote == 0 && ubf::is_empty(action); }
};

/// To Scratch: it is cleared before anybody is asked into it.
struct ClearedLater {};

/// An empty proposal on the stack, for a node to ask its children into. It is cleared and not made
/// by Proposal{}, which writes a large action value by value: that took 40 % of a tick.
template <class Action>
class Scratch {
 public:
  Scratch() noexcept { get().clear(); }
  /// Only its vote is written, so that what is asked first can be compared with it.
  explicit Scratch(ClearedLater) noexcept { get().vote = 0; }
  [[nodiscard]] Proposal<Action>& get() noexcept {
    return *std::launder(reinterpret_cast<Proposal<Action>*>(bytes_));
  }
  [[nodiscard]] const Proposal<Action>& get() const noexcept {
    return *std::launder(reinterpret_cast<const Proposal<Action>*>(bytes_));
  }

 private:
  static_assert(std::is_trivially_copyable_v<Proposal<Action>>);
  alignas(Proposal<Action>) std::byte bytes_[sizeof(Proposal<Action>)];
};

/// Two places that children propose into in turn, one of them the node's own `out`: what is chosen
/// is kept by exchanging the places, and copied at most once, at the end. The second place stays
/// outside: what children may write to must not be one object with the two pointers, or they are
/// read from memory again after every child (measured: 57 ns of 13 nodes became 85).
template <class Action>
class BestSoFar {
 public:
  BestSoFar(Proposal<Action>& out, Scratch<Action>& other) noexcept
      : out_(out), best_(&other.get()), next_(&out) {}
  BestSoFar(const BestSoFar&) = delete;
  BestSoFar& operator=(const BestSoFar&) = delete;

  /// Where the next child proposes.
  [[nodiscard]] Proposal<Action>& next() noexcept { return *next_; }
  /// The best so far, empty before the first. Compare with it, not with a copy of its vote: that
  /// one goes through memory too, with a store after every choice and more to hold during a call.
  [[nodiscard]] const Proposal<Action>& kept() const noexcept { return *best_; }
  /// What is in next() is the best so far.
  void keep() noexcept { std::swap(best_, next_); }
  /// Leaves the best in `out`.
  void hand_on() noexcept {
    if (best_ != &out_)
      out_.copy(*best_);
  }

 private:
  Proposal<Action>& out_;
  Proposal<Action>*best_, *next_;
};

namespace detail {
/// The sign is not set, and it is neither infinite nor NaN.
[[nodiscard]] constexpr bool is_plain_vote(float vote) {
  return std::bit_cast<std::uint32_t>(vote) <= 0x7f7fffffU;
}
}  // namespace detail

/// A vote in [0, infinity), which NaN is not. One comparison of bits: every node's vote is looked
/// at (as two comparisons of numbers it was 15 % of a tick).
[[nodiscard]] constexpr bool is_vote(float vote) {
  return detail::is_plain_vote(vote) || vote == 0;
}
/// Of two votes the larger, as their bits are in the same order; what is no vote beats every vote,
/// and so does -0. So who looks for the largest has to look only at what beats the others.
[[nodiscard]] constexpr bool outvotes(float vote, float other) {
  return std::bit_cast<std::uint32_t>(vote) > std::bit_cast<std::uint32_t>(other);
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

/// Whether an answer means something. Fields are looked at where they come from, that is as long as
/// nobody leads.
template <class Action>
[[nodiscard]] bool fields_mean_something(const Proposal<Action>& proposal) {
  return proposal.leader != kNone || implausible_field(proposal.action) == kFields<Action>;
}

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
  [[nodiscard]] std::string_view label() const noexcept { return label_.empty() ? type_ : label_; }
  /// The name under which the type is registered.
  [[nodiscard]] std::string_view type() const noexcept { return type_; }
  [[nodiscard]] Kind node_kind() const noexcept { return kind_; }

  void set_label(std::string label) { label_ = std::move(label); }
  /// By make(); `check` adds what is wrong with the values of the node's parameters.
  void set_type(std::string_view type, Kind kind,
                void (*check)(const Behavior&, std::vector<std::string>&)) {
    type_ = type;
    kind_ = kind;
    check_ = check;
  }

  /// How its vote follows the state; null if it does not.
  [[nodiscard]] const VoteCurve* vote_curve() const noexcept { return vote_curve_.get(); }
  void set_vote_curve(VoteCurve curve) {
    vote_curve_ = std::make_unique<const VoteCurve>(std::move(curve));
  }

  /// The value of the parameter `vote` of a behavior that was read from a file, for debriefs;
  /// nothing if it has none, and for what was made without a file.
  [[nodiscard]] std::optional<float> vote_given() const noexcept { return vote_given_; }
  void set_vote_given(float vote) { vote_given_ = vote; }

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
  Kind kind_ = Kind::behavior;
  std::uint32_t memory_begin_ = 0, memory_end_ = 0;  ///< of the subtree
  std::unique_ptr<const VoteCurve> vote_curve_;
  std::optional<float> vote_given_;
  void (*check_)(const Behavior&, std::vector<std::string>&) = nullptr;
  std::string_view type_ = "behavior";
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

/// Makes a node of a registered type in code; arguments go to its constructor.
///   auto root = make<WinnerTakesAll<S, A>>(make<Pursue>(), make<Navigate>());
template <class Node, class... Arguments>
[[nodiscard]] std::unique_ptr<Node> make(Arguments&&... arguments) {
  auto node = std::make_unique<Node>(std::forward<Arguments>(arguments)...);
  using Base = Behavior<typename Node::StateType, typename Node::ActionType>;
  node->set_type(Node::type_name, kind_of<Node>(),
                 [](const Base& made, std::vector<std::string>& problems) {
                   if constexpr (Described<Node>)
                     check_values(static_cast<const Node&>(made), "", problems);
                 });
  return node;
}

}  // namespace eyrie::ubf
