// SPDX-License-Identifier: MIT
#include "pilot/outside.hpp"

#include <algorithm>

namespace eyrie::pilot {
namespace {

using model::AutopilotMode, model::Manual, model::PointToFly, model::Seat, model::VoteChange;
using team::Obeyed;

/// Whether every number can be flown: orders come from files and networks.
bool is_sane(const Manual& m) {
  const auto within = [](float x, double most) { return std::fabs(x) <= most; };  // false for NaN
  return m.seat <= Seat::person && within(m.heading, 1e3) && within(m.altitude, 100e3) &&
         within(m.speed, 10e3) && m.speed >= 0 && within(m.climb, 1.6F) &&
         within(m.load_factor, 100) && m.load_factor >= 0 && m.trigger <= 1 && m.radar_off <= 1 &&
         m.dispense <= model::Dispense::both && m.reserved == 0;
}

Obeyed sit(const Manual& wish, Manual& seat) {
  if (!is_sane(wish) || seat.seat == Seat::remote)
    return Obeyed::no;
  const bool stays = wish.seat == seat.seat;
  const Manual before = seat;
  seat = wish.seat == Seat::tree ? Manual{} : wish;
  if (wish.seat == Seat::tree && before.has(Manual::kRadar) && before.radar_off == 1)
    seat.said = Manual::kRadar;  // the tree gets its radar back
  if (wish.seat == Seat::person && stays) {
    // what was asked for once is not taken back by the next word
    if (seat.store == 0)
      seat.store = before.store;
    if (!seat.has(Manual::kDispense) && before.has(Manual::kDispense)) {
      seat.dispense = before.dispense;
      seat.said |= Manual::kDispense;
    }
    if (!seat.has(Manual::kRadar) && before.has(Manual::kRadar)) {
      seat.radar_off = before.radar_off;
      seat.said |= Manual::kRadar;
    }
  }
  return stays ? Obeyed::quietly : Obeyed::told;
}

Obeyed change_vote(const VoteChange& wish, std::span<VoteChange> votes, const team::Flown& flown) {
  if (wish.number == 0 || wish.number > flown.nodes || !(wish.vote <= 1000) ||
      (wish.tree != 0 && wish.tree != flown.tree + 1))
    return Obeyed::no;
  const auto end = std::remove_if(votes.begin(), votes.end(), [&](const VoteChange& v) {
    return v.number == wish.number || v.number == 0;
  });
  if (wish.vote >= 0 && end == votes.end())
    return Obeyed::no;
  std::fill(end, votes.end(), VoteChange{});
  if (wish.vote >= 0)
    *end = {.vote = wish.vote, .number = wish.number};
  return Obeyed::told;
}

Obeyed add_point(PointToFly wish, model::Tasking& asked) {
  const bool sane = std::all_of(wish.position.begin(), wish.position.end(),
                                [](float x) { return std::fabs(x) <= 1e7; }) &&
                    std::fabs(wish.altitude) <= 100e3 && wish.more <= 2;
  if (!sane || (wish.more == 1 && asked.points_left == model::Tasking::kPoints))
    return Obeyed::no;
  if (wish.more != 1) {
    asked.points = {};
    asked.points_left = 0;
  }
  if (wish.more != 2) {
    wish.more = 0;
    asked.points[asked.points_left++] = wish;
  }
  return Obeyed::told;
}

/// north-east-down, m
Vec3 way_to(const PointToFly& point, const State& state) {
  return to_ned(state.own, wide(point.position) - state.own.position);
}

/// By its route, or with its lead; and after nobody.
bool travels(const Action& action) {
  return action.mode == AutopilotMode::route ||
         (action.mode == AutopilotMode::follow && action.target == TrackId{});
}

std::optional<std::uint32_t> store_for(std::uint8_t wish, const State& state, const Seen& target) {
  if (wish != kAnyStore)
    return wish - 1U < state.library.missiles.size() ? std::optional(wish - 1U) : std::nullopt;
  std::optional<std::uint32_t> best;
  double best_reach = math::kInfinity;
  for (const model::Station& station : state.stores.stations) {
    if (station.store == 0 || station.count == 0)
      continue;
    const double reach = state.zone(static_cast<std::uint16_t>(station.store - 1), target).r_max;
    if (reach >= target.range && reach < best_reach) {
      best = station.store - 1U;
      best_reach = reach;
    } else if (!best) {
      best = station.store - 1U;
    }
  }
  return best;
}

}  // namespace

void fly_by_hand(const Manual& m, const State& state, Action& action) {
  const auto said = [&](Manual::Field field, float value) {
    return m.has(field) ? std::optional<double>(value) : std::nullopt;
  };
  action.heading = said(Manual::kHeading, m.heading);
  action.altitude = said(Manual::kAltitude, m.altitude);
  action.speed = said(Manual::kSpeed, m.speed);
  action.climb = said(Manual::kClimb, m.climb);
  action.load_factor = said(Manual::kLoadFactor, m.load_factor);
  action.mode = m.has(Manual::kClimb) ? AutopilotMode::aim : AutopilotMode::hold;
  action.follow.reset();
  action.route.reset();
  if (action.call != Call::land)
    action.call.reset();
  if (m.has(Manual::kTarget)) {
    const Seen* wanted = state.find(m.target);
    action.target = wanted && wanted->hostile() ? m.target : TrackId{};
  }
  action.trigger = m.trigger == 1;
  if (m.has(Manual::kRadar))
    action.radar = m.radar_off == 0;
  if (m.has(Manual::kDispense))
    action.dispense = m.dispense;
  action.release.reset();
  if (m.store != 0)
    if (const Seen* target = state.find(action.target.value_or(state.agent.target)))
      if (const auto store = store_for(m.store, state, *target))
        action.release = Release{target->id(), *store};
}

Obeyed Outside::obey(const sim::Order& order, Asked& asked, const team::Flown& flown) {
  switch (static_cast<OrderKind>(order.kind.value)) {
    case OrderKind::manual:
      return sit(order.as<Manual>(), asked.manual);
    case OrderKind::vote:
      return change_vote(order.as<VoteChange>(), asked.votes, flown);
    case OrderKind::point:
      return add_point(order.as<PointToFly>(), asked);
    case OrderKind::weapons:
      asked.tight = order.as<std::uint8_t>() == 1;
      return Obeyed::told;
    default:
      return Obeyed::no;
  }
}

double Outside::detail(const sim::Order& order) {
  switch (static_cast<OrderKind>(order.kind.value)) {
    case OrderKind::manual:
      return order.as<Manual>().seat == Seat::person ? 1 : 0;
    case OrderKind::vote:
      return order.as<VoteChange>().number - 1;
    case OrderKind::weapons:
      return order.as<std::uint8_t>();
    case OrderKind::point:
      return order.as<PointToFly>().more;
    default:
      return 0;
  }
}

void Outside::overrule(const Asked& asked, const State& state, Action& action) {
  if (asked.manual.seat == Seat::person) {
    fly_by_hand(asked.manual, state, action);
  } else if (asked.points_left > 0 && travels(action)) {
    const Vec3 way = way_to(asked.points[0], state);
    action.mode = AutopilotMode::hold;
    action.route.reset();
    action.follow.reset();
    action.heading = bearing_of(way);
    action.altitude = asked.points[0].altitude;
  }
  if (asked.manual.seat == Seat::tree && asked.manual.has(Manual::kRadar) && !action.radar)
    action.radar = true;
  if (asked.tight) {
    action.release.reset();
    action.trigger = false;
  }
}

void Outside::done(Asked& asked, const State& state) {
  asked.manual.store = 0;
  asked.manual.said &= static_cast<std::uint16_t>(~unsigned{Manual::kDispense});
  asked.manual.dispense = {};
  if (asked.manual.seat == Seat::tree)
    asked.manual = {};
  if (asked.points_left == 0)
    return;
  const Vec3 way = way_to(asked.points[0], state);
  if (way.x * way.x + way.y * way.y > kPointReached * kPointReached)
    return;
  std::rotate(asked.points.begin(), asked.points.begin() + 1, asked.points.end());
  asked.points.back() = {};
  --asked.points_left;
}

}  // namespace eyrie::pilot
