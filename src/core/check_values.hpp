// SPDX-License-Identifier: MIT
#pragma once
/// \file  The parameters of an object that is there: whether its values are what a description
/// allows, as those of files are, and what they are.
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/describe.hpp"

namespace eyrie {

template <Described T>
void check_values(const T& object, std::string_view path, std::vector<std::string>& problems);

namespace detail {

/// "outside [0, 50000 ft]"; the number is not within the limits.
[[nodiscard]] std::string limits_text(const Range& limits, Dimension dimension);

/// What a value must keep to, however it was set.
struct ValueRule {
  std::string name;  ///< the path to it
  Range limits;
  Unit unit;
  std::size_t least, most;  ///< items of a list, characters of a text
};

template <class T>
void check_value(const T& value, const ValueRule& rule, std::vector<std::string>& problems) {
  if constexpr (HasBindHook<T> || std::is_same_v<T, bool> || std::is_same_v<T, Table1> ||
                std::is_same_v<T, Table2>) {
    return;  // such types let nothing else in
  } else if constexpr (is_optional<T>) {
    if (value)
      check_value(*value, rule, problems);
  } else if constexpr (std::is_arithmetic_v<T>) {
    const auto x = static_cast<double>(value);
    if (!std::isfinite(x))
      problems.push_back(fmt::format("{} is {}", rule.name, x));
    else if (!rule.limits.contains(x))
      problems.push_back(fmt::format("{}: {} is {}", rule.name,
                                     exact_quantity(x, rule.unit.dimension),
                                     limits_text(rule.limits, rule.unit.dimension)));
  } else if constexpr (NamedEnum<T>) {
    for (const auto& [name, named] : EnumNames<T>::names)
      if (named == value)
        return;
    problems.push_back(fmt::format("{} is none of its choices", rule.name));
  } else if constexpr (std::is_same_v<T, std::string> || is_vector<T>) {
    if (value.size() < rule.least || value.size() > rule.most)
      problems.push_back(fmt::format("{} has {} {}, not {} to {}", rule.name, value.size(),
                                     is_vector<T> ? "items" : "characters", rule.least, rule.most));
    if constexpr (is_vector<T>)
      for (std::size_t i = 0; i < value.size(); ++i) {
        const typename T::value_type item = value[i];  // a vector of bool has no references
        check_value(item, {fmt::format("{}[{}]", rule.name, i), rule.limits, rule.unit, 0, ~0UL},
                    problems);
      }
  } else if constexpr (std::is_same_v<T, Vec3>) {
    check_value(std::array{value.x, value.y, value.z}, rule, problems);
  } else if constexpr (fixed_items<T> != 0) {
    for (std::size_t i = 0; i < fixed_items<T>; ++i)
      check_value(value[i], {fmt::format("{}[{}]", rule.name, i), rule.limits, rule.unit, 0, ~0UL},
                  problems);
  } else {
    check_values(value, rule.name + ".", problems);
  }
}

}  // namespace detail

/// Adds what is wrong with the parameters of an object, in words; `path` stands before their names.
template <Described T>
void check_values(const T& object, std::string_view path, std::vector<std::string>& problems) {
  std::apply(
      [&](const auto&... param) {
        (detail::check_value(object.*param.member,
                             {std::string(path) + std::string(param.name), param.limits, param.unit,
                              param.min_items, param.max_items},
                             problems),
         ...);
      },
      T::params());
}

/// A parameter of an object with its value in SI; switches are "true" or "false".
struct ParamValue {
  std::string name;
  std::variant<double, std::string, std::vector<double>> value;
};

template <Described T>
void list_values(const T& object, std::string_view path, std::vector<ParamValue>& values);

namespace detail {

template <class T>
void list_value(const T& value, const std::string& name, std::vector<ParamValue>& values) {
  if constexpr (HasBindHook<T>) {
    if constexpr (requires { list_parts(value, name, values); })
      list_parts(value, name, values);
  } else if constexpr (is_optional<T>) {
    if (value)
      list_value(*value, name, values);
  } else if constexpr (std::is_same_v<T, bool>) {
    values.push_back({name, value ? "true" : "false"});
  } else if constexpr (std::is_arithmetic_v<T>) {
    values.push_back({name, static_cast<double>(value)});
  } else if constexpr (NamedEnum<T>) {
    values.push_back({name, std::string(enum_name(value))});
  } else if constexpr (std::is_same_v<T, std::string>) {
    values.push_back({name, value});
  } else if constexpr (requires { static_cast<double>(*value.begin()); }) {
    values.push_back({name, std::vector<double>(value.begin(), value.end())});
  } else if constexpr (Described<T>) {
    list_values(value, name + ".", values);
  }
}

}  // namespace detail

/// Adds the parameters of an object that have a value; `path` stands before their names. A type of
/// its own binding brings `list_parts(value, name, values)`, found next to it, or is left out.
template <Described T>
void list_values(const T& object, std::string_view path, std::vector<ParamValue>& values) {
  std::apply(
      [&](const auto&... param) {
        (detail::list_value(object.*param.member, std::string(path) + std::string(param.name),
                            values),
         ...);
      },
      T::params());
}

}  // namespace eyrie
