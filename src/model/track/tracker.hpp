// SPDX-License-Identifier: MIT
#pragma once
/// \file  How contacts become tracks: the parameters. docs/models/tracks.md has the equations.
#include <cstdint>
#include <string_view>
#include <tuple>

#include "core/describe.hpp"
#include "core/units.hpp"

namespace eyrie::model::track {

/// The tracker in the mission computer: const, shared, one for all sensors of an aircraft.
struct Tracker {
  double rate = 10;
  double gate = 4;
  double max_gate = si(5, "km");
  std::uint32_t confirm_hits = 2;
  double maneuver = 20;
  double initial_speed = 250;
  double coast_time = 12;
  double tentative_time = 6;
  double merge_gate = 2;
  double glance_time = 0.2;

  static constexpr std::string_view type_name = "tracker";
  static constexpr std::string_view help = "association, filter and life of tracks";
  static constexpr auto params() {
    return std::tuple{
        param(
            "rate", &Tracker::rate, "Hz", range(0.1, 100),
            "how often the tracks are looked after, the datalink is read and the beam is steered"),
        param("gate", &Tracker::gate, range(1, 10),
              "a contact belongs to a track within so many standard deviations"),
        param("max_gate", &Tracker::max_gate, "m", range(1, 1e5),
              "and, but for the error of its range, never farther away than this"),
        param("confirm_hits", &Tracker::confirm_hits, range(1, 255),
              "contacts after which a track is believed"),
        param("maneuver", &Tracker::maneuver, "m/s2", range(0, 500),
              "acceleration that a target may have, 1-sigma per axis"),
        param("initial_speed", &Tracker::initial_speed, "m/s", range(1, 2000),
              "speed that a new target may have, 1-sigma per axis"),
        param("coast_time", &Tracker::coast_time, "s", range(0.1, 600),
              "a confirmed track is dropped so long after its last update"),
        param("tentative_time", &Tracker::tentative_time, "s", range(0.1, 600),
              "a tentative track is dropped so long after its last update"),
        param("merge_gate", &Tracker::merge_gate, range(0, 10),
              "tracks closer than so many standard deviations are one"),
        param("glance_time", &Tracker::glance_time, "s", range(0, 60),
              "two tracks that the eyes last saw so far apart in time may be one aircraft")};
  }
};

}  // namespace eyrie::model::track
