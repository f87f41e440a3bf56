// SPDX-License-Identifier: MIT
#pragma once
/// \file  The parameters of nodes that the page arbitrates by (viewer/src/decide).
#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "core/enum_names.hpp"
#include "page/json.hpp"
#include "page/quantum.hpp"
#include "ubf/arbiter/commitment.hpp"
#include "ubf/arbiter/fusion.hpp"
#include "ubf/arbiter/inhibit.hpp"
#include "ubf/arbiter/motor_schema.hpp"
#include "ubf/arbiter/paper_fusion.hpp"
#include "ubf/arbiter/priority.hpp"
#include "ubf/arbiter/suppress.hpp"
#include "ubf/arbiter/verify.hpp"
#include "ubf/arbiter/vote_grid.hpp"
#include "ubf/composite.hpp"
#include "ubf/control/parallel.hpp"

/// As the page calls them.
template <>
struct eyrie::EnumNames<eyrie::ubf::detail::Op> {
  using Op = ubf::detail::Op;
  static constexpr auto names = std::to_array<std::pair<std::string_view, Op>>({
      {"<", Op::less},
      {"<=", Op::less_equal},
      {">", Op::greater},
      {">=", Op::greater_equal},
      {"==", Op::equal},
      {"!=", Op::not_equal},
      {"flag", Op::flag},
      {"not", Op::negate},
      {"and", Op::skip_if_false},
      {"or", Op::skip_if_true},
  });
};

namespace eyrie::page {

/// The limits of fields, flat: "bounds.altitude.min".
template <class Action>
void put_bounds(Json& params, const ubf::Bounds<Action>& bounds) {
  ubf::for_each_field<Action>([&](const auto& f, auto i) {
    const auto& limits = bounds.limits(i);
    const std::string name = "bounds." + std::string(f.name);
    if (limits.min)
      params[name + ".min"] = *limits.min;
    if (limits.max)
      params[name + ".max"] = *limits.max;
  });
}

/// The axes in their order, flat: "grid.heading.from".
template <class Action>
void put_grid(Json& params, const ubf::Grid<Action>& grid) {
  for (const auto& axis : grid.axes()) {
    const std::string name = "grid." + std::string(ubf::field_names<Action>()[axis.field]);
    params[name + ".from"] = axis.from;
    params[name + ".to"] = axis.to;
    params[name + ".steps"] = axis.steps;
    params[name + ".reach"] = axis.reach;
    if (axis.deviation > 0)
      params[name + ".spread"] = axis.deviation;
  }
}

/// The steps of a condition on the state and the proposal; `within` is how far rounding can take
/// apart in the page what is equal.
template <class State, class Action>
class RefusalJson {
 public:
  [[nodiscard]] static Json of(const std::string& words,
                               const ubf::ActionExpression<State, Action>& refusal) {
    Json steps = Json::array();
    for (const ubf::detail::Instruction& i : refusal.program())
      steps.push_back({{"op", enum_name(i.op)},
                       {"left", operand(i.left)},
                       {"right", operand(i.right)},
                       {"target", i.target},
                       {"within", std::max(rounding(i.left), rounding(i.right))}});
    return {{"that", words}, {"steps", std::move(steps)}};
  }

 private:
  using Expression = ubf::ActionExpression<State, Action>;
  using Operand = ubf::detail::Operand;

  [[nodiscard]] static Json operand(const Operand& o) {
    const std::size_t of_state = ubf::StateFields<State>::all().size();
    if (o.field == Operand::kNumber)
      return o.number;
    return o.field < of_state ? Json{{"state", o.field}} : Json{{"action", o.field - of_state}};
  }
  [[nodiscard]] static double rounding(const Operand& o) {
    return o.field == Operand::kNumber ? 0 : quantum_of(Expression::fields()[o.field]) / 2;
  }
};

/// Adds the state fields that the conditions of a tree's nodes read.
template <class State, class Action>
void add_fields_read(const ubf::Tree<State, Action>& tree, std::set<std::uint32_t>& fields) {
  const auto add = [&](const ubf::detail::Operand& o) {
    if (o.field < ubf::StateFields<State>::all().size())
      fields.insert(o.field);
  };
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const auto& node = tree.node(static_cast<ubf::NodeIndex>(i));
    if (const auto* verify = dynamic_cast<const ubf::Verify<State, Action>*>(&node))
      for (const auto& refusal : verify->refusals())
        for (const ubf::detail::Instruction& step : refusal.program()) {
          add(step.left);
          add(step.right);
        }
  }
}

template <class State, class Action>
[[nodiscard]] Json arbiter_params(const ubf::Behavior<State, Action>& node) {
  Json params = Json::object();
  if (node.vote_given())
    params["vote"] = *node.vote_given();
  if (const auto* voting = dynamic_cast<const ubf::Voting<State, Action>*>(&node)) {
    if (voting->vote)
      params["vote"] = *voting->vote;
    if (voting->vote_scale != 1)
      params["vote_scale"] = voting->vote_scale;
  }
  if (const auto* fusion = dynamic_cast<const ubf::Fusion<State, Action>*>(&node)) {
    if (fusion->top)
      params["top"] = *fusion->top;
    params["conflicts"] = enum_name(fusion->conflicts);
  }
  if (const auto* paper = dynamic_cast<const ubf::PaperFusion<State, Action>*>(&node))
    params["high_vote"] = paper->high_vote;
  if (const auto* schema = dynamic_cast<const ubf::MotorSchema<State, Action>*>(&node)) {
    params["direction"] = ubf::field_names<Action>()[schema->direction.index().value_or(0)];
    params["magnitude"] = ubf::field_names<Action>()[schema->magnitude.index().value_or(0)];
    params["unit_vote"] = schema->unit_vote;
  }
  if (const auto* parallel = dynamic_cast<const ubf::Parallel<State, Action>*>(&node)) {
    if (parallel->success_count)
      params["success_count"] = *parallel->success_count;
    params["failure_count"] = parallel->failure_count;
  }
  if (const auto* priority = dynamic_cast<const ubf::Priority<State, Action>*>(&node)) {
    Json list = Json::array();
    for (const bool may : priority->interruptible)
      list.push_back(may ? 1 : 0);
    params["interruptible"] = std::move(list);
  }
  if (const auto* commitment = dynamic_cast<const ubf::Commitment<State, Action>*>(&node)) {
    params["margin"] = commitment->margin;
    params["min_time"] = commitment->min_time;
    params["hold"] = commitment->hold;
  }
  if (const auto* suppress = dynamic_cast<const ubf::Suppress<State, Action>*>(&node))
    params["hold"] = suppress->hold;
  if (const auto* inhibit = dynamic_cast<const ubf::Inhibit<State, Action>*>(&node))
    params["hold"] = inhibit->hold;
  if (const auto* verify = dynamic_cast<const ubf::Verify<State, Action>*>(&node)) {
    put_bounds(params, verify->bounds);
    params["fallback"] = verify->fallback ? "true" : "false";
    Json refuse = Json::array();
    for (std::size_t i = 0; i < verify->refusals().size(); ++i) {
      const bool from_file = i < verify->refuse.size();
      refuse.push_back(RefusalJson<State, Action>::of(from_file ? verify->refuse[i] : "",
                                                      verify->refusals()[i]));
    }
    if (!refuse.empty())
      params["refuse"] = std::move(refuse);
  }
  if (const auto* over = dynamic_cast<const ubf::OverGrid<State, Action>*>(&node))
    put_grid(params, over->grid);
  return params;
}

}  // namespace eyrie::page
