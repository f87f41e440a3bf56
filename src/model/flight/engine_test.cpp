// SPDX-License-Identifier: MIT
#include "model/flight/engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support/model/lone_flight.hpp"

namespace eyrie::model::flight {
namespace {

TEST(Lapse, GivesTheNumbersOfTheBooksExample) {
  // Mattingly, Heiser & Pratt, ch. 2, supercruise: Mach 1.5 at 30,000 ft, throttle ratio 1.07
  const Air air = standard_air(si(30000, "ft"));
  EXPECT_NEAR(military_lapse(1.5, air, 1.07), 0.4792, 0.0015);
  // ch. 3, warm-up: at rest at 2,000 ft on a 100 F day, temperature ratio 1.0796
  Air hot = standard_air(si(2000, "ft"));
  hot.temperature = 1.0796 * kSeaLevelTemperature;
  EXPECT_NEAR(military_lapse(0, hot, 1.07), 0.5390, 0.0005);
}

TEST(Lapse, IsTheStagnationPressureBelowTheThetaBreak) {
  const Air air = standard_air(10000);
  EXPECT_NEAR(afterburner_lapse(0.8, air, 1.07),
              air.pressure / kSeaLevelPressure * std::pow(1 + 0.2 * 0.64, 3.5), 1e-12);
  EXPECT_NEAR(military_lapse(0.8, air, 1.07), 0.6 * afterburner_lapse(0.8, air, 1.07), 1e-12);
  EXPECT_NEAR(afterburner_lapse(0, standard_air(0), 1.07), 1, 1e-12);
}

/// Nguyen et al., NASA TP-1538 (1979), installed thrust of the F-16's F100-PW-200 in lbf: rows Mach
/// 0 to 1 in steps of 0.2, columns 0 to 50,000 ft in steps of 10,000 ft.
using ThrustTable = std::array<std::array<double, 6>, 6>;
constexpr ThrustTable kMaximum = {{{20000, 15000, 10800, 7000, 4000, 2500},
                                   {21420, 15700, 11225, 7323, 4435, 2600},
                                   {22700, 16860, 12250, 8154, 5000, 2835},
                                   {24240, 18910, 13760, 9285, 5700, 3215},
                                   {26070, 21075, 15975, 11115, 6860, 3950},
                                   {28886, 23319, 18300, 13484, 8642, 5057}}};
constexpr ThrustTable kMilitary = {{{12680, 9150, 6200, 3950, 2450, 1400},
                                    {12680, 9150, 6313, 4040, 2470, 1400},
                                    {12610, 9312, 6610, 4290, 2600, 1560},
                                    {12640, 9839, 7090, 4660, 2840, 1660},
                                    {12390, 10176, 7750, 5320, 3250, 1930},
                                    {11680, 9848, 8050, 6100, 3800, 2310}}};

struct Deviation {
  double mean = 0, worst = 0;
};
template <class Lapse>
Deviation deviation(const ThrustTable& table, double static_thrust, Lapse lapse) {
  Deviation d;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      const Air air = standard_air(si(10000, "ft") * static_cast<double>(j));
      const double off = std::fabs(
          static_thrust * lapse(0.2 * static_cast<double>(i), air, 1.07) / table[i][j] - 1);
      d.mean += off / 36;
      d.worst = std::max(d.worst, off);
    }
  return d;
}

TEST(Lapse, StaysNearThePublishedThrustOfAFighter) {
  // rated static thrust 23,830 and 14,670 lbf, with the installation factors that data/ uses
  const Deviation maximum = deviation(kMaximum, 0.95 * 23830, afterburner_lapse);
  EXPECT_LT(maximum.mean, 0.061);
  EXPECT_LT(maximum.worst, 0.19);
  const Deviation military = deviation(kMilitary, 0.84 * 14670 / 0.6, test::installed_military);
  EXPECT_LT(military.mean, 0.063);
  EXPECT_LT(military.worst, 0.24);
}

Engine engine() {
  Engine e;
  e.military = Table2::constant(50e3);
  e.afterburner = Table2::constant(80e3);
  e.idle_share = 0.1;
  return e;
}

TEST(Engine, GivesThrustLinearlyFromIdleOverMilitaryPowerToAfterburner) {
  const Thrust t = engine().thrust_at(0.8, 5000);
  EXPECT_DOUBLE_EQ(Engine::thrust_of(t, 0), 5e3);
  EXPECT_DOUBLE_EQ(Engine::thrust_of(t, 0.5), 27.5e3);
  EXPECT_DOUBLE_EQ(Engine::thrust_of(t, 1), 50e3);
  EXPECT_DOUBLE_EQ(Engine::thrust_of(t, 1.5), 65e3);
  EXPECT_DOUBLE_EQ(Engine::thrust_of(t, 2), 80e3);
}

TEST(Engine, FindsTheThrottleOfAThrust) {
  const Thrust t = engine().thrust_at(0.8, 5000);
  for (const double throttle : {0.0, 0.3, 1.0, 1.4, 2.0})
    EXPECT_NEAR(Engine::throttle_for(t, Engine::thrust_of(t, throttle), true), throttle, 1e-12);
  EXPECT_EQ(Engine::throttle_for(t, 70e3, false), 1) << "no afterburner without leave";
  EXPECT_EQ(Engine::throttle_for(t, 1e6, true), 2);
  EXPECT_EQ(Engine::throttle_for(t, -1e6, true), 0);
}

TEST(Engine, BurnsWhatTheSpecificConsumptionSays) {
  // Mattingly, eq. 3.12 and 3.55: (C1 + C2 M) sqrt(theta) pounds per pound of thrust and hour
  Engine e = engine();
  e.military_tsfc = si(0.9, "lb/lbf/h");
  e.military_tsfc_mach = 0.30 / 0.9;
  e.afterburner_tsfc = si(1.6, "lb/lbf/h");
  e.afterburner_tsfc_mach = 0.27 / 1.6;
  const Thrust t = e.thrust_at(0.8, 0);
  const double temperature = 0.8 * kSeaLevelTemperature, root = std::sqrt(0.8);
  const double dry = (0.9 + 0.30 * 0.8) * root, wet = (1.6 + 0.27 * 0.8) * root;
  const auto pounds_per_hour = [&](double throttle) {
    return in_unit(e.flow_of(t, throttle, 0.8, temperature), "lb/h");
  };
  EXPECT_NEAR(pounds_per_hour(1), dry * in_unit(50e3, "lbf"), 1e-6);
  EXPECT_NEAR(pounds_per_hour(2), wet * in_unit(80e3, "lbf"), 1e-6);
  EXPECT_NEAR(pounds_per_hour(1.5), (pounds_per_hour(1) + pounds_per_hour(2)) / 2, 1e-6);
  EXPECT_NEAR(pounds_per_hour(0), dry * in_unit(5e3, "lbf"), 1e-6);
  e.idle_flow = si(2000, "lb/h");
  EXPECT_NEAR(pounds_per_hour(0), 2000, 1e-9);
}

TEST(Engine, SpoolsUpAndLightsInTheTimesGiven) {
  Engine e = engine();
  e.spool_time = 4;
  e.light_time = 2;
  double throttle = 0, seconds = 0;
  for (; throttle < 1 - 1e-9; seconds += 0.02)
    throttle = e.spool(throttle, 2, 0.02);
  EXPECT_NEAR(seconds, 4, 0.021);
  for (; throttle < 2 - 1e-9; seconds += 0.02)
    throttle = e.spool(throttle, 2, 0.02);
  EXPECT_NEAR(seconds, 6, 0.041);
}

}  // namespace
}  // namespace eyrie::model::flight
