// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "model/frames.hpp"
#include "pilot/geometry.hpp"
#include "support/flight.hpp"

namespace eyrie::test {
namespace {

/// Distance (m) of a player from the place of `rank` beside `lead`.
double off_place(const Flight& f, std::string_view who, std::string_view lead, std::uint32_t rank) {
  const auto rows = f.world().rows(f.scenario->aircraft.kinematics);
  const auto& at = rows[f.row(lead).value()];
  const auto& own = rows[f.row(who).value()];
  const Vec3 ahead = normalized(at.velocity - dot(at.velocity, at.down) * at.down, at.north);
  const Vec3 right = cross(at.down, ahead);
  const auto& flight = f.scenario->roster.players[f.scenario->roster.find(who)->value - 1].flight;
  const Vec3 offset = pilot::formation_offset(f.scenario->formations[flight], rank);
  const Vec3 place = at.position + offset.x * ahead + offset.y * right + offset.z * at.down;
  return norm(own.position - place);
}

TEST(LeadSuccession, GivesTheLeadToTheNextInRankAndClosesUp) {
  Flight f(load_scenario("lead_succession"));

  // the wall stands before the shot
  f.fly_until(60);
  EXPECT_LT(off_place(f, "eagle2", "eagle1", 2), 150);
  EXPECT_LT(off_place(f, "eagle3", "eagle1", 3), 150);
  EXPECT_LT(off_place(f, "eagle4", "eagle1", 4), 150);
  EXPECT_TRUE(f.log.of(EventKind::lead_change).empty());

  // the lead is killed by the only shot
  while (!f.log.first(EventKind::kill) && f.mission.step()) {
  }
  const auto kill = f.log.first(EventKind::kill);
  ASSERT_TRUE(kill);
  EXPECT_EQ(f.scenario->roster.name(kill->event.who), "bogey1");
  ASSERT_EQ(f.scenario->roster.name(kill->event.whom), "eagle1");

  // the next in rank knows it when the datalink has been silent for its timeout of 5 s
  f.fly_until(kill->time + 10);
  const auto change = f.log.first(EventKind::lead_change);
  ASSERT_TRUE(change);
  EXPECT_EQ(f.scenario->roster.name(change->event.who), "eagle2");
  EXPECT_EQ(f.scenario->roster.name(change->event.whom), "eagle1");
  EXPECT_GT(change->time, kill->time);
  EXPECT_LT(change->time, kill->time + 8);

  // within two minutes everybody has moved up one place beside the new lead
  f.fly_until(kill->time + 120);
  EXPECT_LT(off_place(f, "eagle3", "eagle2", 2), 300);
  EXPECT_LT(off_place(f, "eagle4", "eagle2", 3), 300);

  // and they fly on along the route: east, with the new lead steering for the waypoint
  f.fly_until(480);
  EXPECT_EQ(f.log.of(EventKind::lead_change).size(), 1U);
  const auto& eagle2 = f.world().rows(f.scenario->aircraft.kinematics)[f.row("eagle2").value()];
  EXPECT_NEAR(eagle2.heading, radians(90), radians(3));
  EXPECT_LT(off_place(f, "eagle3", "eagle2", 2), 150);
  EXPECT_LT(off_place(f, "eagle4", "eagle2", 3), 150);
  EXPECT_EQ(f.tally.side(model::Side::blue).losses, 1U);
}

}  // namespace
}  // namespace eyrie::test
