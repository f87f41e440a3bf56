// SPDX-License-Identifier: MIT
#pragma once
/// \file  The names that files, reports and recordings use for enumerators.
#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace eyrie {

/// The table of an enum that counts from 0, for a function beside it:
/// `constexpr auto names_of(Mode) { return names_from_zero<Mode>("hold", "route"); }`
template <class E, class... Names>
[[nodiscard]] constexpr auto names_from_zero(Names... names) {
  std::array<std::pair<std::string_view, E>, sizeof...(Names)> table{};
  std::size_t i = 0;
  ((table[i] = {names, static_cast<E>(i)}, ++i), ...);
  return table;
}

/// What names_of() says of an enum, before a row or a description uses it; or specialise it:
/// `template <> struct EnumNames<Mode> { static constexpr std::array names{
///    std::pair<std::string_view, Mode>{"hold", Mode::hold}, ... }; };`
template <class E>
struct EnumNames {};
template <class E>
requires requires {
  names_of(E{});
}
struct EnumNames<E> {
  static constexpr auto names = names_of(E{});
};

template <class E>
concept NamedEnum = std::is_enum_v<E> && requires {
  { EnumNames<E>::names.front().first } -> std::convertible_to<std::string_view>;
  { EnumNames<E>::names.front().second } -> std::convertible_to<E>;
};

/// The name of an enumerator, "" if it has none.
template <NamedEnum E>
[[nodiscard]] constexpr std::string_view enum_name(E value) {
  for (const auto& [name, named] : EnumNames<E>::names)
    if (named == value)
      return name;
  return "";
}

/// The enumerator of that name, if there is one.
template <NamedEnum E>
[[nodiscard]] constexpr std::optional<E> enum_named(std::string_view wanted) {
  for (const auto& [name, named] : EnumNames<E>::names)
    if (name == wanted)
      return named;
  return std::nullopt;
}

/// All names of an enum, in the order of its table.
template <NamedEnum E>
[[nodiscard]] constexpr auto enum_names() {
  std::array<std::string_view, EnumNames<E>::names.size()> result{};
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = EnumNames<E>::names[i].first;
  return result;
}

}  // namespace eyrie
