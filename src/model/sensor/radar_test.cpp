// SPDX-License-Identifier: MIT
#include "model/sensor/radar.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <optional>

#include "support/model/flying.hpp"

namespace eyrie::model::sensor {
namespace {

using test::flying;
using test::mirrored;

constexpr PlayerId kOwn{1}, kOther{2};
using test::kHigh;

Signature sphere(double rcs) {
  return {.rcs_front = rcs, .rcs_side = rcs, .rcs_rear = rcs};
}

Draw draw(Stream stream, std::uint64_t step) {
  return Draw(7, kOwn, stream, step, kOther.value);
}

/// One look of the searching radar at one other aircraft: nothing if it is not detected.
std::optional<Contact> look(const Radar& radar, const Antenna& antenna, const Kinematics& own,
                            const Signature& signature, const Kinematics& other, PlayerId truth,
                            Draw detection, Draw noise) {
  const Vec3 sight = other.position - own.position;
  if (!covers(antenna, sight, norm2(sight)))
    return std::nullopt;
  const Detector detector(radar);
  const auto echo =
      detector.echo(mean_echo(radar, detector, own, signature, other), detection.uniform());
  if (!echo)
    return std::nullopt;
  return measure(errors_of(radar, RadarMode::search, *echo), own, level_axes(own, own.heading),
                 other, truth, noise);
}

double detection_probability(const Radar& radar, const Kinematics& own, const Signature& signature,
                             const Kinematics& other) {
  const Detector detector(radar);
  return detector.probability(mean_echo(radar, detector, own, signature, other));
}

/// Chance to detect a head-on target of the reference cross section at `range`, both high up.
double head_on(const Radar& radar, double range, double rcs) {
  return detection_probability(radar, flying({0, 0, kHigh}, 0, 250), sphere(rcs),
                               flying({range, 0, kHigh}, kPi, 250));
}

TEST(Detector, FindsTheReferenceTargetAtTheReferenceRangeWithTheReferenceProbability) {
  const Radar radar{
      .reference_range = si(80, "nmi"), .reference_rcs = 3.2, .reference_probability = 0.7};
  EXPECT_NEAR(head_on(radar, si(80, "nmi"), 3.2), 0.7, 1e-12);
}

TEST(Detector, GivesNoMoreThanTheFalseAlarmRateWithoutASignal) {
  const Radar radar{.false_alarm = 1e-5};
  EXPECT_NEAR(Detector(radar).probability(0), 1e-5, 1e-18);
}

/// Chance to detect an echo of that strength that does not fluctuate, one look: Albersheim's
/// equation (1981) solved for it. It claims 0.2 dB between 0.1 and 0.9.
double albersheim(double signal_to_noise, double false_alarm) {
  const double a = std::log(0.62 / false_alarm);
  const double z =
      std::pow(10, 10 * std::log10(signal_to_noise) / (6.2 + 4.54 / std::sqrt(1 + 0.44)));
  return 1 / (1 + std::exp(-(z - a) / (1.7 + 0.12 * a)));
}

TEST(Detector, IsTheMeanOfSteadyEchoesOverTheFluctuation) {
  // published for a steady echo: 13.18 dB for 0.9 at a false alarm rate of 1e-6 (square law)
  EXPECT_NEAR(albersheim(std::pow(10, 1.318), 1e-6), 0.9, 0.02);
  // Swerling 1: the strength is exponential about its mean; 21.1 dB are needed for 0.9 then
  const Detector detector{Radar{.false_alarm = 1e-6}};
  EXPECT_NEAR(detector.probability(std::pow(10, 2.11)), 0.9, 0.002);
  for (const double mean : {5.0, 10.0, 19.0, 50.0, 130.0}) {
    double sum = 0;
    constexpr int kParts = 20000;
    for (int i = 0; i < kParts; ++i)
      sum += albersheim(-mean * std::log((i + 0.5) / kParts), 1e-6) / kParts;
    // below 0.1 Albersheim's equation says a little too much
    EXPECT_NEAR(detector.probability(mean), sum, 0.035) << mean;
  }
}

RC_GTEST_PROP(Detector, FollowsTheFourthPowerOfRange, ()) {
  const Detector detector{Radar{}};
  const double range = *rc::gen::inRange(1000, 300000), rcs = 0.1 * *rc::gen::inRange(1, 500);
  const double factor = 0.01 * *rc::gen::inRange(20, 500);
  const double near = detector.signal_to_noise(range * range, rcs);
  const double far = detector.signal_to_noise(range * range * factor * factor, rcs);
  RC_ASSERT(std::fabs(near / far / std::pow(factor, 4) - 1) < 1e-9);
  // and a target that is f^4 times as big is seen f times as far
  const double big =
      detector.signal_to_noise(range * range * factor * factor, rcs * std::pow(factor, 4));
  RC_ASSERT(std::fabs(big / near - 1) < 1e-9);
}

TEST(Detector, ScalesThePublishedAnchorToOtherFighters) {
  // facts: 80 nmi at 3.2 m^2 gives 71 nmi at 2 m^2, 94 at 6, 106 at 10, 118 at 15
  const Radar radar{.reference_range = si(80, "nmi"), .reference_rcs = 3.2};
  for (const auto& [rcs, range] : {std::pair{2.0, 71.0}, {6.0, 94.0}, {10.0, 106.0}, {15.0, 118.0}})
    EXPECT_NEAR(head_on(radar, si(1, "nmi") * range, rcs), 0.5, 0.01) << rcs;
}

TEST(Look, DetectsAsOftenAsTheClosedFormSays) {
  const Radar radar;
  const RadarState state{.mode = RadarMode::search};
  const Kinematics own = flying({0, 0, kHigh}, 0, 250);
  const Antenna antenna = aim(radar, state, own);
  for (const double nmi : {50.0, 70.0, 80.0, 95.0}) {
    const Kinematics other = flying({si(1, "nmi") * nmi, 4000, kHigh}, kPi, 250);
    const double expected = detection_probability(radar, own, sphere(3.2), other);
    constexpr int kLooks = 20000;
    int hits = 0;
    for (int i = 0; i < kLooks; ++i)
      hits += look(radar, antenna, own, sphere(3.2), other, kOther,
                   draw(Stream::radar, static_cast<std::uint64_t>(i)),
                   draw(Stream::radar_noise, static_cast<std::uint64_t>(i)))
                  .has_value();
    const double sigma = std::sqrt(expected * (1 - expected) / kLooks);
    EXPECT_NEAR(hits / double(kLooks), expected, 4 * sigma) << nmi << " nmi";
  }
}

TEST(DetectionProbability, IsTheSameFromLeftAndRightOfTheTarget) {
  const Radar radar;
  const Signature fighter{.rcs_front = 3, .rcs_side = 30, .rcs_rear = 9};
  const Kinematics own = flying({0, 0, kHigh}, 0, 250);
  const auto at_aspect = [&](double aspect) {
    return detection_probability(radar, own, fighter,
                                 flying({si(70, "nmi"), 0, kHigh}, kPi + aspect, 250));
  };
  for (const double degrees : {10.0, 45.0, 80.0, 120.0, 170.0})
    EXPECT_NEAR(at_aspect(radians(degrees)), at_aspect(radians(-degrees)), 1e-12) << degrees;
  EXPECT_GT(at_aspect(radians(60)), at_aspect(0));
  EXPECT_GT(at_aspect(kPi), at_aspect(0));
}

TEST(MeanEcho, IsTheSameInAWindThatCarriesBoth) {
  const Radar radar;
  const Detector detector(radar);
  const Signature fighter{.rcs_front = 3, .rcs_side = 30, .rcs_rear = 9};
  const std::vector<WindLayer> north{{.altitude = 0, .speed = 100, .from = 0}};
  const Wind wind(north);
  Kinematics own = flying({0, 0, kHigh}, kPi / 2, 250);
  Kinematics other = flying({0, 50e3, kHigh}, -kPi / 2, 250);
  const double calm = mean_echo(radar, detector, own, fighter, other);
  for (Kinematics* one : {&own, &other})
    one->velocity = one->velocity + wind.at(one->altitude);
  EXPECT_NEAR(mean_echo(radar, detector, own, fighter, other, wind), calm, 1e-9 * calm);
  EXPECT_GT(mean_echo(radar, detector, own, fighter, other), 1.1 * calm) << "if it turned his nose";
}

TEST(MeanEcho, IsNothingBelowTheHorizon) {
  const Radar radar;
  const double own_altitude = 1000, low = 50;
  const double horizon = horizon_range(own_altitude, low, kRadioEarth);
  const auto at = [&](double range) {
    return mean_echo(radar, Detector(radar), flying({0, 0, -own_altitude}, 0, 250), sphere(1000),
                     flying({range, 0, -low}, kPi, 250));
  };
  EXPECT_GT(at(0.99 * horizon), 100);
  EXPECT_EQ(at(1.01 * horizon), 0);
}

/// A target 4 km below at 40 km that flies across the line of sight except for `closing` m/s.
double looking_down(const Radar& radar, double closing, double altitude = 2096) {
  const Vec3 place{40e3, 0, -altitude};
  const Kinematics own = flying({0, 0, kHigh}, 0, 250);
  const Vec3 unit = normalized(place - own.position, {});
  const Vec3 across{0, 1, 0};
  Kinematics other = flying(place, kPi / 2, 250);
  other.velocity = -closing * unit + std::sqrt(250 * 250 - closing * closing) * across;
  return detection_probability(radar, own, sphere(5), other);
}

TEST(Notch, HidesABeamingTargetOnlyWhenLookingDown) {
  const Radar radar{.notch_speed = 50, .notch_edge = 10};
  EXPECT_LT(looking_down(radar, 0), 1e-5);
  EXPECT_LT(looking_down(radar, 39), 1e-5);
  EXPECT_GT(looking_down(radar, 61), 0.9);
  EXPECT_GT(looking_down(radar, 0, 8000), 0.9) << "nothing but sky behind it";
}

/// Below a radar at 8 km a beaming target's echo of 10 m2 stands over the ground's by the fourth
/// power of the altitude over how far below it is.
TEST(Notch, HidesNobodyWhoOutshinesTheGround) {
  const Radar radar{.beam_width = radians(2.4), .range_cell = 150};
  const auto beaming = [&](double below) {
    Kinematics other = flying({5e3, 0, below - 8000}, kPi / 2, 250);
    other.velocity = {0, 250, 0};
    return detection_probability(radar, flying({0, 0, -8000}, 0, 250), sphere(10), other);
  };
  EXPECT_LT(beaming(3000), 0.1);
  EXPECT_GT(beaming(500), 0.9);
}

TEST(Notch, ClosesSmoothlyAndAlikeForComingAndGoing) {
  const Radar radar{.notch_speed = 50, .notch_edge = 10};
  double before = 0;
  for (double speed = 36; speed <= 64; speed += 1) {
    const double p = looking_down(radar, speed);
    EXPECT_GE(p, before);
    before = p;
    EXPECT_NEAR(p, looking_down(radar, -speed), 1e-12) << speed;
  }
}

TEST(Aim, CoversTheScanAndNothingElse) {
  const Radar radar{.instrumented_range = 100e3,
                    .scan_half_azimuth = radians(30),
                    .scan_bars = 4,
                    .bar_spacing = radians(2.5)};
  const Kinematics own = flying({0, 0, kHigh}, radians(40), 250);
  const auto seen = [&](const RadarState& state, double azimuth, double elevation, double range) {
    const double a = own.heading + radians(azimuth), e = radians(elevation);
    const Vec3 sight =
        range * Vec3{std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), -std::sin(e)};
    return covers(aim(radar, state, own), sight, norm2(sight));
  };
  const RadarState ahead{};
  EXPECT_TRUE(seen(ahead, 0, 0, 50e3));
  EXPECT_TRUE(seen(ahead, 29.9, 4.9, 50e3));
  EXPECT_FALSE(seen(ahead, 30.1, 0, 50e3));
  EXPECT_FALSE(seen(ahead, -30.1, 0, 50e3));
  EXPECT_FALSE(seen(ahead, 0, 5.1, 50e3));
  EXPECT_FALSE(seen(ahead, 0, -5.1, 50e3));
  EXPECT_FALSE(seen(ahead, 180, 0, 50e3));
  EXPECT_FALSE(seen(ahead, 0, 0, 100.1e3)) << "beyond the instrumented range";

