// SPDX-License-Identifier: MIT
#include "model/flight/airframe.hpp"

#include <algorithm>

namespace eyrie::model::flight {

Thrust Engine::thrust_at(double mach, double altitude) const {
  const double dry = military(mach, altitude);
  return {.idle = idle_share * dry,
          .military = dry,
          .afterburner = std::max(afterburner(mach, altitude), dry)};
}

}  // namespace eyrie::model::flight
