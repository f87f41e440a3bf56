// SPDX-License-Identifier: MIT
/// \file  A plug-in whose model has a mistake.
#include "scenario/plugin.hpp"

EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) {
  registrar.add_model("airframes", "brick", "base: f16c\nempty_mass: 2 nmi\n");
})
