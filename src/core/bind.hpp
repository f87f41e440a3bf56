// SPDX-License-Identifier: MIT
#pragma once
/// \file  Reads a document into described types; collects every mistake instead of stopping.
///
/// What a file may write:
///   number    `2 nmi`; the unit is needed unless the parameter has none. Never NaN or infinity.
///   integer   `4`, never `4.0`            boolean   `true` or `false`, without quotes
///   choice    one of the names            list      `[...]`; Vec3 is a list of three
///   text      what can be shown (text_problem() in core/text.hpp), at most kLongestText characters
///   group     a map; an empty one or nothing leaves the defaults
///   optional  as its type, or `null`
///   table     one variable:  {mach: [0, 0.9, 1.2], value: [0.02, 0.021, 0.04]}
///             two variables: {units: {altitude: ft, value: lbf}, mach: [0, 0.9],
///                             altitude: [0, 30000, 50000], value: [[...3 values...], [...]]}
///             with one row of values per breakpoint of the first axis. `units` gives a whole axis
///             its unit; without it each number carries its own.
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "core/describe.hpp"
#include "core/diagnostics.hpp"
#include "core/value.hpp"

namespace eyrie {

/// Characters of a text for which nothing else is said.
inline constexpr std::size_t kLongestText = 1000;

namespace detail {

/// Reports a map that is none, and unknown keys. False if there is nothing to read.
bool check_keys(const Value& map, std::string_view type_name, std::string_view path,
                std::span<const std::string_view> names,
                std::span<const std::string_view> also_allowed, Diagnostics& diagnostics);
void report_missing(const Value& map, std::string_view type_name, std::string_view path,
                    std::string_view name, Diagnostics& diagnostics);

/// Each reads one value, or reports why not and returns false.
bool read_number(double& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics);
bool read_float(float& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics);
bool read_boolean(bool& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics);
bool read_text(std::string& out, const Value& value, const ParamInfo& info,
               Diagnostics& diagnostics);
bool read_choice(std::size_t& out, const Value& value, std::span<const std::string_view> names,
                 const ParamInfo& info, Diagnostics& diagnostics);
bool read_table(Table1& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics);
bool read_table(Table2& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics);
bool check_list(const Value& value, std::size_t least, std::size_t most, const ParamInfo& info,
                Diagnostics& diagnostics);

/// A whole number within [min, max] as sign and magnitude.
struct WholeLimits {
  std::int64_t min;
  std::uint64_t max;
};
bool read_integer(bool& negative, std::uint64_t& magnitude, const Value& value, WholeLimits type,
                  const ParamInfo& info, Diagnostics& diagnostics);

[[nodiscard]] ParamInfo item_info(const ParamInfo& list, std::size_t index);

template <Described T>
void bind_group(T& out, const Value& map, std::string_view path, Diagnostics& diagnostics,
                std::span<const std::string_view> also_allowed);

template <class T>
void read(T& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics) {
  if constexpr (HasBindHook<T>) {
    bind_value(out, value, diagnostics, info);
  } else if constexpr (is_optional<T>) {
    if (value.is_null()) {
      out.reset();
    } else {
      const std::size_t before = diagnostics.count();
      typename T::value_type read_value{};
      read(read_value, value, info, diagnostics);
      if (diagnostics.count() == before)
        out = std::move(read_value);
    }
  } else if constexpr (std::is_same_v<T, bool>) {
    read_boolean(out, value, info, diagnostics);
  } else if constexpr (std::is_integral_v<T>) {
    constexpr WholeLimits kType{std::numeric_limits<T>::min(), std::numeric_limits<T>::max()};
    bool negative = false;
    std::uint64_t magnitude = 0;
    if (read_integer(negative, magnitude, value, kType, info, diagnostics))
      out = static_cast<T>(negative ? 0 - magnitude : magnitude);
  } else if constexpr (std::is_same_v<T, double>) {
    read_number(out, value, info, diagnostics);
  } else if constexpr (std::is_same_v<T, float>) {
    read_float(out, value, info, diagnostics);
  } else if constexpr (std::is_same_v<T, std::string>) {
    read_text(out, value, info, diagnostics);
  } else if constexpr (NamedEnum<T>) {
    static constexpr auto kNames = enum_names<T>();
    std::size_t chosen = 0;
    if (read_choice(chosen, value, kNames, info, diagnostics))
      out = EnumNames<T>::names[chosen].second;
  } else if constexpr (is_vector<T>) {
    if (!check_list(value, info.min_items, info.max_items, info, diagnostics))
      return;
    const std::size_t before = diagnostics.count();
    T items(value.items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      typename T::value_type item{};  // not in place: a vector of bool has no references
      read(item, value.items[i], item_info(info, i), diagnostics);
      items[i] = std::move(item);
    }
    if (diagnostics.count() == before)
      out = std::move(items);
  } else if constexpr (std::is_same_v<T, Vec3>) {
    std::array<double, 3> xyz{out.x, out.y, out.z};
    read(xyz, value, info, diagnostics);
    out = {xyz[0], xyz[1], xyz[2]};
  } else if constexpr (fixed_items<T> != 0) {
    if (!check_list(value, fixed_items<T>, fixed_items<T>, info, diagnostics))
      return;
    const std::size_t before = diagnostics.count();
    T items = out;
    for (std::size_t i = 0; i < fixed_items<T>; ++i)
      read(items[i], value.items[i], item_info(info, i), diagnostics);
    if (diagnostics.count() == before)
      out = std::move(items);
  } else if constexpr (std::is_same_v<T, Table1> || std::is_same_v<T, Table2>) {
    read_table(out, value, info, diagnostics);
  } else {
    static_assert(Described<T>, "a parameter of this type needs params() or bind_value()");
    bind_group(out, value, info.name, diagnostics, {});
  }
}

/// What the map gives for one parameter. Made once per type of member, not per parameter.
template <class Member>
void bind_one(Member& out, const ParamLine& line, const Value& map, std::string_view type_name,
              std::string_view path, Diagnostics& diagnostics) {
  if (const Value* value = map.find(line.name))
    read(out, *value, brief_info(line, path), diagnostics);
  else if (line.is_required)
    report_missing(map, type_name, path, line.name, diagnostics);
}

template <Described T>
void bind_group(T& out, const Value& map, std::string_view path, Diagnostics& diagnostics,
                std::span<const std::string_view> also_allowed) {
  const auto bind_all = [&](const auto&... param) {
    const std::array<std::string_view, sizeof...(param)> names{param.name...};
    if (check_keys(map, T::type_name, path, names, also_allowed, diagnostics))
      (bind_one(out.*param.member, param, map, T::type_name, path, diagnostics), ...);
  };
  std::apply(bind_all, T::params());
}

}  // namespace detail

/// Reads every parameter of `out` that `map` gives. A map may also have the keys `also_allowed`,
/// which someone else reads. Reports unknown and missing keys, wrong kinds, units and
/// ranges; a parameter with a mistake keeps its value (a list as a whole, a group parameter by
/// parameter). True if nothing was wrong.
///
/// An upper layer binds a type of its own by declaring next to it
///   `void bind_value(T& out, const Value&, Diagnostics&, const ParamInfo&);`
/// where ParamInfo::name is the path to say in errors; and, for references,
///   `void describe_value(ParamInfo&, const T& value);`
/// which fills kind, choices and default_text.
///
/// An object and not a function, so that a span among the arguments cannot call std::bind instead.
struct Bind {
  template <Described T>
  bool operator()(T& out, const Value& map, Diagnostics& diagnostics,
                  std::span<const std::string_view> also_allowed = {}) const {
    const std::size_t before = diagnostics.count();
    detail::bind_group(out, map, {}, diagnostics, also_allowed);
    return diagnostics.count() == before;
  }
};
inline constexpr Bind bind{};

}  // namespace eyrie
