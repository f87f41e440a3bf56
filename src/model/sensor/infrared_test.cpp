// SPDX-License-Identifier: MIT
#include "model/sensor/infrared.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/model/air_war.hpp"

namespace eyrie::model::sensor {
namespace {

using test::AirWar;
using test::flying;
using test::kHigh;

const Irst kIrst{.reference_range = 15e3, .reference_intensity = 1000, .greatest_range = 40e3};

/// Share of frames in which something of that intensity is found.
double share(double intensity, double range) {
  int seen = 0;
  constexpr int kFrames = 20000;
  for (int i = 0; i < kFrames; ++i)
    seen += finds(kIrst, intensity, range,
                  Draw(3, PlayerId{1}, Stream::test, static_cast<std::uint64_t>(i)).normal());
  return seen / double(kFrames);
}

TEST(Infrared, FindsWithEvenOddsWhereTheSquareRootOfTheIntensitySays) {
  for (const double intensity : {60.0, 250.0, 1000.0, 5000.0}) {
    const double range = 15e3 * std::sqrt(intensity / 1000);
    EXPECT_NEAR(share(intensity, range), 0.5, 0.015) << intensity;
    // Phi(4.75 ((R0 / R)^2 - 1)): nine tenths at 0.887 of the range, a tenth at 1.17
    EXPECT_NEAR(share(intensity, 0.8874 * range), 0.9, 0.01);
    EXPECT_NEAR(share(intensity, 1.1702 * range), 0.1, 0.01);
  }
  EXPECT_EQ(share(1e6, 40.1e3), 0) << "the air absorbs it";
}

TEST(Infrared, SeesATailFourTimesAsFarAsANoseAndAnAfterburnerFarther) {
  // as published for the OLS-27: 50 km from behind, 15 km from ahead
  const InfraredSignature s;
  const auto reach = [&](double cos_aspect, double throttle) {
    return std::sqrt(radiant_intensity(s, cos_aspect, throttle) / 1000);
  };
  EXPECT_NEAR(reach(-1, 1) / reach(1, 1), 4, 0.2);
  EXPECT_GT(reach(1, 2), 3 * reach(1, 1));
  EXPECT_LT(reach(-1, 0), 0.6 * reach(-1, 1));
}

TEST(Infrared, LooksFromTheNoseAndNotBehind) {
  const Axes body = body_axes(flying({0, 0, kHigh}, 0, 250));
  const auto seen = [&](double azimuth, double up) {
    const double a = radians(azimuth), e = radians(up);
    return covers(kIrst, body, 9e3 * Vec3{std::cos(a), std::sin(a), -std::tan(e) * std::cos(a)});
  };
  EXPECT_TRUE(seen(29, 0) && seen(-29, 0) && seen(0, 29) && seen(0, -14));
  EXPECT_FALSE(seen(31, 0) || seen(-31, 0) || seen(0, 31) || seen(0, -16) || seen(180, 0));
}

TEST(Infrared, MeasuresADirectionAndWithTheLaserARange) {
  const Kinematics own = flying({0, 0, kHigh}, 0.3, 250);
  const Axes body = body_axes(own);
  const Vec3 place{9e3, 3e3, kHigh - 500};
  const Vec3 unit = normalized(place - own.position, {});
  for (const bool fires : {false, true}) {
    double across2 = 0, along2 = 0;
    constexpr int kLooks = 5000;
    for (int i = 0; i < kLooks; ++i) {
      const Contact c =
          measure(kIrst, fires, own, body, place, PlayerId{2},
                  Draw(5, PlayerId{1}, Stream::infrared_noise, static_cast<std::uint64_t>(i)));
      EXPECT_EQ(c.bearing_only, !fires);
      EXPECT_EQ(c.sigma_speed, 0);
      across2 += norm2(cross(unit, c.line)) / kLooks;
      const double ahead = dot(c.position - place, unit);
      along2 += ahead * ahead / kLooks;
      EXPECT_NEAR(c.sigma_across / c.range, kIrst.sigma_angle, 1e-5);
    }
    EXPECT_NEAR(std::sqrt(across2 / 2), kIrst.sigma_angle, 0.03 * kIrst.sigma_angle);
    if (fires)
      EXPECT_NEAR(std::sqrt(along2), kIrst.sigma_laser, 0.1 * kIrst.sigma_laser);
    else
      EXPECT_GT(std::sqrt(along2), 5e3) << "the truth does not leak into the guess";
  }
}

/// A fighter with nothing but an infrared sensor, behind one that flies away.
struct InfraredWar : AirWar {
  PlayerId eagle, bogey;
  explicit InfraredWar(double range, double laser, double heading) {
    AircraftType type = models.aircraft[0];
    models.irsts.add("irst", {.reference_range = 15e3,
                              .reference_intensity = 1000,
                              .greatest_range = 40e3,
                              .laser_range = laser});
    type.index = {.irst = 0, .tracker = type.index.tracker};
    models.aircraft = {};
    models.aircraft.add("fighter", type);
    eagle = add(Side::blue, flying({0, 0, kHigh}, 0, 250));
    bogey = add(Side::red, flying({range, 300, kHigh}, heading, 250));
    build();
    row(aircraft.propulsion, bogey).throttle = 1;
  }
};

TEST(Infrared, GivesTheTrackerADirectionThatIsGoodAndARangeThatIsNot) {
  InfraredWar war(10e3, 0, 0);
  war.fly(40);
  const Track* track = war.track_of(war.eagle, war.bogey);
  ASSERT_NE(track, nullptr);
  EXPECT_EQ(track->sources, kFromInfrared);
  EXPECT_EQ(track->confirmed, 1);
  EXPECT_EQ(track->identity, Identity::unknown);
  const Vec3 own = war.row(war.aircraft.kinematics, war.eagle).position;
  const Vec3 other = war.row(war.aircraft.kinematics, war.bogey).position;
  EXPECT_LT(norm(cross(normalized(track->position - own, {}), normalized(other - own, {}))), 6e-3);
  EXPECT_GT(track->position_sigma, 5e3);
  EXPECT_LT(norm(track->position - other), 3 * static_cast<double>(track->position_sigma));

  InfraredWar with_laser(5e3, 6.5e3, 0);
  with_laser.fly(40);
  track = with_laser.track_of(with_laser.eagle, with_laser.bogey);
  ASSERT_NE(track, nullptr);
  EXPECT_LT(track->position_sigma, 100);
}

/// An eagle, a bogey ahead of it that flies away, and a mate somewhere beyond.
struct MixedWar : AirWar {
  PlayerId eagle, bogey, mate;
  MixedWar(double range, double laser, const Vec3& mate_at) {
    AircraftType type = models.aircraft[0];
    models.irsts.add("irst", {.reference_range = 15e3,
                              .reference_intensity = 1000,
                              .greatest_range = 40e3,
                              .laser_range = laser});
    type.index = {.irst = 0, .datalink = type.index.datalink, .tracker = type.index.tracker};
    models.aircraft = {};
    models.aircraft.add("fighter", type);
    eagle = add(Side::blue, flying({0, 0, kHigh}, 0, 250));
    bogey = add(Side::red, flying({range, 0, kHigh}, 0, 250));
    mate = add(Side::blue, flying(Vec3{0, 0, kHigh} + mate_at, 0, 250));
    build();
    row(aircraft.propulsion, bogey).throttle = 1;
    row(aircraft.propulsion, mate).throttle = 1;
    fly(40);
  }
  /// Whether the eagle takes the bogey for a friend.
  bool fooled() {
    const TrackFile& file = tracks(eagle);
    return std::any_of(file.tracks.begin(), file.tracks.begin() + file.count, [&](const Track& t) {
      return t.truth == bogey && t.identity == Identity::friendly;
    });
  }
  bool knows_mate() {
    const Track* track = track_of(eagle, mate);
    return track != nullptr && track->identity == Identity::friendly;
  }
};

TEST(Infrared, TakesNobodyForAMateWhoseRangeItHasMeasuredToBeAnother) {
  MixedWar war(5e3, 6.5e3, {9e3, 0, 0});
  EXPECT_TRUE(war.knows_mate());
  EXPECT_FALSE(war.fooled());
}

TEST(Infrared, TakesNobodyForAMateWhomItCanNotSee) {
  EXPECT_FALSE(MixedWar(10e3, 0, {60e3, 0, 0}).fooled()) << "too far";
  MixedWar war(10e3, 0, {20e3, 0, 0});
  EXPECT_TRUE(war.knows_mate() || war.fooled()) << "one of the two in his direction";
}

TEST(Infrared, TakesOneOnlyForEachMate) {
  MixedWar war(10e3, 0, {10e3, 90, 0});  // 9 mrad apart, within the gate of 5 times 2 mrad
  EXPECT_TRUE(war.knows_mate());
  EXPECT_FALSE(war.fooled());
}

TEST(Infrared, DoesNotSeeANoseThatItWouldSeeFromBehind) {
  InfraredWar behind(10e3, 0, 0), ahead(10e3, 0, kPi);
  behind.fly(8);
  ahead.fly(8);  // from 10 to 6 km: beyond the 3.7 km of a nose at military power
  EXPECT_NE(behind.track_of(behind.eagle, behind.bogey), nullptr);
  EXPECT_EQ(ahead.track_of(ahead.eagle, ahead.bogey), nullptr);
}

}  // namespace
}  // namespace eyrie::model::sensor
