// SPDX-License-Identifier: MIT
/// \file  What the program says of itself: help with examples that can be typed, completion, the
/// manual page.
#include <gtest/gtest.h>

#include <csignal>
#include <sstream>

#include "support/plugin.hpp"
#include "support/program.hpp"
#include "support/small_scenario.hpp"

namespace eyrie::test {
namespace {

using HelpLines = std::vector<std::string>;

HelpLines text_lines(const std::string& text) {
  HelpLines lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);)
    lines.push_back(line);
  return lines;
}

/// The commands that `eyrie --help` lists.
HelpLines listed_commands() {
  const TempFolder folder;
  HelpLines names;
  for (const std::string& line : text_lines(run_program(folder, {"--help"}).out))
    if (line.starts_with("  ") && line[2] != ' ' && !line.starts_with("  eyrie "))
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
  return names;
}

TEST(Help, HasTwoExamplesOfEachCommandThatCanBeTyped) {
  const HelpLines names = listed_commands();
  EXPECT_GE(names.size(), 18u);
  for (const std::string& name : names) {
    const TempFolder folder;
    folder.write("mine.yaml", kSmallScenario);
    folder.write("tactics.yaml",
                 "eyrie: 1\nname: tactics\nscenario: merge\nreplicates: 2\n"
                 "factors: {wvr: {path: until, values: [20 s, 40 s]}}\ndesign: full_factorial\n"
                 "measures: {losses: {what: losses, who: blue}}\n");
    folder.write("search.yaml",
                 "eyrie: 1\nname: search\nscenario: merge\nset: [until=20 s]\nreplicates: 2\n"
                 "factors: {until: {path: until, values: !uniform {low: 10 s, high: 20 s}}}\n"
                 "optimize: {measure: end, goal: minimize, generations: 1, population: 4, "
                 "proof: 4}\nmeasures: {end: {what: end_time}}\n");
    folder.write("build/libgreet.so", read_text(plugin("greet")));
    ASSERT_EQ(run_line(folder, "eyrie fly merge --quiet").code, 0);
    ASSERT_EQ(run_line(folder, "eyrie fly merge --seed 7 --quiet").code, 0);
    if (name == "report" || name == "query") {
      const Ran ran = run_line(folder, "eyrie campaign tactics.yaml");
      ASSERT_EQ(ran.code, 0) << ran.err;
    }
    const std::string help = run_program(folder, {name, "--help"}).out;
    EXPECT_EQ(help, run_program(folder, {"help", name}).out);
    for (const char* jargon : {"TEXT", "UINT", "Excludes", "POSITIONAL", "SUBCOMMAND", "{false}"})
      EXPECT_EQ(help.find(jargon), std::string::npos) << help;
    EXPECT_EQ(help.find(source_root()), std::string::npos) << help;
    const std::size_t begin = help.find("\nExamples\n");
    ASSERT_NE(begin, std::string::npos) << help;
    const HelpLines examples = text_lines(help.substr(begin + 10));
    EXPECT_GE(examples.size(), 2u);
    for (std::string example : examples) {
      if (name == "serve")  // which does not end, at a port that may be somebody's
        example = "timeout --preserve-status 2 \"$EYRIE\"" +
                  example.substr(example.find(" serve")) + " --port 0";
      const Ran ran = run_line(folder, example);
      const bool differ = name == "diff" && ran.code == 1;  // which is what diff shows
      const bool ended = name == "serve" && ran.code == 128 + SIGTERM;
      EXPECT_TRUE(ran.code == 0 || differ || ended) << example << ": " << ran.err;
    }
  }
}

/// What the shells are offered for the last of these words.
std::string offered(const TempFolder& folder, HelpLines words) {
  words.insert(words.begin(), {"completion", "--for"});
  const Ran ran = run_program(folder, words);
  EXPECT_EQ(ran.code, 0) << ran.err;
  return ran.out;
}

TEST(Completion, KnowsCommandsOptionsScenariosRunsAndPlayers) {
  const TempFolder folder;
  ASSERT_EQ(run_program(folder, {"fly", "merge", "--until", "5 s", "--no-debrief"}).code, 0);
  EXPECT_EQ(offered(folder, {"ex"}), "explain\nexport\n");
  EXPECT_EQ(offered(folder, {"fly", "dr"}), "drill\n");
  EXPECT_EQ(offered(folder, {"fly", "--see"}), "--seed\n--seeds\n");
  EXPECT_EQ(offered(folder, {"explain", "runs/"}), "runs/latest\nruns/merge-4\n");
  EXPECT_EQ(offered(folder, {"explain", "runs/latest", "--player", "v"}), "viper1\n");
  EXPECT_EQ(offered(folder, {"export", "runs/latest", "--to", "cz"}), "czml\n");
  EXPECT_EQ(offered(folder, {"catalog", "purs"}), "pursue\n");
  EXPECT_EQ(offered(folder, {"help", "fl"}), "fly\n");
  EXPECT_EQ(offered(folder, {"completion", "f"}), "fish\n");
  EXPECT_EQ(offered(folder, {"explain", "nowhere", "--player", ""}), "");
  EXPECT_EQ(offered(folder, {"nonsense", ""}), "");
}

TEST(Completion, WorksInBash) {
  const TempFolder folder;
  const Ran ran =
      run_line(folder, "eyrie completion bash >c && PATH=\"" +
                           std::filesystem::path(program_path()).parent_path().string() +
                           ":$PATH\" bash -c '. ./c; COMP_WORDS=(eyrie fly dr); COMP_CWORD=2; "
                           "_eyrie eyrie dr fly; echo \"${COMPREPLY[@]}\"'");
  EXPECT_EQ(ran.out, "drill\n") << ran.err;
}

TEST(Manual, HasEveryCommand) {
  const TempFolder folder;
  const std::string page = run_program(folder, {"completion", "man"}).out;
  EXPECT_TRUE(page.starts_with(".TH EYRIE 1\n"));
  for (const std::string& name : listed_commands())
    EXPECT_NE(page.find("\n.SS eyrie " + name + " "), std::string::npos) << name;
  for (const std::string& line : text_lines(page))
    EXPECT_FALSE(line.starts_with("'")) << line;
}

}  // namespace
}  // namespace eyrie::test
