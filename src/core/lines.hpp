// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a description lists: values of several types, of which a compiler makes little work.
/// The many constructors of std::tuple were a third of compiling whatever includes a model.
#include <tuple>
#include <utility>

namespace eyrie {
namespace detail {

template <std::size_t, class T>
struct Line {
  T value;
};
template <class, class...>
struct LinesOf;
template <std::size_t... I, class... T>
struct LinesOf<std::index_sequence<I...>, T...> : Line<I, T>... {
  constexpr explicit LinesOf(const T&... values) : Line<I, T>{values}... {}
};

}  // namespace detail

/// `Lines{param(...), param(...)}`
template <class... T>
struct Lines : detail::LinesOf<std::index_sequence_for<T...>, T...> {
  constexpr explicit Lines(const T&... values)
      : detail::LinesOf<std::index_sequence_for<T...>, T...>(values...) {}
  static constexpr std::size_t size() { return sizeof...(T); }
};

template <std::size_t I, class T>
[[nodiscard]] constexpr const T& line(const detail::Line<I, T>& lines) {
  return lines.value;
}
/// Calls `use` with all of them.
template <class Use, class... T>
constexpr decltype(auto) with_lines(const Lines<T...>& lines, Use&& use) {
  return [&]<std::size_t... I>(std::index_sequence<I...>)->decltype(auto) {
    return use(line<I>(lines)...);
  }
  (std::index_sequence_for<T...>{});
}

/// The lines of both, one after the other.
template <class... T, class... U>
[[nodiscard]] constexpr Lines<T..., U...> joined(const Lines<T...>& first,
                                                 const Lines<U...>& second) {
  return with_lines(first, [&](const T&... a) {
    return with_lines(second, [&](const U&... b) { return Lines<T..., U...>(a..., b...); });
  });
}

/// A description may list them in a std::tuple, too.
template <class... T>
[[nodiscard]] constexpr Lines<T...> lines_of(const Lines<T...>& lines) {
  return lines;
}
template <class... T>
[[nodiscard]] constexpr Lines<T...> lines_of(const std::tuple<T...>& lines) {
  return std::apply([](const T&... all) { return Lines<T...>(all...); }, lines);
}

}  // namespace eyrie
