// SPDX-License-Identifier: MIT
#pragma once
/// \file  What drivers see in the sky.
#include "model/datalink/datalink.hpp"
#include "model/fit.hpp"
#include "model/sensor/visual.hpp"
#include "model/signature.hpp"
#include "model/vehicle/vehicle.hpp"

namespace eyrie::model::vehicle {

/// The aircraft there are. Which type of signature a row has is its Fit::type.
struct Sky {
  std::span<const PlayerId> ids;
  std::span<const Fit> fit;
  std::span<const Kinematics> kinematics;
  std::span<const Signature* const> signatures;
};

/// s; an aircraft of which nothing was seen or heard for longer is forgotten.
inline constexpr double kSightedMemory = 15;

/// Who looks, and when.
struct Watcher {
  const Kinematics& own;
  PlayerId id{};
  Side side = Side::none;
  std::uint64_t seed = 0, step = 0;
  double time = 0;  ///< s
};

/// One look around, by the same law of visual search as a pilot's. Of more aircraft than there is
/// room for, the nearest are kept.
void look_up(const sensor::Visual& visual, const Watcher& watcher, const Sky& sky,
             Lookout& lookout);

/// Takes in what a mate told of the sky.
void warn(Lookout& lookout, const Vec3& eyes, const datalink::DatalinkMessage& message);
/// The same as tracks, to tell mates of.
[[nodiscard]] TrackFile as_tracks(const Lookout& lookout);

/// Takes in an aircraft seen just now, or told of.
void sight(Lookout& lookout, const Vec3& eyes, const Sighted& seen);
/// Forgets who was not seen for long.
void forget(Lookout& lookout, double time);

}  // namespace eyrie::model::vehicle
