// SPDX-License-Identifier: MIT
#include "model/sensor/visual.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "support/model/flying.hpp"

namespace eyrie::model::sensor {
namespace {

using test::flying;
using test::mirrored;

TEST(AcquisitionProbability, AccumulatesAsThePoissonProcessOfTheReport) {
  // a target that stays where it is: 1 - exp(-beta A / r^2 exp(-2.996 r / R) t)
  const Visual visual{.rate = 2, .visibility = 20e3};
  const double rate = 17e3 * 30 / (4000.0 * 4000.0) * std::pow(0.05, 4000.0 / 20e3);
  const double per_look = acquisition_probability(visual, 17e3, 30, 4000);
  const double in_ten_seconds = 1 - std::pow(1 - per_look, 20);
  EXPECT_NEAR(in_ten_seconds, 1 - std::exp(-10 * rate), 1e-9);
}

TEST(AcquisitionProbability, OfAHeadOnApproachIsTheClosedFormOfTheReport) {
  // without haze the integral of beta A / r^2 dt at closing speed v is beta A / (v r)
  const Visual visual{.rate = 50, .visibility = 1e9, .range = 1e5, .least_angle = 1e-5};
  const double speed = 500, area = 10, start = 60e3, end = 4e3;
  double unseen = 1;
  for (double range = start; range > end; range -= speed / visual.rate)
    unseen *= 1 - acquisition_probability(visual, 140e3, area, range);
  const double exponent = 140e3 * area / speed * (1 / end - 1 / start);
  EXPECT_NEAR(1 - unseen, 1 - std::exp(-exponent), 0.01);
}

TEST(AcquisitionProbability, DoesNotDependOnHowOftenThePilotLooks) {
  const auto in_six_seconds = [](double rate) {
    const Visual visual{.rate = rate};
    return std::pow(1 - acquisition_probability(visual, 140e3, 20, 6000), 6 * rate);
  };
  EXPECT_NEAR(in_six_seconds(1), in_six_seconds(10), 1e-9);
}

TEST(AcquisitionProbability, EndsWhereTheEyeCannotResolveTheTarget) {
  const Visual visual{.range = 1e5, .least_angle = 0.29e-3};
  const double area = kPi / 4;  // a disc of 1 m
  EXPECT_GT(acquisition_probability(visual, 1e9, area, 1 / 0.2901e-3), 0);
  EXPECT_EQ(acquisition_probability(visual, 1e9, area, 1 / 0.2899e-3), 0);
}

TEST(AcquisitionProbability, IsLessForASmallFarTargetInHaze) {
  const Visual clear, haze{.visibility = 5e3};
  const double p = acquisition_probability(clear, 17e3, 20, 5000);
  EXPECT_LT(acquisition_probability(clear, 17e3, 10, 5000), p);
  EXPECT_LT(acquisition_probability(clear, 17e3, 20, 6000), p);
  EXPECT_LT(acquisition_probability(haze, 17e3, 20, 5000), p);
  EXPECT_GT(acquisition_probability(clear, 140e3, 20, 5000), p);
}

TEST(Glimpsed, ByAnEyeThatHoldsHimEndsWhereItCannotResolveHimEither) {
  const Visual visual{.least_angle = 0.29e-3, .hold_probability = 1};
  const Signature disc{.area_front = kPi / 4, .area_side = kPi / 4, .area_top = kPi / 4};  // of 1 m
  const auto held_at = [&](double range) {
    return glimpsed(visual, eyes_of(flying({0, 0, -5000}, 0, 250)),
                    flying({range, 0, -5000}, kPi, 250), disc, range, Cue::held, 0.5);
  };
  EXPECT_TRUE(held_at(1 / 0.2901e-3));
  EXPECT_FALSE(held_at(1 / 0.2899e-3));
}

bool sees(const Kinematics& own, double azimuth, double elevation) {
  const Visual visual{
      .over_nose = radians(15), .over_side = radians(40), .tail_blind = radians(30)};
  const double a = radians(azimuth), e = radians(elevation);
  const Vec3 unit{std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), -std::sin(e)};
  return in_view(visual, eyes_of(own), unit);
}

TEST(InView, HasTheBlindZonesOfTheCockpit) {
  const Kinematics level = flying({}, 0, 250);
  EXPECT_TRUE(sees(level, 0, 0));
  EXPECT_TRUE(sees(level, 0, -14));
  EXPECT_FALSE(sees(level, 0, -16)) << "under the nose";
  EXPECT_TRUE(sees(level, 90, -39));
  EXPECT_FALSE(sees(level, -90, -41)) << "under the wing";
  EXPECT_TRUE(sees(level, 0, 90));
  EXPECT_TRUE(sees(level, 149, 0));
  EXPECT_FALSE(sees(level, 180, 0)) << "the six";
  EXPECT_FALSE(sees(level, -155, 0));
  EXPECT_FALSE(sees(level, 0, -90));
}

TEST(InView, TurnsWithTheAircraft) {
  const Kinematics inverted = flying({}, 0, 250, 0, kPi);
  EXPECT_TRUE(sees(inverted, 0, -90));
  EXPECT_FALSE(sees(inverted, 0, 90));
  EXPECT_FALSE(sees(inverted, 0, 16));
}

RC_GTEST_PROP(InView, IsTheSameLeftAndRight, ()) {
  const auto in = [](int low, int high) { return double(*rc::gen::inRange(low, high)); };
  const Kinematics own =
      flying({}, radians(in(-179, 180)), 250, radians(in(-80, 80)), radians(in(-179, 180)));
  const Vec3 unit = normalized({in(-9, 10), in(-9, 10), in(-9, 10)}, {1, 0, 0});
  const Visual visual;
  RC_ASSERT(in_view(visual, eyes_of(own), unit) ==
            in_view(visual, eyes_of(mirrored(own)), mirrored(unit)));
}

TEST(Estimate, IsGoodInDirectionAndPoorInRange) {
  const Visual visual{.sigma_range = 0.2, .sigma_angle = radians(1)};
  const Kinematics own = flying({0, 0, -5000}, 0.4, 250, 0.1, 0.5);
  const Vec3 place{3000, -2000, -4500};
  const Vec3 unit = normalized(place - own.position, {});
  const double range = norm(place - own.position);
  double along2 = 0, across2 = 0;
  constexpr int kLooks = 20000;
  for (int i = 0; i < kLooks; ++i) {
    const Contact c = estimate(visual, eyes_of(own), place, PlayerId{2},
                               Draw(3, PlayerId{1}, Stream::visual, static_cast<std::uint64_t>(i)));
    const Vec3 error = c.position - place;
    const double along = dot(error, unit);
    along2 += along * along / kLooks;
    across2 += (norm2(error) - along * along) / kLooks / 2;
    ASSERT_EQ(c.sigma_speed, 0) << "the eye measures no speed";
  }
  EXPECT_NEAR(std::sqrt(along2), 0.2 * range, 0.01 * range);
  EXPECT_NEAR(std::sqrt(across2), radians(1) * range, 0.05 * radians(1) * range);
}

RC_GTEST_PROP(Estimate, OfAMirroredSceneIsTheMirroredContact, ()) {
  const auto in = [](int low, int high) { return double(*rc::gen::inRange(low, high)); };
  const Kinematics own =
      flying({}, radians(in(-179, 180)), 250, radians(in(-80, 80)), radians(in(-179, 180)));
  const Vec3 place{in(-4000, 4000), in(-4000, 4000), in(-4000, 4000)};
  RC_PRE(norm(place) > 100 && norm(cross(place, eyes_of(own).body.forward)) > 1);
  const Draw draw(1, PlayerId{1}, Stream::visual, static_cast<std::uint64_t>(in(0, 1000)));
  const Contact c = estimate({}, eyes_of(own), place, PlayerId{2}, draw);
  const Contact m = estimate({}, eyes_of(mirrored(own)), mirrored(place), PlayerId{2}, draw);
  RC_ASSERT(norm(mirrored(c.position) - m.position) < 1e-6);
}

TEST(LooksDangerous, OnlyWhatComesCloserOnASteadyBearing) {
  const Visual visual{.steady_rate = radians(3)};
  const Vec3 ahead{5000, 0, 0};
  EXPECT_TRUE(looks_dangerous(visual, ahead, {-900, 0, 0}));
  EXPECT_FALSE(looks_dangerous(visual, ahead, {900, 0, 0})) << "it goes away";
  EXPECT_FALSE(looks_dangerous(visual, ahead, {-500, 300, 0})) << "it crosses at 3.4 deg/s";
  EXPECT_TRUE(looks_dangerous(visual, ahead, {-500, 250, 0}));
}

}  // namespace
}  // namespace eyrie::model::sensor
