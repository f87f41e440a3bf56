// SPDX-License-Identifier: MIT
/// \file  The airframes in data/: their tables come from the formulas they name, and what public
/// sources say of the aircraft comes out of them. docs/models/flight.md has the list.
#include "model/flight/performance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <string>

#include "model/flight/equations.hpp"
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

struct Deviation {
  double mean = 0, worst = 0;
};
template <class Lapse>
Deviation deviation(const ThrustTable& table, double static_thrust, Lapse lapse) {
  Deviation d;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) {
      const Air air = standard_air(si(10000, "ft") * static_cast<double>(j));
      const double off = std::fabs(static_thrust * lapse(0.2 * static_cast<double>(i), air, 1.07) /
                                       table.installed[i][j] -
                                   1);
      d.mean += off / 36;
      d.worst = std::max(d.worst, off);
    }
  return d;
}

TEST(Lapse, LosesByInstallationWhatPublishedThrustSays) {
  // what TSFC in data/ is divided by, from the rated static thrust to the thrust in flight
  const Deviation maximum = deviation(kMaximum, 0.95 * kMaximum.rated, afterburner_lapse);
  EXPECT_LT(maximum.mean, 0.061);
  EXPECT_LT(maximum.worst, 0.19);
  const auto military = [](double mach, const Air& air, double throttle_ratio) {
    return military_lapse(mach, air, throttle_ratio) * (1 - 0.3 * std::max(mach - 0.6, 0.0));
  };
  const Deviation dry = deviation(kMilitary, 0.84 * kMilitary.rated / 0.6, military);
  EXPECT_LT(dry.mean, 0.063);
  EXPECT_LT(dry.worst, 0.24);
}

TEST(Lapse, GivesThePublishedThrustAtItsPoints) {
  for (const ThrustTable* table : {&kMaximum, &kMilitary})
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        EXPECT_NEAR(table->rated * published_lapse(*table, 0.2 * static_cast<double>(i),
                                                   si(10000, "ft") * static_cast<double>(j)),
                    table->installed[i][j], 1e-6);
}

Engine engine() {
  Engine e;
  e.military = Table2::constant(50e3);
  e.afterburner = Table2::constant(80e3);
  e.idle_share = 0.1;
  return e;
}

/// Of aircraft with that engine.
double flow_of(const Engine& e, const Thrust& available, double throttle, double mach,
               double temperature) {
  Airframe airframe;
  airframe.engine = e;
  const PointMass model(airframe);
  return Equations<double>({&model}).flow_of(available, throttle, mach, temperature);
}
double spool(const Engine& e, double throttle, double wanted, double dt) {
  Airframe airframe;
  airframe.engine = e;
  const PointMass model(airframe);
  return Equations<double>({&model}).spool(throttle, wanted, dt);
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
    return in_unit(flow_of(e, t, throttle, 0.8, temperature), "lb/h");
  };
  EXPECT_NEAR(pounds_per_hour(1), dry * in_unit(50e3, "lbf"), 1e-6);
  EXPECT_NEAR(pounds_per_hour(2), wet * in_unit(80e3, "lbf"), 1e-6);
  EXPECT_NEAR(pounds_per_hour(1.5), (pounds_per_hour(1) + pounds_per_hour(2)) / 2, 1e-6);
  e.idle_flow = si(5000, "lb/h");
  EXPECT_NEAR(pounds_per_hour(0), 5000, 1e-9);
}

TEST(Engine, BurnsMorePerThrustAtPartPower) {
  // JSBSim, FGTurbine: TSFC as 0.84 + (1 - n)^2, thrust as n^2, n from 0 at idle to 1
  const Engine e = engine();
  const Thrust t = e.thrust_at(0.8, 0);
  const double full = flow_of(e, t, 1, 0.8, kSeaLevelTemperature);
  for (int i = 1; i <= 10; ++i) {
    const double x = 0.1 * i;
    const double throttle = Engine::throttle_for(t, x * t.military, false);
    EXPECT_NEAR(flow_of(e, t, throttle, 0.8, kSeaLevelTemperature) / full,
                x * (0.84 + std::pow(1 - std::sqrt(x), 2)) / 0.84, 1e-4);
  }
  EXPECT_EQ(flow_of(e, Thrust{}, 0.5, 0.8, kSeaLevelTemperature), 0) << "an engine without thrust";
}

