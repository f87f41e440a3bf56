// SPDX-License-Identifier: MIT
#pragma once
/// \file  Fields of states and actions as values for people and tools.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <type_traits>

#include "core/enum_names.hpp"
#include "core/units.hpp"
#include "team/decision.hpp"
#include "ubf/state_fields.hpp"

namespace eyrie::team {

/// "45 deg", "6000 ft", "467 kt"; "-" for no value. Heights are in feet however large they are.
[[nodiscard]] inline std::string number_text(std::string_view name, const Unit& unit,
                                             double number) {
  if (std::isnan(number))
    return "-";
  const bool height = name.find("altitude") != name.npos || name.find("above") != name.npos;
  return height ? format_in(number, "ft")
                : format_quantity(number, unit.dimension, UnitStyle::aviation);
}

[[nodiscard]] inline Value number_value(std::string_view name, const Unit& unit, double number) {
  return {std::string(name), std::string(unit.si_symbol),
          std::isnan(number) ? std::nullopt : std::optional(number),
          number_text(name, unit, number)};
}

/// The value of a field of an action.
template <class T>
[[nodiscard]] Value action_value(std::string_view name, const Unit& unit, const T& value) {
  if constexpr (std::is_same_v<T, bool>)
    return {std::string(name), "", value ? 1 : 0, value ? "true" : "false"};
  else if constexpr (std::is_arithmetic_v<T>)
    return number_value(name, unit, static_cast<double>(value));
  else if constexpr (NamedEnum<T>)
    return {std::string(name), "", std::nullopt, std::string(enum_name(value))};
  else if constexpr (requires { to_text(value); })
    return {std::string(name), "", std::nullopt, to_text(value)};
  else
    return {std::string(name), "", static_cast<double>(value.value),
            value ? fmt::format("#{}", value.value) : "nobody"};
}

/// Every named field of a state.
template <class State>
[[nodiscard]] std::vector<Value> state_values(const State& state) {
  std::vector<Value> values;
  for (const auto& field : ubf::StateFields<State>::all()) {
    Value value = number_value(field.info.name, field.info.unit, field.read(state));
    if (field.info.kind == ubf::FieldKind::flag)
      value.text = value.number == 1 ? "yes" : "no";
    if (field.info.kind == ubf::FieldKind::choice && value.number)
      value.text = field.info.choices[static_cast<std::size_t>(*value.number)];
    values.push_back(std::move(value));
  }
  return values;
}

}  // namespace eyrie::team
