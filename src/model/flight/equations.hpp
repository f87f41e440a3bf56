// SPDX-License-Identifier: MIT
#pragma once
/// \file  The equations of point_mass and of its inner loops, for one aircraft (Real = double) or
/// for several side by side (Real = math::Lanes): the same bits. Nothing here branches on what one
/// aircraft does and another one does not. docs/models/flight.md has the equations.
#include "model/flight/autopilot.hpp"
#include "model/flight/point_mass.hpp"

namespace eyrie::model::flight {

/// Guidance in lanes: what the autopilot's inner loops fly.
template <class Real>
struct WantedOf {
  Real heading, altitude, speed, turn_rate, climb;
  math::MaskOf<Real> aims;  ///< flies the direction (heading, climb), and no altitude

  explicit WantedOf(const std::array<Guidance, math::kLanes<Real>>& of)
      : heading(math::each_lane<Real>([&](std::size_t i) { return of[i].heading; })),
        altitude(math::each_lane<Real>([&](std::size_t i) { return of[i].altitude; })),
        speed(math::each_lane<Real>([&](std::size_t i) { return of[i].speed; })),
        turn_rate(math::each_lane<Real>([&](std::size_t i) { return of[i].turn_rate; })),
        climb(math::each_lane<Real>([&](std::size_t i) { return of[i].climb.value_or(0); })),
        aims(math::each_lane<Real>([&](std::size_t i) { return of[i].climb ? 1.0 : 0.0; }) > 0) {}
};

/// `kAlike`: all are of one model, so that its numbers are the same in every lane.
template <class Real, bool kAlike = math::kLanes<Real> == 1>
class Equations {
 public:
  using Mask = math::MaskOf<Real>;
  using SinCos = math::SinCosOf<Real>;
  static constexpr std::size_t kCount = math::kLanes<Real>;
  using Models = std::array<const PointMass*, kCount>;

  explicit Equations(const Models& models) : models_(models) {}

  /// `K` has the members of Kinematics, `E` those of Propulsion.
  template <class K>
  FlightConditionOf<Real> condition(const K& k, const AirOf<Real>& air, const Real& fuel,
                                    const LoadOf<Real>& load) const {
    const Real speed = math::max(k.speed, kLeastSpeed);
    FlightConditionOf<Real> c;
    c.mass = each(&Airframe::empty_mass) + fuel + load.mass;
    c.mach = speed / air.speed_of_sound;
    c.temperature = air.temperature;
    c.speed_of_sound = air.speed_of_sound;
    c.density_root = math::sqrt(air.density * (1 / kSeaLevelDensity));

    using ByMach = PointMass::ByMachOf<Real>;
    const TableCells<Real> cell = cell_of(&PointMass::mach_, c.mach);
    const auto at = [&](std::size_t next) {
      return math::to_lanes<ByMach>(math::each_of<kCount>(
          [&](std::size_t i) { return &model(i).by_mach_[cell.index[i] + next]; }));
    };
    const ByMach below = at(0), above = at(1);
    const auto blend = [&](Real ByMach::*of) {
      return below.*of + cell.fraction * (above.*of - below.*of);
    };
    const Real pressure = 0.5 * air.density * speed * speed;
    const Real lift = pressure * each(&Aerodynamics::wing_area);  // per lift coefficient
    const Real weight = c.mass * kGravity;
    c.zero_lift_drag = lift * blend(&ByMach::zero_lift_drag) + pressure * load.drag_area;
    c.induced_drag = blend(&ByMach::induced_drag) * weight * weight / lift;
    c.separation = each(&Aerodynamics::separation_lift) * lift / weight;
    c.separation_drag = each(&Aerodynamics::separation_drag) * weight * weight / lift;
    c.lift_limit = blend(&ByMach::max_lift) * lift / weight;
    const ThrustOf<Real> thrust = thrust_at(cell, k.altitude);
    const Mask runs = fuel > 0;
    c.thrust = {.idle = math::select(runs, thrust.idle, 0),
                .military = math::select(runs, thrust.military, 0),
                .afterburner = math::select(runs, thrust.afterburner, 0)};
    return c;
  }

