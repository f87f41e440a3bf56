// SPDX-License-Identifier: MIT
#pragma once
/// \file  What every node of one tick answered, and who supplied each field of each action; for
/// people one line per node.
#include "ubf/behavior.hpp"

namespace eyrie::ubf {

/// The decisions of one tick, node by node. Made once for the largest tree and reused: recording
/// allocates nothing. A tree decides the same with and without one, but that answers which mean
/// nothing are also found of who is outvoted.
template <class Action>
class Trace final : public AnyTrace {
 public:
  /// One node's answer.
  struct Row {
    bool ticked = false;
    Status status = Status::failure;
    std::uint16_t halts = 0;    ///< how often it, or a subtree with it, was made to forget
    Proposal<Action> proposal;  ///< as it went up; empty after a failure
    /// Per field the node that supplied it: a leaf, or the arbiter that blended it; kNone if the
    /// field is empty.
    std::array<NodeIndex, kFields<Action>> supplier = none();
    /// Per field whether the supplier proposed it in an earlier tick, whatever it answered in this.
    std::array<bool, kFields<Action>> held{};
  };

  explicit Trace(std::size_t nodes) : AnyTrace(typeid(Action), nodes), rows_(nodes) {}

  [[nodiscard]] static Trace& of(AnyTrace& trace) {
    auto& mine = static_cast<Trace&>(trace);
    EYRIE_DEMAND(*mine.action_ == typeid(Action), "a trace of another action type");
    return mine;
  }

  /// The rows in pre-order, those of the tree that was ticked last.
  [[nodiscard]] std::span<const Row> rows() const { return {rows_.data(), used_}; }
  [[nodiscard]] const Row& row(NodeIndex node) const { return rows_[node]; }

  // Below: called by trees and composites while they tick.

  void begin(std::size_t nodes) {
    EYRIE_DEMAND(nodes <= rows_.size(), "a trace smaller than the tree");
    used_ = nodes;
    const bool was_left = !asked_.empty();  // by an exception: rows are half written
    asked_.clear();
    begin_rows(0, used_, was_left);
    for (Row& row : std::span(rows_.data(), used_))
      if (row.halts)
        row.halts = 0;
  }
  /// Forgets what the nodes [begin, end) answered, for they are asked anew in this tick.
  void begin_again(NodeIndex begin, NodeIndex end) { begin_rows(begin, end, false); }
  void record(NodeIndex node, Status status, const Proposal<Action>& proposal) {
    Row& row = rows_[node];
    row.ticked = true;
    row.status = status;
    if (status == Status::failure)
      row.proposal.clear();
    else
      row.proposal.copy(proposal);
    if (row.proposal.is_empty())
      row.proposal.leader = kNone;
    for_each_field<Action>([&](const auto& f, auto i) {
      const bool set = bool(row.proposal.action.*f.member);
      row.held[i] &= set;
      if (!set)
        row.supplier[i] = kNone;
      else if (row.supplier[i] == kNone)
        row.supplier[i] = node;
    });
  }
  void halted(NodeIndex begin, NodeIndex end) {
    for (Row& row : std::span(rows_.data() + begin, rows_.data() + end))
      ++row.halts;
  }
  /// `node` hands on what `child` proposed in an earlier tick.
  void supplied(NodeIndex node, NodeIndex child, const Action& action) {
    for_each_field<Action>([&](const auto& f, auto i) {
      rows_[node].held[i] = bool(action.*f.member);
      rows_[node].supplier[i] = action.*f.member ? child : kNone;
    });
  }
  /// Of what `node` sends up that which none of its children proposed is its own.
  void changed(NodeIndex node, const Action& action,
               std::span<const std::unique_ptr<AnyNode>> children) {
    Row& row = rows_[node];
    for_each_field<Action>([&](const auto& f, auto i) {
      const auto& value = action.*f.member;
      const auto is_same = [&](const auto& child) {
        const auto& its = rows_[child->index()].proposal.action.*f.member;
        if constexpr (requires { *its == *value; })
          return its == value;
        else
          return bool(its);
      };
      if (value && !row.held[i] && std::ranges::none_of(children, is_same))
        row.supplier[i] = node;
    });
  }
  /// `node` hands on what `child` proposed.
  void took(NodeIndex node, NodeIndex child) {
    rows_[node].supplier = rows_[child].supplier;
    rows_[node].held = rows_[child].held;
  }
  /// `node` hands on one field from `child`.
  void took(NodeIndex node, NodeIndex child, std::size_t field) {
    rows_[node].supplier[field] = rows_[child].supplier[field];
    rows_[node].held[field] = rows_[child].held[field];
  }

