// SPDX-License-Identifier: MIT
#include "core/assert.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace eyrie {
namespace {

TEST(Assert, PassesInSilence) {
  EYRIE_ASSERT(1 + 1 == 2);
  EYRIE_DEMAND(1 + 1 == 2, "arithmetic");
  EXPECT_NO_THROW(EYRIE_THROW_UNLESS(1 + 1 == 2, "arithmetic"));
}

TEST(AssertDeathTest, DemandAbortsInEveryBuildAndSaysWhere) {
  EXPECT_DEATH(EYRIE_DEMAND(1 > 2, "rows stay in spawn order"),
               "^src/core/assert_test\\.cpp:[0-9]+: rows stay in spawn order \\(1 > 2\\)\n$");
}

TEST(AssertDeathTest, AssertAbortsWhereItIsEnabledAndElseIsNotEvaluated) {
#if EYRIE_ASSERT_ENABLED
  EXPECT_DEATH(EYRIE_ASSERT(1 > 2), "^src/core/assert_test\\.cpp:[0-9]+: assertion \\(1 > 2\\)");
#else
  bool evaluated = false;
  EYRIE_ASSERT(evaluated = true);
  EXPECT_FALSE(evaluated);
#endif
}

TEST(Assert, MisuseThrowsWithThePlace) {
  try {
    EYRIE_THROW_UNLESS(1 > 2, "an executor has 1 to 256 workers");
    FAIL() << "did not throw";
  } catch (const std::logic_error& error) {
    const std::string text = error.what();
    EXPECT_TRUE(text.starts_with("src/core/assert_test.cpp:")) << text;
    EXPECT_TRUE(text.ends_with(": an executor has 1 to 256 workers (1 > 2)")) << text;
  }
}

TEST(Assert, IsOneStatement) {
  if (false)
    EYRIE_DEMAND(false, "not reached");
  else
    EYRIE_THROW_UNLESS(true, "fine");
}

}  // namespace
}  // namespace eyrie
