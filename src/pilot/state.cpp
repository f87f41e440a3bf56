// SPDX-License-Identifier: MIT
#include "pilot/state.hpp"

#include <bitset>

#include "model/weapon/gun.hpp"
#include "model/weapon/stores.hpp"
#include "pilot/sort.hpp"

namespace eyrie::pilot {
namespace {

/// A mate who falls silent this near home has landed: the same radius as egress.arrival, and some.
constexpr double kLandedRange = si(6, "nmi");

double across_ground(const Vec3& ned) {
  return std::sqrt(ned.x * ned.x + ned.y * ned.y);
}

/// Who of the flight is alive, who was lost, and the own rank among the living.
void count_flight(State& s, const model::Fit& fit) {
  s.lost = 0;
  s.alive = 0;
  s.rank = team::rank_now(s.datalink, fit.rank);
  for (std::uint32_t i = 0; i < s.datalink.count; ++i) {
    const model::Mate& mate = s.datalink.members[i];
    if (mate.alive) {
      s.alive |= 1U << i;
      continue;
    }
    const bool landed = (mate.reported || mate.called) && s.flight.home &&
                        across_ground(to_ned(s.own, mate.position - *s.flight.home)) < kLandedRange;
    s.lost += landed ? 0 : 1;
  }
}

}  // namespace

State::State(const Cockpit& cockpit, const model::Library& models, const model::Fit& fit,
             const Formation& flown_in, double now)
    : Cockpit(cockpit),
      library(models),
      type(models.aircraft[fit.type]),
      flight(models.flights[fit.flight]),
      formation(flown_in),
      time(now),
      seen_count(tracks.count),
      velocity_ned(to_ned(own, own.velocity)) {
  for (std::uint32_t i = 0; i < seen_count; ++i) {
    const model::Track& track = tracks.tracks[i];
    const Vec3 offset = position_at(track, time) - own.position;
    seen[i].track = &track;
    seen[i].ned = to_ned(own, offset);
    seen[i].range = norm(offset);
  }
  count_flight(*this, fit);
  const Choice choice = choose_target(*this);
  target_index = choice.index;
  contested = choice.contested;
}

const Seen* State::find_named(TrackId id) const {
  for (const Seen& one : tracks_seen())
    if (one.track->named(id))
      return &one;
  return nullptr;
}

std::optional<team::Leader> State::leader() const {
  const model::Mate* mate = lead();
  if (!mate || leads())
    return std::nullopt;
  if (const auto heard = team::heard(*mate, time))
    return heard;
  for (const Seen& one : tracks_seen())
    if ((one.track->sources & model::kFromTruth) && one.track->truth == mate->id)
      return team::Leader{position_at(*one.track, time), one.track->velocity};
  return std::nullopt;
}

std::optional<double> State::home_distance() const {
  if (!flight.home)
    return std::nullopt;
  return across_ground(to_ned(own, *flight.home - own.position));
}

const model::InboundMissile* State::threat() const {
  const model::InboundMissile* worst = nullptr;
  for (std::uint32_t i = 0; i < threats.count; ++i) {
    const model::InboundMissile& m = threats.missiles[i];
    if (!worst || (m.has_position && (!worst->has_position || m.range < worst->range)))
      worst = &m;
  }
  return worst;
}

double State::closing_on(const Seen& one) const {
  return one.range > 0 ? dot(one.ned, velocity_ned - velocity_of(one)) / one.range : 0.0;
}

/// A missile flies in the air, which moves; so do those in whose zone it is, about as fast here.
Vec3 State::through_air(const Vec3& velocity) const {
  return velocity - from_ned(own, wind());
}
model::weapon::LaunchParty State::party(const Seen& one) const {
  return {position_at(*one.track, time), through_air(one.track->velocity),
          altitude_of(own, one.ned)};
}

model::weapon::LaunchSituation State::launch_situation(const Seen& target) const {
  return model::weapon::launch_situation({own.position, through_air(own.velocity), own.altitude},
                                         party(target));
}

const model::Axes& State::body() const {
  if (!body_)
    body_ = model::body_axes(own);
  return *body_;
}

const Vec3& State::nose() const {
  if (!nose_)
    nose_ = nose_of(own);
  return *nose_;
}

const Reach& State::reach_of(const Seen& one) const {
  static_assert(model::kMaxTracks <= 32);
  const auto index = static_cast<std::size_t>(&one - seen.data());
  Reach& worst = reaches_[index];
  if ((reaches_found_ >> index & 1) != 0)
    return worst;
  reaches_found_ |= 1U << index;
  worst = {};
  const auto situation = model::weapon::launch_situation(
      party(one), {own.position, through_air(own.velocity), own.altitude});
  for (std::size_t i = 0; i < library.missiles.size(); ++i) {
    const model::MissileType& missile = library.missiles[i];
    if (missile.locks_before_launch())
      continue;
    const model::weapon::EmploymentZone zone = missile.zone.at(situation);
    if (zone.r_max > worst.r_max)
      worst = {zone.r_max, zone.r_ne};
  }
  return worst;
}

const std::optional<Sight>& State::gun_sight(const Seen& target) const {
  return gun_sight_.about(target.id(), [&]() -> std::optional<Sight> {
    if (!type.index.gun)
      return std::nullopt;
    model::Kinematics believed;
    believed.position = position_at(*target.track, time);
    believed.velocity = target.track->velocity;
    const double density = library.environment.atmosphere.at(own.altitude).density;
    const model::weapon::Lead lead = model::weapon::lead_on(library.guns[*type.index.gun], density,
                                                            own, body().forward, believed);
    const Vec3 aim = to_ned(own, lead.direction);
    return Sight{.aim = aim,
                 .off_nose = lead.off_bore,
                 .range = lead.range,
                 .time = lead.flight_time,
                 .body = in_body(aim)};
  });
}

model::Bearing State::in_body(const Vec3& ned) const {
  const model::Axes& axes = body();
  const Vec3 local = from_ned(own, ned);
  return direction_of({dot(local, axes.forward), dot(local, axes.right), dot(local, axes.down)});
}

const Angles& State::angles(const Seen& one) const {
  return angles_.about(one.id(), [&] {
    const Vec3 his = velocity_of(one) - wind();  // through the air, as the noses
    return Angles{.off_nose = off_nose(one.ned),
                  .off_tail = norm2(his) > 0 ? angle_between(his, one.ned) : 0.0,
                  .crossing = norm2(his) > 0 ? angle_between(his, nose()) : 0.0};
  });
}

const LineOfSight& State::line_of_sight(const Seen& one) const {
  return line_of_sight_.about(one.id(), [&] {
    // it turns by the part of the velocity across it over the range
    const Vec3 sight = normalized(one.ned, {1, 0, 0});
    const Vec3 right = normalized({-sight.y, sight.x, 0}, {0, 1, 0});
    const Vec3 turning = (velocity_of(one) - velocity_ned) / std::max(one.range, 1.0);
    return LineOfSight{.body = in_body(one.ned),
                       .right = dot(turning, right),
                       .up = dot(turning, cross(right, sight))};
  });
}

model::Bearing State::aim() const {
  const Seen* at = target();
  if (!at)
    return direction_of(normalized(velocity_ned, {1, 0, 0}));
  return aim_.about(at->id(), [&] {
    const Vec3 ned = normalized(at->ned, {1, 0, 0});
    const auto& sight = gun_sight(*at);
    if (!sight)
      return direction_of(ned);
    const double reach = library.guns[*type.index.gun].greatest_range;
    const double near = std::clamp(2 - sight->range / reach, 0.0, 1.0);
    return direction_of(normalized(ned + near * (sight->aim - ned), ned));
  });
}

const OwnReach& State::own_reach(const Seen& one) const {
  return own_reach_.about(one.id(), [&] {
    OwnReach reach;
    const auto situation = launch_situation(one);
    double shortest = math::kInfinity;
    std::bitset<256> tried;
    for (const model::Station& station : stores.stations) {
      if (station.store == 0 || station.count == 0 || tried[station.store])
        continue;
      tried.set(station.store);
      const auto store = static_cast<std::uint16_t>(station.store - 1);
      const model::weapon::EmploymentZone zone = library.missiles[store].zone.at(situation);
      if (!zone.possible())
        continue;
      reach.r_max = std::max(reach.r_max, zone.r_max);
      reach.r_ne = std::max(reach.r_ne, zone.r_ne);
      if (one.range >= zone.r_min && one.range <= zone.r_max && zone.r_max < shortest &&
          model::weapon::can_release(stores, store, time)) {
        shortest = zone.r_max;
        reach.store = store;
      }
    }
    return reach;
  });
}

double State::off_nose(const Vec3& ned) const {
  return angle_between(nose(), ned);
}

double State::altitude_for(double climb_angle) const {
  const model::Airframe& a = airframe();
  const double seconds = type.dynamics == model::flight::Dynamics::laero
                             ? a.laero.altitude_time
                             : a.autopilot.altitude_time;
  return own.altitude + own.speed * math::sin(climb_angle) * seconds;
}

}  // namespace eyrie::pilot
