// SPDX-License-Identifier: MIT
#include "model/sensor/visual.hpp"

#include <algorithm>

namespace eyrie::model::sensor {

Eyes eyes_of(const Kinematics& own) {
  return {own.position, own.velocity, body_axes(own), own.altitude};
}

bool in_view(const Visual& visual, const Eyes& eyes, const Vec3& unit) {
  const double ahead = dot(unit, eyes.body.forward), aside = dot(unit, eyes.body.right);
  const double down = dot(unit, eyes.body.down);
  if (ahead <= -math::cos(visual.tail_blind))
    return false;
  const double level2 = ahead * ahead + aside * aside;
  const double sideness = level2 > 1e-12 ? aside * aside / level2 : 1;  // sin^2 of the azimuth
  const double limit = visual.over_nose + (visual.over_side - visual.over_nose) * sideness;
  return down <= math::sin(limit);
}

double acquisition_probability(const Visual& visual, double search, double area, double range) {
  if (range > visual.range || apparent_diameter(area, range) < visual.least_angle)
    return 0;
  constexpr double kFivePercent = 2.995732273553991;  // -ln 0.05: contrast at the visibility
  const double rate =
      search * area / (range * range) * math::exp(-kFivePercent * range / visual.visibility);
  return 1 - math::exp(-rate / visual.rate);
}

double hold_probability(const Visual& visual, double area, double range) {
  return apparent_diameter(area, range) < visual.least_angle ? 0 : visual.hold_probability;
}

bool glimpsed(const Visual& visual, const Eyes& eyes, const Kinematics& other,
              const Signature& signature, double range, Cue cue, double u) {
  const double search = cue == Cue::none ? visual.search : visual.cued_search;
  if (cue != Cue::held) {
    // 1 - exp(-x) <= x: most of those far away need no more than this
    if (u >= search * largest_silhouette(signature) / (range * range * visual.rate))
      return false;
  }
  const Vec3 sight = other.position - eyes.position;
  if (!in_view(visual, eyes, sight / range) ||
      range > horizon_range(eyes.altitude, other.altitude, 1))
    return false;
  const double area = silhouette(signature, body_axes(other), sight / -range);
  return u < (cue == Cue::held ? hold_probability(visual, area, range)
                               : acquisition_probability(visual, search, area, range));
}

Identity recognized(const Visual& visual, const Eyes& eyes, const Kinematics& other,
                    const Signature& signature, double range, Side own, Side side) {
  if (apparent_diameter(largest_silhouette(signature), range) * 1.001 < visual.identify_angle)
    return Identity::unknown;  // however it lies
  const Vec3 towards = (eyes.position - other.position) / range;
  const double area = silhouette(signature, body_axes(other), towards);
  return apparent_diameter(area, range) >= visual.identify_angle ? identity_of(own, side)
                                                                 : Identity::unknown;
}

Identity identity_of(Side own, Side other) {
  if (own == Side::none || other == Side::none)
    return Identity::unknown;
  return own == other ? Identity::friendly : Identity::hostile;
}

double apparent_diameter(double area, double range) {
  return std::sqrt(4 * area / kPi) / range;
}

Contact estimate(const Visual& visual, const Eyes& eyes, const Vec3& position, PlayerId truth,
                 Draw noise) {
  const Vec3 sight = position - eyes.position;
  const double range = norm(sight);
  const Vec3 unit = sight / range;
  // the two directions across the line: away from the nose, and square to that
  const Vec3 outwards =
      normalized(dot(unit, eyes.body.forward) * unit - eyes.body.forward, eyes.body.right);
  const Vec3 sideways = cross(unit, outwards);
  const double mirror = std::copysign(1.0, dot(unit, eyes.body.right));

  Contact contact;
  contact.range = range * math::exp(visual.sigma_range * noise.normal());
  const double out = visual.sigma_angle * noise.normal();
  const double side = mirror * visual.sigma_angle * noise.normal();
  contact.line = normalized(unit + out * outwards + side * sideways, unit);
  contact.position = eyes.position + contact.range * contact.line;
  contact.sigma_along = visual.sigma_range * contact.range;
  contact.sigma_across = visual.sigma_angle * contact.range;
  contact.truth = truth;
  contact.source = kFromVisual;
  return contact;
}

bool looks_dangerous(const Visual& visual, const Vec3& relative_position,
                     const Vec3& relative_velocity) {
  const double range2 = norm2(relative_position);
  if (range2 <= 0 || dot(relative_position, relative_velocity) >= 0)
    return false;
  const double turning = norm(cross(relative_position, relative_velocity)) / range2;
  return turning <= visual.steady_rate;
}

}  // namespace eyrie::model::sensor
