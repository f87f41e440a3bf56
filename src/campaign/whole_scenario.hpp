// SPDX-License-Identifier: MIT
#pragma once
/// \file  A scenario with overrides as one file.
#include <set>

#include "scenario/source.hpp"

namespace eyrie::campaign {

struct WholeScenario {
  std::string text;
  /// Of the networks, without Eyrie's own: a scenario elsewhere reads them if it is allowed to.
  std::set<std::string> folders;
};

/// A scenario that flies as `file` does with these overrides: what that includes stands in it, and
/// plug-ins and networks by their whole path. Throws ConfigError.
[[nodiscard]] WholeScenario whole_scenario(const std::string& file,
                                           const std::vector<std::string>& sets,
                                           scenario::Source source);

}  // namespace eyrie::campaign
