// SPDX-License-Identifier: MIT
#pragma once
/// \file  From a traced tick to a Decision.
#include "team/decision.hpp"
#include "team/moment.hpp"
#include "ubf/tree.hpp"

namespace eyrie::team {

/// Every node of a tree as one that was not asked.
[[nodiscard]] std::vector<Answer> unanswered(const ubf::AnyTree& tree);
/// The branches in which two nodes are where their ways from the root part: children of the lowest
/// node that has both below it. Of two of which one is above the other, the upper one is itself.
[[nodiscard]] std::pair<ubf::NodeIndex, ubf::NodeIndex> parting(const std::vector<Answer>& nodes,
                                                                ubf::NodeIndex a, ubf::NodeIndex b);
/// What decided between the branches in which two nodes part; empty: their votes.
[[nodiscard]] const std::string& decided_by(const std::vector<Answer>& nodes,
                                            std::pair<ubf::NodeIndex, ubf::NodeIndex> parted);
/// The first node above `node`, up to `top`, that handed on what another leaf proposed; kNone: none
/// did, or it proposed nothing.
[[nodiscard]] ubf::NodeIndex lost_in(const std::vector<Answer>& nodes, ubf::NodeIndex node,
                                     ubf::NodeIndex top);
/// Who won each field of the root's action, and against whom.
[[nodiscard]] std::vector<Won> contest(const std::vector<Answer>& nodes);

template <class Action>
std::vector<Value> values_of(const Action& action) {
  std::vector<Value> values;
  ubf::for_each_field<Action>([&](const auto& f, auto) {
    if (action.*f.member)
      values.push_back(action_value(f.name, f.unit, *(action.*f.member)));
  });
  return values;
}

/// What is to be said of a node's answer: what its vote was made of, which one a network gave it,
/// why it failed or was refused.
template <class State, class Action>
std::string why(const ubf::Tree<State, Action>& tree, const ubf::Trace<Action>& trace,
                ubf::NodeIndex node) {
  std::vector<std::string> said;
  const ubf::VoteCurve* curve = tree.node(node).vote_curve();
  if (curve && trace.row(node).status != ubf::Status::failure)
    said.push_back(curve->text(trace.scores(node), ubf::state_field_infos<State>()));
  if (const float vote = trace.given_vote(node); !std::isnan(vote))
    said.push_back(fmt::format("learned vote {:.3g}", vote));
  if (const char* reason = trace.why(node))
    said.emplace_back(reason);
  return fmt::format("{}", fmt::join(said, "; "));
}

/// The vote that an arbiter put in the place of a node's own, if it did. Who abstains stays out.
template <class Action>
std::optional<float> given_vote(const ubf::Trace<Action>& trace, ubf::NodeIndex node) {
  const float vote = trace.given_vote(node);
  return std::isnan(vote) || trace.row(node).proposal.vote == 0 ? std::nullopt
                                                                : std::optional(vote);
}

/// Whether and what a node answered, and its votes.
template <class Action>
void take_votes(Answer& answer, const ubf::Trace<Action>& trace, ubf::NodeIndex node) {
  const auto& row = trace.row(node);
  answer.asked = row.ticked;
  answer.status = row.status;
  answer.vote = row.proposal.vote;
  answer.given = given_vote(trace, node);
  if (const char* why = trace.why(node); why && row.status != ubf::Status::failure)
    answer.set_aside = why;
}

template <class State, class Action>
std::vector<Answer> answers(std::vector<Answer> all, const ubf::Tree<State, Action>& tree,
                            const ubf::Trace<Action>& trace) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto index = static_cast<ubf::NodeIndex>(i);
    const auto& row = trace.row(index);
    Answer& answer = all[i];
    take_votes(answer, trace, index);
    answer.halts = row.halts;
    answer.action = values_of(row.proposal.action);
    auto value = answer.action.begin();
    ubf::for_each_field<Action>([&](const auto& f, auto field) {
      if (!(row.proposal.action.*f.member))
        return;
      value->held = row.held[field];
      (value++)->supplier = row.supplier[field];
    });
    std::string said = row.ticked ? why(tree, trace, index) : "";
    // who fails without a word has failed for what its kind says of all
    if (!said.empty() || !row.ticked || row.status != ubf::Status::failure)
      answer.why = std::move(said);
  }
  return all;
}

template <class Field, class T>
Changed changed(const Field& field, const std::optional<T>& flown, const std::optional<T>& other) {
  const auto value = [&](const std::optional<T>& v) {
    return v ? action_value(field.name, field.unit, *v) : Value{.text = "-"};
  };
  const Value a = value(flown), b = value(other);
  Changed change{std::string(field.name), std::string(field.unit.si_symbol), a.text, b.text, {}};
  if (a.number && b.number && Field::is_number)
    change.difference =
        Field::is_direction ? angle_between(*a.number, *b.number) : *b.number - *a.number;
  return change;
}

/// Whether two arbiters mean the same: the last bits of a sum are not another decision.
template <class Field, class T>
bool same(const Field&, const std::optional<T>& a, const std::optional<T>& b) {
  if constexpr (Field::is_real) {
    constexpr double kRounding = 1e-11;
    if (a && b) {
      const double x = static_cast<double>(*a), y = static_cast<double>(*b);
      return std::fabs(x - y) <= kRounding * std::max({1.0, std::fabs(x), std::fabs(y)});
    }
  }
  return a == b;
}

template <class Action>
std::vector<Changed> changes(const Action& flown, const Action& other) {
  std::vector<Changed> all;
  ubf::for_each_field<Action>([&](const auto& f, auto) {
    if (!same(f, flown.*f.member, other.*f.member))
      all.push_back(changed(f, flown.*f.member, other.*f.member));
  });
  return all;
}

/// Asks the tree of an agent again, with a trace. What it perceived comes from perceived(state),
/// found next to the state.
/// `overrule` puts into an action what somebody outside asked for instead.
template <class State, class Action, class Overrule>
Decision decision_of(const Moment<State>& m, const ubf::Tree<State, Action>& tree,
                     Overrule overrule) {
  ubf::Trace<Action> trace(tree.size());
  const auto out = ask_again(tree, m, &trace);
  Decision d;
  d.status = trace.row(0).status;
  d.step = m.info.step;
  d.time = m.info.time();
  d.player = m.who;
  d.tree = tree.name();
  d.vote = out.vote;
  d.leader = out.leader;
  d.nodes = answers(unanswered(tree), tree, trace);
  d.action = contest(d.nodes);
  Action carried_out = out.action;
  overrule(carried_out);
  d.overruled = changes(out.action, carried_out);
  d.state = state_values(m.state);
  d.perceived = perceived(m.state);
  return d;
}

}  // namespace eyrie::team
