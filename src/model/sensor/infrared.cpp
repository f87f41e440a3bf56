// SPDX-License-Identifier: MIT
#include "model/sensor/infrared.hpp"

#include <algorithm>

#include "model/sensor/radar.hpp"
#include "model/sensor/scene.hpp"

namespace eyrie::model::sensor {

bool covers(const Irst& irst, const Axes& body, const Vec3& sight) {
  const double ahead = dot(sight, body.forward), aside = dot(sight, body.right);
  const double down = dot(sight, body.down);
  if (ahead <= 0)
    return false;
  const auto below_tangent = [&](double part, double angle) {
    const auto [s, c] = math::sin_cos(angle);
    return part * c <= s * ahead;
  };
  return below_tangent(std::fabs(aside), irst.half_azimuth) && below_tangent(down, irst.low) &&
         below_tangent(-down, irst.high);
}

bool finds(const Irst& irst, double intensity, double range, double noise) {
  constexpr double kThreshold = 4.753424308823;  // of a normal law, exceeded once in a million
  if (range > irst.greatest_range)
    return false;
  const double signal = intensity / irst.reference_intensity * irst.reference_range *
                        irst.reference_range / (range * range);
  return kThreshold * signal + noise > kThreshold;
}

Contact measure(const Irst& irst, bool fires, const Kinematics& own, const Axes& body,
                const Vec3& place, PlayerId truth, Draw noise) {
  const Vec3 sight = place - own.position;
  const double range = norm(sight);
  const Vec3 unit = sight / range;
  const Vec3 outwards =
      std::copysign(1.0, dot(unit, body.right)) * normalized(cross(body.down, unit), body.right);
  const Vec3 upwards = normalized(dot(body.down, unit) * unit - body.down, body.forward);
  const double aside = irst.sigma_angle * noise.normal();
  const double above = irst.sigma_angle * noise.normal();

  Contact contact;
  contact.line = normalized(unit + aside * outwards + above * upwards, unit);
  contact.range = fires ? std::max(range + irst.sigma_laser * noise.normal(), 1.0) : range;
  contact.position = own.position + contact.range * contact.line;
  contact.sigma_along = irst.sigma_laser;
  contact.sigma_across = irst.sigma_angle * contact.range;
  contact.truth = truth;
  contact.source = kFromInfrared;
  return fires ? contact : strobe(contact, own.position, irst.greatest_range);
}

namespace {

/// m, 1-sigma: how far a mate may be by now from where he said he would be.
constexpr double kMateRange = 30;

/// How far what was found is from a place, in standard deviations, squared; without the laser
/// nobody knows how far it is along its line.
double misfit(const Irst& irst, const Contact& found, const Vec3& sight) {
  const double range = norm(sight);
  const double aside = norm(sight / range - found.line) / irst.sigma_angle;
  const double along =
      found.bearing_only ? 0.0 : (range - found.range) / (irst.sigma_laser + kMateRange);
  return aside * aside + along * along;
}

}  // namespace

void search_infrared(const Scene& scene, Self& self) {
  const Irst& irst = *self.suite.irst;
  const Kinematics& own = self.kinematics;
  const Axes body = body_axes(own);
  const double reach2 = irst.greatest_range * irst.greatest_range;
  const Wind& wind = scene.library.environment.wind;

  constexpr std::size_t kMost = 8;
  Nearest<kMost> found(kMost);
  const auto propulsion = scene.world.rows(scene.aircraft.propulsion);
  for (std::size_t j = 0; j < scene.kinematics.size(); ++j) {
    const Kinematics& other = scene.kinematics[j];
    const Vec3 sight = other.position - own.position;
    const double range2 = norm2(sight);
    if (range2 > reach2 || range2 <= 0 || j == self.row || !found.wants(range2) ||
        !covers(irst, body, sight))
      continue;
    const double range = std::sqrt(range2);
    if (range > horizon_range(own.altitude, other.altitude, 1))
      continue;
    const double cos_aspect = -dot(nose_of(other, wind), sight) / range;
    const double intensity = radiant_intensity(scene.library.aircraft[scene.fit[j].type].infrared,
                                               cos_aspect, propulsion[j].throttle);
    if (finds(irst, intensity, range, scene.draw(self.id, Stream::infrared, scene.ids[j]).normal()))
      found.offer({range2, static_cast<std::uint32_t>(j)});
  }
  if (found.items().empty())
    return;

  std::array<Contact, kMost> contacts;
  std::size_t count = 0;
  for (const Candidate& c : found.items()) {
    const PlayerId other = scene.ids[c.row];
    const bool fires = count == 0 && c.distance2 <= irst.laser_range * irst.laser_range;
    contacts[count++] = measure(irst, fires, own, body, scene.kinematics[c.row].position, other,
                                scene.draw(self.id, Stream::infrared_noise, other));
  }
  find_mates(
      scene, self, std::span(contacts).first(count),
      [&](const Vec3& sight, double range) {
        return range <= irst.greatest_range && covers(irst, body, sight);
      },
      [&](const Contact& contact, const Vec3& sight, double) {
        return misfit(irst, contact, sight);
      });
  track::update(self.tracks, self.context(scene.time), std::span(contacts).first(count));
}

}  // namespace eyrie::model::sensor
