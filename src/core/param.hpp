// SPDX-License-Identifier: MIT
#pragma once
/// \file  One line of a description, and what references and binders need to know of it. Include
/// core/describe.hpp, which says how to use it.
#include <type_traits>

#include "core/table.hpp"
#include "core/units.hpp"
#include "core/vec.hpp"

namespace eyrie::detail {

template <class T>
struct ElementOf {
  using type = typename T::value_type;
};
template <>
struct ElementOf<Vec3> {
  using type = double;
};

template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T>
inline constexpr std::size_t fixed_items = 0;
template <class T, std::size_t N>
inline constexpr std::size_t fixed_items<std::array<T, N>> = N;
template <>
inline constexpr std::size_t fixed_items<Vec3> = 3;
template <class T>
inline constexpr bool is_list = is_vector<T> || fixed_items<T> != 0;

/// Groups take none: their parameters have their own. A type with its own bind_value may.
template <class T>
constexpr bool takes_range() {
  if constexpr (is_optional<T> || is_list<T>)
    return takes_range<typename ElementOf<T>::type>();
  else
    return !std::is_same_v<T, bool> && !std::is_enum_v<T> && !std::is_same_v<T, std::string> &&
           !requires {
      T::params();
    };
}
template <class T>
constexpr bool takes_unit() {
  if constexpr (is_optional<T> || is_list<T>)
    return takes_unit<typename ElementOf<T>::type>();
  else
    return takes_range<T>() && !std::is_integral_v<T>;
}

template <class T>
concept TakesRange = takes_range<T>();
template <class T>
concept TakesUnit = takes_unit<T>();

}  // namespace eyrie::detail

namespace eyrie {

/// The values a number may have. NaN and infinity are refused always.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool exclusive_min = false;

  [[nodiscard]] constexpr bool contains(double x) const {
    return (exclusive_min ? x > min : x >= min) && x <= max;
  }
  bool operator==(const Range&) const = default;
};

[[nodiscard]] constexpr Range any() {
  return {};
}
/// [low, high], in SI.
[[nodiscard]] constexpr Range range(double low, double high) {
  return {low, high};
}
/// The same in another unit: `range(0, 85, "deg")`.
[[nodiscard]] constexpr Range range(double low, double high, UnitName unit) {
  return {si(low, unit), si(high, unit)};
}
[[nodiscard]] constexpr Range at_least(double low) {
  return {low};
}
/// (0, high]
[[nodiscard]] constexpr Range positive(double high = std::numeric_limits<double>::infinity()) {
  return {0, high, true};
}

/// What an axis of a table is called in a file, and its unit.
struct TableAxis {
  std::string_view name;
  Unit unit;
};

[[nodiscard]] constexpr TableAxis axis(std::string_view name, Unit unit) {
  return {name, unit};
}

/// What a line of a description says, whatever type the member has.
struct ParamLine {
  std::string_view name;
  Unit unit;
  Range limits;
  std::string_view help;
  bool is_required = false;
  std::size_t min_items = 0, max_items = std::numeric_limits<std::size_t>::max();
  std::array<TableAxis, 2> axes{};  ///< of a table
};

/// One line of a description: made by param(), refined by required() and items().
template <class Class, class Member>
struct Param : ParamLine {
  using member_type = Member;

  Member Class::*member;

  /// The file must give it.
  [[nodiscard]] constexpr Param required() const {
    Param copy = *this;
    copy.is_required = true;
    return copy;
  }
  /// A list must have that many items, a text that many characters. Unit and range of a list are
  /// those of each item.
  [[nodiscard]] constexpr Param items(std::size_t least, std::size_t most) const {
    Param copy = *this;
    copy.min_items = least;
    copy.max_items = most;
    return copy;
  }
};

/// A number, or a list, array or optional of numbers.
template <class Class, detail::TakesUnit Member>
[[nodiscard]] constexpr Param<Class, Member> param(std::string_view name, Member Class::*member,
                                                   Unit unit, Range limits, std::string_view help) {
  return {{name, unit, limits, help}, member};
}
/// A number of which every finite value is right.
template <class Class, detail::TakesUnit Member>
[[nodiscard]] constexpr Param<Class, Member> param(std::string_view name, Member Class::*member,
                                                   Unit unit, std::string_view help) {
  return {{name, unit, {}, help}, member};
}
/// A plain number within a range.
template <class Class, detail::TakesRange Member>
[[nodiscard]] constexpr Param<Class, Member> param(std::string_view name, Member Class::*member,
                                                   Range limits, std::string_view help) {
  return {{name, {}, limits, help}, member};
}
/// What has neither unit nor range: switches, texts, choices, groups.
template <class Class, class Member>
[[nodiscard]] constexpr Param<Class, Member> param(std::string_view name, Member Class::*member,
                                                   std::string_view help) {
  return {{name, {}, {}, help}, member};
}
/// A table over one variable; unit and range are those of its values.
template <class Class>
[[nodiscard]] constexpr Param<Class, Table1> param(std::string_view name, Table1 Class::*member,
                                                   TableAxis x, Unit unit, Range limits,
                                                   std::string_view help) {
  Param<Class, Table1> result{{name, unit, limits, help}, member};
  result.axes[0] = x;
  return result;
}
/// A table over two variables: rows first.
template <class Class>
[[nodiscard]] constexpr Param<Class, Table2> param(std::string_view name, Table2 Class::*member,
                                                   TableAxis row, TableAxis column, Unit unit,
                                                   Range limits, std::string_view help) {
  Param<Class, Table2> result{{name, unit, limits, help}, member};
  result.axes = {row, column};
  return result;
}

enum class ParamKind {
  number,   ///< a quantity, or a plain number if the unit is none
  integer,  ///< a whole number
  boolean,  ///< true or false
  text,
  choice,  ///< one of `choices`
  list,    ///< `children[0]` describes an item
  table1,  ///< a map with the axis, `value`, and perhaps `units`
  table2,  ///< the same with two axes; `value` is a list of rows
  group,   ///< a map; `children` describe its parameters
  custom,  ///< a type with its own bind_value
};

/// What a parameter is, for binders, the generated reference and the JSON schema.
struct ParamInfo {
  std::string name;  ///< while binding, the path to it: "legs[2].altitude"
  ParamKind kind = ParamKind::custom;
  Unit unit;
  Range limits;
  std::string default_text;  ///< as a file would write it; "" if required or a group
  std::string help;
  bool required = false;
  bool optional = false;      ///< `null` is a value of it
  std::size_t min_items = 0;  ///< of a list; of a text: characters
  std::size_t max_items = std::numeric_limits<std::size_t>::max();
  std::vector<std::string> choices;
  std::string type_name;  ///< of a group
  std::vector<TableAxis> axes;
  std::vector<ParamInfo> children;
};

}  // namespace eyrie
