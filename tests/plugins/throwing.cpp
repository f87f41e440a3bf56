// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "scenario/plugin.hpp"

EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) {
  registrar.add_model("radars", "mine", "");
  throw std::runtime_error("no licence found");
})
