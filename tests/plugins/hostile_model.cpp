// SPDX-License-Identifier: MIT
/// \file  A plug-in with a model whose label a terminal would obey.
#include "scenario/plugin.hpp"

EYRIE_PLUGIN([](eyrie::scenario::Registrar& registrar) {
  registrar.add_model("aircraft", "odd_fighter", "base: f16c\nlabel: \"F-16 \\e[8m\\n-1\"\n");
})
