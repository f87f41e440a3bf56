// SPDX-License-Identifier: MIT
#pragma once
/// \file  What one aircraft's engines are doing and how much fuel is left.
#include "core/field.hpp"

namespace eyrie::model::flight {

/// Written in move.
struct Propulsion {
  double fuel = 0;      ///< kg on board
  double flow = 0;      ///< kg/s burned
  double throttle = 0;  ///< 0 idle .. 1 military power .. 2 full afterburner
  double thrust = 0;    ///< N

  static constexpr auto fields() {
    return field_list(
        field("fuel", &Propulsion::fuel, "kg"), field("flow", &Propulsion::flow, "kg/s"),
        field("throttle", &Propulsion::throttle), field("thrust", &Propulsion::thrust, "N"));
  }
};
static_assert(fields_cover_row<Propulsion>());

/// Takes what `flow` burns in `dt` seconds out of the tanks. True when they run dry right now.
[[nodiscard]] inline bool burn(Propulsion& p, double dt) {
  if (p.fuel <= 0)
    return false;
  p.fuel -= p.flow * dt;
  if (p.fuel > 0)
    return false;
  p.fuel = 0;
  return true;
}

}  // namespace eyrie::model::flight
