// SPDX-License-Identifier: MIT
#pragma once
/// \file  One of several children, as a condition or a field of the state says.
#include "ubf/composite.hpp"
#include "ubf/registry.hpp"

namespace eyrie::ubf {

struct BranchMemory {
  std::uint16_t open = 0;  ///< the branch that goes on since the last tick, from 1; 0 for none
};

/// The base of nodes that ask one of their children, all but the first `conditions` of them.
template <class State, class Action, std::size_t conditions>
class Branching : public WithMemory<Control<State, Action>, BranchMemory> {
 public:
  [[nodiscard]] NodeIndex active_child(const std::byte* slab) const noexcept final {
    const auto& m = this->memory(slab);
    return m.open ? static_cast<NodeIndex>(m.open - 1 + conditions) : kNone;
  }

 protected:
  [[nodiscard]] const AnyNode& branch(std::size_t number) const {
    return *this->children_[number - 1 + conditions];
  }
  /// Asks a branch, from 1; the one before forgets if it was going on. Fails if there is none.
  Status turn_to(std::size_t number, const Tick<State>& t, Proposal<Action>& out) const {
    auto& m = this->memory(t);
    if (m.open && m.open != number)
      this->halt(branch(m.open), t);
    m.open = 0;
    if (number + conditions > this->children_.size())
      return Status::failure;
    const auto& child = branch(number);
    const Status answer = this->hand_on(t, child, out, this->ask(child, t, out));
    if (this->left_open(child, answer))
      m.open = static_cast<std::uint16_t>(number);
    return answer;
  }
};

/// Asks the condition `if` until it has ended, then `then` after a success or `else` after a
/// failure until that has ended: the condition is not asked again meanwhile. The branch's proposal
/// and status go up; a running condition is running and proposes nothing. When
/// it has ended, nothing in it goes on. Without an `else` it would be a sequence with memory.
///   if_then_else: {if: has_target, then: pursue, else: navigate}
template <class State, class Action>
class IfThenElse final : public Branching<State, Action, 1> {
 public:
  static constexpr std::string_view type_name = "if_then_else";
  static constexpr std::string_view help =
      "one of two children, as a condition says when it begins";
  static constexpr std::array<std::string_view, 3> slots{"if", "then", "else"};

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    if (m.open == 0) {
      const auto& condition = *this->children_[0];
      const Status holds = this->ask(condition, t, out);
      out.clear();
      if (holds == Status::running)
        return holds;
      this->close(condition, t);
      m.open = holds == Status::success ? 1 : 2;
    }
    const auto& child = this->branch(m.open);
    const Status answer = this->hand_on(t, child, out, this->ask(child, t, out));
    if (answer == Status::running)
      return answer;
    this->close(child, t);
    m = {};
    return answer;
  }
};

/// Asks `do` while the condition `when` succeeds and `else` otherwise. The condition is checked in
/// every tick; the branch that it turns away from forgets if it was going on. The branch's proposal
/// and status go up; what `when` proposes is ignored. A `when` that answers running does not hold,
/// and forgets. Without an `else` it would be a guard.
///   while: {when: range < 10 nmi, do: pursue, else: navigate}
template <class State, class Action>
class While final : public Branching<State, Action, 1> {
 public:
  static constexpr std::string_view type_name = "while";
  static constexpr std::string_view help = "one of two children, as a condition says in every tick";
  static constexpr std::array<std::string_view, 3> slots{"when", "do", "else"};

  [[nodiscard]] bool remembers() const noexcept override { return false; }
  [[nodiscard]] bool stands() const noexcept override { return this->any_child_stands(); }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const auto& when = *this->children_[0];
    const Status holds = this->ask(when, t, out);
    if (holds == Status::running)
      this->halt(when, t);
    return this->turn_to(holds == Status::success ? 1 : 2, t, out);
  }
};

/// The cases of a switch as a file writes them.
struct SwitchSpec {
  std::optional<std::size_t> field;  ///< of the state; none after reporting
  std::vector<double> values;
  AnyNode::Children children;
};
[[nodiscard]] SwitchSpec read_switch(const NodeSpec& spec, NodeReader& reader);

/// Asks the child whose case is what a field of the state says, in every tick anew; `default` for
/// every other value and for none. When another child's turn comes, the one before forgets. Vote
/// and status are the child's; without a child for the value it fails.
///   switch: {on: phase, cases: {ingress: navigate, egress: {tree: home}}, default: pursue}
template <class State, class Action>
class Switch final : public Branching<State, Action, 0> {
 public:
  static constexpr std::string_view type_name = "switch";
  static constexpr std::string_view help = "the child whose case a state field names";
  static constexpr std::array<std::string_view, 2> child_keys{"cases", "default"};
  [[nodiscard]] static constexpr auto params() {
    return Switch::with_vote(
        param("on", &Switch::on, "the state field that is looked at").required());
  }

  std::string on;

  [[nodiscard]] bool remembers() const noexcept override { return false; }
  [[nodiscard]] bool stands() const noexcept override { return this->any_child_stands(); }
  [[nodiscard]] std::string problem() const override {
    if (!read_)
      return "a switch needs a field to look at";
    const std::size_t count = this->children_.size();
    if (count != values_.size() && count != values_.size() + 1)
      return fmt::format(
          "a switch has a child per value, and perhaps one more, but here are {} for {} values",
          count, values_.size());
    return Control<State, Action>::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const auto value = std::ranges::find(values_, read_(t.state));
    return this->turn_to(static_cast<std::size_t>(value - values_.begin()) + 1, t, out);
  }

  /// For code that builds a tree without a file: what is looked at, and the value of each child;
  /// one child more than values is the default.
  void look_at(double (*field)(const State&), std::vector<double> values) {
    read_ = field;
    values_ = std::move(values);
  }
  /// From a file.
  void read(const NodeSpec& spec, NodeReader& reader) {
    SwitchSpec read = read_switch(spec, reader);
    this->children_ = std::move(read.children);
    if (read.field)
      look_at(StateFields<State>::all()[*read.field].read, std::move(read.values));
  }

 private:
  double (*read_)(const State&) = nullptr;
  std::vector<double> values_;
};

}  // namespace eyrie::ubf
