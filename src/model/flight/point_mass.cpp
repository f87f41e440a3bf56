// SPDX-License-Identifier: MIT
#include "model/flight/point_mass.hpp"

#include <initializer_list>

namespace eyrie::model::flight {
namespace {

Axis common(std::initializer_list<std::span<const double>> axes) {
  std::vector<double> all;
  for (const auto& axis : axes)
    all.insert(all.end(), axis.begin(), axis.end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (all.size() == 1)  // beyond it the tables go on as they are
    all.push_back(all.front() + std::max(1.0, std::fabs(all.front())));
  return Axis(std::move(all));
}

}  // namespace

PointMass::PointMass(const Airframe& airframe)
    : airframe_(airframe),
      steepest_climb_(math::sin(airframe.autopilot.max_climb_angle)),
      steepest_dive_(math::sin(airframe.autopilot.max_dive_angle)) {
  const Aerodynamics& a = airframe_.aerodynamics;
  const Engine& e = airframe_.engine;
  mach_ = common({a.zero_lift_drag.breakpoints(), a.induced_drag.breakpoints(),
                  a.max_lift.breakpoints(), e.military.rows().breakpoints(),
                  e.afterburner.rows().breakpoints()});
  altitude_ = common({e.military.columns().breakpoints(), e.afterburner.columns().breakpoints()});
  share_ = common({e.part_power.breakpoints()});
  for (const double mach : mach_.breakpoints()) {
    by_mach_.push_back({a.zero_lift_drag(mach), a.induced_drag(mach), a.max_lift(mach), 0});
    const auto altitudes = altitude_.breakpoints();
    for (std::size_t i = 0; i + 1 < altitudes.size(); ++i) {
      const Thrust here = e.thrust_at(mach, altitudes[i]),
                   above = e.thrust_at(mach, altitudes[i + 1]);
      power_.push_back({here.military, here.afterburner, above.military, above.afterburner});
    }
  }
  for (const double share : share_.breakpoints())
    part_power_.push_back(e.part_power(share));
  for (std::size_t i = 0; i + 1 < by_mach_.size(); ++i)
    by_mach_[i].lift_slope = (by_mach_[i + 1].max_lift - by_mach_[i].max_lift) /
                             (mach_.breakpoints()[i + 1] - mach_.breakpoints()[i]);
}

}  // namespace eyrie::model::flight