  const RadarState to_the_right{.scan_azimuth = radians(28), .scan_elevation = radians(-10)};
  EXPECT_TRUE(seen(to_the_right, 55, -12, 50e3));
  EXPECT_FALSE(seen(to_the_right, -10, -12, 50e3));
  EXPECT_FALSE(seen(to_the_right, 55, 0, 50e3));
}

TEST(Aim, IsStabilisedButLimitedByTheGimbal) {
  const Radar radar{.gimbal = radians(60), .scan_half_azimuth = radians(60)};
  const Vec3 level{50e3, 0, 0},
      right{50e3 * std::cos(radians(59)), 50e3 * std::sin(radians(59)), 0};
  // rolling does not move the scan
  const Antenna rolled = aim(radar, {}, flying({}, 0, 250, 0, radians(80)));
  EXPECT_TRUE(covers(rolled, level, norm2(level)));
  EXPECT_TRUE(covers(rolled, right, norm2(right)));
  // nose up 61 degrees: the horizon is out of reach
  const Antenna steep = aim(radar, {}, flying({}, 0, 250, radians(61)));
  EXPECT_FALSE(covers(steep, level, norm2(level)));
  EXPECT_FALSE(within_gimbal(steep.gimbal, level, norm2(level)));
  // nose up 20: straight ahead is fine, the corner is beyond the cone
  const Antenna nose_up = aim(radar, {}, flying({}, 0, 250, radians(20)));
  EXPECT_TRUE(covers(nose_up, level, norm2(level)));
  EXPECT_FALSE(covers(nose_up, right, norm2(right)));
}

TEST(Echo, ShowsTheStrengthThatADetectedSwerlingOneTargetHas) {
  const Detector detector{Radar{.false_alarm = 1e-6}};
  for (const double mean : {5.0, 19.0, 200.0}) {
    // above the threshold T = -ln P_fa an exponential goes on as it began: T + 1 + mean
    double sum = 0;
    int seen = 0;
    constexpr int kLooks = 400000;
    for (int i = 0; i < kLooks; ++i)
      if (const auto echo = detector.echo(mean, (i + 0.5) / kLooks)) {
        EXPECT_GE(*echo, 12.8);
        sum += *echo;
        ++seen;
      }
    EXPECT_NEAR(seen / double(kLooks), detector.probability(mean), 2.0 / kLooks);
    EXPECT_NEAR(sum / seen, -std::log(1e-6) + mean, 0.002 * (13.8 + mean)) << mean;
  }
}

TEST(LookErrors, FallWithTheRootOfTheSignalDownToTheirFloors) {
  const Radar radar{.beam_width = radians(2.4), .range_cell = 150, .speed_cell = 3};
  // 11.1 dB, the threshold: noise is what counts
  const LookErrors weak = errors_of(radar, RadarMode::search, 12.8);
  EXPECT_NEAR(weak.angle, radians(2.4) * std::hypot(0.05, 1 / (1.6 * std::sqrt(2 * 12.8))), 1e-9);
  EXPECT_NEAR(weak.range, 150 * std::hypot(1 / std::sqrt(12.0), 1 / std::sqrt(2 * 12.8)), 1e-9);
  // the strongest: the floors
  const LookErrors strong = errors_of(radar, RadarMode::search, 1e9);
  EXPECT_NEAR(strong.angle, 0.05 * radians(2.4), 1e-8);
  EXPECT_NEAR(strong.range, 150 / std::sqrt(12.0), 1e-4);
  EXPECT_NEAR(strong.range_rate, 3 / std::sqrt(12.0), 1e-6);
  const LookErrors locked = errors_of(radar, RadarMode::track, 1e9);
  EXPECT_NEAR(locked.angle, 0.0125 * radians(2.4), 1e-8);
  // and between them 20 dB are a factor of ten
  const auto noise = [&](double snr) {
    const double e = errors_of(radar, RadarMode::search, snr).angle / radians(2.4);
    return std::sqrt(e * e - 0.05 * 0.05);
  };
  EXPECT_NEAR(noise(20) / noise(2000), 10, 1e-6);
}

TEST(Measure, IsUnbiasedAndAsGoodAsItSays) {
  const LookErrors errors{.range = 50, .range_rate = 3, .angle = radians(0.5)};
  const Kinematics own = flying({0, 0, kHigh}, 0.2, 250);
  const Kinematics other = flying({50e3, 20e3, kHigh - 2000}, 3, 270);
  const Vec3 sight = other.position - own.position;
  const Vec3 unit = normalized(sight, {});
  const double true_speed = dot(other.velocity, unit);
  double along = 0, along2 = 0, across2 = 0, speed2 = 0;
  Vec3 mean;
  constexpr int kLooks = 20000;
  for (int i = 0; i < kLooks; ++i) {
    const Contact c = measure(errors, own, level_axes(own, own.heading), other, kOther,
                              draw(Stream::radar_noise, static_cast<std::uint64_t>(i)));
    const Vec3 error = c.position - other.position;
    const double a = dot(error, unit);
    along += a / kLooks;
    along2 += a * a / kLooks;
    across2 += (norm2(error) - a * a) / kLooks;
    speed2 += (c.speed_along - true_speed) * (c.speed_along - true_speed) / kLooks;
    mean += error / kLooks;
  }
  const double across = norm(sight) * radians(0.5);
  EXPECT_NEAR(std::sqrt(along2), 50, 4);
  EXPECT_NEAR(std::sqrt(across2 / 2), across, 0.03 * across);
  EXPECT_LT(norm(mean), 4 * across * std::sqrt(2.0 / kLooks) + 5);
  EXPECT_LT(std::fabs(along), 6);
  EXPECT_GE(std::sqrt(speed2), 2.9);
}

TEST(Measure, SaysHowGoodTheSpeedAlongTheLineIs) {
  const LookErrors errors{.range = 50, .range_rate = 3, .angle = radians(0.5)};
  const Kinematics own = flying({0, 0, kHigh}, 0, 250);
  for (const double heading : {kPi, kPi / 2, 1.0}) {
    const Kinematics other = flying({30e3, 25e3, kHigh}, heading, 250);
    const double truth = dot(other.velocity, normalized(other.position - own.position, {}));
    double chi2 = 0;
    constexpr int kLooks = 4000;
    for (int i = 0; i < kLooks; ++i) {
      const Contact c = measure(errors, own, level_axes(own, 0), other, kOther,
                                draw(Stream::radar_noise, static_cast<std::uint64_t>(i)));
      const double error = c.speed_along - truth;
      chi2 += error * error / (c.sigma_speed * c.sigma_speed) / kLooks;
    }
    EXPECT_LT(chi2, 1.2) << heading;
  }
}

RC_GTEST_PROP(Look, OfAMirroredSceneIsTheMirroredContactForTheSameDraw, ()) {
  const auto in = [](int low, int high) { return double(*rc::gen::inRange(low, high)); };
  const Radar radar{.scan_half_azimuth = radians(60), .scan_bars = 16, .bar_spacing = 0.1};
  const Kinematics own =
      flying({0, 0, kHigh}, radians(in(-40, 40)), 250, radians(in(-20, 20)), radians(in(-80, 80)));
  const Kinematics other =
      flying({in(20000, 90000), in(-30000, 30000), in(-9000, -1000)}, radians(in(-180, 180)), 250);
  RadarState state{.scan_azimuth = radians(in(-10, 10)), .scan_elevation = radians(in(-5, 5))};
  const Signature fighter{.rcs_front = 10, .rcs_side = 60, .rcs_rear = 20};
  const auto step = static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000));

  const auto contact = look(radar, aim(radar, state, own), own, fighter, other, kOther,
                            draw(Stream::radar, step), draw(Stream::radar_noise, step));
  state.scan_azimuth = -state.scan_azimuth;
  const Kinematics own2 = mirrored(own), other2 = mirrored(other);
  const auto image = look(radar, aim(radar, state, own2), own2, fighter, other2, kOther,
                          draw(Stream::radar, step), draw(Stream::radar_noise, step));
  RC_ASSERT(contact.has_value() == image.has_value());
  RC_PRE(contact.has_value());
  RC_ASSERT(norm(mirrored(contact->position) - image->position) < 1e-6);
  RC_ASSERT(std::fabs(contact->speed_along - image->speed_along) < 1e-9);
}

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
