// SPDX-License-Identifier: MIT
#pragma once
/// \file  Decisions for people: one line per node of a traced tick.
#include <fmt/format.h>

#include <concepts>
#include <string>
#include <type_traits>

#include "core/enum_names.hpp"
#include "core/units.hpp"
#include "ubf/trace.hpp"
#include "ubf/tree.hpp"

namespace eyrie::ubf {

namespace detail {

/// A value of an action's field. A type of one's own brings a `to_text` found next to it.
template <class T>
[[nodiscard]] std::string field_text(const T& value, const Unit& unit) {
  if constexpr (std::same_as<T, bool>)
    return value ? "yes" : "no";
  else if constexpr (std::floating_point<T>)
    return unit.dimension == Dimension::none
               ? fmt::format("{:g}", value)
               : format_quantity(static_cast<double>(value), unit.dimension, UnitStyle::aviation);
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

/// "heading 90 deg, speed 480 kt": the fields that are set.
template <class Action>
[[nodiscard]] std::string to_text(const Action& action) requires requires {
  ActionTraits<Action>::fields;
}
{
  std::string text;
  for_each_field<Action>([&](const auto& f, auto) {
    if (const auto& value = action.*f.member)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", f.name,
                          detail::field_text(*value, f.unit));
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
      line += fmt::format("{}{} {}", separator, f.name, detail::field_text(*value, f.unit));
      if (row.supplier[field] != index)
        line += fmt::format(" ({})", tree.path(row.supplier[field]));
      separator = ", ";
    });
    text += line + "\n";
  }
  return text;
}

}  // namespace eyrie::ubf
