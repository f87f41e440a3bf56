// SPDX-License-Identifier: MIT
#include "record/acmi_object.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/printable.hpp"

namespace eyrie::record {
namespace {

TEST(AcmiText, EscapesAsTheFormatAsks) {
  EXPECT_EQ(acmi_text("four F-15s, on sensors"), "four F-15s\\, on sensors");
  EXPECT_EQ(acmi_text("one\ntwo\r\nthree"), "one\\\ntwo\\\nthree");
  EXPECT_EQ(acmi_text("a|b = c"), "a|b = c") << "nothing else is an escape";
}

TEST(AcmiText, HasNoBackslashThatAReaderCouldTakeForAnEscape) {
  EXPECT_EQ(acmi_text("C:\\data\\"),
            "C:\xEF\xBC\xBC"
            "data\xEF\xBC\xBC");
  EXPECT_EQ(acmi_text("\\,"), "\xEF\xBC\xBC\\,");
}

TEST(AcmiText, IsOneLineWhereItIsAName) {
  EXPECT_EQ(acmi_name("a\nb\rc\r\nd\xC2\x85"
                      "e\xE2\x80\xA8"
                      "f"),
            "a b c d e f");
  EXPECT_EQ(acmi_event_text("x\n-1"), "x -1");
}

TEST(AcmiText, IsOnePartOfAnEvent) {
  EXPECT_EQ(acmi_event_text("a|2|b"),
            "a\xEF\xBD\x9C"
            "2\xEF\xBD\x9C"
            "b");
}

TEST(AcmiText, HoldsNeitherControlCharactersNorBytesThatAreNoText) {
  EXPECT_EQ(acmi_text("a\tb\x1b[2J\xff"), "a b\xEF\xBF\xBD[2J\xEF\xBF\xBD");
}

/// Whatever a reader makes of backslashes: it looks at the character before, or takes two as one.
RC_GTEST_PROP(AcmiText, EndsNeitherItsValueNorItsLine, (const std::string& text)) {
  for (const std::string& value : {acmi_name(text), acmi_event_text(text)}) {
    RC_ASSERT(is_printable(value));
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (value[i] == ',')
        RC_ASSERT(i > 0 && value[i - 1] == '\\' && (i < 2 || value[i - 2] != '\\'));
      if (value[i] == '\\')
        RC_ASSERT(i + 1 < value.size() && value[i + 1] == ',');
    }
  }
  RC_ASSERT(acmi_event_text(text).find('|') == std::string::npos);
}

}  // namespace
}  // namespace eyrie::record
