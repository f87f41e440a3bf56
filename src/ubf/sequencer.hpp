// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ubf/composite.hpp"
#include "ubf/sequencer_spec.hpp"

namespace eyrie::ubf {

struct SequencerMemory {
  std::uint16_t active = 0;  ///< 1 + the tree in charge, 0 before the first tick
};

/// A node over whole trees: the middle layer of a three-layer architecture (Gat, "On Three-Layer
/// Architectures", 1998). One tree is in charge; its proposal and status go up. In every tick,
/// before that tree is asked, the conditions of the transitions that leave it are asked in file
/// order, and the first that answers success hands control over: at most one transition per tick,
/// and the new tree decides in the same tick. The tree that is left forgets, once, and so do the
/// conditions that were asked while it was in charge. Entering (also the first tree) is logged.
template <class State, class Action>
class Sequencer final : public WithMemory<Voting<State, Action>, SequencerMemory> {
  using Base = WithMemory<Voting<State, Action>, SequencerMemory>;

 public:
  using Children = typename Base::Children;

  static constexpr std::string_view type_name = "sequencer";
  static constexpr std::string_view help =
      "one of several trees is in charge; conditions hand control from one to another";
  static constexpr Kind kind = Kind::control;
  static constexpr auto child_keys = kSequencerKeys;
  [[nodiscard]] static constexpr auto params() {
    return Voting<State, Action>::template vote_params<Sequencer>();
  }

  /// The tree `from` (kNone: any other tree) hands over to `to` when its condition succeeds.
  struct Rule {
    std::uint16_t from = kNone, to = kNone;
  };

  Sequencer() = default;
  /// In code: trees, labelled with their names; rules; one condition per rule; the first tree.
  Sequencer(Children trees, std::vector<Rule> rules, Children conditions, std::uint16_t start = 0) {
    set_up(std::move(trees), std::move(rules), std::move(conditions), start);
  }
  void set_up(Children trees, std::vector<Rule> rules, Children conditions, std::uint16_t start) {
    tree_count_ = trees.size();
    rules_ = std::move(rules);
    start_ = start;
    for (auto& condition : conditions)
      trees.push_back(std::move(condition));
    this->adopt(std::move(trees));
  }

  /// From a file: see ubf/sequencer_spec.hpp.
  template <class Reader>
  void read(const NodeSpec& spec, Reader& reader) {
    const SequencerSpec read = read_sequencer(spec, reader.diagnostics());
    Children trees, conditions;
    std::vector<Rule> rules;
    for (const auto& [name, value] : read.trees) {
      auto tree = reader.read(*value);
      if (tree)
        tree->set_label(name);
      trees.push_back(std::move(tree));
    }
    for (const SequencerSpec::Transition& transition : read.transitions) {
      conditions.push_back(reader.read(*transition.when));
      rules.push_back({transition.from, transition.to});
    }
    set_up(std::move(trees), std::move(rules), std::move(conditions), read.start);
  }

  [[nodiscard]] std::size_t tree_count() const { return tree_count_; }
  [[nodiscard]] std::span<const Rule> rules() const { return rules_; }
  [[nodiscard]] std::uint16_t start() const { return start_; }

  [[nodiscard]] bool stands() const noexcept override { return true; }
  [[nodiscard]] bool is_sequencer() const noexcept override { return true; }
  /// The tree in charge; kNone before the first tick.
  [[nodiscard]] NodeIndex active_child(const std::byte* slab) const noexcept override {
    const auto& m = this->memory(slab);
    return m.active ? static_cast<NodeIndex>(m.active - 1) : kNone;
  }
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
    if (const auto never = std::find(reached.begin(), reached.end(), false); never != reached.end())
      return fmt::format("no transition leads to tree {}, counted from 0", never - reached.begin());
    return Base::problem();
  }

  Status tick(const Tick<State>& t, Proposal<Action>& out) const override {
    auto& m = this->memory(t);
    const bool first = m.active == 0;
    if (first)
      enter(t, kNone, start_);
    const auto before = static_cast<std::uint16_t>(m.active - 1);
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      if (!applies(rules_[i], before) || this->ask(condition(i), t, out) != Status::success)
        continue;
      leave(t, before, !first);
      enter(t, before, rules_[i].to);
      break;
    }
    const auto& tree = *this->children_[m.active - 1u];
    const Status answer = this->ask(tree, t, out);
    this->took(t, tree);
    this->rescale(out);
    return answer;
  }

 private:
  [[nodiscard]] const typename Sequencer::Node& condition(std::size_t rule) const {
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
    this->memory(t).active = static_cast<std::uint16_t>(to + 1);
    if (t.log)
      t.log->add({this->index(), from, to});
  }

  std::size_t tree_count_ = 0;
  std::vector<Rule> rules_;
  std::uint16_t start_ = 0;
};

}  // namespace eyrie::ubf
