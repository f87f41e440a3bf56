// SPDX-License-Identifier: MIT
#include "model/sensor/iff.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace eyrie::model {
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

TEST(Conclude, AReplyMakesAFriend) {
  Track track{.unanswered = 2};
  conclude(track, 3, true);
  EXPECT_EQ(track.identity, Identity::friendly);
}

TEST(Conclude, SilenceToSoManyInterrogationsMakesAHostile) {
  Track track;
  conclude(track, 3, false);
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::unknown);
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::hostile);
}

TEST(Conclude, ZeroTriesNeverDeclareAnyoneHostile) {
  Track track;
  for (int i = 0; i < 1000; ++i)
    conclude(track, 0, false);
  EXPECT_EQ(track.identity, Identity::unknown);
  EXPECT_EQ(track.unanswered, 255);
}

TEST(Conclude, MakesAFriendOfAHostileThatReplies) {
  Track track{.identity = Identity::hostile};
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::hostile);
  conclude(track, 3, true);
  EXPECT_EQ(track.identity, Identity::friendly);
}

TEST(Conclude, AsksAFriendThatFallsSilentAnew) {
  Track track{.identity = Identity::friendly};
  conclude(track, 3, false);
  conclude(track, 3, true);
  conclude(track, 3, false);
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::friendly) << "not three in a row";
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::unknown) << "perhaps it is somebody else by now";
  conclude(track, 3, false);
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::unknown);
  conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::hostile);
  for (int i = 0; i < 9; ++i)
    conclude(track, 3, false);
  EXPECT_EQ(track.identity, Identity::hostile);
}

}  // namespace
}  // namespace eyrie::model
