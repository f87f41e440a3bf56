// SPDX-License-Identifier: MIT
#pragma once
/// \file  Mistakes in files: where they are, what they say, and the nearest right name.
#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eyrie {

/// The name of a text file. Each name is kept once, for as long as the program runs, so that the
/// many places in a file cost no more than their line and column.
class FileName {
 public:
  FileName() = default;
  FileName(std::string_view name);  // so that a place is written {"file", line, column}
  FileName(const std::string& name) : FileName(std::string_view(name)) {}
  FileName(const char* name) : FileName(std::string_view(name)) {}

  [[nodiscard]] std::string_view text() const { return name_ ? *name_ : std::string_view(); }
  friend bool operator==(const FileName& a, const FileName& b) {
    return a.name_ == b.name_ || a.text() == b.text();
  }

 private:
  const std::string* name_ = nullptr;
};

/// A place in a text file. Lines and columns count from 1; 0 means unknown.
struct Location {
  FileName file;
  int line = 0, column = 0;

  /// "file:line:column" as far as it is known; empty when nothing is known.
  [[nodiscard]] std::string text() const;
  bool operator==(const Location&) const = default;
};

/// One mistake and its place.
struct Diagnostic {
  Location where;
  std::string message;

  /// "file:line:column: message", fit for a terminal as quote() is, and of bounded length.
  [[nodiscard]] std::string text() const;
  bool operator==(const Diagnostic&) const = default;
};

/// Collects the mistakes of a load, so that the user sees all of them in one go. Of a file that
/// makes more than anybody would read the rest is counted only.
class Diagnostics {
 public:
  /// Gives nothing, which a reader may pass on: `return diagnostics.error(...)`.
  std::nullopt_t error(Location where, std::string message);
  template <class... T>
  requires(sizeof...(T) > 0) std::nullopt_t
      error(Location where, fmt::format_string<T...> message, T&&... values) {
    return error(where, fmt::format(message, std::forward<T>(values)...));
  }
  void merge(const Diagnostics& other);
  /// Says of what was reported after the first `before` also where it comes from, except of what
  /// stands there itself.
  void trace_to(std::size_t before, const Location& where, std::string_view words);

  [[nodiscard]] bool ok() const { return count_ == 0; }
  /// Throws ConfigError with all of them if there are any.
  void throw_if_any() const;
  /// Mistakes reported so far, duplicates included.
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Whether more need not be looked for.
  [[nodiscard]] bool full() const { return count_ >= kKept; }

  /// Those that were kept, without duplicates and in the order a reader meets them: files by first
  /// appearance, then line, then column, then the order of reporting.
  [[nodiscard]] std::vector<Diagnostic> sorted() const;

  /// One line per mistake, without a final newline. Beyond `limit` lines: "... and 7 more".
  [[nodiscard]] std::string text(std::size_t limit = kPrinted) const;

  static constexpr std::size_t kPrinted = 50, kKept = 1000;

 private:
  std::vector<Diagnostic> found_;
  std::size_t count_ = 0;
};

/// The user's mistake, found while loading. what() is the text of the diagnostics.
class ConfigError : public std::runtime_error {
 public:
  explicit ConfigError(Diagnostics diagnostics);
  ConfigError(Location where, std::string message);
  template <class... T>
  requires(sizeof...(T) > 0)
      ConfigError(Location where, fmt::format_string<T...> message, T&&... values)
      : ConfigError(where, fmt::format(message, std::forward<T>(values)...)) {}

  [[nodiscard]] const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  Diagnostics diagnostics_;
};

/// The texts of a list, for as long as it lives.
struct NameList : std::vector<std::string_view> {
  template <class List>
  NameList(const List& list) : vector(std::begin(list), std::end(list)) {}
};
/// "; did you mean 'x'?" for the name nearest to `wrong`, or "" when none is near. Letter case does
/// not count, swapping two neighbors counts as one edit; the earlier name wins a tie. When none is
/// near: the only one that `wrong` is whole words of, as "latin" of "latin_hypercube".
[[nodiscard]] std::string did_you_mean(std::string_view wrong, const NameList& names);
/// Likewise, but ", only a, b, c" when none is near and all of them are read at a glance.
[[nodiscard]] std::string nearest_or_all(std::string_view wrong, const NameList& names);

/// The names of some things, for these: `nearest_or_all(wrong, listed(measures, &Measure::name))`.
template <class Things, class Name>
[[nodiscard]] std::vector<std::string> listed(const Things& things, Name name) {
  std::vector<std::string> names;
  for (const auto& thing : things)
    names.emplace_back(std::invoke(name, thing));
  return names;
}

/// The printable() text in single quotes; one that is longer than 60 characters is cut with "...".
[[nodiscard]] std::string quote(std::string_view text);
/// The same of the path of a file, which may be longer.
[[nodiscard]] std::string quote_path(std::string_view path);

}  // namespace eyrie
