// SPDX-License-Identifier: MIT
#pragma once
/// \file  Comparing simulated times, which are sums of steps and carry their rounding.

namespace eyrie::ubf {

/// s. A tick that comes this little too early is on time: 0.7 - 0.2 is a bit less than 0.5.
inline constexpr double kTimeSlack = 1e-6;

/// Whether at `now` at least `duration` has passed since `since`; all in s.
[[nodiscard]] constexpr bool passed(double now, double since, double duration) {
  return now - since >= duration - kTimeSlack;
}

}  // namespace eyrie::ubf
