// SPDX-License-Identifier: MIT
#include "debrief/health.hpp"

#include <gtest/gtest.h>

namespace eyrie::debrief {
namespace {

TEST(Steadiness, CountsReversalsOfTheBankAndWhatOfATurnIsLeft) {
  Steadiness weaving, turning, level;
  for (int i = 0; i <= 1200; ++i) {  // two minutes, a weave of 20 s with 30 degrees of bank
    const double time = 0.1 * i, phase = 2 * 3.14159265358979 * time / 20;
    weaving.sample(time, 0.2 * (1 - std::cos(phase)), si(30, "deg") * std::sin(phase));
    turning.sample(time, wrap_pi(0.02 * time), si(30, "deg"));
    level.sample(time, 1, si(9, "deg") * std::sin(phase));
  }
  for (Steadiness* all : {&weaving, &turning, &level})
    all->stop();
  EXPECT_EQ(weaving.reversals(), 11U) << "6 periods, the last one ends level";
  EXPECT_NEAR(weaving.turned(), 12 * 0.4, 0.02);
  EXPECT_LT(weaving.gained(), 0.01);
  EXPECT_EQ(turning.reversals(), 0U);
  EXPECT_NEAR(turning.gained(), turning.turned(), 0.003);
  EXPECT_EQ(level.reversals(), 0U) << "nobody is level to a degree";
  EXPECT_EQ(level.samples(), 1201U);
}

TEST(Steadiness, ForgetsWhatWasNotWatched) {
  Steadiness pursuit;
  pursuit.sample(0, 0, 0);
  pursuit.stop();
  pursuit.sample(30, 3, 0);
  pursuit.stop();
  EXPECT_EQ(pursuit.turned(), 0);
  EXPECT_EQ(pursuit.gained(), 0);
}

}  // namespace
}  // namespace eyrie::debrief
