// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace eyrie::record {

/// A text as a cell of a CSV file (RFC 4180). Control characters and invalid UTF-8 become
/// \x1b-like escapes, so that a row is a line. A text that a spreadsheet would take for a formula,
/// as it begins with = + - @ (also full-width, also behind blanks), gets a ' in front.
[[nodiscard]] std::string csv_text(std::string_view text);
/// The same, always in quotes: a text where other rows have a number.
[[nodiscard]] std::string csv_quoted(std::string_view text);

}  // namespace eyrie::record
