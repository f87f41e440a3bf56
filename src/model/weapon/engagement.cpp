// SPDX-License-Identifier: MIT
#include "model/weapon/engagement.hpp"

#include "model/weapon/seeker.hpp"

namespace eyrie::model::weapon {

namespace {

constexpr Vec3 kDown{0, 0, 1};
constexpr double kNear = 0.5;  // s to go, within which the closest approach is looked for

constexpr double kDiveAngle = radians(30);
constexpr double kDiveFloor = 1000;  // m

/// A target in flight that may turn until it flies along `course`, and dive.
struct Target {
  Vec3 position, velocity;
  Vec3 ahead;   ///< unit vector, level: where it flies to on the map
  Vec3 course;  ///< unit vector, level: where it wants to fly to
  double speed = 0;
  double turn_rate = 0;  ///< rad/s; 0: it keeps its course
  double dive = 0;       ///< rad, wanted
  double angle = 0;      ///< rad, flown downwards

  void move(double dt, bool warned) {
    const Vec3 before = velocity;
    if (warned && turn_rate > 0) {
      turn(turn_rate * dt);
      const double wanted = -position.z > kDiveFloor ? dive : 0;
      angle += std::clamp(wanted - angle, -turn_rate * dt, turn_rate * dt);
      const auto [sine, cosine] = math::sin_cos(angle);
      velocity = speed * (cosine * ahead + sine * kDown);
    }
    position += (dt / 2) * (before + velocity);
  }
  void turn(double by) {
    if (angle_between(ahead, course) <= by) {
      ahead = course;
      return;
    }
    // the level direction across the path on the side of the course; starboard if that is behind
    const Vec3 starboard = cross(kDown, ahead);
    const double side = dot(starboard, course) < 0 ? -1 : 1;
    const auto [sine, cosine] = math::sin_cos(by);
    ahead = cosine * ahead + (side * sine) * starboard;
  }
};

Target make_target(const Engagement& e) {
  const LaunchSituation& s = e.situation;
  const double up = s.target_altitude - s.shooter_altitude;
  const double level = std::sqrt(std::max(e.range * e.range - up * up, 0.0));
  const auto [sine, cosine] = math::sin_cos(s.aspect);
  const Vec3 ahead{-cosine, sine, 0};
  Target target{.position = {level, 0, -s.target_altitude},
                .velocity = s.target_speed * ahead,
                .ahead = ahead,
                .course = e.escape == Escape::beam ? Vec3{0, 1, 0} : Vec3{1, 0, 0},
                .speed = s.target_speed,
                .dive = e.escape == Escape::dive ? kDiveAngle : 0};
  if (e.escape != Escape::none && s.target_speed > 0)
    target.turn_rate =
        kGravity * std::sqrt(kEscapeLoadFactor * kEscapeLoadFactor - 1) / s.target_speed;
  return target;
}

}  // namespace

EngagementResult engage(const MissileType& type, const Atmosphere& atmosphere,
                        const Engagement& e) {
  Target target = make_target(e);
  // the shooter points to the side that the target does not cross to: the longer way round
  const auto [sine, cosine] = math::sin_cos(e.situation.off_boresight);
  Flyout missile{
      .position = {0, 0, -e.situation.shooter_altitude},
      .velocity = e.situation.shooter_speed * Vec3{cosine, -sine, 0} + type.ejection_speed * kDown};
  EngagementResult result{.miss = std::numeric_limits<double>::infinity(),
                          .greatest_altitude = e.situation.shooter_altitude};
  const double greatest_rate2 = type.seeker.greatest_rate * type.seeker.greatest_rate;
  const double cos_gimbal = math::cos(type.seeker.gimbal);
  Vec3 wanted;
  double age = 0, last_seen = 0;
  bool warned = false;
  while (age < type.greatest_time) {
    const Vec3 apart = target.position - missile.position;
    const Vec3 drift = target.velocity - missile.velocity;
    const LineOfSight truth = line_of_sight(apart, drift);
    const double speed = norm(missile.velocity);

    const bool burning = age < type.motor.burn_time();

    // a tenth of the time to go, a small turn, a small gain of speed
    const double to_go = truth.range / std::max(truth.closing, 1.0);
    double wish = std::min(to_go / 10, 0.1 * speed / std::max(norm(missile.lift), 1.0));
    if (burning) {
      const double gain = type.motor.thrust(age) / type.motor.mass(age);
      wish = std::min(wish, 0.15 * std::max(speed, 100.0) / std::max(gain, 1.0));
    }
    const double dt = std::clamp(wish, e.shortest_step, e.longest_step);

    // a target that moves too fast for the seeker is lost: the last command goes on. One that must
    // be locked on before launch has nothing but its seeker, and gives up in the end; the others
    // are told the way until they see it
    const bool locks = type.locks_before_launch();
    const bool homing = locks || truth.range < type.seeker.activation_range;
    const bool follows = (!homing || norm2(truth.rate) <= greatest_rate2) &&
                         (!locks || dot(truth.direction, missile.velocity) >= cos_gimbal * speed);
    if (follows)
      last_seen = age;
    else if (locks && age - last_seen > type.seeker.memory)
      break;
    if (age >= type.guidance.separation_time && follows) {
      if (const auto& loft = type.guidance.loft; loft && !homing) {
        const Vec3 aim = lofted(*loft, apart, kDown, -missile.position.z);
        wanted = steer(type.guidance, line_of_sight(aim, drift), missile.velocity, kDown);
      } else {
        wanted = steer(type.guidance, truth, missile.velocity, kDown);
      }
    }
    fly(type, atmosphere.at(-missile.position.z), {}, kDown, age, dt, wanted, missile);
    warned = warned || truth.range <= e.warned;
    target.move(dt, warned);

    const Vec3 apart_now = target.position - missile.position;
    result.greatest_speed = std::max(result.greatest_speed, speed);
    result.greatest_lift = std::max(result.greatest_lift, norm(missile.lift));
    result.greatest_altitude = std::max(result.greatest_altitude, -missile.position.z);
    if (to_go < kNear) {
      const ClosestApproach nearest = closest_approach(apart, (apart_now - apart) / dt, 0, dt);
      if (nearest.distance < result.miss) {
        result.miss = nearest.distance;
        result.time = age + nearest.time;
        result.speed = norm(missile.velocity);
        result.armed =
            result.time >= std::max(type.warhead.arming_time, type.guidance.separation_time);
      }
    }
    age += dt;
    if (!burning && (speed < type.least_speed || truth.closing < 0))
      break;
    if (missile.position.z > 0)
      break;
  }
  return result;
}

namespace {

/// m, across the line of sight.
Vec3 noisy_miss(const MissileType& type, const NoisyApproach& a, std::uint64_t seed) {
  constexpr double kAltitude = 8000, kTargetSpeed = 300;
  const Air air = Atmosphere{}.at(kAltitude);
  const Vec3 velocity{-kTargetSpeed, 0, 0};
  Vec3 place{10 * a.lag * a.closing, 0, -kAltitude};
  Flyout missile{.position = {0, 0, -kAltitude},
                 .velocity = {a.closing - kTargetSpeed, 0, 0},
                 .lift = {0, 0, -kGravity}};
  MissileState state;
  for (std::uint64_t step = 0;; ++step) {
    const double time = static_cast<double>(step) * a.step;
    const LineOfSight truth = line_of_sight(place - missile.position, velocity - missile.velocity);
    const SeekerView view{.position = missile.position,
                          .velocity = missile.velocity,
                          .axis = normalized(missile.velocity, {1, 0, 0}),
                          .down = kDown,
                          .altitude = kAltitude};
    if (step == 0)
      start_following(state, {truth.direction, truth.range, truth.closing}, {}, time);
    constexpr double kBright = 1e9;  // m, where it would just be seen: S/N is high all the way
    const Draw noise(seed, PlayerId{1}, Stream::seeker, step);
    follow(type.seeker, view,
           measure(type.seeker, view, truth, kBright, a.step, state.glint, noise), time, state);
    const LineOfSight seen{.direction = sight_at(state, time),
                           .rate = state.sight_rate,
                           .closing = state.closing_speed};
    fly(type, air, {}, kDown, 0, a.step, steer(type.guidance, seen, missile.velocity, kDown),
        missile);
    place += a.step * velocity;
    const Vec3 before = truth.range * truth.direction, after = place - missile.position;
    const ClosestApproach nearest = closest_approach(before, (after - before) / a.step, 0, a.step);
    if (nearest.time < a.step)
      return perpendicular(nearest.separation, {1, 0, 0});
  }
}

}  // namespace

double spread_of_miss(const NoisyApproach& a) {
  MissileType type;
  type.motor.mass = Table1::constant(100);
  type.motor.thrust = Table1::constant(0);
  type.aero.reference_area = 0.02;
  type.aero.drag_power_on = type.aero.drag_power_off = Table1::constant(1e-9);
  type.aero.induced_drag = Table1::constant(0);
  type.aero.greatest_lift = Table1::constant(1e6);
  type.aero.greatest_load_factor = 1e6;
  type.guidance.navigation_gain = a.gain;
  type.guidance.autopilot_lag = a.lag;
  type.seeker = a.errors;
  type.seeker.range_noise = type.seeker.closing_noise = 0;
  type.seeker.filter_time = 0.005;
  constexpr int kFlights = 400;
  double squares = 0;
  Vec3 sum;
  for (std::uint64_t seed = 1; seed <= kFlights; ++seed) {
    const Vec3 miss = noisy_miss(type, a, seed);
    squares += norm2(miss);
    sum += miss;
  }
  return std::sqrt((squares - norm2(sum) / kFlights) / (2 * kFlights));
}

}  // namespace eyrie::model::weapon