  /// Controls that fly `wanted` with at most `load_factor` (g), the structure and the wing
  /// permitting. Height has priority over the turn, and flying speed over height: it climbs no
  /// steeper than the excess thrust allows at the speed asked for, and puts the nose down before it
  /// gets too slow. A wanted climb angle (Guidance::climb) is a direction of flight: the lift
  /// vector goes to it, past the vertical and upside down too, and neither height nor flying speed
  /// have priority. `afterburner` is lit when it falls behind the speed asked for, and put out once
  /// military power is enough. `pitch` and `roll` are those of `k`.
  template <class K>
  ControlsOf<Real> steer(const K& k, const SinCos& pitch, const SinCos& roll,
                         const FlightConditionOf<Real>& c, const WantedOf<Real>& wanted,
                         const Real& load_factor, Mask& afterburner) const {
    const Real push_limit = each(&Autopilot::push_limit), speed_time = each(&Autopilot::speed_time);
    const Real speed = math::max(k.speed, 1);
    const Real slowest = slowest_speed(k, c);
    const Real fastest = fastest_speed(c);
    const Real speed_wanted = math::min(math::max(wanted.speed, slowest), fastest);

    // the afterburner is allowed while military power has left it behind
    afterburner = afterburner | (speed_wanted - k.speed > each(&Autopilot::afterburner_error));
    const Real power = math::select(afterburner, c.thrust.afterburner, c.thrust.military);

    const Real most = math::max(
        math::min(math::min(load_factor, each(&FlightLimits::max_load_factor)), c.lift_limit),
        math::max(push_limit, 0));
    Lift lift{0, 0, 0};
    // out of a steep climb, too: letting go bends no path that stands upright
    const Mask aims = wanted.aims | (pitch.sin > kSteep);
    if (math::any(aims))
      lift = lift_towards(k, pitch, wanted, most);
    if (!math::all(aims)) {  // upwards first
      const Real turn_rate =
          angle_between(k.heading, wanted.heading) / each(&Autopilot::heading_time) +
          wanted.turn_rate;
      const Real turn = speed * pitch.cos * turn_rate / kGravity;
      const Real turning = c.drag(math::min(math::sqrt(1 + turn * turn), math::max(most, 1)));
      const Real climb =
          wanted_climb(k, c, wanted, most, speed_wanted, slowest, fastest, power, turning);
      const Real climb_rate =
          (climb - pitch.sin) / (each(&Autopilot::climb_time) * math::max(pitch.cos, 0.1));
      const Real upwards = math::clamp(pitch.cos + speed * climb_rate / kGravity, push_limit, most);
      const Real room = math::sqrt(math::max(most * most - upwards * upwards, 0));
      const Real sideways = math::clamp(turn, -room, room);
      lift = {math::select(aims, lift.upwards, upwards),
              math::select(aims, lift.sideways, sideways),
              math::select(aims, lift.above, math::max(upwards, kLevelLift))};
    }

    // bank to that lift; while rolling, pull only what lies along the lift axis already
    ControlsOf<Real> controls;
    controls.bank = math::atan2(lift.sideways, lift.above);
    controls.load_factor =
        math::clamp(lift.upwards * roll.cos + lift.sideways * roll.sin, push_limit, most);

    // thrust for the speed, at the climb angle and load factor that are flown
    const Real acceleration = (speed_wanted - k.speed) / speed_time;
    const Real thrust = c.mass * (acceleration + kGravity * pitch.sin) + c.drag(k.load_factor);
    afterburner = afterburner & !(thrust < c.thrust.military);
    controls.throttle = Engine::throttle_for(c.thrust, thrust, afterburner);
    return controls;
  }

  /// Slowest speed (m/s) that steer() flies: where the wing can still give the stall margin.
  template <class K>
  Real slowest_speed(const K& k, const FlightConditionOf<Real>& c) const {
    return math::max(k.speed, 1) * math::sqrt(each(&Autopilot::stall_margin) / c.lift_limit);
  }
  /// Fastest speed (m/s) by Mach number and equivalent airspeed.
  Real fastest_speed(const FlightConditionOf<Real>& c) const {
    return math::min(each(&FlightLimits::max_mach) * c.speed_of_sound,
                     each(&FlightLimits::max_equivalent_airspeed) / c.density_root);
  }

