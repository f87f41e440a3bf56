// SPDX-License-Identifier: MIT
#pragma once
/// \file  The shapes of parameters: which types are lists, which are optional, which take a unit.
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/vec.hpp"

namespace eyrie::detail {

template <class T>
struct ElementOf {};
template <class T>
struct ElementOf<std::optional<T>> {
  using type = T;
};
template <class T>
struct ElementOf<std::vector<T>> {
  using type = T;
};
template <class T, std::size_t N>
struct ElementOf<std::array<T, N>> {
  using type = T;
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
