// SPDX-License-Identifier: MIT
#pragma once
/// \file  What somebody outside the run asks of an aircraft: a person at its controls, a policy, an
/// operator. It comes by orders, so a run with it is flown again like any other.
#include "model/command.hpp"

namespace eyrie::model {

/// Who flies an aircraft.
enum class Seat : std::uint8_t {
  tree,    ///< its own tree
  person,  ///< somebody outside, while the tree goes on proposing
  remote,  ///< another program, which tells where it is
};
constexpr auto names_of(Seat) {
  return names_from_zero<Seat>("tree", "person", "remote");
}

/// What a person at the controls asks for; also the payload of the order that says so.
struct Manual {
  /// Which of the fields are meant; the others are the tree's. Weapons never are the tree's while
  /// somebody is at the controls, and nor is the direction of flight.
  enum Field : std::uint16_t {
    kHeading = 1,
    kAltitude = 2,
    kSpeed = 4,
    kClimb = 8,
    kLoadFactor = 16,
    kTarget = 32,
    kRadar = 64,
    kDispense = 128,
  };

  float heading = 0;   ///< rad, true
  float altitude = 0;  ///< m
  float speed = 0;     ///< m/s true airspeed
  float climb = 0;     ///< rad above the horizontal: a direction to fly to, instead of an altitude
  float load_factor = 0;   ///< g, the most that turning may use
  TrackId target;          ///< as the own tracker numbers it; none: nobody
  std::uint16_t said = 0;  ///< bits of Field
  Seat seat = Seat::tree;
  std::uint8_t store = 0;      ///< 1 + index of the missile type to release at the target, once
  std::uint8_t trigger = 0;    ///< 1: gun trigger pressed
  std::uint8_t radar_off = 0;  ///< 1: silent
  Dispense dispense = Dispense::none;
  std::uint8_t reserved = 0;

  static constexpr auto fields() {
    return field_list(
        field("heading", &Manual::heading, "rad"), field("altitude", &Manual::altitude, "m"),
        field("speed", &Manual::speed, "m/s"), field("climb", &Manual::climb, "rad"),
        field("load_factor", &Manual::load_factor), field("target", &Manual::target),
        field("said", &Manual::said), field("seat", &Manual::seat), field("store", &Manual::store),
        field("trigger", &Manual::trigger), field("radar_off", &Manual::radar_off),
        field("dispense", &Manual::dispense), field("reserved", &Manual::reserved));
  }
  [[nodiscard]] constexpr bool has(Field f) const { return (said & f) != 0; }
};
static_assert(sizeof(Manual) == 32, "the payload of an order");

/// A node's vote from now on, instead of the one that its file says.
struct VoteChange {
  float vote = 0;
  std::uint16_t number = 0;  ///< 1 + index of the node in the tree; 0: an empty place
  std::uint16_t tree = 0;    ///< of an order: 1 + index of the tree; 0: whichever is flown

  static constexpr auto fields() {
    return field_list(field("vote", &VoteChange::vote), field("number", &VoteChange::number),
                      field("tree", &VoteChange::tree));
  }
};

/// A place to fly to instead of the route.
struct PointToFly {
  Vec3f position{};        ///< m, local frame
  float altitude = 0;      ///< m
  std::uint32_t more = 0;  ///< of an order: 1 it follows the points there are, 0 replaces them
  static constexpr auto fields() {
    return field_list(field("position", &PointToFly::position, "m"),
                      field("altitude", &PointToFly::altitude, "m"),
                      field("more", &PointToFly::more));
  }
};

/// All that is asked of one aircraft. Zero means nothing.
struct Tasking {
  static constexpr std::size_t kVotes = 8, kPoints = 4;

  Manual manual;
  std::array<VoteChange, kVotes> votes{};
  std::array<PointToFly, kPoints> points{};  ///< the next one first
  std::uint8_t points_left = 0;
  std::uint8_t tight = 0;  ///< 1: weapons tight, nothing is released
  std::uint8_t reserved[2] = {};

  static constexpr auto fields() {
    return field_list(field("manual", &Tasking::manual), field("votes", &Tasking::votes),
                      field("points", &Tasking::points),
                      field("points_left", &Tasking::points_left), field("tight", &Tasking::tight),
                      field("reserved", &Tasking::reserved));
  }
};

}  // namespace eyrie::model
