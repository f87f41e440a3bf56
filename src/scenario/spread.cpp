// SPDX-License-Identifier: MIT
#include "scenario/spread.hpp"

#include "core/angle.hpp"
#include "core/draw.hpp"
#include "model/flight/flight_system.hpp"
#include "scenario/assemble.hpp"

namespace eyrie::scenario {
namespace {

constexpr double kHighest = 30e3;  // m, of a start

/// What is wrong with the range of one start, in words.
std::optional<std::string> problem(const Spread& s) {
  const auto length = [](double x) { return exact_quantity(x, Dimension::length); };
  const auto speed = [](double x) { return exact_quantity(x, Dimension::speed); };
  const double altitude = s.altitude - s.offset.z;
  if (altitude < s.by.altitude)
    return fmt::format("altitude: {} below a start at {} is below the surface",
                       length(s.by.altitude), length(altitude));
  if (altitude + s.by.altitude > kHighest)
    return fmt::format("altitude: {} above a start at {} is above {}", length(s.by.altitude),
                       length(altitude), length(kHighest));
  if (s.speed - s.by.speed < 1)
    return fmt::format("speed: {} slower than a start at {} does not fly", speed(s.by.speed),
                       speed(s.speed));
  const Vec3 corner{std::fabs(s.place.x) + s.by.position, std::fabs(s.place.y) + s.by.position, 0};
  if (norm(corner) > kReach)
    return fmt::format(
        "position: {} from this start is {:.0f} km from the reference point; the "
        "local frame reaches {:.0f} km",
        length(s.by.position), norm(corner) / 1000, kReach / 1000);
  return std::nullopt;
}

/// The same of its place beside its lead, unmoved.
std::optional<std::string> problem_in_formation(const Spread& s) {
  const auto length = [](double x) { return exact_quantity(x, Dimension::length); };
  const double altitude = s.altitude - s.offset.z;
  if (altitude >= 0 && altitude <= kHighest)
    return std::nullopt;
  return fmt::format("{} {} its lead, which starts at {}, is {}", length(std::fabs(s.offset.z)),
                     altitude < 0 ? "below" : "above", length(s.altitude),
                     altitude < 0 ? "below the surface" : "above " + length(kHighest));
}

}  // namespace

std::optional<Spread> spread_of(const PlayerPlan& player, Spread of, const Reference& reference,
                                Diagnostics& diagnostics) {
  const StartSpec& start = player.spec.start;
  of.by = player.spec.spread;
  if (!start.altitude || !start.heading || !start.speed)
    return std::nullopt;
  of.altitude = *start.altitude;
  if (const auto wrong = problem_in_formation(of))
    return diagnostics.error(player.where, "{}: {}", player.name, *wrong);
  if (of.by == SpreadSpec{})
    return std::nullopt;
  of.heading = *start.heading;
  of.speed = *start.speed;
  if (player.own && player.own->find("spread")) {
    of.drawn_by = of.player;
    of.place = beside(reference, of.place, of.heading + of.lead_off, of.offset);
    of.altitude -= of.offset.z;
    of.offset = {};
  }
  if (const auto wrong = problem(of))
    return diagnostics.error(player.place("spread"), "{}: spread.{}", player.name, *wrong);
  return of;
}

void scatter(std::span<const Spread> spreads, const Reference& reference,
             const model::Environment& environment, const model::AircraftColumns& columns,
             sim::World& world) {
  for (const Spread& s : spreads) {
    Draw draw(world.seed(), s.drawn_by, Stream::start, 0);
    const auto about = [&](double middle, double most) {
      return middle + draw.uniform(-most, most);
    };
    const double north = about(s.place.x, s.by.position), east = about(s.place.y, s.by.position);
    const double altitude = about(s.altitude, s.by.altitude);
    const double heading = wrap_pi(about(s.heading, s.by.heading));
    const double speed = about(s.speed, s.by.speed);
    Vec3 place = at_altitude(reference, north, east, altitude);
    if (s.offset != Vec3{})
      place = beside(reference, place, heading + s.lead_off, s.offset);

    const auto row = world.row(columns.table, s.player);
    EYRIE_DEMAND(row.has_value(), "at the start everybody is there");
    model::Kinematics& k = world.rows(columns.kinematics)[*row];
    k = model::flight::placed(reference, environment, place, heading, speed);
    model::Command& command = world.rows(columns.command)[*row];
    command.heading = k.heading;
    command.altitude = k.altitude;
    command.speed = speed;
  }
}

}  // namespace eyrie::scenario
