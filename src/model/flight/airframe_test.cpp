// SPDX-License-Identifier: MIT
/// \file  The airframes in data/: their tables come from the formulas they name, and what public
/// sources say of the aircraft comes out of them. docs/models/flight.md has the list.
#include "model/flight/airframe.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string>

#include "support/data_file.hpp"
#include "support/model/lapse.hpp"
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

using test::TestFlight;

/// What is published of a type, and how well the textbook methods meet it.
struct Published {
  const char* name;
  double static_military, static_afterburner;  // N, all engines, on the test bench
  bool variable_inlet;
  double slowest_top, fastest_top;         // Mach at 11 km, clean, half the fuel
  double top_at_sea_level;                 // Mach
  double least_climb, greatest_climb;      // m/s at sea level with afterburner and missiles
  double lowest_ceiling, highest_ceiling;  // m, with afterburner and missiles

  friend void PrintTo(const Published& p, std::ostream* out) { *out << p.name; }
};

const Published kAircraft[] = {
    // F-15: Mach 2.5, 65,000 ft, 67,250 ft/min (press history)
    {"f15c", si(2 * 14690, "lbf"), si(2 * 23840, "lbf"), true, 2.3, 2.55, 1.2, 290, 380, 18e3,
     22.5e3},
    // F-16: Mach 2.0, above 50,000 ft, 50,000 ft/min with the first, weaker engine
    {"f16c", si(17800, "lbf"), si(29000, "lbf"), false, 1.85, 2.1, 1.2, 254, 390, 15.2e3, 21e3},
    // MiG-29: 2,450 km/h, 18 km, 330 m/s
    {"mig29", 2 * 49.4e3, 2 * 81.4e3, true, 2.2, 2.45, 1.15, 280, 360, 17.5e3, 21e3},
    // Su-27: 2,500 km/h, 18.5 km, 300 m/s
    {"su27", 2 * 76.2e3, 2 * 122.6e3, true, 2.2, 2.45, 1.14, 270, 330, 18e3, 21e3},
};

class AirframeData : public testing::TestWithParam<Published> {
 protected:
  const Published& published() const { return GetParam(); }
  Airframe airframe_ =
      eyrie::test::load<Airframe>(std::string("data/airframes/") + GetParam().name + ".yaml");
  PointMass model_{airframe_};
  Load missiles_{.mass = 600, .drag_area = 0.06};

  /// m/s of energy height that full power leaves in level flight; half the fuel.
  [[nodiscard]] double excess_power(double mach, double altitude, const Load& load,
                                    double load_factor = 1) const {
    const Air air = standard_air(altitude);
    Kinematics k;
    k.speed = mach * air.speed_of_sound;
    k.altitude = altitude;
    const FlightCondition c = model_.condition(k, air, airframe_.internal_fuel / 2, load);
    if (c.lift_limit < load_factor)
      return -1e9;
    return (c.thrust.afterburner - c.drag(load_factor)) / (c.mass * kGravity) * k.speed;
  }
  [[nodiscard]] double top_mach(double altitude) const {
    double top = 0;
    for (double mach = 0.5; mach < 2.7; mach += 0.005)
      if (excess_power(mach, altitude, {}) > 0)
        top = mach;
    return top;
  }
};

TEST_P(AirframeData, HasTheThrustOfTheFormulaItNames) {
  const auto check = [&](const Table2& table, double rated, auto lapse, bool variable) {
    const std::size_t columns = table.columns().size();
    for (std::size_t i = 0; i < table.rows().size(); ++i)
      for (std::size_t j = 0; j < columns; ++j) {
        const double mach = table.rows().breakpoints()[i];
        const Air air = standard_air(table.columns().breakpoints()[j]);
        double formula = lapse(mach, air, 1.07);
        if (variable && mach > 1.5)
          formula = std::max(formula, lapse(1.5, air, 1.07));
        const double thrust = table.values()[i * columns + j];
        const double printed = thrust < 10e3 ? 5.1 : 51;  // half a digit, N
        if (formula * rated > 0.05 * rated * air.pressure / kSeaLevelPressure) {
          EXPECT_NEAR(thrust, formula * rated, printed) << mach;
        } else {  // where the formula gives nothing, a little is left
          EXPECT_GT(thrust, 0) << mach;
          EXPECT_LT(thrust, 0.06 * rated * air.pressure / kSeaLevelPressure) << mach;
        }
      }
  };
  check(airframe_.engine.military, 0.84 * published().static_military / 0.6,
        test::installed_military, false);
  check(airframe_.engine.afterburner, 0.95 * published().static_afterburner, afterburner_lapse,
        published().variable_inlet);
}

