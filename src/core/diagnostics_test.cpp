// SPDX-License-Identifier: MIT
#include "core/diagnostics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace eyrie {
namespace {

Location at(int line, int column, std::string file = "sweep.yaml") {
  return {std::move(file), line, column};
}

TEST(Location, LeavesOutWhatIsUnknown) {
  EXPECT_EQ(at(14, 9).text(), "sweep.yaml:14:9");
  EXPECT_EQ(at(14, 0).text(), "sweep.yaml:14");
  EXPECT_EQ(at(0, 9).text(), "sweep.yaml");
  EXPECT_EQ(Location({"", 14, 9}).text(), "line 14:9");
  EXPECT_EQ(Location{}.text(), "");
}

TEST(Diagnostics, PrintsMistakesInTheOrderOfTheFileNotOfTheirDiscovery) {
  Diagnostics found;
  EXPECT_TRUE(found.ok());
  EXPECT_EQ(found.text(), "");
  found.error(at(15, 15), "vote: -4 is outside [0, 1000]");
  found.error(at(14, 9), "break_turn has no parameter 'danger_rang'");
  found.error(at(14, 2), "first on its line");
  EXPECT_FALSE(found.ok());
  EXPECT_EQ(found.text(),
            "sweep.yaml:14:2: first on its line\n"
            "sweep.yaml:14:9: break_turn has no parameter 'danger_rang'\n"
            "sweep.yaml:15:15: vote: -4 is outside [0, 1000]");
}

TEST(Diagnostics, KeepsFilesInTheOrderOfTheirFirstMistake) {
  Diagnostics found;
  found.error(at(9, 1, "z.yaml"), "z9");
  found.error(at(1, 1, "a.yaml"), "a1");
  found.error(at(2, 1, "z.yaml"), "z2");
  EXPECT_EQ(found.text(), "z.yaml:2:1: z2\nz.yaml:9:1: z9\na.yaml:1:1: a1");
}

TEST(Diagnostics, KeepsTheOrderOfReportingAtOnePlace) {
  Diagnostics found;
  found.error(at(1, 1), "b");
  found.error(at(1, 1), "a");
  EXPECT_EQ(found.text(), "sweep.yaml:1:1: b\nsweep.yaml:1:1: a");
}

TEST(Diagnostics, DropsDuplicatesEvenIfOthersOfThatPlaceStandBetween) {
  Diagnostics found;
  found.error(at(1, 1), "a");
  found.error(at(1, 1), "b");
  found.error(at(1, 1), "a");
  found.error(at(2, 1), "a");
  EXPECT_EQ(found.count(), 4u);
  EXPECT_EQ(found.text(), "sweep.yaml:1:1: a\nsweep.yaml:1:1: b\nsweep.yaml:2:1: a");
}

TEST(Diagnostics, PrintsSoManyAndCountsTheRest) {
  Diagnostics found;
  for (int line = 1; line <= 57; ++line)
    found.error(at(line, 1), "wrong");
  const std::string text = found.text();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 50);
  EXPECT_TRUE(text.ends_with("sweep.yaml:50:1: wrong\n... and 7 more"));
  EXPECT_EQ(found.text(0), "... and 57 more");
  EXPECT_TRUE(found.text(57).ends_with("sweep.yaml:57:1: wrong"));
}

TEST(Diagnostics, CountsNoRepeatsAsOthers) {
  Diagnostics found;
  for (int line = 1; line <= 1000; ++line)
    found.error(at(line, 1), "wrong");
  for (int i = 0; i < 5000; ++i)
    found.error(at(1, 1), "wrong");
  EXPECT_TRUE(found.text().ends_with("sweep.yaml:50:1: wrong\n... and 950 or more"));
}

TEST(Diagnostics, MergeAddsAllOfAnother) {
  Diagnostics a, b;
  a.error(at(2, 1), "a");
  b.error(at(1, 1), "b");
  a.merge(b);
  EXPECT_EQ(a.text(), "sweep.yaml:1:1: b\nsweep.yaml:2:1: a");
  a.merge(a);
  EXPECT_EQ(a.count(), 4u);
}

