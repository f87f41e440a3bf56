// SPDX-License-Identifier: MIT
#pragma once
/// \file  Fields of actions from values of Python.
#include <nanobind/stl/array.h>

#include "common.hpp"
#include "pilot/action.hpp"

namespace eyrie::python {

/// Refuses a part that there is not.
inline void demand_parts(const nb::dict& whole, const char* field,
                         std::span<const std::string_view> parts) {
  for (const auto& [key, value] : whole) {
    const auto name = nb::cast<std::string>(key);
    if (std::ranges::find(parts, name) == parts.end())
      refuse("{}: there is no {}{}", field, quote(name), nearest_or_all(name, parts));
  }
}
/// Of a dictionary that stands for a value of several parts.
template <class T>
[[nodiscard]] T part_of(const nb::dict& whole, const char* field, const char* part) {
  if (!whole.contains(part))
    refuse("{}: there is no {} in it", field, quote(part));
  return nb::cast<T>(whole[part]);
}
[[nodiscard]] inline Vec3 vector_of(const nb::dict& whole, const char* part) {
  const auto [x, y, z] = part_of<std::array<double, 3>>(whole, "follow", part);
  return {x, y, z};
}

/// A value of a field as Python gives it: numbers in SI, the names of choices,
/// the numbers of tracks, dictionaries of what has parts.
template <class T>
[[nodiscard]] T action_value(std::string_view field, const nb::handle& value) {
  if constexpr (NamedEnum<T>) {
    const auto name = nb::cast<std::string>(value);
    if (const auto meant = enum_named<T>(name))
      return *meant;
    static constexpr auto names = enum_names<T>();
    refuse("{}: there is no {}{}", field, quote(name), nearest_or_all(name, names));
  } else if constexpr (std::is_arithmetic_v<T>) {
    if (nb::isinstance<nb::bool_>(value) && !std::is_same_v<T, bool>)
      throw nb::cast_error();  // Python's True is a number, too
    return nb::cast<T>(value);
  } else if constexpr (std::is_same_v<T, pilot::Follow>) {
    static constexpr std::array<std::string_view, 4> kParts{"position", "velocity", "time",
                                                            "offset"};
    const auto parts = nb::cast<nb::dict>(value);
    demand_parts(parts, "follow", kParts);
    return {.position = vector_of(parts, "position"),
            .velocity = vector_of(parts, "velocity"),
            .time = part_of<double>(parts, "follow", "time"),
            .offset = vector_of(parts, "offset")};
  } else if constexpr (std::is_same_v<T, pilot::Release>) {
    static constexpr std::array<std::string_view, 2> kParts{"track", "store"};
    const auto parts = nb::cast<nb::dict>(value);
    demand_parts(parts, "release", kParts);
    return {.track = TrackId{part_of<std::uint32_t>(parts, "release", "track")},
            .store = part_of<std::uint32_t>(parts, "release", "store")};
  } else {
    return T{nb::cast<std::uint32_t>(value)};
  }
}

/// Sets one field of an action. Throws ValueError or TypeError.
template <class Action>
void set_action_field(Action& action, const std::string& name, const nb::handle& value) {
  bool found = false;
  std::vector<std::string_view> names;
  ubf::for_each_field<Action>([&](const auto& field, auto) {
    names.push_back(field.name);
    if (field.name != name)
      return;
    found = true;
    using T = typename std::remove_cvref_t<decltype(field)>::Value;
    try {
      action.*field.member = action_value<T>(field.name, value);
    } catch (const nb::cast_error&) {
      throw nb::type_error(
          fmt::format("{}: {} is no value of it", name, nb::cast<std::string>(nb::repr(value)))
              .c_str());
    }
  });
  if (!found)
    refuse("an action has no field {}{}", quote(name), nearest_or_all(name, names));
}

}  // namespace eyrie::python
