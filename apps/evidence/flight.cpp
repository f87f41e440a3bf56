// SPDX-License-Identifier: MIT
/// \file  The airframes of data/ beside what is published of the aircraft.

#include "evidence.hpp"
#include "load.hpp"
#include "model/flight/performance.hpp"

namespace eyrie::evidence {
namespace {

using namespace model;
using namespace model::flight;

/// An aircraft, what hangs under it when it is armed, and what is published of it (0: nothing).
struct Aircraft {
  const char* name;
  const char* label;
  const char* source;
  Load armed;                       ///< all missiles of data/aircraft
  double rated_thrust, rated_tsfc;  ///< full afterburner on the test bench, N and kg/N/s
  double top, ceiling, climb = 0;
  double range = 0, low_range = 0;  ///< m on internal fuel, at altitude and near the ground
  double low_top = 0;               ///< m/s at sea level
  double sustained = 0, turn = 0;   ///< rad/s, best turn that speed is held in, and best of all
};
constexpr double kKilometer = 1000;
const Aircraft kAircraft[] = {
    {.name = "f15c",
     .label = "F-15C",
     .source = "climb: press history at vintageaviationnews.com; else USAF fact sheet and museum "
               "(seen as quoted)",
     .armed = {.mass = 950, .drag_area = 0.08},
     .rated_thrust = si(2 * 23840, "lbf"),
     .rated_tsfc = si(2.17, "lb/lbf/h"),
     .top = 2.5,
     .ceiling = 19.8e3,
     .climb = 341.6},
    {.name = "f16c",
     .label = "F-16C",
     .source = "pimaair.org: Mach 2.05, 55,000 ft; armedforces.co.uk: Mach 2 (both seen)",
     .armed = {.mass = 779, .drag_area = 0.064},
     .rated_thrust = si(29000, "lbf"),
     .rated_tsfc = si(2.05, "lb/lbf/h"),
     .top = 2.0,
     .ceiling = 16.8e3},
    {.name = "mig29",
     .label = "MiG-29S",
     .source = "museum and booklet of the 9.13 (seen as quoted); 1,500 km: rt.com (seen); 700 km: "
               "Army Recognition (seen as quoted)",
     .armed = {.mass = 770, .drag_area = 0.072},
     .rated_thrust = 2 * 81.4e3,
     .rated_tsfc = si(2.05, "lb/lbf/h"),
     .top = 2.3,
     .ceiling = 18e3,
     .climb = 330,
     .range = 1500e3,
     .low_range = 700e3,
     .low_top = si(1500, "km/h")},
    {.name = "su27",
     .label = "Su-27SM",
     .source = "Sukhoi's page; climb, turns: Russian Knights (both seen as quoted)",
     .armed = {.mass = 910, .drag_area = 0.084},
     .rated_thrust = 2 * 122.6e3,
     .rated_tsfc = si(1.96, "lb/lbf/h"),
     .top = 2.35,
     .ceiling = 18.5e3,
     .climb = 300,
     .range = 3530e3,
     .low_range = 1340e3,
     .low_top = si(1400, "km/h"),
     .sustained = si(17, "deg/s"),
     .turn = si(23, "deg/s")}};

std::vector<Point> curve(double from, double to, double step, const auto& f) {
  std::vector<Point> points;
  const int n = static_cast<int>(std::lround((to - from) / step));
  for (int i = 0; i <= n; ++i)
    points.push_back({from + i * step, f(from + i * step)});
  return points;
}

double speed_of_sound(double altitude) {
  return standard_air(altitude).speed_of_sound;
}

constexpr struct {
  const char* name;
  double feet;
} kLevels[] = {{"sea level", 0}, {"15,000 ft", 15e3}, {"30,000 ft", 30e3}, {"45,000 ft", 45e3}};

std::vector<Plot> diagrams(const Aircraft& a, const Performance& armed) {
  Plot power{.file = fmt::format("excess_power_{}", a.name),
             .title = fmt::format(
                 "{}: specific excess power, full afterburner, half the fuel, armed", a.label),
             .x = "Mach",
             .y = "m/s"};
  Plot turn{.file = fmt::format("turn_{}", a.name),
            .title = fmt::format("{}: turn rate, full afterburner, half the fuel, armed", a.label),
            .x = "Mach",
            .y = "deg/s"};
  for (const auto& [name, feet] : kLevels) {
    const double h = si(feet, "ft");
    power.series.push_back({name, curve(0.3, 2.4, 0.025, [&](double m) {
                              return armed.excess_power(m, h, Power::afterburner);
                            })});
    const auto rate = [&](double m, double g) {
      return g > 1 ? in_unit(turn_rate(g, m * speed_of_sound(h)), "deg/s") : -1;
    };
    if (feet > 40e3)
      continue;
    turn.series.push_back({fmt::format("{}, sustained", name), curve(0.3, 1.6, 0.02, [&](double m) {
                             return rate(m, armed.sustained_load_factor(m, h));
                           })});
    turn.series.push_back({fmt::format("{}, limit", name), curve(0.3, 1.6, 0.02, [&](double m) {
                             return rate(m, armed.greatest_load_factor(m, h));
                           })});
  }
  if (a.climb > 0)
    power.series.push_back({"published, clean", {{0.9, a.climb}}, true});

  Plot envelope{.file = fmt::format("envelope_{}", a.name),
                .title = fmt::format("{}: level flight, half the fuel, armed", a.label),
                .x = "Mach",
                .y = "km"};
  for (const auto& [power_name, which] :
       {std::pair{"afterburner", Power::afterburner}, {"military", Power::military}}) {
    std::vector<Point> slow, fast;
    for (double h = 0; h < 22e3; h += 250) {
      double low = 0, high = 0;
      for (double m = 0.1; m < 2.6; m += 0.01)
        if (armed.excess_power(m, h, which) > 0) {
          low = low > 0 ? low : m;
          high = m;
        }
      if (high > 0) {
        slow.push_back({low, h / kKilometer});
        fast.push_back({high, h / kKilometer});
      }
    }
    std::reverse(fast.begin(), fast.end());
    slow.insert(slow.end(), fast.begin(), fast.end());
    envelope.series.push_back({power_name, slow});
  }
  envelope.series.push_back({"published", {{a.top, 11}}, true});
  return {power, turn, envelope};
}

/// s to each energy height by the largest excess power that any altitude and speed gives there:
/// the energy method (Rutowski), a lower bound.
std::vector<Point> energy_climb(const Performance& p, double highest) {
  std::vector<Point> points;
  double time = 0;
  constexpr double kStep = 100;  // m of energy height
  double energy = 300;           // m: 80 m/s at sea level
  for (double top = 0; top < highest;) {
    double best = 0;
    for (double h = 0; h < std::min(energy, highest); h += 100) {
      const double mach = std::sqrt(2 * kGravity * (energy - h)) / speed_of_sound(h);
      if (mach > 0.2 && mach < p.model.airframe().limits.max_mach)
        best = std::max(best, p.excess_power(mach, h, Power::afterburner));
    }
    if (best <= 0)
      break;
    time += kStep / best;
    energy += kStep;
    // with what speed is needed to fly level up there
    top = energy - 0.5 * 250 * 250 / kGravity;
    if (top > 0)
      points.push_back({time, top / kKilometer});
  }
  return points;
}

}  // namespace

Evidence of_flight(const std::string& home) {
  Evidence out;
  Plot acceleration{.file = "acceleration",
                    .title = "Acceleration at 30,000 ft from Mach 0.8, full afterburner, armed",
                    .x = "s",
                    .y = "Mach",
                    .from_y = 0.8};
  Plot range{.file = "specific_range",
             .title = "Specific range at 36,000 ft, half the fuel, armed",
             .x = "Mach",
             .y = "km/kg"};
  Plot flow{.file = "cruise_flow",
            .title = "Fuel flow at the speed of best range, half the fuel, armed",
            .x = "altitude, km",
            .y = "kg/h"};
  Plot climb{.file = "climb",
             .title = "Time to height by the energy method, a quarter of the fuel, clean",
             .x = "s",
             .y = "km"};
  for (const Aircraft& a : kAircraft) {
    const auto airframe = load<Airframe>(home, fmt::format("data/airframes/{}.yaml", a.name));
    const PointMass model(airframe);
    const double fuel = airframe.internal_fuel;
    const Performance clean{.model = model, .fuel = fuel / 2};
    const Performance armed{.model = model, .load = a.armed, .fuel = fuel / 2};
    for (Plot& plot : diagrams(a, armed))
      out.plots.push_back(std::move(plot));

    const std::string model_name = fmt::format("point_mass, {}", a.label);
    const auto row = [&](Row r) {
      r.model = model_name;
      r.page = "flight.md";
      if (r.source.empty())
        r.source = a.source;
      out.rows.push_back(std::move(r));
    };
    row({.claim = "top Mach at 11 km, clean",
         .here = clean.top_mach(11e3, Power::afterburner),
         .published = a.top,
         .test = "AirframeData.ReachesItsPublishedTopSpeed",
         .plot = fmt::format("envelope_{}", a.name)});
    row({.claim = "Mach at military power, 10 km, armed",
         .here = armed.top_mach(10e3, Power::military),
         .published = 1,
         .source = "none of these aircraft is said to cruise above Mach 1 (not seen)",
         .test = "AirframeData.HardlyPassesMachOneAtMilitaryPower",
         .plot = fmt::format("envelope_{}", a.name)});
    const bool bound = a.name[1] == '1' && a.name[2] == '6';
    row({.claim = bound ? "service ceiling, km (more than)" : "service ceiling, km",
         .here = armed.ceiling(si(100, "ft/min"), Power::afterburner) / kKilometer,
         .published = a.ceiling / kKilometer,
         .tolerance = bound ? 0 : 0.1,
         .test = "AirframeData.ReachesItsPublishedCeiling",
         .plot = fmt::format("envelope_{}", a.name),
         .why = bound ? "\"above 55,000 ft\" is a lower bound" : ""});
    if (a.climb > 0) {
      double best = 0;
      for (double mach = 0.3; mach < 1.1; mach += 0.01)
        best = std::max(best, clean.excess_power(mach, 0, Power::afterburner));
      row({.claim = "best climb at sea level, m/s, clean",
           .here = best,
           .published = a.climb,
           .test = "AirframeData.ClimbsAtItsPublishedRate",
           .plot = fmt::format("excess_power_{}", a.name)});
    }
    if (a.low_top > 0)
      row({.claim = "top speed at sea level, km/h, clean",
           .here = in_unit(clean.top_mach(0, Power::afterburner) * speed_of_sound(0), "km/h"),
           .published = in_unit(a.low_top, "km/h"),
           .test = "AirframeData.ReachesItsPublishedTopSpeed",
           .plot = fmt::format("envelope_{}", a.name)});
    if (a.turn > 0) {
      double sustained = 0, best = 0;
      for (double m = 0.3; m < 1.1; m += 0.01) {
        const double speed = m * speed_of_sound(0);
        sustained = std::max(sustained, turn_rate(armed.sustained_load_factor(m, 0), speed));
        best = std::max(best, turn_rate(armed.greatest_load_factor(m, 0), speed));
      }
      for (const auto& [claim, here, published, why] :
           {std::tuple{"best sustained turn at sea level, deg/s, armed", sustained, a.sustained,
                       ""},
            {"best turn at sea level, deg/s, armed", best, a.turn,
             "its weight and altitude are not published: with full tanks 24.0, at 2 km 23.8"}})
        row({.claim = claim,
             .here = in_unit(here, "deg/s"),
             .published = in_unit(published, "deg/s"),
             .tolerance = *why ? 0 : 0.1,
             .test = "AirframeData.TurnsLikeAFighterOfItsGeneration",
             .plot = fmt::format("turn_{}", a.name),
             .why = why});
    }
    if (a.range > 0) {
      Performance full = armed;
      full.fuel = fuel;
      row({.claim = "range on internal fuel, km, armed",
           .here = full.best_cruise(8e3, 15e3).range / kKilometer,
           .published = a.range / kKilometer,
           .test = "AirframeData.FliesItsPublishedRange",
           .plot = "specific_range"});
      row({.claim = "the same near the ground, km",
           .here = full.best_cruise(100, 100).range / kKilometer,
           .published = a.low_range / kKilometer,
           .test = "AirframeData.FliesItsPublishedRange",
           .plot = "specific_range"});
    }
    const FlightCondition ground = clean.at(0, 0);
    row({.claim = "fuel flow at full afterburner at rest, kg/h",
         .here = 3600 * clean.flow(ground, 2),
         .published = 3600 * a.rated_thrust * a.rated_tsfc,
         .tolerance = 0,
         .source = "rated thrust times rated TSFC of the engine",
         .test = "AirframeData.BurnsAtFullAfterburnerWhatItsRatingSays",
         .plot = "cruise_flow",
         .why = "installed thrust at rest is 16 % below the rating, and TSFC carries the mean loss "
                "of 5 %"});

    Performance light = clean;
    light.fuel = fuel / 4;
    climb.series.push_back({a.label, energy_climb(light, 20e3)});
    std::vector<Point> faster;
    for (double mach = 0.8; mach < 2; mach += 0.02) {
      const double time = armed.acceleration_time(si(30000, "ft"), 0.8, mach);
      if (time < 200)
        faster.push_back({time, mach});
    }
    acceleration.series.push_back({a.label, faster});
    const auto per_kilogram = [&](double mach, double altitude) {
      return mach * speed_of_sound(altitude) / armed.cruise_flow(mach, altitude) / kKilometer;
    };
    range.series.push_back(
        {a.label, curve(0.4, 1, 0.01, [&](double m) { return per_kilogram(m, si(36000, "ft")); })});
    flow.series.push_back({a.label, curve(0, 15, 0.5, [&](double km) {
                             double best = 0, at = 0;
                             for (double m = 0.4; m < 0.98; m += 0.01)
                               if (per_kilogram(m, km * kKilometer) > best) {
                                 best = per_kilogram(m, km * kKilometer);
                                 at = m;
                               }
                             return at > 0 ? 3600 * armed.cruise_flow(at, km * kKilometer) : -1;
                           })});
    out.rows.push_back({.model = model_name,
                        .page = "flight.md",
                        .claim = "thrust up to Mach 1 and 50,000 ft, military and afterburner",
                        .source = "NASA TP-1538 (1979), times rated thrust",
                        .test = "AirframeData.HasTheThrustOfTheFormulaItNames"});
  }
  climb.series.push_back({"Streak Eagle (lighter)",
                          {{27.6, 3}, {39.3, 6}, {48.9, 9}, {59.4, 12}, {77.0, 15}, {122.9, 20}},
                          true});
  for (Plot* plot : {&acceleration, &range, &flow, &climb})
    out.plots.push_back(std::move(*plot));
  return out;
}

}  // namespace eyrie::evidence
