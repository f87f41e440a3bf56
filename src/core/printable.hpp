// SPDX-License-Identifier: MIT
#pragma once
/// \file  Text from files and plug-ins made fit for a terminal, which obeys control characters.
#include <cstddef>
#include <string>
#include <string_view>

namespace eyrie {

/// At most `longest` characters of it and then "...", with \x1b-like escapes, byte by byte, for
/// what a terminal would obey or cannot show: control characters (C0, DEL, C1), the marks that turn
/// the direction of writing, the two Unicode line ends, and invalid UTF-8.
[[nodiscard]] std::string printable(std::string_view text,
                                    std::size_t longest = std::string_view::npos);
/// The same of every line of a text: line feeds stay.
[[nodiscard]] std::string printable_lines(std::string_view text);
/// Whether printable() changes nothing.
[[nodiscard]] bool is_printable(std::string_view text);

/// With U+FFFD in the place of each byte that is not UTF-8.
[[nodiscard]] std::string valid_utf8(std::string_view text);

/// Columns of a terminal: two for wide characters (Chinese, Japanese, Korean, emoji), one for the
/// others, as fmt counts when it pads.
[[nodiscard]] std::size_t columns(std::string_view text);

/// The first character of a text.
struct Utf8 {
  std::size_t length = 0;  ///< bytes; 0 if they are no UTF-8
  char32_t point = 0;
};
/// Of a text that is not empty (Unicode 15, table 3-7).
[[nodiscard]] Utf8 first_character(std::string_view text);
/// Whether it is a control character, a line end, or turns the direction of writing.
[[nodiscard]] bool is_control(char32_t point);

}  // namespace eyrie
