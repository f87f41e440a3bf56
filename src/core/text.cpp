// SPDX-License-Identifier: MIT
#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace eyrie {
namespace {

struct Points {
  char32_t first, last;
};

template <std::size_t N>
bool is_in(const Points (&ranges)[N], char32_t point) {
  return std::any_of(std::begin(ranges), std::end(ranges),
                     [&](Points r) { return point >= r.first && point <= r.last; });
}

bool begins_identifier(char c) {
  return is_letter(c) || is_digit(c) || c == '_';
}
bool continues_identifier(char c) {
  return begins_identifier(c) || c == '-' || c == '.';
}

bool breaks_line(char32_t c) {
  return c == '\n' || c == '\r' || c == 0x85 || c == 0x2028 || c == 0x2029;
}

}  // namespace

std::string to_small(std::string text) {
  for (char& c : text)
    c = to_small(c);
  return text;
}

std::string xml_text(std::string_view text) {
  std::string result;
  for (const char c : text)
    result += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return result;
}

Utf8 first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) -> char32_t {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  const auto within = [&](std::size_t i, unsigned low, unsigned high) {
    return byte(i) >= low && byte(i) <= high;
  };
  const auto tail = [&](std::size_t i) { return byte(i) & 0x3F; };
  const char32_t first = byte(0);
  if (first < 0x80)
    return {1, first};
  if (within(0, 0xC2, 0xDF) && within(1, 0x80, 0xBF))
    return {2, (first & 0x1F) << 6 | tail(1)};
  if (within(0, 0xE0, 0xEF)) {
    const unsigned low = first == 0xE0 ? 0xA0 : 0x80;
    const unsigned high = first == 0xED ? 0x9F : 0xBF;
    if (within(1, low, high) && within(2, 0x80, 0xBF))
      return {3, (first & 0x0F) << 12 | tail(1) << 6 | tail(2)};
  }
  if (within(0, 0xF0, 0xF4)) {
    const unsigned low = first == 0xF0 ? 0x90 : 0x80;
    const unsigned high = first == 0xF4 ? 0x8F : 0xBF;
    if (within(1, low, high) && within(2, 0x80, 0xBF) && within(3, 0x80, 0xBF))
      return {4, (first & 0x07) << 18 | tail(1) << 12 | tail(2) << 6 | tail(3)};
  }
  return {};
}

bool is_control(char32_t point) {
  static constexpr Points kControls[] = {
      {0x00, 0x1F},     {0x7F, 0x9F},       // C0, DEL, C1
      {0x61C, 0x61C},   {0x200E, 0x200F},   // marks of direction (Unicode 15, UAX #9)
      {0x2028, 0x2029},                     // ends of a line and of a paragraph
      {0x202A, 0x202E}, {0x2066, 0x2069},   // embeddings, overrides and isolates
      {0xFEFF, 0xFEFF},                     // byte order mark
      {0xFFF9, 0xFFFB}, {0xE0000, 0xE007F}  // annotations and tags, which nobody sees
  };
  return is_in(kControls, point);
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string result;
  for (std::size_t characters = 0; !text.empty(); ++characters) {
    if (characters == longest)
      return result + "...";
    const Utf8 next = first_character(text);
    const std::size_t length = std::max<std::size_t>(next.length, 1);
    if (next.length == 0 || is_control(next.point)) {
      for (const char byte : text.substr(0, length))
        fmt::format_to(std::back_inserter(result), "\\x{:02x}", static_cast<unsigned char>(byte));
    } else {
      result += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return result;
}

std::optional<char32_t> look_alike(std::string_view text) {
  static constexpr Points kAlike[] = {{0xA0, 0xA0},     {0x2000, 0x200A}, {0x2010, 0x2013},
                                      {0x202F, 0x202F}, {0x205F, 0x205F}, {0x2212, 0x2212},
                                      {0x3000, 0x3000}};
  static constexpr Points kGreekAndCyrillic[] = {{0x370, 0x52F}};
  const bool has_ours = std::ranges::any_of(text, is_letter);
  while (!text.empty()) {
    const Utf8 next = first_character(text);
    if (next.length > 0 &&
        (is_in(kAlike, next.point) || (has_ours && is_in(kGreekAndCyrillic, next.point))))
      return next.point;
    text.remove_prefix(std::max<std::size_t>(next.length, 1));
  }
  return std::nullopt;
}

std::string printable_lines(std::string_view text) {
  std::string result;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    result += printable(text.substr(0, end)) + '\n';
    text.remove_prefix(end + 1);
  }
  return result + printable(text);
}

std::size_t columns(std::string_view text) {
  static constexpr Points kWide[] = {{0x1100, 0x115F},   {0x2329, 0x232A},   {0x2E80, 0x303E},
                                     {0x3040, 0xA4CF},   {0xAC00, 0xD7A3},   {0xF900, 0xFAFF},
                                     {0xFE10, 0xFE19},   {0xFE30, 0xFE6F},   {0xFF00, 0xFF60},
                                     {0xFFE0, 0xFFE6},   {0x1F300, 0x1F64F}, {0x1F900, 0x1F9FF},
                                     {0x20000, 0x2FFFD}, {0x30000, 0x3FFFD}};
  std::size_t sum = 0;
  while (!text.empty()) {
    const Utf8 next = first_character(text);
    sum += next.length && is_in(kWide, next.point) ? 2 : 1;
    text.remove_prefix(std::max<std::size_t>(next.length, 1));
  }
  return sum;
}

bool is_identifier(std::string_view text) {
  return !text.empty() && text.size() <= kLongestIdentifier && begins_identifier(text.front()) &&
         std::ranges::all_of(text, continues_identifier);
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
    text.remove_prefix(text[0] & 0x80 ? std::max<std::size_t>(first_character(text).length, 1) : 1);
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

std::string without_minus_zero(std::string number) {
  if (number.starts_with('-') && number.find_first_not_of("-0.") == number.npos)
    number.erase(0, 1);
  return number;
}

std::string size_text(std::uint64_t bytes) {
  const auto size = static_cast<double>(bytes);
  return bytes >= 1'000'000 ? fmt::format("{:.1f} MB", size / 1e6)
         : bytes >= 1'000   ? fmt::format("{:.0f} kB", size / 1e3)
                            : fmt::format("{} bytes", bytes);
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    const std::size_t there = bytes.size() - i < 3 ? bytes.size() - i : 3;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (k < there ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out.push_back(k <= there ? kDigits[three >> (18 - 6 * k) & 63] : '=');
  }
  return out;
}

std::optional<std::string> from_base64(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t digits = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const int digit = is_capital(c) ? c - 'A'
                      : is_small(c) ? c - 'a' + 26
                      : is_digit(c) ? c - '0' + 52
                      : c == '+'    ? 62
                      : c == '/'    ? 63
                                    : 0;
    digits = digits << 6 | static_cast<std::uint32_t>(digit);
    if (i % 4 == 3)
      for (const int shift : {16, 8, 0})
        bytes.push_back(static_cast<char>(digits >> shift & 255));
  }
  for (int i = 0; i < 2 && text.ends_with('=') && !bytes.empty(); ++i)
    if (text[text.size() - 1 - static_cast<std::size_t>(i)] == '=')
      bytes.pop_back();
  return base64(bytes) == text ? std::optional(std::move(bytes)) : std::nullopt;
}

}  // namespace eyrie
