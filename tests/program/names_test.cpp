// SPDX-License-Identifier: MIT
/// \file  Hostile names: whatever a scenario calls itself and its parts, the run is made below
/// runs/, and what a terminal or another program would obey is refused with its place.
#include <gtest/gtest.h>

#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

using namespace std::string_literals;

TEST(NameOfARun, MakesAFolderBelowRunsWhateverItIs) {
  struct Case {
    const char *name, *folder;
  };
  for (const Case& c : {Case{"../../evil", "evil-1"}, Case{"/tmp/x", "tmp-x-1"},
                        Case{"..", "run-1"}, Case{"-rf", "rf-1"}, Case{".hidden", "hidden-1"},
                        Case{"鷹の巣", "run-1"}, Case{"4 v 2, night", "4-v-2-night-1"}}) {
    const TempFolder folder;
    folder.write("x.yaml", changed_scenario({{"name: small", "name: \""s + c.name + "\""}}));
    const Ran ran = run_program(folder, {"fly", "x.yaml", "--no-debrief", "--until", "1 s"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(ran.out.starts_with(c.name)) << "people see the name: " << ran.out;
    const auto all = folder.everything();
    EXPECT_EQ(all[0], "runs") << c.name;
    EXPECT_NE(std::find(all.begin(), all.end(), "runs/"s + c.folder), all.end()) << c.name;
    EXPECT_EQ(all.back(), "x.yaml");
    EXPECT_EQ(run_program(folder, {"replay", "runs/"s + c.folder}).code, 0);
  }
}

struct Bad {
  const char* name;
  std::string from, to;
  const char* expected;
};
void PrintTo(const Bad& b, std::ostream* out) {
  *out << b.name;
}
class BadNames : public testing::TestWithParam<Bad> {};

TEST_P(BadNames, AreRefusedWithTheirPlace) {
  const TempFolder folder;
  folder.write("x.yaml", changed_scenario({{GetParam().from, GetParam().to}}));
  for (const char* command : {"fly", "validate"}) {
    const Ran ran = run_program(folder, {command, "x.yaml"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(ran.err, GetParam().expected);
  }
  EXPECT_EQ(folder.everything(), std::vector<std::string>{"x.yaml"});
}

INSTANTIATE_TEST_SUITE_P(
    OfAFile, BadNames,
    testing::Values(
        Bad{"NewLine", "name: small", R"(name: "a\nb")",
            "x.yaml:2:7: name: 'a\\x0ab' holds a line break\n"},
        Bad{"Nul", "name: small", R"(name: "a\0b")",
            "x.yaml:2:7: name: 'a\\x00b' holds the control character U+0000\n"},
        Bad{"Escape", "name: small", R"(name: "\e[31mred")",
            "x.yaml:2:7: name: '\\x1b[31mred' holds the control character U+001B\n"},
        Bad{"C1", "name: small", R"(name: "\x9b31m")",
            "x.yaml:2:7: name: '\\xc2\\x9b31m' holds the control character U+009B\n"},
        Bad{"Bidi", "name: small", R"(name: "a\u202Eb")",
            "x.yaml:2:7: name: 'a\\xe2\\x80\\xaeb' holds the control character U+202E\n"},
        Bad{"Empty", "name: small", "name: ''", "x.yaml:2:7: name: expected a text, got ''\n"},
        Bad{"Blank", "name: small", "name: '  '", "x.yaml:2:7: name: expected a text, got '  '\n"},
        Bad{"Long", "name: small", "name: " + std::string(101, 'x'),
            "x.yaml:2:7: name: 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...' "
            "has 101 characters, at most 100 fit\n"},
        Bad{"Help", "name: small", R"(name: small
help: "\e]0;PWNED\a")",
            "x.yaml:3:7: help: '\\x1b]0;PWNED\\x07' holds the control character U+001B\n"},
        Bad{"Tree", "  cruise:\n", "  \"a\\nb\": navigate\n  cruise:\n",
            "x.yaml:7:3: trees: 'a\\x0ab' is no name: use letters, digits, '_', '-' and '.', a "
            "letter, a digit or '_' first, at most 64 in all\n"},
        Bad{"Label", "navigate: {", R"(navigate: {name: "a\nb", )",
            "x.yaml:10:26: name: 'a\\x0ab' holds a line break\n"},
        Bad{"Phase", "    winner_takes_all:",
            R"(    sequencer: {start: "p\n1", trees: {"p\n1": navigate}}
  other:
    winner_takes_all:)",
            "x.yaml:8:40: the name of a tree 'p\\x0a1' holds a line break\n"},
        Bad{"Flight", "    eagle:", "    \"eagle\\n\":",
            "x.yaml:14:5: 'eagle\\x0a' cannot name a flight: lower-case letters, digits and '_', "
            "with a letter first and no digit last, at most 40 in all\n"},
        Bad{"LongFlight", "    eagle:", "    eagleeagleeagleeagleeagleeagleeagleeagleeagle:",
            "x.yaml:14:5: 'eagleeagleeagleeagleeagleeagleeagleeagleeagle' cannot name a flight: "
            "lower-case letters, digits and '_', with a letter first and no digit last, at most 40 "
            "in all\n"},
        Bad{"Player", "[eagle1, eagle2]", "[eagle1, \"eagle2\\n\"]",
            "x.yaml:17:25: 'eagle2\\x0a' is not the flight's name and a rank, such as 'eagle1'\n"},
        Bad{"Model", "name: small", "name: small\ndata: {aircraft: {../x: {base: f15c}}}",
            "x.yaml:3:19: data.aircraft: '../x' is no name: use letters, digits, '_', '-' and '.', "
            "a letter, a digit or '_' first, at most 64 in all\n"},
        Bad{"ModelLabel", "name: small",
            "name: small\ndata: {aircraft: {x: {base: f15c, label: \"a\\eb\"}}}",
            "x.yaml:3:42: label: 'a\\x1bb' holds the control character U+001B\n"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(NameOfARun, IsCheckedWhenItIsSet) {
  const TempFolder folder;
  folder.write("x.yaml", kSmallScenario);
  EXPECT_EQ(run_program(folder, {"fly", "x.yaml", "--set", "name=\"a\\nb\""}).err,
            "--set name=\"a\\nb\":1:6: name: 'a\\x0ab' holds a line break\n");
  EXPECT_EQ(run_program(folder, {"fly", "x.yaml", "--set", "name=../../evil", "--no-debrief"}).code,
            0);
  EXPECT_TRUE(std::filesystem::is_directory(folder / "runs/evil-1"));
}

TEST(HelpOfARun, MayStandInABlock) {
  const TempFolder folder;
  folder.write("x.yaml",
               changed_scenario({{"name: small", "name: small\nhelp: >\n  two\n  lines"}}));
  EXPECT_EQ(run_program(folder, {"validate", "x.yaml"}).err, "");
}

}  // namespace
}  // namespace eyrie::test
