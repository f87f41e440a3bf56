// SPDX-License-Identifier: MIT
#pragma once
/// \file  Flies one step of aircraft, those of point_mass several side by side.
#include "model/ellipsoid.hpp"
#include "model/flight/energy.hpp"
#include "model/flight/equations.hpp"

namespace eyrie::model::flight {

/// What surrounds all who fly a step.
struct Sky {
  const Reference& reference;
  const Environment& environment;
  double dt = 0;  ///< s
};

/// One aircraft: the rows that flying reads and writes, and what it is.
struct Flyer {
  const PointMass* model = nullptr;
  Kinematics* kinematics = nullptr;
  Flying* flying = nullptr;
  Propulsion* propulsion = nullptr;
  const Command* command = nullptr;
  std::span<const Route> routes = {};  ///< of its flight
  Load load = {};                      ///< stores on board
  double time = 0;                     ///< s, at the beginning of the step
  bool tells_energy = true;            ///< Flying::energy is of this step
  bool ran_dry = false;                ///< the tanks did in this step
};

/// Flies one step of point_mass as the commands ask.
void fly(const Sky& sky, std::span<Flyer* const> flyers);
/// Flies one step of laero.
void fly_laero(const Sky& sky, Flyer& flyer);

/// m: of a level turn, with the distance flown while rolling into it.
template <class Real>
Real turn_radius(const Real& speed, const Real& rate, const Real& lag) {
  return speed / math::max(rate, 1e-3) + speed * lag;
}

/// Kinematics in lanes, with the same members.
template <class Real>
struct Motion {
  Vec3Of<Real> position, velocity, north, east, down;
  Real altitude, heading, pitch, roll, speed, mach, load_factor;
};
/// Propulsion in lanes, with the same members.
template <class Real>
struct Engines {
  Real fuel, flow, throttle, thrust;
};

/// Flies one step as the commands ask, of as many as there are lanes; `kAlike`: all of one model.
template <class Real, bool kAlike = math::kLanes<Real> == 1>
[[gnu::flatten]] void fly_abreast(const Sky& sky, Flyer* const* flyers) {
  constexpr std::size_t kCount = math::kLanes<Real>;
  const auto each = [&](auto of) {
    return math::each_lane<Real>([&](std::size_t i) { return of(*flyers[i]); });
  };
  const auto kinematics = math::each_of<kCount>([&](auto i) { return flyers[i]->kinematics; });
  const auto propulsion = math::each_of<kCount>([&](auto i) { return flyers[i]->propulsion; });
  auto k = math::to_lanes<Motion<Real>>(kinematics);
  auto engines = math::to_lanes<Engines<Real>>(propulsion);

  // what place and speed decide
  const auto models = math::each_of<kCount>([&](auto i) { return flyers[i]->model; });
  const Equations<Real, kAlike> equations(models);
  const FlightConditionOf<Real> condition =
      equations.condition(k, sky.environment.atmosphere.at(k.altitude), engines.fuel,
                          LoadOf<Real>{each([](const Flyer& f) { return f.load.mass; }),
                                       each([](const Flyer& f) { return f.load.drag_area; })});
  const Real load_factor =
      math::max(each([](const Flyer& f) { return f.command->load_factor; }), kLeastLoadFactor);
  const Real most = math::min(load_factor, condition.lift_limit);
  const Real turn_rate =
      kGravity * math::sqrt(math::max(most * most - 1, 0)) / math::max(k.speed, 1);
  const Real radius =
      turn_radius(k.speed, turn_rate,
                  each([](const Flyer& f) { return f.model->airframe().autopilot.heading_time; }));

  // where to fly
  const Wind& air = sky.environment.wind;
  const auto winds = math::each_of<kCount>(
      [&](auto i) { return air.is_calm() ? Vec3{} : air.at(kinematics[i]->altitude); });
  const auto wanted = math::each_of<kCount>([&](std::size_t i) {
    const Flyer& f = *flyers[i];
    return guide(f.model->airframe().autopilot, *f.kinematics, *f.command, f.routes,
                 math::lane(radius, i), *f.flying, winds[i], f.time, sky.dt);
  });
  bool tells_energy = false;
  for (std::size_t i = 0; i < kCount; ++i)
    tells_energy |= flyers[i]->tells_energy;
  if (tells_energy) {
    const EnergyOf<Real> energy = energy_of(models, condition, k.speed);
    const auto of = [](const Real& x, std::size_t i) {
      return static_cast<float>(math::lane(x, i));
    };
    for (std::size_t i = 0; i < kCount; ++i)
      if (flyers[i]->tells_energy)
        flyers[i]->flying->energy = {of(energy.available, i), of(energy.sustained, i),
                                     of(energy.corner_speed, i), of(energy.excess_power, i)};
  }

  auto afterburner = each([](const Flyer& f) { return f.flying->afterburner ? 1.0 : 0.0; }) > 0;
  const auto [pitch, roll] = math::sin_cos(k.pitch, k.roll);
  const ControlsOf<Real> controls =
      equations.steer(k, pitch, roll, condition, WantedOf<Real>(wanted), load_factor, afterburner);
  const auto wind = [&](double Vec3::*of) {
    return math::each_lane<Real>([&](std::size_t i) { return winds[i].*of; });
  };
  equations.step(k, pitch, engines, condition, controls,
                 {wind(&Vec3::x), wind(&Vec3::y), wind(&Vec3::z)}, sky.dt);
  const VerticalOf<Real> at = sky.reference.vertical_at(k.position);
  carry_to(k, at);

  const auto runs_dry = burn(engines, sky.dt);

  math::from_lanes(k, kinematics);
  math::from_lanes(engines, propulsion);
  for (std::size_t i = 0; i < kCount; ++i) {
    flyers[i]->flying->afterburner = math::holds(afterburner, i);
    flyers[i]->ran_dry = math::holds(runs_dry, i);
  }
}

/// Flies what fills the lanes, and says how many that were.
template <class Real>
[[nodiscard]] std::size_t fly_full(const Sky& sky, std::span<Flyer* const> all) {
  constexpr std::size_t kCount = math::kLanes<Real>;
  std::size_t next = 0;
  for (; next + kCount <= all.size(); next += kCount) {
    Flyer* const* const flyers = &all[next];
    bool alike = true;
    for (std::size_t i = 1; i < kCount; ++i)
      alike &= flyers[i]->model == flyers[0]->model;
    alike ? fly_abreast<Real, true>(sky, flyers) : fly_abreast<Real, false>(sky, flyers);
  }
  return next;
}
/// The same for a processor that has AVX2, and for one that has AVX-512 (of Ice Lake or Zen 4, at
/// least: those before work slower by it).
[[nodiscard]] std::size_t fly_by_avx2(const Sky& sky, std::span<Flyer* const> all);
[[nodiscard]] std::size_t fly_by_avx512(const Sky& sky, std::span<Flyer* const> all);

}  // namespace eyrie::model::flight
