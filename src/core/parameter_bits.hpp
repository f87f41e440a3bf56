// SPDX-License-Identifier: MIT
#pragma once
/// \file  The parameters of a described object as bytes: two objects with the same bytes do the
/// same, whatever they are called. What was computed from an object may be kept under them.
#include <bit>
#include <cstdint>
#include <string>
#include <tuple>
#include <type_traits>

#include "core/describe.hpp"

namespace eyrie {

/// Appends the value of one parameter, bit by bit.
template <class T>
void append_bits(std::string& out, const T& value);

namespace detail {

inline void append_word(std::string& out, std::uint64_t word) {
  for (int shift = 0; shift < 64; shift += 8)
    out.push_back(static_cast<char>(word >> shift));
}

template <class List>
void append_list(std::string& out, const List& list) {
  append_word(out, list.size());
  for (const auto& item : list)
    append_bits(out, item);
}

}  // namespace detail

template <class T>
void append_bits(std::string& out, const T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    // a text is for people
  } else if constexpr (std::is_same_v<T, double>) {
    detail::append_word(out, std::bit_cast<std::uint64_t>(value));
  } else if constexpr (std::is_same_v<T, float>) {
    detail::append_word(out, std::bit_cast<std::uint32_t>(value));
  } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
    detail::append_word(out, static_cast<std::uint64_t>(value));
  } else if constexpr (detail::is_optional<T>) {
    detail::append_word(out, value.has_value());
    if (value)
      append_bits(out, *value);
  } else if constexpr (std::is_same_v<T, Vec3>) {
    for (const double part : {value.x, value.y, value.z})
      append_bits(out, part);
  } else if constexpr (detail::is_list<T>) {
    detail::append_list(out, value);
  } else if constexpr (std::is_same_v<T, Table1>) {
    detail::append_list(out, value.breakpoints());
    detail::append_list(out, value.values());
  } else if constexpr (std::is_same_v<T, Table2>) {
    detail::append_list(out, value.rows().breakpoints());
    detail::append_list(out, value.columns().breakpoints());
    detail::append_list(out, value.values());
  } else {
    static_assert(Described<T>, "what is this parameter as bytes?");
    std::apply([&](const auto&... param) { (append_bits(out, value.*param.member), ...); },
               T::params());
  }
}

/// Every parameter, bit by bit, but texts. Of one version of the type: nothing says which is which.
template <Described T>
[[nodiscard]] std::string parameter_bits(const T& object) {
  std::string out;
  append_bits(out, object);
  return out;
}

}  // namespace eyrie