TEST(Engine, SpoolsUpAndLightsInTheTimesGiven) {
  Engine e = engine();
  e.spool_time = 4;
  e.light_time = 2;
  double throttle = 0, seconds = 0;
  for (; throttle < 1 - 1e-9; seconds += 0.02)
    throttle = spool(e, throttle, 2, 0.02);
  EXPECT_NEAR(seconds, 4, 0.021);
  for (; throttle < 2 - 1e-9; seconds += 0.02)
    throttle = spool(e, throttle, 2, 0.02);
  EXPECT_NEAR(seconds, 6, 0.041);
}

using test::TestFlight;

/// What is published of a type: docs/models/flight.md has the sources.
struct Published {
  const char* name;
  double static_military, static_afterburner;  // N, all engines, on the test bench
  bool variable_inlet;
  double top, top_at_sea_level;        // Mach at 11 km and at sea level, clean, half the fuel
  double least_climb, greatest_climb;  // m/s at sea level with afterburner and missiles
  double ceiling;                      // m, with afterburner and missiles
  double range;                        // m on internal fuel with missiles; 0: nothing published
  double range_at_sea_level;           // m

  friend void PrintTo(const Published& p, std::ostream* out) { *out << p.name; }
};

const Published kAircraft[] = {
    // F-15: Mach 2.5, 65,000 ft, 67,250 ft/min
    {"f15c", si(2 * 14690, "lbf"), si(2 * 23840, "lbf"), true, 2.5, 1.2, 290, 380, 19.8e3, 0, 0},
    // F-16: Mach 2.0, above 55,000 ft, 50,000 ft/min with the first, weaker engine
    {"f16c", si(17800, "lbf"), si(29000, "lbf"), false, 2.0, 1.2, 254, 390, 18e3, 0, 0},
    // MiG-29: 2,450 km/h, 18 km, 330 m/s, 1,500 km and near the ground 700 km
    {"mig29", 2 * 49.4e3, 2 * 81.4e3, true, 2.3, 1.15, 280, 360, 18e3, 1500e3, 700e3},
    // Su-27: 2,500 km/h, 18.5 km, 300 m/s, 3,530 km and near the ground 1,340 km
    {"su27", 2 * 76.2e3, 2 * 122.6e3, true, 2.35, 1.14, 260, 330, 18.5e3, 3530e3, 1340e3},
};

class AirframeData : public testing::TestWithParam<Published> {
 protected:
  const Published& published() const { return GetParam(); }
  Airframe airframe_ =
      eyrie::test::load<Airframe>(std::string("data/airframes/") + GetParam().name + ".yaml");
  PointMass model_{airframe_};
  Load missiles_{.mass = 800, .drag_area = 0.07};
  Performance clean_{.model = model_, .fuel = airframe_.internal_fuel / 2};
  Performance armed_{.model = model_, .load = missiles_, .fuel = airframe_.internal_fuel / 2};
};

TEST_P(AirframeData, HasTheThrustOfTheFormulaItNames) {
  const auto check = [&](const Table2& table, double rated, auto lapse, bool variable) {
    const std::size_t columns = table.columns().size();
    for (std::size_t i = 0; i < table.rows().size(); ++i)
      for (std::size_t j = 0; j < columns; ++j) {
        const double mach = table.rows().breakpoints()[i];
        const double altitude = table.columns().breakpoints()[j];
        // where the formula gives nothing, a little is left
        const double least = 0.05 * standard_air(altitude).pressure / kSeaLevelPressure;
        const double formula = lapse(variable ? std::min(mach, 1.5) : mach, altitude);
        const double thrust = table.values()[i * columns + j];
        EXPECT_NEAR(thrust, std::max(formula, least) * rated, thrust < 20e3 ? 6 : 60)
            << mach << ' ' << altitude;
      }
  };
  check(airframe_.engine.military, published().static_military, installed_military, false);
  check(airframe_.engine.afterburner, published().static_afterburner, installed_afterburner,
        published().variable_inlet);
}

