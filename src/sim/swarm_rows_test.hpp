// SPDX-License-Identifier: MIT
#pragma once
/// \file  The rows, events and orders of the swarm, the small world of the kernel's tests.
#include <cstdint>

#include "core/field.hpp"
#include "core/id.hpp"
#include "core/vec.hpp"
#include "sim/schema.hpp"

namespace eyrie::sim::swarm {

enum class Happening : std::uint16_t { none, shot, hit, kill, hatched, turned };
enum class Wish : std::uint16_t { none, turn };

struct Body {
  Vec3 position{}, velocity{};
  static constexpr auto fields() {
    return field_list(field("position", &Body::position), field("velocity", &Body::velocity));
  }
};
static_assert(fields_cover_row<Body>());

struct Mood {
  Vec3 goal{};
  PlayerId target{};
  std::uint16_t looks = 0;
  std::uint8_t angry = 0;
  std::uint8_t reserved = 0;
  static constexpr auto fields() {
    return field_list(field("goal", &Mood::goal), field("target", &Mood::target),
                      field("looks", &Mood::looks), field("angry", &Mood::angry),
                      field("reserved", &Mood::reserved));
  }
};
static_assert(fields_cover_row<Mood>());

struct Vitals {
  std::uint32_t hits = 0, kills = 0;
  static constexpr auto fields() {
    return field_list(field("hits", &Vitals::hits), field("kills", &Vitals::kills));
  }
};
static_assert(fields_cover_row<Vitals>());

struct Aim {
  PlayerId target{}, owner{};
  std::uint32_t age = 0, reserved = 0;
  static constexpr auto fields() {
    return field_list(field("target", &Aim::target), field("owner", &Aim::owner),
                      field("age", &Aim::age), field("reserved", &Aim::reserved));
  }
};
static_assert(fields_cover_row<Aim>());

struct Turn {
  Vec3 velocity{};
};

/// The keys of the swarm's tables and columns.
struct Keys {
  TableId birds, pellets;
  Column<Body> body;
  Column<Mood> mood;
  Column<Vitals> vitals;
  ByteColumn brain;
  Column<Body> pellet_body;
  Column<Aim> aim;
};

inline constexpr double kReach = 40;       // m, of a pellet's fuze
inline constexpr std::uint32_t kHits = 2;  // that kill
inline constexpr std::uint32_t kPeriod = 5;

}  // namespace eyrie::sim::swarm
