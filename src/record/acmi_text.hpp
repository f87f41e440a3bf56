// SPDX-License-Identifier: MIT
#pragma once
/// \file  Texts as values of a Tacview ACMI 2.2 file. The published rules escape the comma and, in
/// free text, the line end, both by a backslash; they have no escape for the backslash itself, nor
/// for the bar between the parts of an event, and readers that do not know the rule for line ends
/// are common. So whatever could be taken for more than text is written as its look-alike:
/// a backslash as U+FF3C, a bar of an event as U+FF5C, any other control character as U+FFFD.
#include <string>
#include <string_view>

namespace eyrie::record {

/// Free text of several lines, such as Comments: their ends are escaped.
[[nodiscard]] std::string acmi_text(std::string_view text);
/// A name, of one line: line ends are blanks.
[[nodiscard]] std::string acmi_name(std::string_view text);
/// A part of an event, of one line.
[[nodiscard]] std::string acmi_event_text(std::string_view text);

}  // namespace eyrie::record
