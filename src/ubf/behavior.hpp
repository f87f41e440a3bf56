// SPDX-License-Identifier: MIT
#pragma once
/// \file  The nouns of the Unified Behavior Framework: state, action, vote, proposal, behavior.
#include "core/draw.hpp"
#include "ubf/action_traits.hpp"
#include "ubf/node.hpp"
#include "ubf/proposal.hpp"
#include "ubf/state_fields.hpp"
#include "ubf/watch.hpp"

namespace eyrie::ubf {

/// What a node says of its task. `failure` also means "not applicable now"; a plain UBF behavior
/// answers `running` as long as its recommendation stands.
enum class Status : std::uint8_t { failure, running, success };

[[nodiscard]] constexpr std::string_view to_text(Status status) {
  constexpr std::string_view kNames[] = {"failure", "running", "success"};
  return kNames[static_cast<std::size_t>(status)];
}

/// A node that votes otherwise than its file says: this much, or this much of its curve.
struct NodeVote {
  NodeIndex node = kNone;
  float vote = 0;
};

/// Everything a node may look at during one tick. Nothing in it outlives the tick.
template <class State>
struct Tick {
  const State& state;                    ///< what the agent perceives
  double time = 0;                       ///< s, simulated
  double dt = 0;                         ///< s since this agent's previous tick
  std::uint64_t step = 0;                ///< of the world, for draws
  std::uint64_t seed = 0;                ///< of the run, for draws
  PlayerId player{};                     ///< whose tick this is, for draws
  std::byte* memory = nullptr;           ///< this agent's slab, laid out by the tree
  AnyTrace* trace = nullptr;             ///< null when nobody watches
  TransitionLog* log = nullptr;          ///< null when nobody listens
  Mistake* mistake = nullptr;            ///< takes the first of the tick; null when nobody listens
  std::span<const NodeVote> votes = {};  ///< which nodes vote otherwise than their file says

