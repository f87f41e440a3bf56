// SPDX-License-Identifier: MIT
#include "model/sensor/threats.hpp"

#include <gtest/gtest.h>

namespace eyrie::model::sensor {
namespace {

Sighting heard(double degrees) {
  return {.bearing = radians(degrees), .source = kThreatFromRwr};
}
Sighting seen(double degrees, double range) {
  return {.bearing = radians(degrees),
          .elevation = 0.1,
          .range = range,
          .source = kThreatFromSight,
          .has_position = true,
          .closing = true};
}

TEST(ThreatUpdate, TellsANewMissileOnce) {
  Threats threats;
  EXPECT_TRUE(ThreatUpdate(threats, 1).note(heard(40)));
  EXPECT_FALSE(ThreatUpdate(threats, 2).note(heard(55)));
  ASSERT_EQ(threats.count, 1u);
  EXPECT_NEAR(degrees(threats.missiles[0].bearing), 55, 1e-9);
  EXPECT_EQ(threats.missiles[0].first_time, 1);
  EXPECT_EQ(threats.missiles[0].time, 2);
}

TEST(ThreatUpdate, KeepsTwoOnOneBearingApartWithinOneLook) {
  Threats threats;
  ThreatUpdate look(threats, 1);
  EXPECT_TRUE(look.note(heard(40)));
  EXPECT_TRUE(look.note(heard(45)));
  ThreatUpdate next(threats, 2);
  EXPECT_FALSE(next.note(heard(41)));
  EXPECT_FALSE(next.note(heard(44)));
  EXPECT_EQ(threats.count, 2u);
}

TEST(ThreatUpdate, JoinsWhatIsHeardWithWhatIsSeen) {
  Threats threats;
  ThreatUpdate(threats, 1).note(heard(170));
  EXPECT_FALSE(ThreatUpdate(threats, 1.1).note(seen(-170, 4000)));
  ASSERT_EQ(threats.count, 1u);
  EXPECT_EQ(threats.missiles[0].sources, kThreatFromRwr | kThreatFromSight);
  EXPECT_EQ(threats.missiles[0].range, 4000);
  EXPECT_EQ(threats.missiles[0].closing, 1);
  // the eye's bearing is kept while it is fresh
  ThreatUpdate(threats, 2).note(heard(165));
  EXPECT_NEAR(degrees(threats.missiles[0].bearing), -170, 1e-9);
}

TEST(ThreatUpdate, WhatIsHeardNeverHasARange) {
  Threats threats;
  ThreatUpdate(threats, 1).note(heard(40));
  EXPECT_EQ(threats.missiles[0].has_position, 0);
  EXPECT_EQ(threats.missiles[0].range, 0);
}

TEST(ThreatUpdate, DropsWhatItHasNoPlaceFor) {
  Threats threats;
  ThreatUpdate look(threats, 1);
  for (std::size_t i = 0; i < kMaxThreats; ++i)
    EXPECT_TRUE(look.note(heard(80.0 * static_cast<double>(i))));
  EXPECT_FALSE(look.note(heard(-40)));
  EXPECT_EQ(threats.count, kMaxThreats);
}

TEST(ThreatUpdate, DoesNotReadTheTruth) {
  Threats threats;
  Sighting first = heard(40), other = heard(50);
  first.truth = PlayerId{7};
  other.truth = PlayerId{8};
  ThreatUpdate(threats, 1).note(first);
  EXPECT_FALSE(ThreatUpdate(threats, 2).note(other));
  EXPECT_EQ(threats.missiles[0].truth, PlayerId{8});
}

TEST(ThreatUpdate, TellsSeekersApartByTheirFingerprints) {
  Threats threats;
  Sighting one = heard(40), two = heard(42), eye = seen(41, 5000);
  one.emitter = PlayerId{7};
  two.emitter = PlayerId{8};
  two.arrival = 12;
  EXPECT_TRUE(ThreatUpdate(threats, 1).note(one));
  EXPECT_TRUE(ThreatUpdate(threats, 1.2).note(two));
  EXPECT_FALSE(ThreatUpdate(threats, 1.4).note(eye));
  one.bearing = radians(170);
  EXPECT_FALSE(ThreatUpdate(threats, 1.6).note(one)) << "the same, wherever it is now";
  ASSERT_EQ(threats.count, 2u);
  EXPECT_EQ(threats.missiles[0].emitter, one.emitter);
  EXPECT_EQ(threats.missiles[0].arrival, 0);
  EXPECT_EQ(threats.missiles[1].arrival, 12);
}

TEST(ThreatUpdate, KeepsAnArrivalWhileTheLineOfItsSignalBeginsAnew) {
  Threats threats;
  Sighting missile = heard(40);
  missile.emitter = PlayerId{7};
  const auto arrival = [&](double time) {
    ThreatUpdate(threats, time).note(missile);
    return threats.missiles[0].arrival;
  };
  missile.arrival = 12;
  EXPECT_EQ(arrival(9), 12);
  missile.arrival = 0;
  missile.begins_anew = true;  // a hard turn of one of the two
  EXPECT_EQ(arrival(9.2), 12);
  EXPECT_EQ(arrival(12.9), 12);
  EXPECT_EQ(arrival(13.1), 0) << "it was another's";
  missile.arrival = 16;
  missile.begins_anew = false;
  EXPECT_EQ(arrival(13.3), 16);
  missile.arrival = 0;
  EXPECT_EQ(arrival(13.5), 0) << "its signal does not grow: it goes away";
}

TEST(ForgetThreats, DropsTheOldAndTheOldRange) {
  Threats threats;
  ThreatUpdate(threats, 0).note(seen(10, 3000));
  ThreatUpdate(threats, 0).note(heard(100));
  ThreatUpdate(threats, 3).note(heard(10));
  forget(threats, 4.5);
  ASSERT_EQ(threats.count, 1u);
  EXPECT_EQ(threats.missiles[0].has_position, 0) << "its range is older than the memory";
  EXPECT_EQ(threats.missiles[0].range, 0);
  EXPECT_EQ(threats.missiles[0].time, 3);
  EXPECT_EQ(threats.missiles[1].time, 0) << "a freed place is zero";
}

}  // namespace
}  // namespace eyrie::model::sensor
