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
#include <variant>

#include "core/enum_names.hpp"
#include "page/json.hpp"
#include "page/quantum.hpp"
#include "ubf/arbiter/verify.hpp"

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

/// What the page arbitrates by; of a leaf its vote.
template <class State, class Action>
[[nodiscard]] Json arbiter_params(const ubf::Behavior<State, Action>& node) {
  const bool decides =
      node.node_kind() == ubf::Kind::arbiter || node.node_kind() == ubf::Kind::control;
  Json params = Json::object();
  for (const ParamValue& param : node.values())
    if (param.name == "vote" || (decides && param.name != "vote_scale") ||
        (decides && std::get<double>(param.value) != 1))
      std::visit([&](const auto& value) { params[param.name] = value; }, param.value);
  if (const auto* verify = dynamic_cast<const ubf::Verify<State, Action>*>(&node)) {
    Json refuse = Json::array();
    for (std::size_t i = 0; i < verify->refusals().size(); ++i)
      refuse.push_back(RefusalJson<State, Action>::of(
          i < verify->refuse.size() ? verify->refuse[i] : "", verify->refusals()[i]));
    if (!refuse.empty())
      params["refuse"] = std::move(refuse);
  }
  return params;
}

}  // namespace eyrie::page
