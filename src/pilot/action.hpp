// SPDX-License-Identifier: MIT
#pragma once
/// \file  What a pilot wants: numbers to fly, and orders. An empty field is "no opinion".
#include <cstdint>
#include <optional>
#include <tuple>

#include "core/id.hpp"
#include "core/vec.hpp"
#include "model/command.hpp"
#include "ubf/action_traits.hpp"

namespace eyrie::pilot {

/// Whom to follow, and where: what the autopilot's follow mode needs.
struct Follow {
  Vec3 position;    ///< m, local frame, at `time`
  Vec3 velocity;    ///< m/s
  double time = 0;  ///< s
  Vec3 offset;      ///< m, forward, right, down of the heading of who is followed
  friend constexpr bool operator==(const Follow&, const Follow&) = default;
};

/// Which store at which track.
struct Release {
  TrackId track;
  std::uint32_t store = 0;  ///< index of the missile type in the Library
  friend constexpr bool operator==(const Release&, const Release&) = default;
};

/// What the pilot calls out while doing it; told as an event when it changes.
enum class Call : std::uint32_t { none, defend_far, defend_near, land };

/// The recommendation of one behavior, or of a whole tree. A field that stays empty up to the root
/// leaves the last command as it is.
struct Action {
  std::optional<double> heading;             ///< rad, true
  std::optional<double> altitude;            ///< m
  std::optional<double> speed;               ///< m/s true airspeed
  std::optional<double> load_factor;         ///< g, the most that turning may use
  std::optional<model::AutopilotMode> mode;  ///< flown instead of the numbers unless it is hold
  std::optional<Follow> follow;              ///< for the mode follow
  std::optional<TrackId> target;             ///< the track to lock
  std::optional<Release> release;
  std::optional<bool> trigger;  ///< of the gun
  std::optional<bool> radar;    ///< radiate or be silent
  std::optional<Call> call;
};

}  // namespace eyrie::pilot

template <>
struct eyrie::ubf::ActionTraits<eyrie::pilot::Action> {
  using A = pilot::Action;
  static constexpr auto fields = std::tuple{
      field<blend::Angle>("heading", &A::heading, "rad"),
      field<blend::Mean>("altitude", &A::altitude, "m"),
      field<blend::Mean>("speed", &A::speed, "m/s"),
      field<blend::Mean>("load_factor", &A::load_factor),
      field<blend::Agreed>("mode", &A::mode),
      field<blend::Agreed>("follow", &A::follow),
      field<blend::Strongest>("target", &A::target),
      field<blend::Strongest>("release", &A::release),
      field<blend::Strongest>("trigger", &A::trigger),
      field<blend::Strongest>("radar", &A::radar),
      field<blend::Strongest>("call", &A::call),
  };
};