RC_GTEST_PROP(Diagnostics, SortedIsOrderedWithoutDuplicatesAndLosesNothing, ()) {
  Diagnostics found;
  std::vector<Diagnostic> reported;
  for (int i = *rc::gen::inRange(0, 40); i > 0; --i) {
    const Diagnostic d{at(*rc::gen::inRange(0, 4), *rc::gen::inRange(0, 3)),
                       std::string(1, *rc::gen::elementOf(std::string("ab")))};
    reported.push_back(d);
    found.error(d.where, d.message);
  }
  const std::vector<Diagnostic> sorted = found.sorted();
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    RC_ASSERT(std::pair(sorted[i - 1].where.line, sorted[i - 1].where.column) <=
              std::pair(sorted[i].where.line, sorted[i].where.column));
    RC_ASSERT(std::count(sorted.begin(), sorted.end(), sorted[i]) == 1);
  }
  for (const Diagnostic& d : reported)
    RC_ASSERT(std::find(sorted.begin(), sorted.end(), d) != sorted.end());
}

TEST(ConfigError, SaysAllItsDiagnostics) {
  Diagnostics found;
  found.error(at(2, 1), "b");
  found.error(at(1, 1), "a");
  const ConfigError error(found);
  EXPECT_STREQ(error.what(), "sweep.yaml:1:1: a\nsweep.yaml:2:1: b");
  EXPECT_EQ(error.diagnostics().count(), 2u);
  EXPECT_STREQ(ConfigError(at(3, 4), "one").what(), "sweep.yaml:3:4: one");
}

constexpr std::array<std::string_view, 6> kNames{"danger_range", "vote", "mode",
                                                 "altitude",     "x",    "weight"};

TEST(DidYouMean, NamesTheNearest) {
  const auto hint = [](std::string_view wrong) { return did_you_mean(wrong, kNames); };
  EXPECT_EQ(hint("danger_rang"), "; did you mean 'danger_range'?");
  EXPECT_EQ(hint("DANGER_RANGE"), "; did you mean 'danger_range'?");
  EXPECT_EQ(hint("dagner-range"), "; did you mean 'danger_range'?");
  EXPECT_EQ(hint("voet"), "; did you mean 'vote'?");  // a swap is one edit
  EXPECT_EQ(hint("vo"), "");                          // two edits are half of the name
  EXPECT_EQ(hint("heading"), "");
  EXPECT_EQ(hint("y"), "");  // one edit would replace all of 'x'
  EXPECT_EQ(hint("X"), "; did you mean 'x'?");
  EXPECT_EQ(hint(""), "");
  EXPECT_EQ(hint(std::string(1000, 'v')), "");
}

TEST(NearestOrAll, ListsWhatIsReadAtAGlance) {
  EXPECT_EQ(nearest_or_all("voet", kNames), "; did you mean 'vote'?");
  EXPECT_EQ(nearest_or_all("heading", kNames),
            ", only danger_range, vote, mode, altitude, x, weight");
  EXPECT_EQ(nearest_or_all("a", std::vector<std::string>{}), "");
  EXPECT_EQ(nearest_or_all("a", std::vector<std::string>(30, "danger")), ", only danger");
  EXPECT_EQ(nearest_or_all("a", std::vector<std::string>{std::string(300, 'x')}), "");
}

TEST(DidYouMean, NamesTheOnlyOneOfTheseWords) {
  const std::vector<std::string> names{"winner_takes_all", "latin_hypercube", "one_of", "one_by"};
  EXPECT_EQ(did_you_mean("latin", names), "; did you mean 'latin_hypercube'?");
  EXPECT_EQ(did_you_mean("takes_all", names), "; did you mean 'winner_takes_all'?");
  EXPECT_EQ(did_you_mean("one", names), "") << "of two";
  EXPECT_EQ(did_you_mean("hyper", names), "") << "no whole word";
}

