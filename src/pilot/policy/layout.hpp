// SPDX-License-Identifier: MIT
#pragma once
/// \file  Layouts of what goes into a policy and comes out of it, as text: a line for each number.
#include <fmt/format.h>

#include <optional>

#include "core/diagnostics.hpp"
#include "core/hash.hpp"
#include "core/units.hpp"
#include "ubf/state_fields.hpp"

namespace eyrie::pilot {

/// A layout has at most this many lines.
inline constexpr std::size_t kMostLines = 1024;

/// One line of a layout, read word by word. The first mistake is reported, what follows is not.
class LayoutLine {
 public:
  LayoutLine(std::string_view line, Location where, Diagnostics& diagnostics)
      : line_(line), where_(std::move(where)), diagnostics_(diagnostics) {}

  /// The next word; empty at the end.
  std::string_view word();
  /// Two quantities, the lower one first.
  std::optional<std::pair<double, double>> range(Dimension dimension);
  /// Whether the line ends here, as it should.
  bool end();
  /// Reports a mistake at the last word.
  std::nullopt_t fail(std::string message);

 private:
  std::optional<double> quantity(Dimension dimension);
  [[nodiscard]] std::string_view next_word() const;

  std::string_view line_;
  Location where_;
  Diagnostics& diagnostics_;
  std::size_t at_ = 0, begin_ = 0;  ///< behind the last word, and where it begins
  bool failed_ = false;
};

/// Calls `read(LayoutLine&)` for every line that is not empty; `where` is the place of the text.
/// False, and reported, if there are none or too many.
template <class Read>
bool read_layout(std::string_view text, Location where, Diagnostics& diagnostics, Read read) {
  const Location begin = where;
  std::size_t lines = 0;
  while (!text.empty() && lines <= kMostLines) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.find_first_not_of(" \t\r") != line.npos && ++lines <= kMostLines) {
      LayoutLine words(line, where, diagnostics);
      read(words);
    }
    text.remove_prefix(std::min(end + 1, text.size()));
    ++where.line;
    where.column = 1;
  }
  if (lines == 0)
    diagnostics.error(begin, "there is no line in it");
  if (lines > kMostLines)
    diagnostics.error(begin, fmt::format("more than {} lines", kMostLines));
  return lines > 0 && lines <= kMostLines;
}

/// An ordered list of what the lines of a text say, one Item each:
///   static std::optional<Item> read(LayoutLine&, std::span<const Item> before);
///   std::string text() const;
template <class Item>
class Layout {
 public:
  /// No line.
  Layout() = default;
  /// From text; throws ConfigError with all of its mistakes, at `where`.
  Layout(std::string_view text, const Location& where) {
    Diagnostics diagnostics;
    if (!read(text, where, diagnostics))
      throw ConfigError(std::move(diagnostics));
  }
  /// The same with the mistakes to `diagnostics`; false if there are any.
  [[nodiscard]] bool read(std::string_view text, const Location& where, Diagnostics& diagnostics) {
    const std::size_t before = diagnostics.count();
    read_layout(text, where, diagnostics, [&](LayoutLine& line) {
      if (const auto item = Item::read(line, items_))
        items_.push_back(*item);
    });
    return diagnostics.count() == before;
  }

  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] std::span<const Item> items() const { return items_; }

  /// What read() reads back to the same, the ranges in the units that say them most simply.
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const Item& item : items_)
      text += item.text() + '\n';
    return text;
  }
  /// Of text(): two of one hash mean the same.
  [[nodiscard]] std::uint64_t hash() const {
    const std::string all = text();
    return hash_bytes(std::as_bytes(std::span(all)));
  }

 private:
  std::vector<Item> items_;
};

/// "0 nmi 40 nmi", as LayoutLine::range() reads it.
[[nodiscard]] inline std::string range_text(double low, double high, Dimension dimension) {
  return fmt::format("{} {}", exact_quantity(low, dimension), exact_quantity(high, dimension));
}

/// x in [low, high] -> [-1, 1], what is beyond at the bounds; NaN stays.
[[nodiscard]] constexpr double to_unit(double x, double low, double high) {
  const double unit = (2 * x - (low + high)) / (high - low);
  return unit < -1 ? -1 : unit > 1 ? 1 : unit;
}
/// And back.
[[nodiscard]] constexpr double from_unit(double unit, double low, double high) {
  const double inside = unit < -1 ? -1 : unit > 1 ? 1 : unit;
  return 0.5 * ((low + high) + inside * (high - low));
}

}  // namespace eyrie::pilot
