// SPDX-License-Identifier: MIT
#pragma once
/// \file  A scenario of Eyrie's own, for what is told to a mission.
#include <cstdlib>

#include "scenario/mission.hpp"

namespace eyrie::fuzz {

inline std::shared_ptr<const scenario::Scenario> shipped(const std::string& name,
                                                         const std::vector<std::string>& sets) {
  const char* home = std::getenv("EYRIE_HOME");
  const std::string root = home ? home : ".";
  return scenario::load({root + "/scenarios/" + name + ".yaml", sets},
                        scenario::Source::disk(root));
}

}  // namespace eyrie::fuzz