  /// One step of `dt` (s). Load factor and bank follow the controls at their rates, limited by
  /// structure and lift; the throttle spools; forces stay constant during the step and the motion
  /// is integrated by the midpoint rule, which changes the energy by the work of thrust and drag
  /// only. Sets the fuel flow; the caller burns it. Leaves everything of `k` but the vertical axes
  /// and the altitude of the new position, which the caller sets. `climb` is the pitch of `k`.
  template <class K, class E>
  void step(K& k, const SinCos& climb, E& engines, const FlightConditionOf<Real>& condition,
            const ControlsOf<Real>& controls, const Vec3Of<Real>& wind_ned, double dt) const {
    // load factor: what structure and wing allow of what is asked
    const Real most = math::min(each(&FlightLimits::max_load_factor), condition.lift_limit);
    const Real least = math::max(each(&FlightLimits::min_load_factor), -condition.lift_limit);
    const Real pull = each(&FlightLimits::load_factor_rate) * dt;
    const Real wanted =
        k.load_factor + math::clamp(controls.load_factor - k.load_factor, -pull, pull);
    k.load_factor = math::clamp(wanted, least, most);
    const Real turn = each(&FlightLimits::roll_rate) * dt;
    k.roll = wrap_pi(k.roll + math::clamp(angle_between(k.roll, controls.bank), -turn, turn));

    // thrust and fuel flow; without fuel both are zero
    const Mask runs = engines.fuel > 0;
    const Real throttle = spool(engines.throttle, controls.throttle, dt);
    engines.throttle = math::select(runs, throttle, 0);
    engines.thrust = math::select(runs, Engine::thrust_of(condition.thrust, throttle), 0);
    engines.flow = math::select(
        runs, flow_of(condition.thrust, throttle, condition.mach, condition.temperature), 0);
    const Real along = (engines.thrust - condition.drag(k.load_factor)) / condition.mass;  // m/s2

    // half a step to find the climb angle in its middle
    const SinCos roll = math::sin_cos(k.roll);
    const Real upward = kGravity * k.load_factor * roll.cos;  // m/s2, across the path
    const Real sideward = kGravity * k.load_factor * roll.sin;
    const Real speed = math::max(k.speed, kLeastSpeed);
    const Real start_rate = (upward - kGravity * climb.cos) / speed;
    const auto climb_middle = turned(climb, 0.5 * dt * start_rate);

    // the whole step with the rates of its middle
    const Real new_speed =
        math::max(speed + dt * (along - kGravity * climb_middle.sin), kLeastSpeed);
    const Real speed_middle = 0.5 * (speed + new_speed);
    const Real climb_turn = dt * (upward - kGravity * climb_middle.cos) / speed_middle;
    const Real heading_turn = dt * sideward / (speed_middle * away_from_zero(climb_middle.cos));
    const auto [heading_middle, heading] =
        math::sin_cos(k.heading + 0.5 * heading_turn, k.heading + heading_turn);
    const auto climb_end = turned(climb, climb_turn);

    const auto ground_velocity = [&](const Real& v, const SinCos& c, const SinCos& h) {
      return (v * c.cos * h.cos + wind_ned.x) * k.north +
             (v * c.cos * h.sin + wind_ned.y) * k.east + (-v * c.sin) * k.down;
    };
    k.position += dt * ground_velocity(speed_middle, climb_middle, heading_middle);
    k.velocity = ground_velocity(new_speed, climb_end, heading);
    k.speed = new_speed;
    k.mach = new_speed / condition.speed_of_sound;
    k.pitch += climb_turn;
    k.heading = wrap_pi(k.heading + heading_turn);

    // over the top of a loop: the same direction, said the other way round
    const Mask over = math::abs(k.pitch) > kPi / 2;
    if (math::any(over)) {
      k.pitch = math::select(over, math::copysign(Real(kPi), k.pitch) - k.pitch, k.pitch);
      k.heading = math::select(over, wrap_pi(k.heading + kPi), k.heading);
      k.roll = math::select(over, wrap_pi(k.roll + kPi), k.roll);
    }
  }

