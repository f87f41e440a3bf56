// SPDX-License-Identifier: MIT
#pragma once
/// \file  Flies one step of aircraft, those of point_mass several side by side.
#include "model/ellipsoid.hpp"
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
void fly(const Sky& sky, std::span<Flyer> flyers);
/// Flies one step of laero.
void fly_laero(const Sky& sky, Flyer& flyer);

/// m: of a level turn, with the distance flown while rolling into it.
template <class Real>
Real turn_radius(const Real& speed, const Real& rate, const Real& lag) {
  return speed / math::max(rate, 1e-3) + speed * lag;
}

/// Kinematics in lanes.
template <class Real>
struct Motion {
  Vec3Of<Real> position, velocity, north, east, down;
  Real altitude, heading, pitch, roll, speed, mach, load_factor;
};
/// Propulsion in lanes.
template <class Real>
struct Engines {
  Real fuel, flow, throttle, thrust;
};

/// Flies one step as the commands ask, of as many as there are lanes; `kAlike`: all of one model.
template <class Real, bool kAlike = math::kLanes<Real> == 1>
[[gnu::flatten]] void fly_abreast(const Sky& sky, Flyer* flyers) {
  constexpr std::size_t kCount = math::kLanes<Real>;
  const auto each = [&](auto of) {
    return math::each_lane<Real>([&](std::size_t i) { return of(flyers[i]); });
  };
  const auto number = [&](double Kinematics::*of) {
    return each([&](const Flyer& f) { return f.kinematics->*of; });
  };
  const auto vector = [&](Vec3 Kinematics::*of) -> Vec3Of<Real> {
    return {each([&](const Flyer& f) { return (f.kinematics->*of).x; }),
            each([&](const Flyer& f) { return (f.kinematics->*of).y; }),
            each([&](const Flyer& f) { return (f.kinematics->*of).z; })};
  };
  Motion<Real> k{.position = vector(&Kinematics::position),
                 .north = vector(&Kinematics::north),
                 .east = vector(&Kinematics::east),
                 .down = vector(&Kinematics::down),
                 .altitude = number(&Kinematics::altitude),
                 .heading = number(&Kinematics::heading),
                 .pitch = number(&Kinematics::pitch),
                 .roll = number(&Kinematics::roll),
                 .speed = number(&Kinematics::speed),
                 .load_factor = number(&Kinematics::load_factor)};
  Engines<Real> engines{.fuel = each([](const Flyer& f) { return f.propulsion->fuel; }),
                        .throttle = each([](const Flyer& f) { return f.propulsion->throttle; })};

  // what place and speed decide
  std::array<const PointMass*, kCount> models;
  for (std::size_t i = 0; i < kCount; ++i)
    models[i] = flyers[i].model;
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
  const auto all = [&]<std::size_t... I>(std::index_sequence<I...>, auto of) {
    return std::array{of(I)...};
  };
  constexpr std::make_index_sequence<kCount> kIndices;
  const auto winds = all(kIndices, [&](std::size_t i) {
    return sky.environment.wind.at(flyers[i].kinematics->altitude);
  });
  const auto wanted = all(kIndices, [&](std::size_t i) {
    const Flyer& f = flyers[i];
    return guide(f.model->airframe().autopilot, *f.kinematics, *f.command, f.routes,
                 math::lane(radius, i), *f.flying, winds[i], f.time, sky.dt);
  });
  for (std::size_t i = 0; i < kCount; ++i)
    if (flyers[i].tells_energy)
      flyers[i].flying->energy =
          flyers[i].model->energy(lane_of(condition, i), flyers[i].kinematics->speed);

  auto afterburner = each([](const Flyer& f) { return f.flying->afterburner ? 1.0 : 0.0; }) > 0;
  const ControlsOf<Real> controls =
      equations.steer(k, condition, WantedOf<Real>(wanted), load_factor, afterburner);
  const auto wind = [&](double Vec3::*of) {
    return math::each_lane<Real>([&](std::size_t i) { return winds[i].*of; });
  };
  equations.step(k, engines, condition, controls, {wind(&Vec3::x), wind(&Vec3::y), wind(&Vec3::z)},
                 sky.dt);
  const VerticalOf<Real> at = sky.reference.vertical_at(k.position);
  k.heading = wrap_pi(k.heading - turn_of_north(k.east, at.north));

  for (std::size_t i = 0; i < kCount; ++i) {
    const auto of = [&](const Vec3Of<Real>& v) {
      return Vec3{math::lane(v.x, i), math::lane(v.y, i), math::lane(v.z, i)};
    };
    *flyers[i].kinematics = {.position = of(k.position),
                             .velocity = of(k.velocity),
                             .north = of(at.north),
                             .east = of(at.east),
                             .down = of(at.down),
                             .altitude = math::lane(at.altitude, i),
                             .heading = math::lane(k.heading, i),
                             .pitch = math::lane(k.pitch, i),
                             .roll = math::lane(k.roll, i),
                             .speed = math::lane(k.speed, i),
                             .mach = math::lane(k.mach, i),
                             .load_factor = math::lane(k.load_factor, i)};
    Propulsion& propulsion = *flyers[i].propulsion;
    propulsion.flow = math::lane(engines.flow, i);
    propulsion.throttle = math::lane(engines.throttle, i);
    propulsion.thrust = math::lane(engines.thrust, i);
    flyers[i].flying->afterburner = math::holds(afterburner, i);
    flyers[i].ran_dry = burn(propulsion, sky.dt);
  }
}

/// Flies in the lanes of AVX2 what fills them, and says how many that were; for a processor that
/// has it.
[[nodiscard]] std::size_t fly_in_lanes(const Sky& sky, std::span<Flyer> flyers);

}  // namespace eyrie::model::flight
