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

double Engine::thrust_of(const Thrust& available, double throttle) {
  return throttle <= 1
             ? available.idle + throttle * (available.military - available.idle)
             : available.military + (throttle - 1) * (available.afterburner - available.military);
}

double Engine::throttle_for(const Thrust& available, double thrust, bool with_afterburner) {
  const double dry = available.military - available.idle;
  if (thrust <= available.military || !with_afterburner)
    return dry > 0 ? std::clamp((thrust - available.idle) / dry, 0.0, 1.0) : 1;
  const double wet = available.afterburner - available.military;
  return wet > 0 ? std::min(1 + (thrust - available.military) / wet, 2.0) : 1;
}

double Engine::flow_of(const Thrust& available, double throttle, double mach,
                       double temperature) const {
  const double root_theta = std::sqrt(temperature * (1 / kSeaLevelTemperature));
  const double dry = military_tsfc * (1 + military_tsfc_mach * mach) * root_theta;
  const double at_military = dry * available.military;
  if (throttle <= 1) {
    const double share =
        available.military > 0 ? thrust_of(available, throttle) / available.military : 0;
    return std::max(at_military * part_power(share), idle_flow);
  }
  const double wet = afterburner_tsfc * (1 + afterburner_tsfc_mach * mach) * root_theta;
  const double at_full = wet * available.afterburner;
  return std::max(at_military + (throttle - 1) * (at_full - at_military), idle_flow);
}

double Engine::spool(double throttle, double wanted, double dt) const {
  const double step =
      dt / (throttle > 1 || (throttle == 1 && wanted > 1) ? light_time : spool_time);
  return throttle + std::clamp(wanted - throttle, -step, step);
}

}  // namespace eyrie::model::flight
