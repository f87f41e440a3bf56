// SPDX-License-Identifier: MIT
#include "model/sensor/iff.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace eyrie::model::sensor {
namespace {

TEST(Iff, FriendsAnswerAsOftenAsTheySayAndOthersNever) {
  const Iff iff{.reply_probability = 0.9};
  int friends = 0;
  constexpr int kAsked = 20000;
  for (int i = 0; i < kAsked; ++i) {
    const Draw draw(1, PlayerId{1}, Stream::iff, static_cast<std::uint64_t>(i));
    friends += answers(iff, Side::blue, Side::blue, draw);
    EXPECT_FALSE(answers(iff, Side::blue, Side::red, draw));
    EXPECT_FALSE(answers(iff, Side::none, Side::none, draw));
  }
  EXPECT_NEAR(friends / double(kAsked), 0.9, 4 * std::sqrt(0.9 * 0.1 / kAsked));
}

}  // namespace
}  // namespace eyrie::model::sensor
