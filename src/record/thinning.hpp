// SPDX-License-Identifier: MIT
#pragma once
/// \file  Which samples of a flight a reader needs that draws straight lines between them.
#include <span>
#include <vector>

#include "core/vec.hpp"

namespace eyrie::record {

/// Where somebody was, and how it lay in the air.
struct Pose {
  double time = 0;                          ///< s
  Vec3 position = {};                       ///< m, local frame
  double roll = 0, pitch = 0, heading = 0;  ///< rad
};

/// How far what is left out may be from the line between what is kept.
struct Tolerance {
  double position = 0;  ///< m
  double attitude = 0;  ///< rad, of each angle
};

/// Marks what has to be kept besides what is marked already (the first and the last pose must be):
/// each line reaches as far as all poses that it leaves out are within the tolerance. Angles turn
/// the shorter way.
void thin(std::span<const Pose> poses, std::vector<bool>& kept, const Tolerance& tolerance);

}  // namespace eyrie::record
