// SPDX-License-Identifier: MIT
#pragma once
/// \file  Two models of a motion, believed with their probabilities, as one.
#include "model/track/filter.hpp"

namespace eyrie::model::track {

/// How much of two that are believed with their probabilities goes into their mean.
struct Weights {
  double total, a, b;

  Weights(const Mode& first, const Mode& second) : total(first.probability + second.probability) {
    b = total > 0 ? second.probability / total : 0;
    a = 1 - b;
  }
  [[nodiscard]] Vec3 mean(const Vec3& x, const Vec3& y) const { return x + b * (y - x); }
};

/// Of the mean of two modes. Without `kAccelerates` their accelerations are left out.
template <bool kAccelerates = true>
Covariance covariance_of(const Mode& a, const Mode& b, const Weights& weights, const Vec3& line) {
  // the spread of their means counts as well
  const Vec3 p = b.position - a.position, v = b.velocity - a.velocity,
             w = b.acceleration - a.acceleration;
  const double pa = dot(p, line), va = dot(v, line);
  AxisState along{pa * pa, pa * va, va * va};
  AxisState across{(norm2(p) - pa * pa) / 2, (dot(p, v) - pa * va) / 2, (norm2(v) - va * va) / 2};
  if constexpr (kAccelerates) {
    const double wa = dot(w, line);
    along.position_acceleration = pa * wa;
    along.velocity_acceleration = va * wa;
    along.acceleration = wa * wa;
    across.position_acceleration = (dot(p, w) - pa * wa) / 2;
    across.velocity_acceleration = (dot(v, w) - va * wa) / 2;
    across.acceleration = (norm2(w) - wa * wa) / 2;
  }
  const auto both = [&](const AxisState& x, const AxisState& y, const AxisState& means) {
    const auto of = [&](double AxisState::*m) {
      return 0 + weights.a * (x.*m) + weights.b * (y.*m) + weights.a * weights.b * (means.*m);
    };
    AxisState c{of(&AxisState::position), of(&AxisState::cross), of(&AxisState::velocity)};
    if constexpr (kAccelerates) {
      c.position_acceleration = of(&AxisState::position_acceleration);
      c.velocity_acceleration = of(&AxisState::velocity_acceleration);
      c.acceleration = of(&AxisState::acceleration);
    }
    return c;
  };
  return {both(a.along, b.along, along), both(a.across, b.across, across)};
}

/// Both as one.
template <bool kAccelerates = true>
Mode mixture(const Mode& a, const Mode& b, const Vec3& line) {
  const Weights weights(a, b);
  const Covariance c = covariance_of<kAccelerates>(a, b, weights, line);
  return {.position = weights.mean(a.position, b.position),
          .velocity = weights.mean(a.velocity, b.velocity),
          .acceleration = kAccelerates ? weights.mean(a.acceleration, b.acceleration) : Vec3{},
          .along = c.along,
          .across = c.across,
          .probability = weights.total};
}

}  // namespace eyrie::model::track
