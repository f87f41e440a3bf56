// SPDX-License-Identifier: MIT
#include "record/csv.hpp"

#include <algorithm>

#include "core/printable.hpp"

namespace eyrie::record {
namespace {

/// OWASP, "CSV injection" (2024); tabs and carriage returns are escapes already.
bool is_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  constexpr std::u32string_view kBegin = U"=+-@\uFF1D\uFF0B\uFF0D\uFF20";
  return !text.empty() && kBegin.find(first_character(text).point) != kBegin.npos;
}

std::string harmless(std::string_view text) {
  const std::string shown = printable(text);
  return is_formula(shown) ? '\'' + shown : shown;
}

std::string in_quotes(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text)
    quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

}  // namespace

std::string csv_text(std::string_view text) {
  std::string cell = harmless(text);
  return cell.find_first_of(",\";") == cell.npos ? cell : in_quotes(cell);
}

std::string csv_quoted(std::string_view text) {
  return in_quotes(harmless(text));
}

}  // namespace eyrie::record