  /// Fuel flow (kg/s) at a throttle. At military power and at full afterburner thrust times
  /// TSFC = (C1 + C2 M) sqrt(theta), Mattingly, Heiser & Pratt, Aircraft Engine Design, 2nd ed.
  /// (2002), eq. 3.12, with C1 given at sea level and C2 / C1 as *_tsfc_mach (0.3 / 0.9 and
  /// 0.27 / 1.6 in eq. 3.55a, b). Below military power it falls as `part_power` says; by default
  /// x (0.84 + (1 - sqrt(x))^2) / 0.84 of the share x of thrust: turbines of JSBSim
  /// (docs/models/flight.md). Between military power and full afterburner it is linear in the
  /// throttle. theta: temperature over sea-level temperature.
  Real flow_of(const ThrustOf<Real>& available, const Real& throttle, const Real& mach,
               const Real& temperature) const {
    const Real root_theta = math::sqrt(temperature * (1 / kSeaLevelTemperature));
    const Real dry =
        each(&Engine::military_tsfc) * (1 + each(&Engine::military_tsfc_mach) * mach) * root_theta;
    const Real wet = each(&Engine::afterburner_tsfc) *
                     (1 + each(&Engine::afterburner_tsfc_mach) * mach) * root_theta;
    const Real at_military = dry * available.military;
    const Real share = math::select(available.military > 0,
                                    Engine::thrust_of(available, throttle) / available.military, 0);
    const TableCells<Real> cell = cell_of(&PointMass::share_, share);
    const auto part_at = [&](std::size_t next) {
      return math::each_lane<Real>(
          [&](std::size_t i) { return model(i).part_power_[cell.index[i] + next]; });
    };
    const Real part = detail::mix(part_at(0), part_at(1), cell.fraction);
    const Real at_full = wet * available.afterburner;
    return math::max(math::select(throttle <= 1, at_military * part,
                                  at_military + (throttle - 1) * (at_full - at_military)),
                     each(&Engine::idle_flow));
  }
  /// The throttle one step of `dt` (s) later, on its way to `wanted`.
  Real spool(const Real& throttle, const Real& wanted, double dt) const {
    const Mask lights = (throttle > 1) | ((throttle >= 1) & (wanted > 1));
    const Real step =
        dt / math::select(lights, each(&Engine::light_time), each(&Engine::spool_time));
    return throttle + math::clamp(wanted - throttle, -step, step);
  }

 private:
  static constexpr double kLeastSpeed = 1;   ///< m/s: a direction of flight must exist
  static constexpr double kLevelLift = 0.3;  ///< g: who lets the nose fall banks as with so much
  static constexpr double kSteep = 0.8;      ///< sine of a climb angle of 53 degrees
  /// Lift that is wanted, in g: upwards across the path, to the right, and upwards for the bank.
  struct Lift {
    Real upwards, sideways, above;
  };

  const PointMass& model(std::size_t i) const { return *models_[kAlike ? 0 : i]; }
  Real of_each(auto number) const {
    if constexpr (kAlike)
      return number(model(0));
    else
      return math::each_lane<Real>([&](std::size_t i) { return number(model(i)); });
  }
  Real each(double Airframe::*of) const {
    return of_each([of](const PointMass& m) { return m.airframe().*of; });
  }
  Real each(double Aerodynamics::*of) const {
    return of_each([of](const PointMass& m) { return m.airframe().aerodynamics.*of; });
  }
  Real each(double Engine::*of) const {
    return of_each([of](const PointMass& m) { return m.airframe().engine.*of; });
  }
  Real each(double FlightLimits::*of) const {
    return of_each([of](const PointMass& m) { return m.airframe().limits.*of; });
  }
  Real each(double Autopilot::*of) const {
    return of_each([of](const PointMass& m) { return m.airframe().autopilot.*of; });
  }

  TableCells<Real> cell_of(Axis PointMass::*axis, const Real& x) const {
    if constexpr (kAlike && kCount > 1) {
      return (model(0).*axis).cell(x);
    } else {
      TableCells<Real> cells;
      cells.fraction = math::each_lane<Real>([&](std::size_t i) {
        const TableCell at = (model(i).*axis).cell(math::lane(x, i));
        cells.index[i] = at.index;
        return at.fraction;
      });
      return cells;
    }
  }

  ThrustOf<Real> thrust_at(const TableCells<Real>& mach, const Real& altitude) const {
    using Power = PointMass::PowerOf<Real>;
    const TableCells<Real> cell = cell_of(&PointMass::altitude_, altitude);
    const auto at = [&](std::size_t next) {
      return math::to_lanes<Power>(math::each_of<kCount>([&](std::size_t i) {
        const PointMass& m = model(i);
        return &m.power_[(mach.index[i] + next) * (m.altitude_.size() - 1) + cell.index[i]];
      }));
    };
    const Power slow = at(0), fast = at(1);
    const auto blend = [&](Real Power::*here, Real Power::*above) {
      const Real slower = slow.*here + cell.fraction * (slow.*above - slow.*here);
      const Real faster = fast.*here + cell.fraction * (fast.*above - fast.*here);
      return slower + mach.fraction * (faster - slower);
    };
    const Real military = blend(&Power::military, &Power::military_above);
    return {.idle = each(&Engine::idle_share) * military,
            .military = military,
            .afterburner = blend(&Power::afterburner, &Power::afterburner_above)};
  }

