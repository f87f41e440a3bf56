// SPDX-License-Identifier: MIT
#pragma once
/// \file  Aircraft that fly into each other.
#include "model/row_boxes.hpp"

namespace eyrie::model::flight {

/// m: aircraft whose middles come nearer than this have collided. Two fighters of 13 m span and
/// 19 m length that meet in any attitude touch somewhere below it: the mean of both sizes over two.
inline constexpr double kCollision = 8;

/// Whether two that are `apart` (m) now, and whose distance changes by `relative` (m/s), were
/// nearer than kCollision at some time in the last `duration` seconds, in straight lines.
[[nodiscard]] constexpr bool collided(const Vec3& apart, const Vec3& relative, double duration) {
  const double speed2 = norm2(relative);
  const double back = speed2 > 0 ? std::clamp(dot(apart, relative) / speed2, 0.0, duration) : 0.0;
  return norm2(apart - back * relative) < kCollision * kCollision;
}

/// Calls `hit(i, j)` for each of `first` to `last` and each other that it has collided with in the
/// last `duration` seconds.
template <class Hit>
void for_each_collision(std::span<const Kinematics> all, std::size_t first, std::size_t last,
                        double duration, const Hit& hit) {
  constexpr double kNear = 500;  // m: nobody comes from farther in a tenth of a second
  RowBoxes(all).each_pair_within(
      first, last, kNear * kNear, [&](std::size_t i, std::size_t j, double) {
        if (j != i && collided(all[j].position - all[i].position, all[j].velocity - all[i].velocity,
                               duration))
          hit(i, j);
      });
}

}  // namespace eyrie::model::flight
