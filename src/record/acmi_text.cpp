// SPDX-License-Identifier: MIT
#include "record/acmi_text.hpp"

#include <algorithm>

#include "core/printable.hpp"

namespace eyrie::record {
namespace {

std::string escaped(std::string_view text, std::string_view line_end, std::string_view bar) {
  std::string out;
  while (!text.empty()) {
    const Utf8 next = first_character(text);
    const std::size_t length = text.starts_with("\r\n") ? 2 : std::max<std::size_t>(next.length, 1);
    const char32_t c = length == 2 && next.length == 1 ? U'\n' : next.point;
    if (next.length == 0)
      out += "\xEF\xBF\xBD";
    else if (c == U'\n' || c == U'\r' || c == 0x85 || c == 0x2028 || c == 0x2029)
      out += line_end;
    else if (c == U'\t')
      out += ' ';
    else if (is_control(c))
      out += "\xEF\xBF\xBD";
    else if (c == U',')
      out += "\\,";
    else if (c == U'\\')
      out += "\xEF\xBC\xBC";
    else if (c == U'|')
      out += bar;
    else
      out += text.substr(0, length);
    text.remove_prefix(length);
  }
  return out;
}

}  // namespace

std::string acmi_text(std::string_view text) {
  return escaped(text, "\\\n", "|");
}

std::string acmi_name(std::string_view text) {
  return escaped(text, " ", "|");
}

std::string acmi_event_text(std::string_view text) {
  return escaped(text, " ", "\xEF\xBD\x9C");
}

}  // namespace eyrie::record
