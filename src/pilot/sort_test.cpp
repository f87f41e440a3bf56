// SPDX-License-Identifier: MIT
#include "pilot/sort.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <bit>

#include "support/pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using model::Identity;
using testing::Desk;

model::Track& see_at(Desk& s, double range, double bearing, Identity identity = Identity::hostile) {
  const auto [sine, cosine] = math::sin_cos(bearing);
  return s.track({range * cosine, range * sine, 0}, wrap_pi(bearing + kPi), 250, identity);
}

TrackId target(const Desk& s) {
  const State state = s.state();
  return state.target() ? state.target()->id() : TrackId{};
}

TEST(Sort, TakesTheNearestHostile) {
  Desk s;
  EXPECT_EQ(target(s), TrackId{});
  see_at(s, 30e3, 0);
  see_at(s, 20e3, 1);
  EXPECT_EQ(target(s), TrackId{2});
}

TEST(Sort, LeavesFriendsUnknownsAndUnconfirmedAlone) {
  Desk s;
  see_at(s, 1e3, 0, Identity::friendly);
  see_at(s, 2e3, 0, Identity::unknown);
  see_at(s, 3e3, 0).confirmed = 0;
  EXPECT_EQ(target(s), TrackId{});
  see_at(s, 50e3, 0);
  EXPECT_EQ(target(s), TrackId{4});
}

TEST(Sort, LeavesTheTargetOfABetterRankedMateToHim) {
  Desk s;
  s.in_flight(2, 2);
  see_at(s, 20e3, 0).targeted_by = 0b01;
  see_at(s, 30e3, 0.2);
  EXPECT_EQ(target(s), TrackId{2});
}

TEST(Sort, TakesWhomItSeesBeforeWhoWasNotSeenForLong) {
  Desk s;
  see_at(s, 18e3, 1.7).time = s.time - 9;  // dead, perhaps
  see_at(s, 20e3, 0.1);
  EXPECT_EQ(target(s), TrackId{2});
  s.tracks.tracks[0].time = s.time - 7;
  EXPECT_EQ(target(s), TrackId{1});
  s.in_flight(2, 2);
  s.tracks.tracks[0].time = s.time - 9;
  s.tracks.tracks[1].targeted_by = 0b01;
  EXPECT_EQ(target(s), TrackId{1}) << "a mate has the other one";
}

TEST(Sort, KeepsAFreshTargetForAWhileWhateverTheMatesSay) {
  Desk s;
  s.in_flight(2, 2);
  see_at(s, 50e3, 0).targeted_by = 0b01;
  see_at(s, 60e3, 0.2);
  s.agent.target = TrackId{1};
  s.agent.contested_since = s.time - 40;
  s.agent.target_since = s.time - 29;
  EXPECT_EQ(target(s), TrackId{1});
  s.agent.target_since = s.time - 31;
  EXPECT_EQ(target(s), TrackId{2});
  s.tracks.tracks[0].position = s.own.position + Vec3{8e3, 0, 0};  // near: for eight seconds
  s.agent.target_since = s.time - 9;
  EXPECT_EQ(target(s), TrackId{2});
  s.agent.target_since = s.time - 7;
  EXPECT_EQ(target(s), TrackId{1});
  s.agent.target_since = s.time - 31;
  s.agent.shots[0] = {.until = s.time + 5, .track = TrackId{1}, .store = kMedium};
  EXPECT_EQ(target(s), TrackId{1}) << "its own missile is on the way";
}

TEST(Sort, DoesNotGiveWayToAWorseRankOrToTheDead) {
  Desk s;
  s.in_flight(3, 2);
  s.datalink.members[0].reported = 0;  // nobody knows where he is and whom he would take
  see_at(s, 20e3, 0).targeted_by = 0b100;
  see_at(s, 30e3, 0.2);
  EXPECT_EQ(target(s), TrackId{1});
  s.tracks.tracks[0].targeted_by = 0b001;
  s.lose(1);
  EXPECT_EQ(target(s), TrackId{1});
}

TEST(Sort, DoublesUpWhenThereAreFewerTargets) {
  Desk s;
  s.in_flight(4, 3);
  see_at(s, 20e3, 0).targeted_by = 0b01;
  see_at(s, 30e3, 0.2).targeted_by = 0b10;
  EXPECT_EQ(target(s), TrackId{1});
  s.in_flight(4, 4);
  s.tracks.tracks[0].targeted_by = 0b101;
  EXPECT_EQ(target(s), TrackId{2});
}

TEST(Sort, ReckonsWithWhomAMateWillTakeWhoHasNotSaidYet) {
  Desk s;
  s.in_flight(3, 3);
  s.datalink.members[0].position = s.own.position + Vec3{0, -2e3, 0};
  s.datalink.members[1].position = s.own.position + Vec3{0, 2e3, 0};
  s.datalink.members[0].reported = s.datalink.members[1].reported = 1;
  s.track({20e3, -1e3, 0});
  s.track({20e3, 0, 0});
  s.track({20e3, 3e3, 0});
  EXPECT_EQ(target(s), TrackId{2}) << "the first takes the left one, the second the right one";
  s.tracks.tracks[1].targeted_by = 0b01;
  EXPECT_EQ(target(s), TrackId{1}) << "what he says counts more";
  s.agent.target = TrackId{3};
  EXPECT_EQ(target(s), TrackId{3}) << "who has a target waits for the word";
}

