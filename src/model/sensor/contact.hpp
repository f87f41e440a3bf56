// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one look of one sensor gives, before any filter.
#include "core/id.hpp"
#include "core/vec.hpp"
#include "model/track.hpp"

namespace eyrie::model {

/// Who looks: what the trackers need to know about the own aircraft.
struct Observer {
  Vec3 position{};  ///< m, local frame
  Vec3 velocity{};  ///< m/s, local frame
};

/// One measurement of one other player, in the local frame, with the errors of the sensor in it.
struct Contact {
  Vec3 position{};          ///< m
  Vec3 line{};              ///< unit vector from the sensor to `position`
  double range = 0;         ///< m
  double speed_along = 0;   ///< m/s, of the target over the ground along `line`; needs sigma_speed
  double sigma_along = 0;   ///< m, 1-sigma along the line
  double sigma_across = 0;  ///< m, 1-sigma in each direction across it
  double sigma_speed = 0;   ///< m/s, 1-sigma of speed_along; 0 if the sensor does not measure it
  PlayerId truth{};         ///< where the echo or the light came from
  TrackSource source = kFromRadar;
  Identity identity = Identity::unknown;  ///< if the look itself told
  bool interrogated = false;              ///< asked by IFF in this look; `identity` has the reply
};

}  // namespace eyrie::model
