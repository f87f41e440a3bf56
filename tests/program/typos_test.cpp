// SPDX-License-Identifier: MIT
/// \file  The wrong command lines of typos.txt, through the real program: each is answered with one
/// clear message that has the right word in it.
#include <gtest/gtest.h>

#include <sstream>

#include "support/program.hpp"

namespace eyrie::test {
namespace {

/// Words between spaces; '10 nmi' is one.
std::vector<std::string> typed_words(const std::string& line) {
  std::vector<std::string> words{""};
  bool quoted = false;
  for (const char c : line) {
    if (c == '\'')
      quoted = !quoted;
    else if (c != ' ' || quoted)
      words.back() += c;
    else if (!words.back().empty())
      words.emplace_back();
  }
  if (words.back().empty())
    words.pop_back();
  return words;
}

TEST(Typos, AreAnsweredWithTheRightWord) {
  const TempFolder folder;
  const Ran flown = run_program(
      folder, {"fly", "merge", "--until", "20 s", "--quiet", "--no-debrief", "--out", "run"});
  ASSERT_EQ(flown.code, 0) << flown.err;
  const auto before = folder.everything();
  std::istringstream lines(read_text("tests/program/typos.txt"));
  int tried = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t arrow = line.find(" => ");
    if (line.starts_with('#') || arrow == line.npos)
      continue;
    ++tried;
    const std::string right = line.substr(arrow + 4);
    const Ran ran = run_program(folder, typed_words(line.substr(0, arrow)));
    EXPECT_EQ(ran.code, 2) << line;
    EXPECT_EQ(ran.out, "") << line;
    EXPECT_NE(ran.err.find(right), std::string::npos) << line << "\n" << ran.err;
    EXPECT_EQ(ran.err.find("Usage"), std::string::npos) << line << "\n" << ran.err;
    const std::string first = ran.err.substr(0, ran.err.find('\n') + 1);
    const std::string rest = ran.err.substr(first.size());
    EXPECT_TRUE(rest.empty() ||
                (rest.starts_with("eyrie ") && rest.ends_with("--help says more\n")))
        << line << "\n"
        << ran.err;
  }
  EXPECT_GE(tried, 40);
  EXPECT_EQ(folder.everything(), before);
}

}  // namespace
}  // namespace eyrie::test
