// SPDX-License-Identifier: MIT
/// \file  `eyrie diff` as a user has it.
#include <gtest/gtest.h>

#include <regex>

#include "support/program.hpp"

namespace eyrie::test {
namespace {

TEST(DiffProgram, WritesValuesOfEventsInTheUnitsAskedFor) {
  const TempFolder folder;
  for (const char* seed : {"7", "13"})
    ASSERT_EQ(run_program(folder, {"fly", "sweep", "--until", "1 s", "--quiet", "--no-debrief",
                                   "--seed", seed, "--out", seed})
                  .code,
              0);
  const auto has = [](const std::string& text, const char* pattern) {
    return std::regex_search(text, std::regex(pattern));
  };
  const auto event = [&](const char* units) {
    const std::string words = run_program(folder, {"diff", "7", "13", "--units", units}).out;
    return words.substr(words.find("\nevent "));
  };
  EXPECT_TRUE(has(event("us"), R"( range \S+ (nmi|ft); and [^;]+ range \S+ \1 in the other)"));
  EXPECT_TRUE(has(event("metric"), R"( range \S+ (k?m); and [^;]+ range \S+ \1 in the other)"));
}

}  // namespace
}  // namespace eyrie::test