  /// Sine of the climb angle that leads to the altitude, as far as energy allows: upwards what the
  /// turn with its drag leaves.
  template <class K>
  Real wanted_climb(const K& k, const FlightConditionOf<Real>& c, const WantedOf<Real>& wanted,
                    const Real& most_lift, const Real& speed_wanted, const Real& slowest,
                    const Real& fastest, const Real& thrust, const Real& turning) const {
    const Real speed_time = each(&Autopilot::speed_time);
    const Real speed = math::max(k.speed, 1);
    const Real error = wanted.altitude - k.altitude;
    // sinks no faster than the lift it may use stops above the altitude; half of it is kept back
    const Real stopping = kGravity * math::max(most_lift - 1, 0.05);
    const Real asked = math::max(error / each(&Autopilot::altitude_time),
                                 -math::sqrt(stopping * math::max(-error, 0))) /
                       speed;
    const Real level = c.drag(1);
    const Real excess = (thrust - turning) / c.mass;
    const Real too_slow = (speed_wanted - k.speed) / speed_time;

    // upwards: excess thrust and excess speed, less the share that goes into speed
    const Real for_speed =
        math::min(too_slow, each(&Autopilot::acceleration_share) * math::max(excess, 0));
    Real highest = math::max((excess - for_speed) / kGravity, 0);
    highest = math::min(highest, of_each([](const PointMass& m) { return m.steepest_climb_; }));
    // near the slowest speed the nose goes down, whatever was asked
    const Real spare = (thrust - level) / c.mass + (k.speed - slowest) / speed_time;
    highest = math::min(highest, spare / kGravity);

    // downwards: as steep as the overspeed permits
    const Real most = math::min(speed_wanted + each(&Autopilot::dive_overspeed), fastest);
    const Real too_fast = (k.speed - most) / speed_time;
    const Real steepest = of_each([](const PointMass& m) { return m.steepest_dive_; });
    const Real lowest =
        math::max(math::min((c.thrust.idle - level) / c.mass + too_fast, 0) / kGravity, -steepest);
    return math::min(math::max(asked, lowest), highest);
  }

  /// Lift that turns the path towards a direction: what turns it, and what carries the weight. Of
  /// what is too much the turn is cut, so that the path goes on bending straight at the direction:
  /// |turn e + carry| = most is solved for the turn.
  template <class K>
  Lift lift_towards(const K& k, const SinCos& path, const WantedOf<Real>& wanted,
                    const Real& most) const {
    const auto [climb, heading] =
        math::sin_cos(wanted.climb, angle_between(k.heading, wanted.heading));
    // the direction in the axes of the path: ahead, to the right, up
    const Real ahead = path.cos * climb.cos * heading.cos + path.sin * climb.sin;
    const Real right = climb.cos * heading.sin;
    const Real up = path.cos * climb.sin - path.sin * climb.cos * heading.cos;
    const Real across = math::sqrt(right * right + up * up);
    const Real angle = math::atan2(across, ahead);
    // straight behind: over the top
    const Mask aside = across > 1e-9;
    const Real e_right = math::select(aside, right / across, 0);
    const Real e_up = math::select(aside, up / across, 1);
    const Real carry = path.cos, along = e_up * carry;
    const Real room = along * along - carry * carry + most * most;
    const Real largest =
        math::select(room > 0, math::max(math::sqrt(math::max(room, 0)) - along, 0), 0);
    const Real turn =
        math::min(math::max(k.speed, 1) * angle / (each(&Autopilot::aim_time) * kGravity), largest);
    const Real upwards = carry + turn * e_up, push_limit = each(&Autopilot::push_limit);
    // a little downwards is flown by letting go, not by rolling over
    const Mask lets_go = (upwards < push_limit) & (angle < radians(15));
    return {math::select(lets_go, push_limit, upwards), turn * e_right,
            math::select(lets_go, math::max(push_limit, kLevelLift), upwards)};
  }

  /// sin and cos of an angle a little further, for |turn| < 0.1: series to the fifth order.
  static SinCos turned(const SinCos& from, const Real& turn) {
    const Real t2 = turn * turn;
    const Real sine = turn * (1 - t2 * (1.0 / 6) * (1 - t2 * (1.0 / 20)));
    const Real cosine = 1 - t2 * 0.5 * (1 - t2 * (1.0 / 12));
    return {from.sin * cosine + from.cos * sine, from.cos * cosine - from.sin * sine};
  }

  /// Keeps the heading rate finite at the vertical.
  static Real away_from_zero(const Real& cosine) {
    constexpr double kLeast = 1e-3;
    return math::select(math::abs(cosine) < kLeast, math::copysign(Real(kLeast), cosine), cosine);
  }

  Models models_;
};

}  // namespace eyrie::model::flight
