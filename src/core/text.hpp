// SPDX-License-Identifier: MIT
#pragma once
/// \file  Text from outside: made fit for a terminal, which obeys control characters, and what
/// names that machines use and text that people read may hold.
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace eyrie {

// Of ASCII alone, whatever the user's language is.
[[nodiscard]] constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
[[nodiscard]] constexpr bool is_small(char c) {
  return c >= 'a' && c <= 'z';
}
[[nodiscard]] constexpr bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}
[[nodiscard]] constexpr bool is_letter(char c) {
  return is_small(c) || is_capital(c);
}
[[nodiscard]] constexpr char to_small(char c) {
  return is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c;
}
[[nodiscard]] constexpr char to_capital(char c) {
  return is_small(c) ? static_cast<char>(c - 'a' + 'A') : c;
}
/// With small letters in place of capitals.
[[nodiscard]] std::string to_small(std::string text);

/// As XML writes it between tags.
[[nodiscard]] std::string xml_text(std::string_view text);

/// Without blanks and tabs around it.
[[nodiscard]] constexpr std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The number that a whole text is, without spaces and '+'; nothing if it is none or T cannot hold
/// it.
template <class T>
[[nodiscard]] std::optional<T> number_from(std::string_view text) {
  T number{};
  const char* const end = text.data() + text.size();
  const auto [stop, failed] = std::from_chars(text.data(), end, number);
  return failed == std::errc{} && stop == end ? std::optional(number) : std::nullopt;
}

/// At most `longest` characters of it and then "...", with \x1b-like escapes, byte by byte, for
/// what a terminal would obey or cannot show: control characters (C0, DEL, C1), the marks that turn
/// the direction of writing, the two Unicode line ends, and invalid UTF-8.
[[nodiscard]] std::string printable(std::string_view text,
                                    std::size_t longest = std::string_view::npos);
/// The same of every line of a text: line feeds stay.
[[nodiscard]] std::string printable_lines(std::string_view text);
/// The first character that looks like a blank, a hyphen or another one of ASCII and is none, as
/// what was copied from a page often holds; beside letters of ours also a Greek or Cyrillic one.
[[nodiscard]] std::optional<char32_t> look_alike(std::string_view text);

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

/// An identifier is what trees, models, flights and folders are called by: ASCII letters, digits
/// and '_', and inside '-' and '.'; it begins with a letter or a digit, or with '_'.
[[nodiscard]] bool is_identifier(std::string_view text);
inline constexpr std::size_t kLongestIdentifier = 64;
/// What is wrong with an identifier, in words, the text quoted; nothing if it is one.
[[nodiscard]] std::optional<std::string> identifier_problem(std::string_view text);

/// What keeps a text from being shown to people, in words: what printable() would escape. Nothing
/// if there is none.
[[nodiscard]] std::optional<std::string> text_problem(std::string_view text);
/// Of UTF-8; bytes that are none count one each.
[[nodiscard]] std::size_t characters(std::string_view text);

/// A name for a file or folder, made from any text: letters, digits, '.', '_' and '-' stay, any
/// others in a row become one '-'. It begins with a letter, a digit or '_', has at most
/// kLongestIdentifier bytes, and is never empty.
[[nodiscard]] std::string file_name_from(std::string_view text);

/// The text of a number, without the minus of one that was rounded to 0.
[[nodiscard]] std::string without_minus_zero(std::string number);
/// "1.6 MB", "52 kB" or "120 bytes".
[[nodiscard]] std::string size_text(std::uint64_t bytes);

/// RFC 4648, with padding and without line ends.
[[nodiscard]] std::string base64(std::string_view bytes);
/// What base64() made that text of; nothing if it is another one.
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);

}  // namespace eyrie
