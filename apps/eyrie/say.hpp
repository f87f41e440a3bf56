// SPDX-License-Identifier: MIT
#pragma once
/// \file  Everything that the program prints. What is filled into a message may come from a file or
/// a plug-in: each text among it is made printable, so that no terminal obeys it. What was put
/// together of such texts already, with our own colors and line ends, is Composed.
#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/text.hpp"

namespace eyrie::app {

/// A text that goes to the terminal as it is.
struct Composed {
  std::string text;
};
/// The lines of a text of several ones, each made printable.
[[nodiscard]] inline Composed lines(std::string_view text) {
  return {printable_lines(text)};
}

namespace detail {
template <class T>
constexpr bool kIsText = std::is_convertible_v<const T&, std::string_view>;
template <class T>
using Shown = std::conditional_t<kIsText<T> || std::is_same_v<T, Composed>, std::string, T>;

template <class T>
[[nodiscard]] Shown<T> shown(const T& value) {
  if constexpr (std::is_same_v<T, Composed>)
    return value.text;
  else if constexpr (kIsText<T>)
    return printable(value);
  else
    return value;
}
void print_out(std::string_view text);
void print_error(std::string_view text);
}  // namespace detail

template <class... T>
using Format = fmt::format_string<detail::Shown<T>...>;

/// As fmt::format(), of texts that are fit for a terminal.
template <class... T>
[[nodiscard]] std::string shown(Format<T...> format, const T&... values) {
  return fmt::format(format, detail::shown(values)...);
}
/// On standard output.
template <class... T>
void say(Format<T...> format, const T&... values) {
  detail::print_out(shown<T...>(format, values...));
}
/// On standard error.
template <class... T>
void complain(Format<T...> format, const T&... values) {
  detail::print_error(shown<T...>(format, values...));
}

/// The user's mistake, in words that are fit for a terminal: run_command() says them, with exit
/// code 2.
struct Mistake : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// Throws one.
template <class... T>
[[noreturn]] void refuse(Format<T...> format, const T&... values) {
  throw Mistake(shown<T...>(format, values...));
}

/// "1 flight", "2 flights"
[[nodiscard]] inline std::string counted(std::uint64_t n, std::string_view what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

/// Whether standard output is a terminal that wants colors (https://no-color.org).
[[nodiscard]] bool colors();
/// Writes what standard output still holds back. 0, or the errno for which something of it is lost.
[[nodiscard]] int lost_output();

class Progress {
 public:
  /// `what` is counted to `total`: "seeds".
  Progress(std::string_view what, std::uint64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `more` stands behind it. Draws ten times a second at most.
  void at(std::uint64_t done, std::string_view more = {});
  /// Whether anybody sees it: what `more` costs may be saved.
  [[nodiscard]] bool due() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::string what_;
  std::uint64_t total_;
  bool shown_, drawn_ = false;
  Clock::time_point begun_ = Clock::now(), last_ = begun_;
};

}  // namespace eyrie::app
