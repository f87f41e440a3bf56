// SPDX-License-Identifier: MIT
#include "model/flight/steering.hpp"

#include "model/flight/equations.hpp"

namespace eyrie::model::flight {

Controls steer(const PointMass& model, const Kinematics& k, const FlightCondition& c,
               const Guidance& wanted, double load_factor, std::uint8_t& afterburner) {
  bool lit = afterburner != 0;
  const Controls controls =
      Equations<double>({&model}).steer(k, c, WantedOf<double>({wanted}), load_factor, lit);
  afterburner = lit;
  return controls;
}

double slowest_speed(const PointMass& model, const Kinematics& k, const FlightCondition& c) {
  return Equations<double>({&model}).slowest_speed(k, c);
}

}  // namespace eyrie::model::flight