TEST_P(AirframeData, ReachesItsPublishedTopSpeed) {
  EXPECT_GE(top_mach(11000), published().slowest_top);
  EXPECT_LE(top_mach(11000), published().fastest_top);
  EXPECT_NEAR(top_mach(0), published().top_at_sea_level, 0.05);
}

TEST_P(AirframeData, FliesAsFastAsItsThrustAndLimitsLetIt) {
  TestFlight f(airframe_);
  f.propulsion.fuel = airframe_.internal_fuel;
  f.start(11000, 0, 400);
  f.command.speed = 900;
  double fastest = 0;
  for (int i = 0; i < 50 * 400; ++i) {
    f.propulsion.fuel = airframe_.internal_fuel / 2;
    f.step();
    fastest = std::max(fastest, f.kinematics.mach);
  }
  EXPECT_NEAR(fastest, std::min(top_mach(11000), airframe_.limits.max_mach), 0.06);
}

TEST_P(AirframeData, ClimbsAtItsPublishedRate) {
  double best = 0;
  for (double mach = 0.3; mach < 1.1; mach += 0.01)
    best = std::max(best, excess_power(mach, 0, missiles_));
  EXPECT_GE(best, published().least_climb);
  EXPECT_LE(best, published().greatest_climb);
}

TEST_P(AirframeData, ReachesItsPublishedCeiling) {
  // service ceiling: 100 ft/min are left
  double ceiling = 0;
  for (double altitude = 10e3; altitude < 25e3; altitude += 100)
    for (double mach = 0.5; mach < airframe_.limits.max_mach; mach += 0.02)
      if (excess_power(mach, altitude, missiles_) > si(100, "ft/min"))
        ceiling = altitude;
  EXPECT_GE(ceiling, published().lowest_ceiling);
  EXPECT_LE(ceiling, published().highest_ceiling);
}

TEST_P(AirframeData, TurnsLikeAFighterOfItsGeneration) {
  // sustained at 15,000 ft with afterburner and missiles, somewhere between Mach 0.6 and 1
  double sustained = 0;
  for (double g = 3; g < 10; g += 0.05)
    for (double mach = 0.6; mach < 1; mach += 0.02)
      if (excess_power(mach, si(15000, "ft"), missiles_, g) > 0)
        sustained = g;
  EXPECT_GE(sustained, 6.5);
  EXPECT_LE(sustained, 9);
  // corner speed at sea level: the slowest at which the wing gives 9 g
  Kinematics k;
  k.speed = 200;
  const FlightCondition c =
      model_.condition(k, standard_air(0), airframe_.internal_fuel / 2, missiles_);
  const double corner = 200 * std::sqrt(9 / c.lift_limit);
  EXPECT_GE(corner, si(330, "kt"));
  EXPECT_LE(corner, si(440, "kt"));
}

TEST_P(AirframeData, CruisesDryForMoreThanAnHour) {
  TestFlight f(airframe_);
  f.load = missiles_;
  f.propulsion.fuel = airframe_.internal_fuel;
  f.start(si(35000, "ft"), 0, 250);
  f.run(3600);
  EXPECT_GT(f.propulsion.fuel, 0.05 * airframe_.internal_fuel);
  EXPECT_LT(f.propulsion.fuel, 0.82 * airframe_.internal_fuel);
  EXPECT_EQ(f.flying.afterburner, 0);
  EXPECT_NEAR(f.kinematics.altitude, si(35000, "ft"), 1);
}

TEST_P(AirframeData, BurnsAtFullAfterburnerWhatItsRatingSays) {
  const Engine& e = airframe_.engine;
  const Thrust full = e.thrust_at(0, 0);
  const double flow = e.flow_of(full, 2, 0, kSeaLevelTemperature);
  EXPECT_NEAR(flow, e.afterburner_tsfc * full.afterburner, 1e-9);
  // minutes of full afterburner at sea level on internal fuel: a handful
  EXPECT_GT(airframe_.internal_fuel / flow / 60, 4);
  EXPECT_LT(airframe_.internal_fuel / flow / 60, 13);
}

INSTANTIATE_TEST_SUITE_P(All, AirframeData, testing::ValuesIn(kAircraft),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace eyrie::model::flight
