// SPDX-License-Identifier: MIT
#include "train/task.hpp"

#include <algorithm>

#include "core/angle.hpp"
#include "model/events.hpp"
#include "pilot/geometry.hpp"
#include "scenario/assemble.hpp"

namespace eyrie::train {
namespace {

using model::Kinematics;

/// 1 up to `low`, 0 from `high` on, a straight line between.
double near_one(double x, double low, double high) {
  return high > low ? std::clamp((high - x) / (high - low), 0.0, 1.0) : x <= low ? 1.0 : 0.0;
}

/// How many are left of each side.
struct Living {
  std::uint32_t own = 0, enemies = 0;
};
Living living(const scenario::Scenario& scenario, const sim::World& world, model::Side side) {
  Living count;
  scenario.each_player(world, [&](const scenario::Fleet&, PlayerId id, std::size_t) {
    const scenario::Roster::Player* player = scenario.roster.find(id);
    if (player != nullptr)
      ++(player->side == side ? count.own : count.enemies);
  });
  return count;
}

const Kinematics* nearest_enemy(const scenario::Scenario& scenario, const sim::World& world,
                                const Kinematics& own, model::Side side) {
  const auto fits = world.rows(scenario.aircraft.fit);
  const auto motions = world.rows(scenario.aircraft.kinematics);
  const Kinematics* nearest = nullptr;
  double least = math::kInfinity;
  for (std::size_t row = 0; row < fits.size(); ++row)
    if (const double d = norm2(motions[row].position - own.position);
        fits[row].side != side && d < least) {
      least = d;
      nearest = &motions[row];
    }
  return nearest;
}

/// m, from the own place beside the lead of the flight; nothing without another one who leads.
std::optional<double> off_place(const scenario::Scenario& scenario, const sim::World& world,
                                PlayerId who, const Kinematics& own) {
  const scenario::Roster::Player& player = *scenario.roster.find(who);
  const PlayerId lead = scenario.roster.flights[player.flight].members.front();
  const auto row = world.row(scenario.aircraft.table, lead);
  if (lead == who || !row)
    return std::nullopt;
  const Kinematics& k = world.rows(scenario.aircraft.kinematics)[*row];
  const Vec3 offset = pilot::formation_offset(scenario.formations[player.flight], player.rank);
  return norm(own.position -
              scenario::beside(scenario.library->reference, k.position, k.heading, offset));
}

/// m/s
double closing(const Kinematics& own, const Kinematics& other, const Vec3& sight, double range) {
  return range > 0 ? -dot(sight, other.velocity - own.velocity) / range : 0;
}

}  // namespace

void note(const sim::Event& e, PlayerId who, const scenario::Roster& roster, Merit& merit) {
  const auto at_enemy = [&] {
    const auto *own = roster.find(who), *whom = roster.find(e.whom);
    return e.who == who && own && whom && own->side != whom->side;
  };
  switch (e.kind.as<model::EventKind>()) {
    case model::EventKind::kill:
      merit.kills += at_enemy() ? 1 : 0;
      break;
    case model::EventKind::hit:
      merit.hits += at_enemy() ? 1 : 0;
      merit.hits_by += e.whom == who ? 1 : 0;
      break;
    case model::EventKind::launch:
      merit.launches += e.detail == who.value ? 1 : 0;
      break;
    case model::EventKind::home:
      merit.home |= e.who == who;
      break;
    default:
      break;
  }
}

double reward(std::span<const Reward> terms, const scenario::Scenario& scenario,
              const sim::World& world, PlayerId who, const Merit& merit, bool over,
              double seconds) {
  const model::Side side = scenario.roster.find(who)->side;
  const auto row = world.row(scenario.aircraft.table, who);
  const Kinematics* own = row ? &world.rows(scenario.aircraft.kinematics)[*row] : nullptr;
  const Kinematics* other = own ? nearest_enemy(scenario, world, *own, side) : nullptr;
  const Vec3 sight = other ? other->position - own->position : Vec3{};
  const double range = norm(sight);
  const Living left = over ? living(scenario, world, side) : Living{};
  const auto worth = [&](const Reward& r) -> double {
    const double lived = own ? r.weight * seconds : 0, fought = other ? lived : 0;
    const auto within = [&] {
      return !other ? 0 : r.high == 0 ? 1 : near_one(range, r.low, r.high);
    };
    switch (r.term) {
      case Term::win:
        return over && left.enemies == 0 && left.own > 0 ? r.weight : 0;
      case Term::loss:
        return over && left.enemies > 0 && left.own == 0 ? r.weight : 0;
      case Term::draw:
        return over && (left.enemies == 0) == (left.own == 0) ? r.weight : 0;
      case Term::kill:
        return r.weight * merit.kills;
      case Term::killed:
        return !merit.alive && !merit.home ? r.weight : 0;
      case Term::hit:
        return r.weight * merit.hits;
      case Term::hit_by:
        return r.weight * merit.hits_by;
      case Term::launch:
        return r.weight * merit.launches;
      case Term::rounds:
        return r.weight * merit.rounds;
      case Term::alive:
        return lived;
      case Term::nose_on:
        if (const double share = within(); share > 0)
          return fought * (share * (1 - angle_between(own->velocity, sight) / kPi));
        return 0;
      case Term::advantage:
        if (const double share = within(); share > 0) {
          const double off_his_nose = angle_between(other->velocity, -sight);
          return fought * (share * (off_his_nose - angle_between(own->velocity, sight)) / kPi);
        }
        return 0;
      case Term::closeness:
        return fought * within();
      case Term::closing:
        return other ? fought * std::clamp(closing(*own, *other, sight, range) / r.high, -1.0, 1.0)
                     : 0;
      case Term::low:
        return own ? lived * near_one(own->altitude, r.low, r.high) : 0;
      case Term::formation: {
        const auto off = own ? off_place(scenario, world, who, *own) : std::nullopt;
        return off ? lived * near_one(*off, r.low, r.high) : 0;
      }
    }
    return 0;
  };
  double sum = 0;
  for (const Reward& r : terms)
    sum += worth(r);
  return sum;
}

}  // namespace eyrie::train
