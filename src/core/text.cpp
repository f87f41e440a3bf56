// SPDX-License-Identifier: MIT
#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "core/printable.hpp"

namespace eyrie {
namespace {

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}
bool begins_identifier(char c) {
  return is_letter_or_digit(c) || c == '_';
}
bool continues_identifier(char c) {
  return begins_identifier(c) || c == '-' || c == '.';
}

bool breaks_line(char32_t c) {
  return c == '\n' || c == '\r' || c == 0x85 || c == 0x2028 || c == 0x2029;
}
}  // namespace

bool is_identifier(std::string_view text) {
  return !text.empty() && text.size() <= kLongestIdentifier && begins_identifier(text.front()) &&
         std::all_of(text.begin(), text.end(), continues_identifier);
}

std::optional<std::string> identifier_problem(std::string_view text) {
  if (is_identifier(text))
    return std::nullopt;
  return fmt::format(
      "'{}' is no name: use letters, digits, '_', '-' and '.', a letter, a digit or "
      "'_' first, at most {} in all",
      printable(text, kLongestIdentifier - 4), kLongestIdentifier);
}

std::optional<std::string> text_problem(std::string_view text) {
  while (!text.empty()) {
    const Utf8 next = first_character(text);
    if (next.length == 0)
      return fmt::format("the byte {}, which is not UTF-8", printable(text.substr(0, 1)));
    if (breaks_line(next.point))
      return "a line break";
    if (is_control(next.point))
      return fmt::format("the control character U+{:04X}", static_cast<std::uint32_t>(next.point));
    text.remove_prefix(next.length);
  }
  return std::nullopt;
}

std::size_t characters(std::string_view text) {
  std::size_t count = 0;
  for (; !text.empty(); ++count)
    text.remove_prefix(std::max<std::size_t>(first_character(text).length, 1));
  return count;
}

std::string file_name_from(std::string_view text) {
  std::string name;
  for (const char c : text) {
    if (name.size() == kLongestIdentifier)
      break;
    if (name.empty() ? begins_identifier(c) : continues_identifier(c))
      name += c;
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (name.ends_with('-') || name.ends_with('.'))
    name.pop_back();
  return name.empty() ? "run" : name;
}

}  // namespace eyrie
