// SPDX-License-Identifier: MIT
/// \file  Plug-ins that were built for another Eyrie: UNFIT says in what they differ.
#include <cstdlib>

#include "scenario/plugin.hpp"

const eyrie::scenario::PluginInfo eyrie_plugin{
    UNFIT, .add = [](eyrie::scenario::Registrar&) { std::abort(); }};
