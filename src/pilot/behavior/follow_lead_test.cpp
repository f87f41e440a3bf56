// SPDX-License-Identifier: MIT
#include "pilot/behavior/follow_lead.hpp"

#include <gtest/gtest.h>

#include <set>

#include "pilot/testing.hpp"

namespace eyrie::pilot {
namespace {

using namespace pilot::testing;

constexpr double kFoot = si(1, "ft");

/// The rank-th of four.
Desk wingman(std::uint32_t rank) {
  Desk desk;
  desk.in_flight(4, rank);
  return desk;
}
Vec3 place(const Desk& desk) {
  return decide("follow_lead", desk).action().follow->offset;
}

TEST(FollowLead, PutsTheSecondWhereThePaperHasIt) {
  const Vec3 offset = place(wingman(2));
  EXPECT_NEAR(offset.x, -1000 * kFoot, 1e-9);
  EXPECT_NEAR(offset.y, -6000 * kFoot, 1e-9);  // left
  EXPECT_NEAR(offset.z, 500 * kFoot, 1e-9);    // below
}

TEST(FollowLead, FollowsWhereTheLeadIsNow) {
  Desk desk = wingman(2);
  desk.datalink.members[0].time -= 2;
  const Decided d = decide("{follow_lead: {vote: 20}}", desk);
  EXPECT_EQ(d.status, kRunning);
  EXPECT_EQ(d.action().mode, model::AutopilotMode::follow);
  EXPECT_NEAR(d.action().follow->position.x, desk.datalink.members[0].position.x + 2 * 250, 1e-6);
  EXPECT_EQ(d.action().follow->time, desk.time);
  EXPECT_NEAR(*d.action().altitude, 8000 - 500 * kFoot, 1);
  EXPECT_EQ(d.proposal.vote, 20);
}

TEST(FollowLead, FailsForTheLead) {
  EXPECT_EQ(decide("follow_lead", wingman(1)).status, kFailure);
}

TEST(FollowLead, FailsUntilTheLeadHasBeenHeardOf) {
  Desk desk = wingman(2);
  desk.datalink.members[0].reported = 0;
  EXPECT_EQ(decide("follow_lead", desk).status, kFailure);
}

TEST(FollowLead, FailsWithoutADatalink) {
  Desk desk;
  desk.fit.rank = 2;
  EXPECT_EQ(decide("follow_lead", desk).status, kFailure);
}

TEST(FollowLead, FollowsTheSecondWhenTheLeadIsLost) {
  Desk desk = wingman(3);
  desk.lose(1);
  const Decided d = decide("follow_lead", desk);
  EXPECT_NEAR(d.action().follow->position.y, desk.datalink.members[1].position.y, 1e-6);
}

TEST(FollowLead, LeadsItselfWhenAllBeforeItAreLost) {
  Desk desk = wingman(3);
  desk.lose(1);
  desk.lose(2);
  EXPECT_TRUE(desk.state().leads());
  EXPECT_EQ(decide("follow_lead", desk).status, kFailure);
}

TEST(FollowLead, ClosesUp) {
  const Vec3 third = place(wingman(3));
  for (const std::uint32_t dead : {1U, 2U, 3U}) {
    Desk desk = wingman(4);
    desk.lose(dead);
    EXPECT_EQ(place(desk), third) << dead;
  }
}

TEST(FollowLead, DoesNotMoveWhenSomebodyBehindIsLost) {
  Desk desk = wingman(2);
  const Vec3 before = place(desk);
  desk.lose(4);
  EXPECT_EQ(place(desk), before);
}

TEST(FollowLead, GivesEveryRankAPlaceOfItsOwn) {
  std::set<std::pair<double, double>> places;
  for (std::uint32_t rank = 1; rank <= model::kMaxFlight; ++rank) {
    const Vec3 offset = formation_offset({}, rank);
    EXPECT_TRUE(places.insert({offset.x, offset.y}).second) << rank;
  }
}

TEST(FollowLead, NeverFollowsBelowItsFloor) {
  Desk desk = wingman(2);
  desk.own = model::test::flying({0, 0, -650}, 0, 250);
  desk.in_flight(4, 2);
  EXPECT_NEAR(*decide("{follow_lead: {floor: 600 m}}", desk).action().altitude, 600, 1e-9);
}

}  // namespace
}  // namespace eyrie::pilot
