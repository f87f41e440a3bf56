// SPDX-License-Identifier: MIT
#include "model/weapon/seeker.hpp"

#include <gtest/gtest.h>

#include "core/angle.hpp"
#include "core/units.hpp"
#include "model/signature.hpp"

namespace eyrie::model::weapon {
namespace {

SeekerType radar() {
  return {.kind = SeekerKind::radar,
          .detection_range = 14e3,
          .reference_signature = 5,
          .greatest_range = 25e3,
          .gimbal = radians(55),
          .greatest_rate = radians(30),
          .notch_speed = 50};
}
SeekerType infrared() {
  return {.kind = SeekerKind::infrared,
          .detection_range = 12e3,
          .reference_signature = 1000,
          .greatest_range = 18e3,
          .gimbal = radians(40),
          .greatest_rate = radians(20)};
}

/// Level, northbound at 700 m/s.
constexpr SeekerView kView{.position = {}, .velocity = {700, 0, 0}, .axis = {1, 0, 0}};

bool sees(const SeekerType& seeker, const Vec3& place, const Vec3& velocity, double signature) {
  return visible(seeker, kView, line_of_sight(place, velocity - kView.velocity), velocity,
                 signature);
}

/// A look at something bright whose center has had time to wander.
SeekerLook look_once(const SeekerType& seeker, const SeekerView& view, const LineOfSight& los,
                     const Draw& noise) {
  Vec3 glint;
  return measure(seeker, view, los, 1e9, 100, glint, noise);
}

TEST(AcquisitionRange, GrowsWithTheFourthRootForRadarAndTheSquareRootForInfrared) {
  EXPECT_DOUBLE_EQ(acquisition_range(radar(), 5), 14e3);
  EXPECT_NEAR(acquisition_range(radar(), 5.0 / 16), 7e3, 1e-9);
  EXPECT_DOUBLE_EQ(acquisition_range(infrared(), 1000), 12e3);
  EXPECT_NEAR(acquisition_range(infrared(), 250), 6e3, 1e-9);
}

TEST(AcquisitionRange, EndsAtTheGreatest) {
  EXPECT_DOUBLE_EQ(acquisition_range(radar(), 1e9), 25e3);
  EXPECT_DOUBLE_EQ(acquisition_range(infrared(), 1e9), 18e3);
  EXPECT_DOUBLE_EQ(acquisition_range(infrared(), 0), 0);
}

/// 8 km high and 17 degrees down, 30 m2 on the beam outshine the ground by 13 dB within 4.2 km.
TEST(Visible, SeesANearTargetThroughTheGroundsEcho) {
  SeekerType seeker = radar();
  seeker.field_of_view = 0.2;
  seeker.range_gate = 150;
  const auto beaming = [&](double range, double altitude) {
    SeekerView view = kView;
    view.altitude = altitude;
    const Vec3 velocity{0, 250, 0}, place = range * Vec3{0.9539392, 0, 0.3};
    return visible(seeker, view, line_of_sight(place, velocity - view.velocity), velocity, 30);
  };
  EXPECT_FALSE(beaming(4.4e3, 8e3));
  EXPECT_TRUE(beaming(4.0e3, 8e3));
  EXPECT_FALSE(beaming(4.0e3, 4e3)) << "nearer to the ground";
}

TEST(Visible, NeedsRangeAndGimbal) {
  const Vec3 coming{-300, 0, 0};
  EXPECT_TRUE(sees(radar(), {13e3, 0, -10}, coming, 5));
  EXPECT_FALSE(sees(radar(), {15e3, 0, -10}, coming, 5));
  const double inside = radians(54), outside = radians(56);
  EXPECT_TRUE(sees(radar(), 9e3 * Vec3{std::cos(inside), std::sin(inside), -0.1}, coming, 5));
  EXPECT_FALSE(sees(radar(), 9e3 * Vec3{std::cos(outside), std::sin(outside), -0.1}, coming, 5));
}

TEST(Visible, NeedsALineOfSightThatItCanFollow) {
  // abeam at 700 m/s the line of sight turns at 700 / range
  const auto turning = [](double rate) {
    return sees(radar(), (700 / rate) * Vec3{0.6, 0.8, -0.01}, {}, 5);
  };
  EXPECT_TRUE(turning(radians(30)));  // times the sine of 53 degrees: 24 deg/s
  EXPECT_FALSE(turning(radians(45)));
}

TEST(Visible, LosesATargetInTheNotchWhenItLooksDown) {
  const Vec3 below{9e3, 0, 2000}, above{9e3, 0, -2000};
  const Vec3 beaming{0, 300, 0}, coming{-300, 0, 0};
  EXPECT_FALSE(sees(radar(), below, beaming, 5));
  EXPECT_TRUE(sees(radar(), below, coming, 5));
  EXPECT_TRUE(sees(radar(), above, beaming, 5));        // sky behind it: no clutter
  EXPECT_TRUE(sees(infrared(), below, beaming, 1000));  // heat has no Doppler
}

TEST(Measure, IsExactWithoutNoise) {
  SeekerType seeker = radar();
  seeker.angle_noise = seeker.range_noise = seeker.closing_noise = 0;
  const LineOfSight los = line_of_sight({8e3, 1e3, 500}, {-900, 100, 0});
  const SeekerLook look = look_once(seeker, kView, los, Draw(1, PlayerId{1}, Stream::seeker, 0));
  EXPECT_EQ(look.direction, los.direction);
  EXPECT_DOUBLE_EQ(look.range, los.range);
  EXPECT_DOUBLE_EQ(look.closing, los.closing);
}

TEST(Measure, HasTheStatedNoise) {
  SeekerType seeker = radar();
  seeker.angle_noise = 2e-3;
  seeker.range_noise = 15;
  const LineOfSight los = line_of_sight({8e3, 1e3, 500}, {-900, 100, 0});
  double angle2 = 0, range2 = 0, range_sum = 0;
  constexpr int kLooks = 20000;
  for (int i = 0; i < kLooks; ++i) {
    const Draw noise(3, PlayerId{7}, Stream::seeker, static_cast<std::uint64_t>(i));
    const SeekerLook look = look_once(seeker, kView, los, noise);
    const double off = angle_between(look.direction, los.direction);
    angle2 += off * off;
    range2 += (look.range - los.range) * (look.range - los.range);
    range_sum += look.range - los.range;
  }
  EXPECT_NEAR(std::sqrt(angle2 / kLooks / 2), 2e-3, 0.05e-3);
  EXPECT_NEAR(std::sqrt(range2 / kLooks), 15, 0.4);
  EXPECT_NEAR(range_sum / kLooks, 0, 0.5);
}

TEST(Measure, WandersWithTheGlintOfANearTarget) {
  SeekerType seeker = radar();
  seeker.angle_noise = 0;
  seeker.glint = 3;
  double off2 = 0;
  const LineOfSight los = line_of_sight({400, 50, 20}, {-900, 100, 0});
  for (std::uint64_t i = 0; i < 5000; ++i) {
    const SeekerLook look = look_once(seeker, kView, los, Draw(3, PlayerId{7}, Stream::seeker, i));
    off2 += norm2(los.range * (look.direction - los.direction));
  }
  EXPECT_NEAR(std::sqrt(off2 / 5000 / 2), 3, 0.1);
}

TEST(Measure, LooksInTheMomentOfTheLaunch) {
  SeekerType seeker = radar();
  seeker.glint = 3;
  Vec3 glint;
  const LineOfSight los = line_of_sight({400, 50, 20}, {-900, 100, 0});
  for (const double dt : {0.0, -7e-15}) {
    const Draw noise(3, PlayerId{7}, Stream::seeker, 1);
    EXPECT_NEAR(norm2(measure(seeker, kView, los, 14e3, dt, glint, noise).direction), 1, 1e-9)
        << dt;
    EXPECT_EQ(norm2(glint), 0) << dt;
  }
}

TEST(Measure, ErrsWithTheSquareOfRangeWhereTheSignalIsFaint) {
  SeekerType seeker = radar();
  seeker.angle_noise = 1e-3;
  const auto sigma = [&](double range) {
    double off2 = 0;
    const LineOfSight los = line_of_sight({range, 0, -50}, {-900, 0, 0});
    for (std::uint64_t i = 0; i < 5000; ++i) {
      Vec3 glint;
      const Draw noise(4, PlayerId{7}, Stream::seeker, i);
      off2 +=
          norm2(measure(seeker, kView, los, 14e3, 0.02, glint, noise).direction - los.direction);
    }
    return std::sqrt(off2 / 5000 / 2);
  };
  EXPECT_NEAR(sigma(14e3), 10e-3, 0.3e-3);  // 20 dB less signal: ten times the error
  EXPECT_NEAR(sigma(7e3), 2.5e-3, 0.08e-3);
  EXPECT_NEAR(sigma(2e3), 1e-3, 0.03e-3);
}

TEST(Follow, SmoothsAFaintSignalLonger) {
  const SeekerType seeker = radar();
  MissileState bright, faint;
  const SeekerLook first{.range = 9000};
  start_following(bright, first, {}, 0);
  start_following(faint, first, {}, 0);
  SeekerLook aside{.direction = normalized(Vec3{1, 0.01, 0}, {}), .range = 9000};
  follow(seeker, kView, aside, 0.02, bright);
  aside.faint = 9;
  follow(seeker, kView, aside, 0.02, faint);
  // three times as far: nine times the errors, a third of the turn of a maneuver.
  // alpha = 1 - theta^2, and the logarithm of theta goes with 1 over the time constant
  const auto theta = [](const MissileState& s) { return std::sqrt(1 - s.sight.y / 0.01); };
  EXPECT_NEAR(std::log(theta(faint)), std::log(theta(bright)) / std::sqrt(27.0), 1e-4);
}

TEST(Measure, WandersOverATime) {
  SeekerType seeker = radar();
  seeker.angle_noise = 0;
  seeker.glint = 3;
  seeker.glint_time = 0.2;
  const LineOfSight los = line_of_sight({4000, 0, -50}, {-900, 0, 0});
  Vec3 glint;
  double square = 0, product = 0;  // a first-order Gauss-Markov process: sigma^2 exp(-t / T)
  constexpr int kLag = 10;         // looks of 0.02 s: one time constant
  std::array<Vec3, kLag> past{};
  for (std::uint64_t i = 0; i < 60000; ++i) {
    (void)measure(seeker, kView, los, 1e9, 0.02, glint, Draw(5, PlayerId{7}, Stream::seeker, i));
    square += norm2(glint) / 2;
    product += dot(glint, past[i % kLag]) / 2;
    past[i % kLag] = glint;
  }
  EXPECT_NEAR(std::sqrt(square / 60000), 3, 0.1);
  EXPECT_NEAR(product / square, std::exp(-1.0), 0.03);
}

TEST(Measure, OfAMirroredSceneIsTheMirroredMeasurement) {
  const SeekerType seeker = radar();
  const auto mirror = [](const Vec3& v) { return Vec3{v.x, -v.y, v.z}; };
  const Vec3 apart{8e3, 1e3, 500}, drift{-900, 100, 0};
  const Draw noise(3, PlayerId{7}, Stream::seeker, 9);
  const SeekerLook right = look_once(seeker, kView, line_of_sight(apart, drift), noise);
  const SeekerLook left =
      look_once(seeker, kView, line_of_sight(mirror(apart), mirror(drift)), noise);
  EXPECT_EQ(left.direction, mirror(right.direction));
  EXPECT_NE(right.direction, line_of_sight(apart, drift).direction);
}

TEST(Measure, OfAnInfraredSeekerTakesTheOwnSpeedForTheClosingSpeed) {
  const LineOfSight los = line_of_sight({5e3, 0, 0}, {-400, 0, 0});
  const SeekerLook look =
      look_once(infrared(), kView, los, Draw(1, PlayerId{1}, Stream::seeker, 0));
  EXPECT_DOUBLE_EQ(look.closing, 700);
}

/// Follows a target for `seconds` without noise, or with.
MissileState followed(const SeekerType& seeker, double seconds, Vec3 place, const Vec3& velocity,
                      const Vec3& first_rate) {
  MissileState state;
  SeekerView view = kView;
  Vec3 glint;
  for (int step = 0; step <= std::lround(seconds * 50); ++step) {
    const double time = step / 50.0;
    const LineOfSight los = line_of_sight(place - view.position, velocity - view.velocity);
    const Draw noise(5, PlayerId{2}, Stream::seeker, static_cast<std::uint64_t>(step));
    const SeekerLook look = measure(seeker, view, los, 1e9, 0.02, glint, noise);
    if (step == 0)
      start_following(state, look, first_rate, time);
    follow(seeker, view, look, time, state);
    place += 0.02 * velocity;
    view.position += 0.02 * view.velocity;
  }
  return state;
}

TEST(Follow, FindsTheLineOfSightRate) {
  SeekerType seeker = radar();
  seeker.angle_noise = seeker.range_noise = seeker.closing_noise = 0;
  const Vec3 place{12e3, 800, 0}, velocity{-300, 80, 0};
  const MissileState state = followed(seeker, 2, place, velocity, {});
  const LineOfSight truth =
      line_of_sight(place + 2 * velocity - 2 * kView.velocity, velocity - kView.velocity);
  EXPECT_NEAR(norm(state.sight_rate - truth.rate), 0,
              0.05 * norm(truth.rate));  // it lags a rate that grows
  EXPECT_LT(angle_between(state.sight, truth.direction), 1e-4);
  EXPECT_NEAR(norm(state.target_position - (place + 2 * velocity)), 0, 2);
  EXPECT_NEAR(norm(state.target_velocity - velocity), 0, 10);
}

TEST(Follow, SmoothsNoise) {
  SeekerType seeker = radar();
  seeker.angle_noise = 1e-3;
  const Vec3 place{14e3, 0, 0}, velocity{-300, 0, 0};
  const MissileState state = followed(seeker, 3, place, velocity, {});
  // two raw looks differ by 1e-3 sqrt(2) in 0.02 s: 0.07 rad/s
  EXPECT_LT(norm(state.sight_rate), 0.012);
  EXPECT_GT(norm(state.sight_rate), 1e-6);
}

TEST(Follow, OfAnInfraredSeekerLearnsNoRange) {
  const MissileState state = followed(infrared(), 1, {9e3, 0, 0}, {-300, 0, 0}, {});
  EXPECT_EQ(state.target_position, Vec3{});
}

TEST(SightAt, TurnsOnWithItsRate) {
  MissileState state;
  state.sight_rate = {0, 0, 0.1};
  const Vec3 later = sight_at(state, 0.5);
  EXPECT_NEAR(math::atan2(later.y, later.x), 0.05, 1e-4);
}

TEST(RadiantIntensity, IsBrightestFromBehindAndWithAfterburner) {
  const InfraredSignature s{.front = 60, .side = 250, .rear = 1000, .afterburner = 10};
  EXPECT_DOUBLE_EQ(radiant_intensity(s, 1, 1), 60);
  EXPECT_DOUBLE_EQ(radiant_intensity(s, 0, 1), 250);
  EXPECT_DOUBLE_EQ(radiant_intensity(s, -1, 1), 1000);
  EXPECT_DOUBLE_EQ(radiant_intensity(s, -1, 2), 10000);
  EXPECT_DOUBLE_EQ(radiant_intensity(s, -1, 1.5), 5500);
  EXPECT_NEAR(radiant_intensity(s, -1, 0), 1000.0 / 3, 1e-9);
  for (double c = -1; c < 1; c += 0.01)
    EXPECT_GE(radiant_intensity(s, c, 1) + 1e-9, radiant_intensity(s, c + 0.01, 1));
}

}  // namespace
}  // namespace eyrie::model::weapon
