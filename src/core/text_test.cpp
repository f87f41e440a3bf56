// SPDX-License-Identifier: MIT
#include "core/text.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "core/diagnostics.hpp"

namespace eyrie {
namespace {

using namespace std::string_literals;

struct Named {
  std::string text, folder;
};

/// Every one was a folder outside runs/, a surprise for a shell, or bytes that a terminal obeys.
const std::vector<Named> kHostile{
    {"sweep", "sweep"},
    {"Sweep 4v2", "Sweep-4v2"},
    {"", "run"},
    {".", "run"},
    {"..", "run"},
    {"../../evil", "evil"},
    {"/etc/passwd", "etc-passwd"},
    {"-rf", "rf"},
    {"--out", "out"},
    {".hidden", "hidden"},
    {"a/../b", "a-..-b"},
    {"a\\b", "a-b"},
    {"a\nb", "a-b"},
    {"a\0b"s, "a-b"},
    {"\x1b[31mred", "31mred"},
    {"~", "run"},
    {"$(reboot)", "reboot"},
    {"a b\tc", "a-b-c"},
    {"trailing. ", "trailing"},
    {"ends...", "ends"},
    {"übung", "bung"},
    {"鷹", "run"},
    {"\xff\xfe", "run"},
    {"_", "_"},
    {std::string(100'000, 'x'), std::string(64, 'x')},
    {std::string(63, 'x') + "/y", std::string(63, 'x')},
};

TEST(FolderOfAName, IsACheckedIdentifierWhateverTheNameIs) {
  for (const Named& one : kHostile)
    EXPECT_EQ(file_name_from(one.text), one.folder) << printable(one.text, 80);
}

TEST(FolderOfAName, HoldsForRandomBytes) {
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    std::string text(random() % 100, '\0');
    for (char& c : text)
      c = static_cast<char>(random() % 4 ? random() % 256 : "./-~\\ "[random() % 6]);
    const std::string name = file_name_from(text);
    ASSERT_TRUE(is_identifier(name)) << printable(text, 200);
    ASSERT_EQ(file_name_from(name), name);
  }
}

TEST(Identifier, IsLettersDigitsAndThreeSigns) {
  for (const char* good : {"a", "f15c", "R-77", "_x", "1l121", "aim9.m", "a_b-c.d"}) {
    EXPECT_TRUE(is_identifier(good)) << good;
    EXPECT_EQ(identifier_problem(good), std::nullopt);
  }
  for (const std::string& bad : {""s, "-x"s, ".x"s, ".."s, "a b"s, "a/b"s, "a:b"s, "ä"s, "a\n"s,
                                 "a\0"s, std::string(65, 'a')})
    EXPECT_FALSE(is_identifier(bad)) << printable(bad, 80);
  EXPECT_EQ(identifier_problem("../x"),
            "'../x' is no name: use letters, digits, '_', '-' and '.', a letter, a digit or '_' "
            "first, at most 64 in all");
}

TEST(TextForPeople, SaysWhatItMustNotHold) {
  EXPECT_EQ(text_problem(""), std::nullopt);
  EXPECT_EQ(text_problem("Übung 4, 鷹 \U0001F985 <b>'\"\\"), std::nullopt);
  EXPECT_EQ(text_problem("a\nb"), "a line break");
  EXPECT_EQ(text_problem("a\rb"), "a line break");
  EXPECT_EQ(text_problem("a\u2028b"), "a line break");
  EXPECT_EQ(text_problem("a\0b"s), "the control character U+0000");
  EXPECT_EQ(text_problem("a\x1b[31m"), "the control character U+001B");
  EXPECT_EQ(text_problem("a\x7f"), "the control character U+007F");
  EXPECT_EQ(text_problem("a\u009b"), "the control character U+009B");
  EXPECT_EQ(text_problem("a\xff"), "the byte \\xff, which is not UTF-8");
  EXPECT_EQ(text_problem("\xed\xa0\x80"), "the byte \\xed, which is not UTF-8");  // a surrogate
  EXPECT_EQ(text_problem("a\u202Eb"), "the control character U+202E");
  EXPECT_EQ(text_problem("a\u2066b"), "the control character U+2066");
}

TEST(TextForPeople, NamesWhatOnlyLooksLikeABlankOrAMinus) {
  EXPECT_EQ(quote("10\u00a0min"), "'10\u00a0min' (with the character U+00A0)");
  EXPECT_EQ(quote("\u221268 deg"), "'\u221268 deg' (with the character U+2212)");
  EXPECT_EQ(quote("10 min, -68\u00b0, \u00e9"), "'10 min, -68\u00b0, \u00e9'");
}

TEST(TextForPeople, IsCountedInCharacters) {
  EXPECT_EQ(characters(""), 0u);
  EXPECT_EQ(characters("aä鷹\U0001F985"), 4u);
  EXPECT_EQ(characters("a\xff\xff"), 3u);
}

TEST(Printable, LeavesWhatPeopleWrite) {
  for (const char* text : {"", "eagle1", "30\xC2\xB0 \xC2\xB1 2", "\xE9\xB7\xB2 \xF0\x9F\x9B\xA9",
                           "C:\\x1b 'quoted' \"twice\""}) {
    EXPECT_EQ(printable(text), text);
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
  RC_ASSERT(printable(shown) == shown);
}

TEST(Numbers, HaveNoMinusAsZeroAndSizesAUnit) {
  EXPECT_EQ(without_minus_zero("-0.00"), "0.00");
  EXPECT_EQ(without_minus_zero("-0"), "0");
  EXPECT_EQ(without_minus_zero("-0.01"), "-0.01");
  EXPECT_EQ(without_minus_zero("0.00"), "0.00");
  EXPECT_EQ(size_text(999), "999 bytes");
  EXPECT_EQ(size_text(51'600), "52 kB");
  EXPECT_EQ(size_text(1'550'000), "1.6 MB");
}

TEST(Base64, IsThatOfRfc4648) {  // section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  for (const char* text : {"", "f", "fo", "foobar"})
    EXPECT_EQ(from_base64(base64(text)), text);
  for (const char* none : {"Zg", "Zg=", "Zh==", "Zm9v?mFy", "====", "Zg==Zg=="})
    EXPECT_FALSE(from_base64(none)) << none;
}

}  // namespace
}  // namespace eyrie
