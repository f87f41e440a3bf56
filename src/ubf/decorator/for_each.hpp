// SPDX-License-Identifier: MIT
#pragma once
#include "ubf/composite.hpp"
#include "ubf/registry.hpp"

namespace eyrie::ubf {

/// Which of the things a loop goes over decides.
enum class Choose : std::uint8_t { strongest, first };
constexpr auto names_of(Choose) {
  return names_from_zero<Choose>("strongest", "first");
}

/// Asks its child once for each of the things in a list of the state, each time in a state that
/// looks at that one; the highest vote goes up, the earlier of equals, or with `choose: first` the
/// first that does not fail. Fails if every one does, or there is none. No behavior below it may
/// remember anything, for which thing is the third may change from tick to tick: the child starts
/// anew each time. What is drawn for one thing is drawn anew for the next. In a trace the child
/// shows what it answered for the thing that was chosen, or else for the last one.
///   for_each: {over: hostiles, child: {guard: {when: range < 10 nmi, child: pursue}}}
template <class State, class Action>
class ForEach final : public Decorator<State, Action> {
 public:
  static constexpr std::string_view type_name = "for_each";
  static constexpr std::string_view help = "asks its child once for each of several things";
  [[nodiscard]] static constexpr auto params() {
    return Lines{
        param("over", &ForEach::over, "the list of the state, such as tracks").required(),
        param("choose", &ForEach::choose, "the highest vote, or the first that does not fail")};
  }

  std::string over;
  Choose choose = Choose::strongest;

  [[nodiscard]] std::string problem() const override {
    for (const auto& child : this->children_)
      if (const std::string_view name = remembering(*child); !name.empty())
        return fmt::format("for_each asks for one thing after the other, but {} remembers", name);
    return list_ ? "" : "for_each needs a list to go over";
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    const std::size_t count = list_->count(t.state);
    if (count == 0)
      return this->fails(t, "there is nothing to look at");
    State state = t.state;
    Tick<State> inner = t.in(state);
    Status status = Status::failure;
    std::size_t chosen = count;
    Scratch<Action> other;
    BestSoFar<Action> best(out, other);
    float highest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      list_->look_at(state, i);
      inner.seed = seed_of(t.seed, i);
      const Status answer = ask_anew(inner, best.next());
      if (answer == Status::failure)
        continue;
      if (chosen != count && !(best.next().vote > highest))
        continue;
      highest = best.next().vote;
      status = answer;
      chosen = i;
      best.keep();
      if (choose == Choose::first)
        break;
    }
    if (chosen == count)
      return Status::failure;
    if (t.trace) [[unlikely]] {
      list_->look_at(state, chosen);
      inner.seed = seed_of(t.seed, chosen);
      ask_anew(inner, best.next());
    }
    best.hand_on();
    this->took(t, this->child());
    return status;
  }

  /// For code that builds a tree without a file.
  void go_over(const StateList<State>& list) { list_ = &list; }
  /// From a file.
  void read(const NodeSpec& spec, NodeReader& reader) {
    const Value* name = spec.body->find("over");
    const auto& lists = StateLists<State>::all();
    for (const StateList<State>& list : lists)
      if (list.name == over)
        go_over(list);
    if (!list_ && name && name->is_scalar())
      reader.diagnostics().error(name->where, "the state has no list {}{}", quote(over),
                                 did_you_mean(over, listed(lists, &StateList<State>::name)));
  }

 private:
  /// Asks the child as one that was not asked before in this tick.
  Status ask_anew(const Tick<State>& t, Proposal<Action>& out) const {
    if (t.trace) [[unlikely]]
      Trace<Action>::of(*t.trace).begin_again(this->child().index(), this->child().end_index());
    const Status answer = this->ask(this->child(), t, out);
    this->forget(this->child(), t);
    return answer;
  }
  /// For what is drawn at one of the things: another number than at the others, also in a loop
  /// within a loop (the finalizer of SplitMix64: Steele et al., OOPSLA 2014).
  [[nodiscard]] static constexpr std::uint64_t seed_of(std::uint64_t seed, std::size_t thing) {
    std::uint64_t z = seed + (thing + 1) * 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  /// The name of a node below that remembers, or "".
  static std::string_view remembering(const AnyNode& node) {
    if (node.remembers())
      return node.label();
    for (const auto& child : node.children())
      if (child)
        if (const std::string_view name = remembering(*child); !name.empty())
          return name;
    return {};
  }

  const StateList<State>* list_ = nullptr;
};

}  // namespace eyrie::ubf