  /// The same tick of an agent that looks at another state.
  [[nodiscard]] Tick in(const State& other) const {
    return {other, time, dt, step, seed, player, memory, trace, log, mistake, votes};
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
class Appraiser;
template <class Action>
class Trace;

/// A node of a tree over one kind of state and action.
template <class State, class Action>
class Behavior : public AnyNode {
 public:
  using StateType = State;
  using ActionType = Action;

  /// No parameters, unless the type says otherwise (core/describe.hpp).
  [[nodiscard]] static constexpr auto params() { return Lines{}; }

  /// Recommends an action for this tick. `out` arrives empty; what is left in it when the answer
  /// is `failure` is ignored. Must not allocate, throw, lock or look at a clock.
  virtual Status tick(const Tick<State>& t, Proposal<Action>& out) const = 0;
  /// What it recommends, with the share of its vote that the state gives it. For parents.
  Status decide(const Tick<State>& t, Proposal<Action>& out) const {
    const Status status = tick(t, out);
    if (!t.votes.empty()) [[unlikely]]
      vote_anew(t, status, out);
    if (looked_at_) [[unlikely]]
      return look_at(t, status, out);
    return status;
  }
  /// This node as one that judges candidates, or null.
  [[nodiscard]] virtual const Appraiser<State, Action>* appraiser() const noexcept {
    return nullptr;
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

 private:
  [[gnu::noinline]] void vote_anew(const Tick<State>& t, Status status,
                                   Proposal<Action>& out) const {
    for (const NodeVote& change : t.votes)
      if (change.node == index_ && status != Status::failure && !out.is_empty())
        out.vote = change.vote;
  }
  [[gnu::noinline]] Status look_at(const Tick<State>& t, Status status,
                                   Proposal<Action>& out) const {
    const auto refuse = [&] {
      const bool goes_on = stands_ || status != Status::success;
      if (goes_on && memory_end_ != memory_begin_)
        std::memset(t.memory + memory_begin_, 0, memory_end_ - memory_begin_);
      if (goes_on && t.trace)
        Trace<Action>::of(*t.trace).halted(index_, end_index_);
      return Status::failure;
    };
    if (status > Status::success) {
      if (t.mistake && t.mistake->node == kNone)
        *t.mistake = {index_, fmt::format("answers what means nothing: status is {}",
                                          static_cast<unsigned>(status))};
      static_cast<void>(fails(t, "its status is none of failure, running and success"));
      return refuse();
    }
    // a stranger may change what a child proposed, which was looked at there
    if (status != Status::failure && !children_.empty()) {
      if (out.leader != kNone && implausible_field(out.action) != kFields<Action>) {
        detail::note_mistake(t, index_, out);
        return refuse();
      }
      if (t.trace)
        Trace<Action>::of(*t.trace).changed(index_, out.action, children_);
    }
    if (vote_curve_)
      weigh(t, out);
    return status;
  }
  void weigh(const Tick<State>& t, Proposal<Action>& out) const {
    VoteCurve::Scores scores{};
    const StateField<State>* fields = StateFields<State>::all().data();
    out.vote *= static_cast<float>(
        vote_curve_->share([&](std::uint32_t i) { return fields[i].read(t.state); }, scores));
    if (t.trace)
      t.trace->weighed(index_, scores);
  }
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

/// A behavior that says of every candidate what it is worth, for the arbiters vote_grid and
/// utility. Its tick answers the status and, as the vote, the weight of its opinion; the action may
/// hold orders and whatever else is not decided on the grid. Under any other arbiter it is a
/// behavior like another.
///
///   class Avoid : public Appraiser<State, Action> {
///     Status tick(const Tick<State>&, Proposal<Action>& out) const override {
///       out.vote = 10;                          // how much the opinion weighs
///       return Status::running;
///     }
///     double appraise(const Tick<State>& t, const Action& candidate) const override {
///       return free_ahead(t.state, *candidate.heading) ? 0 : -1;
///     }
///   };
template <class State, class Action>
class Appraiser : public Behavior<State, Action> {
 public:
  /// What a command is worth: a vote in [-1, 1] for vote_grid, the utility of the outcome, any
  /// finite number, for utility. The fields of the grid are set in `candidate`, no others. Must not
  /// allocate, throw, lock or look at a clock.
  [[nodiscard]] virtual double appraise(const Tick<State>& t, const Action& candidate) const = 0;

  [[nodiscard]] const Appraiser* appraiser() const noexcept final { return this; }
};

/// A node with memory: `class BreakTurn : public WithMemory<Behavior<State, Action>, Phase>`.
/// `Memory` is zero bytes when the agent starts and again whenever the node loses control. If it
/// has a `ChildSlot child`, that is the child in charge.
template <class Base, NodeMemory Memory>
class WithMemory : public Base {
  static_assert(
      !requires { Base::kRemembers; },
      "the base has a memory already; add to its struct what else is remembered");

 public:
  static constexpr bool kRemembers = true;
  using Base::Base;
  using TickType = Tick<typename Base::StateType>;

  [[nodiscard]] std::size_t memory_bytes() const noexcept override { return sizeof(Memory); }
  [[nodiscard]] NodeIndex active_child(const std::byte* slab) const noexcept override {
    if constexpr (requires(const Memory& m) { m.child.get(); })
      return memory(slab).child.get();
    else
      return Base::active_child(slab);
  }

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
  else if constexpr (requires { typename B::Child; })
    return Kind::arbiter;
  else if constexpr (std::derived_from<B, Condition<typename B::StateType, typename B::ActionType>>)
    return Kind::condition;
  else
    return Kind::behavior;
}

namespace detail {

template <class B>
[[nodiscard]] consteval NodeType node_type() {
  NodeType type;
  type.name = B::type_name;
  type.kind = kind_of<B>();
  if constexpr (requires { B::help; })
    type.help = B::help;
  if constexpr (requires { B::text_key; })
    type.text_key = B::text_key;
  if constexpr (requires { B::decided_by; })
    type.decided_by = B::decided_by;
  if constexpr (requires { B::child_keys; }) {
    type.grammar = Grammar::own;
    type.child_keys = B::child_keys;
  } else if constexpr (requires { B::slots; }) {
    type.grammar = Grammar::slots;
    type.child_keys = B::slots;
  } else if constexpr (requires { B::takes_one_child; }) {
    type.grammar = Grammar::list_or_one;
  } else if constexpr (requires { typename B::Child; }) {
    type.grammar = Grammar::list;
  }
  type.parameters = &description_of<B>();
  type.object = [](AnyNode& node) -> void* { return &static_cast<B&>(node); };
  if constexpr (std::default_initializable<B>)
    type.make = [](const NodeType&) -> std::unique_ptr<AnyNode> { return std::make_unique<B>(); };
  if constexpr (requires(B & node, const NodeSpec& spec, NodeReader& reader) {
                  node.read(spec, reader);
                })
    type.read = [](AnyNode& node, const NodeSpec& spec, NodeReader& reader) {
      static_cast<B&>(node).read(spec, reader);
    };
  return type;
}

}  // namespace detail

template <class B>
inline constexpr NodeType kNodeType = detail::node_type<B>();

/// Makes a node of a registered type in code; arguments are its children, or go to its constructor.
///   auto root = make<WinnerTakesAll<S, A>>(make<Pursue>(), make<Navigate>());
template <class Node, class... Arguments>
[[nodiscard]] std::unique_ptr<Node> make(Arguments&&... arguments) {
  std::unique_ptr<Node> node;
  if constexpr (std::constructible_from<Node, Arguments...>) {
    node = std::make_unique<Node>(std::forward<Arguments>(arguments)...);
  } else {
    node = std::make_unique<Node>();
    node->adopt(std::forward<Arguments>(arguments)...);
  }
  node->set_type(kNodeType<Node>);
  return node;
}

}  // namespace eyrie::ubf