 private:
  [[nodiscard]] static constexpr std::array<NodeIndex, kFields<Action>> none() {
    std::array<NodeIndex, kFields<Action>> nodes{};
    nodes.fill(kNone);
    return nodes;
  }

  void begin_rows(std::size_t begin, std::size_t end, bool all) {
    const auto part = [&](auto& of) { return std::span(of).subspan(begin, end - begin); };
    std::ranges::fill(part(reasons_), nullptr);
    std::ranges::fill(part(given_votes_), std::numeric_limits<float>::quiet_NaN());
    for (Row& row : part(rows_)) {
      if (!row.ticked && row.halts == 0 && !all)
        continue;  // as it began: most nodes are not asked
      row.ticked = false;
      row.status = Status::failure;
      row.proposal.clear();
      row.supplier = none();
      row.held = {};
    }
  }

  std::vector<Row> rows_;
  std::size_t used_ = 0;
};

template <class State, class Action>
class Tree;

namespace detail {

/// A value of an action's field. A type of one's own brings a `to_text` found next to it.
template <class T>
[[nodiscard]] std::string field_text(const T& value, const Unit& unit, bool direction = false) {
  if constexpr (std::same_as<T, bool>)
    return value ? "yes" : "no";
  else if constexpr (std::floating_point<T>)
    return unit.dimension == Dimension::none ? fmt::format("{:g}", value)
           : direction                       ? format_direction(static_cast<double>(value))
                       : format_quantity(static_cast<double>(value), unit.dimension);
  else if constexpr (std::integral<T>)
    return fmt::format("{}", +value);
  else if constexpr (NamedEnum<T>)
    return std::string(enum_name(value));
  else if constexpr (requires { value.value + 0; })
    return fmt::format("#{}", value.value);
  else
    return std::string(to_text(value));
}

}  // namespace detail

/// "heading 090°, speed 480 kt": the fields that are set.
template <class Action>
[[nodiscard]] std::string to_text(const Action& action) requires requires {
  ActionTraits<Action>::fields;
}
{
  std::string text;
  for_each_field<Action>([&](const auto& f, auto) {
    if (const auto& value = action.*f.member)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", f.name,
                          detail::field_text(*value, f.unit, f.is_direction));
  });
  return text;
}

/// One line per node, children indented: label, answer ("-" if it was not asked), vote, what it
/// proposed and which nodes that came from.
template <class State, class Action>
[[nodiscard]] std::string to_text(const Tree<State, Action>& tree, const Trace<Action>& trace) {
  std::string text;
  for (std::size_t i = 0; i < trace.rows().size(); ++i) {
    const auto index = static_cast<NodeIndex>(i);
    const auto& row = trace.row(index);
    std::string line = fmt::format("{:{}}{}", "", 2 * tree.depth(index), tree.node(index).label());
    line = fmt::format("{:<32} {}", line, row.ticked ? to_text(row.status) : "-");
    if (row.proposal.vote > 0)
      line += fmt::format(" {:g}", row.proposal.vote);
    if (const VoteCurve* curve = tree.node(index).vote_curve(); curve && row.ticked)
      line += fmt::format(" ({})", curve->text(trace.scores(index), state_field_infos<State>()));
    if (row.halts)
      line += " halted";
    const char* separator = ": ";
    for_each_field<Action>([&](const auto& f, auto field) {
      const auto& value = row.proposal.action.*f.member;
      if (!value)
        return;
      line += fmt::format("{}{} {}", separator, f.name,
                          detail::field_text(*value, f.unit, f.is_direction));
      if (row.supplier[field] != index)
        line += fmt::format(" ({})", tree.path(row.supplier[field]));
      separator = ", ";
    });
    text += line + "\n";
  }
  return text;
}

}  // namespace eyrie::ubf
