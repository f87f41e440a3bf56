// SPDX-License-Identifier: MIT
#pragma once
/// \file  Describe once: one table of parameters per type drives binding, errors and references.
///
///   struct BreakTurn {
///     static constexpr std::string_view type_name = "break_turn";
///     static constexpr std::string_view help = "turns hard away from a missile";
///     static constexpr auto params() {
///       return Lines{
///           param("danger_range", &BreakTurn::danger_range_, "m", range(0, 50e3), "break inside"),
///           param("mode", &BreakTurn::mode_, "how to turn").required()};
///     }
///    private:
///     double danger_range_ = si(2, "nmi");
///     Mode mode_ = Mode::level;
///   };
///
/// A member may be: double, float, bool, an integer, std::string, an enum with EnumNames, Vec3,
/// Table1, Table2, another described struct, std::optional, std::vector or std::array of these, or
/// a type with its own bind_value (see core/bind.hpp). The value of a default-constructed object is
/// the default of the parameter.
#include <functional>
#include <memory>
#include <variant>

#include "core/enum_names.hpp"
#include "core/lines.hpp"
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

/// A parameter of an object with its value.
struct ParamValue {
  std::string name;
  std::string text;                ///< as a file would write it: "2 nmi", "true", "[1, 2]"
  std::optional<double> number{};  ///< of a number, in SI
};

/// One type of value that a parameter may have, at run time.
struct ValueType;

/// One parameter of a described type, at run time.
struct Parameter : ParamLine {
  const ValueType* type = nullptr;
  void* (*member)(void* object) = nullptr;

  [[nodiscard]] const void* of(const void* object) const {
    return member(const_cast<void*>(object));
  }
};

/// A described type at run time. Whatever is done with parameters (core/bind.hpp, and below) goes
/// over it and is compiled once, not once per type.
struct Description {
  std::string_view type_name;
  std::span<const Parameter> parameters;
  std::shared_ptr<void> (*fresh)() =
      nullptr;  ///< with its defaults; null if there is no such thing

  /// The parameter of that name, or null.
  [[nodiscard]] const Parameter* find(std::string_view name) const;
};

struct ValueType {
  ParamKind kind = ParamKind::custom;
  /// Numbers, integers, booleans and choices as 64 bits: those of a double, or an integer extended.
  std::uint64_t (*load)(const void*) = nullptr;
  void (*store)(void*, std::uint64_t) = nullptr;
  bool is_float = false;
  std::int64_t least = 0;  ///< of an integer
  std::uint64_t most = 0;
  std::span<const std::string_view> names{};  ///< of a choice, and what they stand for
  std::span<const std::uint64_t> values{};

  /// Of a list its item, of an optional what it may hold; `build` gives `out` so many parts, each
  /// filled in by `fill`, unless that answers false for one of them.
  const ValueType* part = nullptr;
  bool is_optional = false;
  std::size_t fixed = 0;  ///< how many items an array has
  std::size_t (*size)(const void*) = nullptr;
  const void* (*at)(const void*, std::size_t) = nullptr;
  void (*build)(void* out, std::size_t size,
                const std::function<bool(void* part, std::size_t)>& fill) = nullptr;

  const Description* group = nullptr;

  /// Of a type with its own bind_value.
  void (*bind)(void*, const Value&, Diagnostics&, const ParamInfo&) = nullptr;
  void (*describe)(ParamInfo&, const void* value) = nullptr;
  void (*list)(const void*, const std::string& name, std::vector<ParamValue>&) = nullptr;
};

