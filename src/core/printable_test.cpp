// SPDX-License-Identifier: MIT
#include "core/printable.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace eyrie {
namespace {

TEST(Printable, LeavesWhatPeopleWrite) {
  for (const char* text : {"", "eagle1", "30\xC2\xB0 \xC2\xB1 2", "\xE9\xB7\xB2 \xF0\x9F\x9B\xA9",
                           "C:\\x1b 'quoted' \"twice\""}) {
    EXPECT_EQ(printable(text), text);
    EXPECT_TRUE(is_printable(text)) << text;
  }
}

TEST(Printable, EscapesWhatATerminalObeys) {
  EXPECT_EQ(printable("\x1b]0;PWNED\a\x1b[2J\r\n\t"), R"(\x1b]0;PWNED\x07\x1b[2J\x0d\x0a\x09)");
  EXPECT_EQ(printable(std::string_view("a\0b\x7f", 4)), R"(a\x00b\x7f)");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J"),
            R"(\xc2\x9b2J)")
      << "CSI in one character";
  EXPECT_EQ(printable("\xE2\x80\xAE"
                      "evil"),
            R"(\xe2\x80\xaeevil)")
      << "from right to left";
  EXPECT_EQ(printable("a\xE2\x80\xA8"
                      "b"),
            R"(a\xe2\x80\xa8b)")
      << "a line end";
  EXPECT_EQ(printable("\xff\xC3\xA9"), "\\xff\xC3\xA9");
}

TEST(Printable, KeepsTheLinesOfATextWhereTheyAreWanted) {
  EXPECT_EQ(printable_lines("a\n\x1b[2J\n"), "a\n\\x1b[2J\n");
  EXPECT_EQ(printable_lines("\n\nb\r"), "\n\nb\\x0d");
}

TEST(Printable, CountsColumnsAsPaddingDoes) {
  for (const std::string text : {"", "eagle1", "\xC3\xA9t\xC3\xA9", "\xE9\xB7\xB2\xE9\xB7\xB2",
                                 "\xF0\x9F\x98\x80!", "\xEF\xBC\xA1\xEF\xBC\xA2"})
    EXPECT_EQ(fmt::format("{:<12}|", text), text + std::string(12 - columns(text), ' ') + '|');
}

RC_GTEST_PROP(Printable, NeverHoldsWhatATerminalObeys, (const std::string& bytes)) {
  const std::string shown = printable(bytes);
  RC_ASSERT(is_printable(shown));
  RC_ASSERT(printable(shown) == shown);
  RC_ASSERT(is_printable(bytes) == (shown == bytes));
  RC_ASSERT(valid_utf8(valid_utf8(bytes)) == valid_utf8(bytes));
}

}  // namespace
}  // namespace eyrie