TEST_P(AirframeData, ReachesItsPublishedTopSpeed) {
  const auto top = [&](double altitude) { return clean_.top_mach(altitude, Power::afterburner); };
  EXPECT_NEAR(top(11000) / published().top, 1, 0.1);
  EXPECT_NEAR(top(0) / published().top_at_sea_level, 1, 0.1);
}

TEST_P(AirframeData, HardlyPassesMachOneAtMilitaryPower) {
  for (const double altitude : {9e3, 10e3, 11e3}) {
    EXPECT_GE(armed_.top_mach(altitude, Power::military), 0.95) << altitude;
    EXPECT_LE(armed_.top_mach(altitude, Power::military), 1.08) << altitude;
  }
}

TEST_P(AirframeData, AcceleratesThroughMachOneInAboutAMinute) {
  const double time = armed_.acceleration_time(si(30000, "ft"), 0.8, 1.6);
  EXPECT_GE(time, 54);
  EXPECT_LE(time, 72);
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
  EXPECT_NEAR(fastest,
              std::min(clean_.top_mach(11000, Power::afterburner), airframe_.limits.max_mach),
              0.06);
}

TEST_P(AirframeData, ClimbsAtItsPublishedRate) {
  double best = 0;
  for (double mach = 0.3; mach < 1.1; mach += 0.01)
    best = std::max(best, armed_.excess_power(mach, 0, Power::afterburner));
  EXPECT_GE(best, published().least_climb);
  EXPECT_LE(best, published().greatest_climb);
}

TEST_P(AirframeData, ReachesItsPublishedCeiling) {
  const double ceiling = armed_.ceiling(si(100, "ft/min"), Power::afterburner);
  EXPECT_NEAR(ceiling / published().ceiling, 1, 0.1) << ceiling;
}

TEST_P(AirframeData, FliesItsPublishedRange) {
  Performance full = armed_;
  full.fuel = airframe_.internal_fuel;
  const Cruise high = full.best_cruise(8e3, 15e3), low = full.best_cruise(100, 100);
  if (published().range > 0) {
    EXPECT_NEAR(high.range / published().range, 1, 0.1) << high.range;
    EXPECT_NEAR(low.range / published().range_at_sea_level, 1, 0.1) << low.range;
  }
  EXPECT_GT(high.range, 2.2 * low.range);
  EXPECT_GT(high.mach, 0.8);
}

TEST_P(AirframeData, TurnsLikeAFighterOfItsGeneration) {
  // sustained at 15,000 ft and Mach 0.9 with afterburner and missiles
  const double sustained = armed_.sustained_load_factor(0.9, si(15000, "ft"));
  EXPECT_GE(sustained, 5.8);
  EXPECT_LE(sustained, 7.2);
  // at 30,000 ft the best sustained turn is not supersonic
  double best = 0, at = 0;
  for (double mach = 0.5; mach < 1.6; mach += 0.01) {
    const double rate = turn_rate(armed_.sustained_load_factor(mach, si(30000, "ft")), mach);
    if (rate > best) {
      best = rate;
      at = mach;
    }
  }
  EXPECT_LT(at, 1);
  // corner speed at sea level: the slowest at which the wing gives 9 g
  const double mach = 200 / standard_air(0).speed_of_sound;
  const double corner = 200 * std::sqrt(9 / armed_.at(mach, 0).lift_limit);
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
  const double flow = flow_of(e, full, 2, 0, kSeaLevelTemperature);
  EXPECT_NEAR(flow, e.afterburner_tsfc * full.afterburner, 1e-9);
  // minutes of full afterburner at sea level on internal fuel: a handful
  EXPECT_GT(airframe_.internal_fuel / flow / 60, 4);
  EXPECT_LT(airframe_.internal_fuel / flow / 60, 14);
}

INSTANTIATE_TEST_SUITE_P(All, AirframeData, testing::ValuesIn(kAircraft),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace eyrie::model::flight
