// SPDX-License-Identifier: MIT
#include "record/event_table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/text.hpp"

namespace eyrie::record {
namespace {

TEST(CsvText, IsWrittenAsItIsWhereNothingForbids) {
  for (const char* text : {"", "eagle1", "root/bvr/pursue", "a b", "x=1", "\xC3\xA9"})
    EXPECT_EQ(csv_text(text), text);
}

TEST(CsvText, IsQuotedWhereTheFormatAsksForIt) {
  EXPECT_EQ(csv_text("a,b"), R"("a,b")");
  EXPECT_EQ(csv_text(R"(say "no")"), R"("say ""no""")");
  EXPECT_EQ(csv_text("a;b"), R"("a;b")") << "a separator in half of Europe";
  EXPECT_EQ(csv_quoted("route"), R"("route")");
}

TEST(CsvText, IsNoFormula) {
  EXPECT_EQ(csv_text("=HYPERLINK(1)"), "'=HYPERLINK(1)");
  EXPECT_EQ(csv_text("=A(1,2)"), "\"'=A(1,2)\"");
  for (const char* text : {"+1", "-1", "@SUM", "  =1",
                           "\xEF\xBC\x9D"
                           "1"})
    EXPECT_EQ(csv_text(text), "'" + std::string(text));
  EXPECT_EQ(csv_quoted("=1"), "\"'=1\"");
}

TEST(CsvText, IsOneLineOfUtf8) {
  EXPECT_EQ(csv_text("a\r\nb\tc"), R"(a\x0d\x0ab\x09c)");
  EXPECT_EQ(csv_text(std::string_view("\0\xff\x1b[2J", 6)), R"(\x00\xff\x1b[2J)");
}

RC_GTEST_PROP(CsvText, IsReadBackAsWhatATerminalShows, (const std::string& text)) {
  const std::string cell = csv_quoted(text);
  RC_ASSERT(printable(cell) == cell);
  std::string back;
  for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
    back += cell[i];
    if (cell[i] == '"')
      RC_ASSERT(cell[++i] == '"');
  }
  RC_ASSERT(back == printable(text) || back == '\'' + printable(text));
}

}  // namespace
}  // namespace eyrie::record