TEST(Sort, GivesATargetUpWhenAMateSaysForAWhileThatItIsHis) {
  Desk s;
  s.in_flight(2, 2);
  see_at(s, 20e3, 0).targeted_by = 0b01;
  see_at(s, 22e3, 0.2);
  s.agent.target = TrackId{1};
  EXPECT_EQ(target(s), TrackId{1});
  EXPECT_TRUE(s.state().contested);
  s.agent.contested_since = s.time - kBelieved + 0.1;
  EXPECT_EQ(target(s), TrackId{1});
  s.agent.contested_since = s.time - kBelieved;
  EXPECT_EQ(target(s), TrackId{2});
  s.tracks.tracks[0].targeted_by = 0;
  EXPECT_FALSE(s.state().contested) << "he meant another one";
}

TEST(Sort, KeepsItsTargetUntilAnotherIsClearlyNearer) {
  Desk s;
  see_at(s, 20e3, 0);
  see_at(s, 15e3, 0.5);
  s.agent.target = TrackId{1};
  EXPECT_EQ(target(s), TrackId{1});
  s.tracks.tracks[1].position = s.own.position + Vec3{9.5e3, 0, 0};
  EXPECT_EQ(target(s), TrackId{2});
}

TEST(Sort, TakesTheOlderTrackOfTwoAtTheSameRange) {
  Desk s;
  s.track({20e3, 5e3, 0});
  s.track({20e3, -5e3, 0});
  EXPECT_EQ(target(s), TrackId{1});
}

TEST(Sort, TakesTwoTracksOfOnePlaceForOneAircraft) {
  Desk s;
  s.in_flight(2, 2);
  s.track({20e3, 0, 0}).targeted_by = 0b01;
  s.track({20e3, 300, 0});  // the same one, tracked twice
  s.track({30e3, 9e3, 0});
  EXPECT_EQ(target(s), TrackId{3});
}

// Everybody sees the same and hears of everybody's choice: within a few rounds nobody wants to
// change any more, and no target has two more attackers than another.
RC_GTEST_PROP(SortLaw, SettlesAndSharesEvenly, ()) {
  const auto members = *rc::gen::inRange(1u, 5u);
  const auto hostiles = *rc::gen::inRange(1u, 5u);
  std::vector<Vec3> places;
  for (std::uint32_t i = 0; i < hostiles; ++i)
    places.push_back({*rc::gen::inRange(20'000, 60'000) * 1.0,
                      *rc::gen::inRange(-5, 6) * 200.0 + i * 3000.0, 0});
  std::array<TrackId, 4> chosen{};
  const auto choose = [&](std::uint32_t member) {
    Desk s;
    s.in_flight(members, member + 1);
    for (const Vec3& place : places)
      s.track(place - Vec3{0, member * 2000.0, 0});
    for (std::uint32_t i = 0; i < members; ++i)
      if (chosen[i])
        s.tracks.tracks[chosen[i].value - 1].targeted_by |= static_cast<std::uint8_t>(1U << i);
    s.agent.target = chosen[member];
    s.agent.contested_since = s.time - kBelieved;
    return target(s);
  };
  for (int round = 0; round < 6; ++round)
    for (std::uint32_t i = 0; i < members; ++i)
      chosen[i] = choose(i);
  std::array<std::uint32_t, 5> attackers{};
  for (std::uint32_t i = 0; i < members; ++i) {
    RC_ASSERT(chosen[i]);
    RC_ASSERT(choose(i) == chosen[i]);
    ++attackers[chosen[i].value - 1];
  }
  for (std::uint32_t a = 0; a < hostiles; ++a)
    for (std::uint32_t b = 0; b < hostiles; ++b)
      RC_ASSERT(attackers[a] <= attackers[b] + 1);
}

TEST(ShootsFirst, IsTheNearestFreeMemberOnTheTarget) {
  Desk s;
  s.in_flight(2, 2);
  s.track({20e3, 0, 0}).targeted_by = 0b11;
  const auto first = [&] { return shoots_first(s.state(), *s.state().target()); };
  s.datalink.members[0].position = s.own.position + Vec3{-5000, 0, 0};
  EXPECT_TRUE(first()) << "the mate is farther";
  s.datalink.members[0].position = s.own.position + Vec3{5000, 0, 0};
  EXPECT_FALSE(first());
  s.tracks.tracks[0].targeted_by = 0b10;
  EXPECT_TRUE(first()) << "he is after somebody else";
  s.tracks.tracks[0].targeted_by = 0b11;
  s.track({40e3, 9e3, 0}).shot_by = 0b01;
  EXPECT_TRUE(first()) << "he is busy with a missile in the air";
  s.tracks.tracks[1].shot_by = 0;
  s.datalink.members[0].reported = 0;
  EXPECT_TRUE(first()) << "nobody knows where he is";
}

TEST(ShootsFirst, GoesByRankAtTheSameRange) {
  Desk s;
  s.in_flight(2, 2);
  s.track({20e3, 0, 0}).targeted_by = 0b11;
  s.datalink.members[0].position = s.own.position;
  EXPECT_FALSE(shoots_first(s.state(), *s.state().target()));
  s.in_flight(2, 1);
  s.datalink.members[1].position = s.own.position;
  EXPECT_TRUE(shoots_first(s.state(), *s.state().target()));
}

}  // namespace
}  // namespace eyrie::pilot
