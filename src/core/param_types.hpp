// SPDX-License-Identifier: MIT
#pragma once
/// \file  Which C++ types a parameter may have, and what each looks like in a reference. Include
/// core/describe.hpp.
#include <algorithm>
#include <array>
#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "core/enum_names.hpp"
#include "core/member_types.hpp"
#include "core/param.hpp"

namespace eyrie {
class Diagnostics;
struct Value;

/// A type that describes its parameters.
template <class T>
concept Described = requires {
  { T::type_name } -> std::convertible_to<std::string_view>;
  T::params();
};
}  // namespace eyrie

namespace eyrie::detail {

/// `bind_value(out, value, diagnostics, info)` found next to the type takes over.
template <class T>
concept HasBindHook = requires(T& out, const Value& value, Diagnostics& diagnostics,
                               const ParamInfo& info) {
  bind_value(out, value, diagnostics, info);
};

/// `describe_value(info, value)` found next to the type fills kind, choices and default_text.
template <class T>
concept HasDescribeHook = requires(ParamInfo& info, const T& value) {
  describe_value(info, value);
};

/// What binding needs to know; the rest of ParamInfo is for references. `path` is where the
/// parameter's group stands.
[[nodiscard]] ParamInfo brief_info(const ParamLine& line, std::string_view path = {});

/// Fills kind, choices and children from the type.
template <class T>
void describe_type(ParamInfo& info) {
  if constexpr (HasBindHook<T>) {
    info.kind = ParamKind::custom;
  } else if constexpr (is_optional<T>) {
    info.optional = true;
    describe_type<typename ElementOf<T>::type>(info);
  } else if constexpr (std::is_same_v<T, bool>) {
    info.kind = ParamKind::boolean;
  } else if constexpr (std::is_integral_v<T>) {
    info.kind = ParamKind::integer;
    info.limits.min = std::max(info.limits.min, double(std::numeric_limits<T>::min()));
    info.limits.max = std::min(info.limits.max, double(std::numeric_limits<T>::max()));
  } else if constexpr (std::is_floating_point_v<T>) {
    info.kind = ParamKind::number;
  } else if constexpr (std::is_same_v<T, std::string>) {
    info.kind = ParamKind::text;
  } else if constexpr (NamedEnum<T>) {
    info.kind = ParamKind::choice;
    for (const std::string_view name : enum_names<T>())
      info.choices.emplace_back(name);
  } else if constexpr (is_list<T>) {
    info.kind = ParamKind::list;
    if constexpr (fixed_items<T> != 0)
      info.min_items = info.max_items = fixed_items<T>;
    ParamInfo item;
    item.unit = info.unit;
    item.limits = info.limits;
    describe_type<typename ElementOf<T>::type>(item);
    info.children.push_back(std::move(item));
  } else if constexpr (std::is_same_v<T, Table1>) {
    info.kind = ParamKind::table1;
  } else if constexpr (std::is_same_v<T, Table2>) {
    info.kind = ParamKind::table2;
  } else {
    static_assert(Described<T>, "a parameter of this type needs params() or bind_value()");
    info.kind = ParamKind::group;
    info.type_name = T::type_name;
  }
}

/// A value as a file would write it.
template <class T>
std::string value_text(const T& value, const ParamInfo& info) {
  if constexpr (is_optional<T>) {
    return value ? value_text(*value, info) : "null";
  } else if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_integral_v<T>) {
    return std::to_string(+value);
  } else if constexpr (std::is_floating_point_v<T>) {
    return exact_quantity(value, info.unit.dimension);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return value;
  } else if constexpr (NamedEnum<T>) {
    return std::string(enum_name(value));
  } else if constexpr (std::is_same_v<T, Vec3>) {
    return value_text(std::array{value.x, value.y, value.z}, info);
  } else if constexpr (is_list<T>) {
    std::string text;
    for (const auto& item : value)
      text += (text.empty() ? "" : ", ") + value_text(item, info);
    return "[" + text + "]";
  } else {
    return {};
  }
}

template <class Member>
ParamInfo info(const ParamLine& line, const Member& value);

/// Fills the children of a group, looking through optionals and lists.
template <class T>
void describe_children(ParamInfo& info, const T* value) {
  if constexpr (HasBindHook<T>) {
    if constexpr (HasDescribeHook<T> && std::is_default_constructible_v<T>)
      describe_value(info, value ? *value : T{});
  } else if constexpr (is_optional<T>) {
    describe_children<typename ElementOf<T>::type>(info, value && *value ? &**value : nullptr);
  } else if constexpr (is_list<T>) {
    describe_children<typename ElementOf<T>::type>(info.children[0], nullptr);
  } else if constexpr (Described<T>) {
    const T fresh = value ? *value : T{};
    std::apply(
        [&](const auto&... param) {
          (info.children.push_back(detail::info(param, fresh.*param.member)), ...);
        },
        T::params());
  }
}

/// Made once per type of member, not per parameter.
template <class Member>
ParamInfo info(const ParamLine& line, const Member& value) {
  ParamInfo result = brief_info(line);
  describe_type<Member>(result);
  if (!line.is_required)
    result.default_text = value_text(value, result);
  describe_children<Member>(result, &value);
  return result;
}

}  // namespace eyrie::detail
