// SPDX-License-Identifier: MIT
#include "model/rates.hpp"

#include <gtest/gtest.h>

namespace eyrie::model {
namespace {

TEST(RateProblems, NameEachModelWhoseRateDoesNotDivideTheStep) {
  Library library;
  Radar odd;
  odd.track_rate = 7;
  library.radars.add("good", {});
  library.radars.add("odd", odd);
  library.visuals.add("eyes", {});
  const auto problems = rate_problems(library, 0.02);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].kind, "radars");
  EXPECT_EQ(problems[0].model, "odd");
  EXPECT_EQ(problems[0].parameter, "track_rate");
  EXPECT_NE(problems[0].problem.find("7 Hz"), std::string::npos) << problems[0].problem;
}

}  // namespace
}  // namespace eyrie::model
