// SPDX-License-Identifier: MIT
#pragma once
/// \file  One of several trees in charge, and how a file writes that.
///
///   sequencer:
///     start: ingress
///     trees:
///       ingress: {winner_takes_all: [navigate, follow_lead]}
///       bvr: {tree: bvr}
///     transitions:                           # asked in this order, at most one per tick
///       - {from: ingress, to: bvr, when: has_target}
///       - {from: any, to: egress, when: {bingo: {fuel: 900 kg}}}
#include "ubf/composite.hpp"
#include "ubf/registry.hpp"

namespace eyrie::ubf {

/// Trees and transitions with their names resolved to positions.
struct SequencerSpec {
  struct Transition {
    std::uint16_t from, to;  ///< positions in `trees`; `from` is kNone for any
    const Value* when;
  };
  std::vector<std::pair<std::string, const Value*>> trees;
  std::vector<Transition> transitions;
  std::uint16_t start = 0;
};

/// Which trees the transitions can enter, that have `from` and `to`.
template <class Transitions>
[[nodiscard]] std::vector<bool> entered(std::size_t trees, const Transitions& transitions,
                                        std::uint16_t start) {
  std::vector<bool> reached(trees);
  std::vector<std::uint16_t> open{start};
  while (!open.empty()) {
    const std::uint16_t tree = open.back();
    open.pop_back();
    if (reached[tree])
      continue;
    reached[tree] = true;
    for (const auto& transition : transitions)
      if (transition.from == tree || transition.from == kNone)
        open.push_back(transition.to);
  }
  return reached;
}

/// Reads everything but the nodes. Reports unknown, duplicate and missing names, a transition from
/// a tree to itself, and a tree that can never be entered.
[[nodiscard]] SequencerSpec read_sequencer(const NodeSpec& spec, Diagnostics& diagnostics);

struct SequencerMemory {
  ChildSlot child;  ///< the tree in charge, none before the first tick
};

/// A node over whole trees: the middle layer of a three-layer architecture (Gat, "On Three-Layer
/// Architectures", 1998). One tree is in charge; its proposal and status go up. In every tick,
/// before that tree is asked, the conditions of the transitions that leave it are asked in file
/// order, and the first that answers success hands control over: at most one transition per tick,
/// and the new tree decides in the same tick. The tree that is left forgets, once, and so do the
/// conditions that were asked while it was in charge. Entering (also the first tree) is logged.
template <class State, class Action>
class Sequencer final : public WithMemory<Control<State, Action>, SequencerMemory> {
  using Base = WithMemory<Control<State, Action>, SequencerMemory>;

 public:
  using Children = typename Base::Children;

  static constexpr std::string_view type_name = "sequencer";
  static constexpr std::string_view help =
      "one of several trees is in charge; conditions hand control from one to another";
  static constexpr auto child_keys = kSequencerKeys;

  /// The tree `from` (kNone: any other tree) hands over to `to` when its condition succeeds.
  struct Rule {
    std::uint16_t from = kNone, to = kNone;
  };

  Sequencer() = default;
  /// In code: trees, labelled with their names; rules; one condition per rule; the first tree.
  Sequencer(Children trees, std::vector<Rule> rules, Children conditions, std::uint16_t start = 0)
      : tree_count_(trees.size()), rules_(std::move(rules)), start_(start) {
    for (auto& condition : conditions)
      trees.push_back(std::move(condition));
    this->adopt(std::move(trees));
  }

  /// From a file.
  void read(const NodeSpec& spec, NodeReader& reader) {
    SequencerSpec read = read_sequencer(spec, reader.diagnostics());
    tree_count_ = read.trees.size();
    start_ = read.start;
    for (const auto& [name, value] : read.trees) {
      auto tree = reader.read(*value);
      if (tree)
        tree->set_label(name);
      this->children_.push_back(std::move(tree));
    }
    for (const SequencerSpec::Transition& transition : read.transitions) {
      this->children_.push_back(reader.read(*transition.when));
      rules_.push_back({transition.from, transition.to});
    }
  }

  [[nodiscard]] std::size_t tree_count() const { return tree_count_; }
  [[nodiscard]] std::span<const Rule> rules() const { return rules_; }
  [[nodiscard]] std::uint16_t start() const { return start_; }

  [[nodiscard]] bool stands() const noexcept override { return true; }
  [[nodiscard]] bool is_sequencer() const noexcept override { return true; }
  [[nodiscard]] std::string problem() const override {
    const auto is_tree = [&](std::uint16_t tree) { return tree < tree_count_; };
    if (tree_count_ == 0 || !is_tree(start_))
      return "a sequencer needs a tree to start with";
    if (this->children_.size() != tree_count_ + rules_.size())
      return "a sequencer needs one condition per transition";
    for (const Rule& rule : rules_)
      if (!is_tree(rule.to) || rule.from == rule.to || (rule.from != kNone && !is_tree(rule.from)))
        return "a transition leads from one tree of the sequencer to another";
    const std::vector<bool> reached = entered(tree_count_, rules_, start_);
    if (const auto never = std::ranges::find(reached, false); never != reached.end())
      return fmt::format("no transition leads to tree {}, counted from 0", never - reached.begin());
    return Base::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    const bool first = !m.child;
    if (first)
      enter(t, kNone, start_);
    const NodeIndex before = m.child.get();
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      if (!applies(rules_[i], before) || this->ask(condition(i), t, out) != Status::success)
        continue;
      leave(t, before, !first);
      enter(t, before, rules_[i].to);
      break;
    }
    const auto& tree = *this->children_[m.child.get()];
    return this->hand_on(t, tree, out, this->ask(tree, t, out));
  }

 private:
  [[nodiscard]] const AnyNode& condition(std::size_t rule) const {
    return *this->children_[tree_count_ + rule];
  }
  [[nodiscard]] static bool applies(const Rule& rule, std::uint16_t tree) {
    return rule.from == tree || (rule.from == kNone && rule.to != tree);
  }
  void leave(const Tick<State>& t, std::uint16_t tree, bool was_asked) const {
    if (was_asked)
      this->halt(*this->children_[tree], t);
    for (std::size_t i = 0; i < rules_.size(); ++i)
      if (applies(rules_[i], tree))
        this->halt(condition(i), t);
  }
  void enter(const Tick<State>& t, std::uint16_t from, std::uint16_t to) const {
    this->memory(t).child.set(to);
    if (t.log)
      t.log->add({this->index(), from, to});
  }

  std::size_t tree_count_ = 0;
  std::vector<Rule> rules_;
  std::uint16_t start_ = 0;
};

}  // namespace eyrie::ubf