TEST(DidYouMean, PrefersOfTwoEquallyNearTheOneThatBeginsAlikeThenTheEarlier) {
  EXPECT_EQ(did_you_mean("line", std::vector<std::string>{"lane", "line", "lone"}),
            "; did you mean 'line'?");
  EXPECT_EQ(did_you_mean("lane", std::vector<std::string>{"line", "lone"}),
            "; did you mean 'line'?");
  const std::vector<std::string> eagles{"eagle1", "eagle2"};
  EXPECT_EQ(did_you_mean("rang", std::vector<std::string>{"rank", "range"}),
            "; did you mean 'range'?");
  EXPECT_EQ(did_you_mean("Eagle1", eagles), "; did you mean 'eagle1'?");
  EXPECT_EQ(did_you_mean("Eagle1", std::vector<std::string>{"eagle1", "eagle2", "Eagle1"}),
            "; did you mean 'Eagle1'?");
}

RC_GTEST_PROP(DidYouMean, FindsANameAfterAnySingleEdit, ()) {
  const std::string name(*rc::gen::elementOf(
      std::vector<std::string_view>{"danger_range", "vote", "mode", "altitude", "weight"}));
  std::string wrong = name;
  const auto i = *rc::gen::inRange<std::size_t>(0, name.size());
  switch (*rc::gen::inRange(0, 5)) {
    case 0:
      wrong.erase(i, 1);
      break;
    case 1:
      wrong.insert(i, 1, 'q');
      break;
    case 2:
      wrong[i] = 'q';
      break;
    case 3:
      if (i + 1 < wrong.size())
        std::swap(wrong[i], wrong[i + 1]);
      break;
    default:
      wrong[i] = static_cast<char>(std::toupper(wrong[i]));
  }
  RC_ASSERT(did_you_mean(wrong, kNames) == "; did you mean '" + name + "'?");
}

TEST(Quote, EscapesWhatATerminalWouldObey) {
  EXPECT_EQ(quote("2 nmi"), "'2 nmi'");
  EXPECT_EQ(quote(""), "''");
  EXPECT_EQ(quote("\x1b[31m\n"), R"('\x1b[31m\x0a')");
  EXPECT_EQ(quote(std::string_view("a\0b", 3)), R"('a\x00b')");
  EXPECT_EQ(quote("30\xC2\xB0"), "'30\xC2\xB0'");              // degree sign
  EXPECT_EQ(quote("\xC2\x9B"), R"('\xc2\x9b')");               // C1 control: CSI
  EXPECT_EQ(quote("\xF0\x9F\x9B\xA9"), "'\xF0\x9F\x9B\xA9'");  // U+1F6E9
}

TEST(Quote, EscapesWhatIsNotUtf8) {
  EXPECT_EQ(quote("\xff"), R"('\xff')");
  EXPECT_EQ(quote("\xC2"), R"('\xc2')");                          // cut short
  EXPECT_EQ(quote("\xC0\xAF"), R"('\xc0\xaf')");                  // overlong
  EXPECT_EQ(quote("\xE0\x80\x80"), R"('\xe0\x80\x80')");          // overlong
  EXPECT_EQ(quote("\xED\xA0\x80"), R"('\xed\xa0\x80')");          // surrogate
  EXPECT_EQ(quote("\xF4\x90\x80\x80"), R"('\xf4\x90\x80\x80')");  // beyond U+10FFFF
}

TEST(Quote, CutsLongTextsBetweenCharacters) {
  EXPECT_EQ(quote(std::string(60, 'a')), "'" + std::string(60, 'a') + "'");
  EXPECT_EQ(quote(std::string(61, 'a')), "'" + std::string(60, 'a') + "...'");
}

TEST(Diagnostics, PrintsNothingThatATerminalWouldObey) {
  Diagnostics d;
  d.error({"a\x1b[2J.yaml", 3, 1}, "there is no 'x'; did you mean '\x07\xff\xc3\xa9'?");
  EXPECT_EQ(d.text(), "a\\x1b[2J.yaml:3:1: there is no 'x'; did you mean '\\x07\\xff\xc3\xa9'?");
}

}  // namespace
}  // namespace eyrie
