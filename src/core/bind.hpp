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
#include "core/describe.hpp"
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

/// Each reads one value, or reports why not, leaves `out` and returns false.
bool read(const ValueType& type, void* out, const Value& value, const ParamInfo& info,
          Diagnostics& diagnostics);
bool read_number(double& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics);
bool read_table(Table1& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics);
bool read_table(Table2& out, const Value& value, const ParamInfo& info, Diagnostics& diagnostics);
bool check_list(const Value& value, std::size_t least, std::size_t most, const ParamInfo& info,
                Diagnostics& diagnostics);
[[nodiscard]] ParamInfo item_info(const ParamInfo& list, std::size_t index);

bool bind(const Description& type, void* out, const Value& map, std::string_view path,
          Diagnostics& diagnostics, std::span<const std::string_view> also_allowed);

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
    return detail::bind(description_of<T>(), &out, map, {}, diagnostics, also_allowed);
  }
};
inline constexpr Bind bind{};

}  // namespace eyrie