namespace detail {

/// `bind_value(out, value, diagnostics, info)` found next to the type takes over.
template <class T>
concept HasBindHook = requires(T& out, const Value& value, Diagnostics& diagnostics,
                               const ParamInfo& info) {
  bind_value(out, value, diagnostics, info);
};

template <class T>
struct DescriptionOf {
  static const Description value;
};
template <class T>
struct TypeOf {
  static const ValueType value;
};

template <NamedEnum E>
inline constexpr auto kEnumNames = enum_names<E>();
template <NamedEnum E>
inline constexpr auto kEnumValues = [] {
  std::array<std::uint64_t, EnumNames<E>::names.size()> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<std::uint64_t>(EnumNames<E>::names[i].second);
  return values;
}();

template <class T>
std::uint64_t load(const void* value) {
  if constexpr (std::is_floating_point_v<T>)
    return std::bit_cast<std::uint64_t>(static_cast<double>(*static_cast<const T*>(value)));
  else
    return static_cast<std::uint64_t>(*static_cast<const T*>(value));
}
template <class T>
void store(void* value, std::uint64_t bits) {
  if constexpr (std::is_floating_point_v<T>)
    *static_cast<T*>(value) = static_cast<T>(std::bit_cast<double>(bits));
  else
    *static_cast<T*>(value) = static_cast<T>(bits);
}

template <class T>
std::size_t size_of(const void* parts) {
  if constexpr (is_optional<T>)
    return static_cast<const T*>(parts)->has_value();
  else if constexpr (is_vector<T>)
    return static_cast<const T*>(parts)->size();
  else
    return fixed_items<T>;
}
template <class T>
const void* part_at(const void* parts, std::size_t i) {
  static constexpr bool kTruth[] = {false, true};
  const T& all = *static_cast<const T*>(parts);
  if constexpr (is_optional<T>)
    return &*all;
  else if constexpr (std::is_same_v<T, std::vector<bool>>)  // it has no references
    return &kTruth[all[i]];
  else if constexpr (std::is_same_v<T, Vec3>)
    return std::array{&all.x, &all.y, &all.z}[i];
  else
    return &all[i];
}
template <class T>
void build(void* out, std::size_t size, const std::function<bool(void*, std::size_t)>& fill) {
  using Part = typename ElementOf<T>::type;
  T& target = *static_cast<T*>(out);
  T made{};
  if constexpr (is_vector<T>)
    made.resize(size);
  else if constexpr (fixed_items<T> != 0)
    made = target;
  for (std::size_t i = 0; i < size; ++i) {
    Part part{};
    if constexpr (fixed_items<T> != 0)
      part = *static_cast<const Part*>(part_at<T>(&made, i));
    if (!fill(&part, i))
      return;
    if constexpr (is_optional<T>)
      made = std::move(part);
    else if constexpr (std::is_same_v<T, Vec3>)
      *std::array{&made.x, &made.y, &made.z}[i] = part;
    else
      made[i] = std::move(part);
  }
  target = std::move(made);
}

template <class T>
constexpr ValueType scalar_type(ParamKind kind) {
  ValueType type{.kind = kind, .load = load<T>, .store = store<T>};
  if constexpr (std::is_integral_v<T>) {
    type.least = std::numeric_limits<T>::min();
    type.most = std::numeric_limits<T>::max();
  }
  type.is_float = std::is_same_v<T, float>;
  return type;
}
template <class T>
constexpr ValueType custom_type() {
  ValueType type{
      .bind = [](void* out, const Value& value, Diagnostics& diagnostics, const ParamInfo& info) {
        bind_value(*static_cast<T*>(out), value, diagnostics, info);
      }};
  if constexpr (std::is_default_constructible_v<T> &&
                requires(ParamInfo & info, const T& value) { describe_value(info, value); })
    type.describe = [](ParamInfo& info, const void* value) {
      describe_value(info, value ? *static_cast<const T*>(value) : T{});
    };
  if constexpr (requires(const T& value, const std::string& name, std::vector<ParamValue>& all) {
                  list_parts(value, name, all);
                })
    type.list = [](const void* value, const std::string& name, std::vector<ParamValue>& all) {
      list_parts(*static_cast<const T*>(value), name, all);
    };
  return type;
}

template <class T>
constexpr ValueType value_type() {
  if constexpr (HasBindHook<T>) {
    return custom_type<T>();
  } else if constexpr (is_optional<T> || is_list<T>) {
    return {.kind = ParamKind::list,
            .part = &TypeOf<typename ElementOf<T>::type>::value,
            .is_optional = is_optional<T>,
            .fixed = fixed_items<T>,
            .size = size_of<T>,
            .at = part_at<T>,
            .build = build<T>};
  } else if constexpr (std::is_floating_point_v<T>) {
    return scalar_type<T>(ParamKind::number);
  } else if constexpr (std::is_integral_v<T>) {
    return scalar_type<T>(std::is_same_v<T, bool> ? ParamKind::boolean : ParamKind::integer);
  } else if constexpr (NamedEnum<T>) {
    ValueType type = scalar_type<T>(ParamKind::choice);
    type.names = kEnumNames<T>;
    type.values = kEnumValues<T>;
    return type;
  } else if constexpr (std::is_same_v<T, std::string>) {
    return {.kind = ParamKind::text};
  } else if constexpr (std::is_same_v<T, Table1> || std::is_same_v<T, Table2>) {
    return {.kind = std::is_same_v<T, Table1> ? ParamKind::table1 : ParamKind::table2};
  } else {
    static_assert(Described<T>, "a parameter of this type needs params() or bind_value()");
    return {.kind = ParamKind::group, .group = &DescriptionOf<T>::value};
  }
}
template <class T>
constexpr ValueType TypeOf<T>::value = value_type<T>();

template <class T, auto member>
void* member_of(void* object) {
  return &(static_cast<T*>(object)->*member);
}
template <Described T>
inline constexpr auto kParameters = []<std::size_t... I>(std::index_sequence<I...>) {
  [[maybe_unused]] constexpr auto kLines = lines_of(T::params());
  return std::array<Parameter, sizeof...(I)>{Parameter{
      line<I>(kLines),
      &TypeOf<typename std::remove_cvref_t<decltype(line<I>(kLines))>::member_type>::value,
      member_of<T, line<I>(kLines).member>}...};
}
(std::make_index_sequence<decltype(lines_of(T::params()))::size()>{});

template <Described T>
constexpr std::shared_ptr<void> (*fresh_of())() {
  if constexpr (std::default_initializable<T>)
    return [] { return std::shared_ptr<void>(std::make_shared<T>()); };
  else
    return nullptr;
}
template <class T>
constexpr Description DescriptionOf<T>::value{T::type_name, kParameters<T>, fresh_of<T>()};

[[nodiscard]] std::vector<ParamInfo> parameters(const Description& type, const void* defaults);
/// Adds what is wrong with the parameters of an object, in words, which may have been set by code;
/// `path` stands before their names. `defaults`: it is a fresh one, of which a required parameter
/// says nothing.
void check_values(const Description& type, const void* object, std::string_view path,
                  std::vector<std::string>& problems, bool defaults = false);
/// Adds the parameters of an object that have a value; `path` stands before their names. A type of
/// its own binding brings `list_parts(value, name, values)`, found next to it, or is left out.
void list_values(const Description& type, const void* object, std::string_view path,
                 std::vector<ParamValue>& values);
void append_bits(const ValueType& type, const void* value, std::string& out);

/// What binding needs to know; the rest of ParamInfo is for references. `path` is where the
/// parameter's group stands.
[[nodiscard]] ParamInfo brief_info(const ParamLine& line, std::string_view path = {});
/// "outside [0, 50000 ft]"; the number is not within the limits.
[[nodiscard]] std::string limits_text(const Range& limits, Dimension dimension);

}  // namespace detail

/// A described type at run time.
template <Described T>
[[nodiscard]] constexpr const Description& description_of() {
  return detail::DescriptionOf<T>::value;
}

/// Every parameter of a type, with the values of `defaults` as defaults. A type must not contain
/// itself, not even in a list.
template <Described T>
[[nodiscard]] std::vector<ParamInfo> parameters(const T& defaults) {
  return detail::parameters(description_of<T>(), &defaults);
}
template <Described T>
requires std::default_initializable<T>
[[nodiscard]] std::vector<ParamInfo> parameters() {
  return parameters(T{});
}

/// Appends a value that a parameter may have, bit by bit.
template <class T>
void append_bits(std::string& out, const T& value) {
  detail::append_bits(detail::TypeOf<T>::value, &value, out);
}
/// Every parameter, bit by bit, but texts, which are for people: two objects with the same bytes do
/// the same, and what was computed from one may be kept under them. Of one version of the type:
/// nothing says which is which.
template <Described T>
[[nodiscard]] std::string parameter_bits(const T& object) {
  std::string out;
  append_bits(out, object);
  return out;
}

}  // namespace eyrie
