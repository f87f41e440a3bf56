// SPDX-License-Identifier: MIT
#include "model/jamming.hpp"

#include <gtest/gtest.h>

#include "model/sensor/radar.hpp"

namespace eyrie::model {
namespace {

TEST(Jamming, IsTheOneWayRangeEquationOverTheReceiversNoise) {
  // by hand: 1 kW over 500 MHz, 2.4 degrees (36.5 dB), 3 cm, 100 km, -200 dBW/Hz
  const double density = Jammer{.power = 1e3, .bandwidth = 500e6}.density();
  EXPECT_NEAR(10 * std::log10(antenna_gain(si(2.4, "deg"))), 36.5, 0.1);
  const double one_way = -57.0 + 36.5 + 20 * std::log10(0.03 / (4 * kPi)) - 100.0;
  EXPECT_NEAR(10 * std::log10(jamming_to_noise(density, si(2.4, "deg"), 1e10)), one_way + 200.0,
              0.1);
  EXPECT_NEAR(jamming_to_noise(density, 0.05, 4e10) / jamming_to_noise(density, 0.05, 1e10), 0.25,
              1e-12);
}

TEST(BurnThrough, IsWhereTheEchoIsAsGoodAsWithoutJammingAtTheOldRange) {
  const sensor::Radar radar;
  const sensor::Detector detector(radar);
  for (const double power : {1e-3, 1.0, 1e3, 1e6})
    for (const double rcs : {1.0, 5.0, 15.0}) {
      const double clean = radar.reference_range * std::sqrt(std::sqrt(rcs / radar.reference_rcs));
      const double at_1_m = jamming_to_noise(power / 500e6, radar.beam_width, 1);
      const double range = burn_through(clean, at_1_m), range2 = range * range;
      const double echo = detector.signal_to_noise(range2, rcs) / (1 + at_1_m / range2);
      EXPECT_NEAR(detector.probability(echo), radar.reference_probability, 1e-9) << power;
      EXPECT_LT(range, clean);
    }
}

TEST(BurnThrough, FallsWithTheRootOfTheJammersPowerAndGrowsWithTheRootOfTheCrossSection) {
  // strong jamming: R^2 = range^4 / (J/N at 1 m), the textbook form
  const double near = burn_through(150e3, 1e14), nearer = burn_through(150e3, 4e14);
  EXPECT_NEAR(near / nearer, 2, 0.01);
  EXPECT_NEAR(near, 150e3 * 150e3 / 1e7, 20);
  // twice the range without jamming is 16 times the cross section
  EXPECT_NEAR(burn_through(300e3, 4e14) / nearer, 4, 0.02);
  EXPECT_EQ(burn_through(150e3, 0), 150e3);
}

/// By hand: 60 dB, 9 cm^2 and 4 pi make 18.6 dB over 1 m^2.
TEST(PullOff, OfARepeaterIsTheEchoOfASectionThatIsItsGainTimesLambdaSquaredOverFourPi) {
  const PullOff pull;
  EXPECT_NEAR(10 * std::log10(pull.section()), 60 - 30.46 - 10.99, 0.01);
  EXPECT_NEAR((PullOff{.gain = 70}.section()) / pull.section(), 10, 1e-12);
}

TEST(PullOff, MovesAwayWithItsAccelerationAndBeginsAnew) {
  PullOff pull{.acceleration = 20, .walk_time = 8, .pause_time = 4};
  EXPECT_EQ(pull.phase(0), 0);
  EXPECT_EQ(pull.phase(7), 7);
  EXPECT_FALSE(pull.phase(8));
  EXPECT_FALSE(pull.phase(23.9));
  EXPECT_EQ(pull.phase(26), 2);
  EXPECT_EQ(pull.at(8).range, 640);
  EXPECT_EQ(pull.at(8).speed, 160);
  pull.gates = Gates::range;
  EXPECT_EQ(pull.at(8).speed, 0);
  pull.gates = Gates::speed;
  EXPECT_EQ(pull.at(8).range, 0);
}

}  // namespace
}  // namespace eyrie::model
