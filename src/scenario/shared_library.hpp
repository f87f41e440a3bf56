// SPDX-License-Identifier: MIT
#pragma once
/// \file  Opens a plug-in's shared library, or says in words why that cannot be done.
#include <string>

#include "scenario/plugin.hpp"

namespace eyrie::scenario {

/// `info` is null exactly if there is a problem.
struct OpenedPlugin {
  const PluginInfo* info = nullptr;
  std::string problem;
};

/// Opens the file at an absolute path and checks that it was made for this program. Of its code
/// only the constructors of its static objects have run then.
[[nodiscard]] OpenedPlugin open_plugin(const std::string& path);

}  // namespace eyrie::scenario
