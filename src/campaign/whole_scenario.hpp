// SPDX-License-Identifier: MIT
#pragma once
/// \file  A scenario with overrides as one file.
#include "scenario/source.hpp"

namespace eyrie::campaign {

/// The text of a scenario that flies as `file` does with these overrides: what that includes stands
/// in it, and plug-ins and networks by their whole path. Throws ConfigError.
[[nodiscard]] std::string whole_scenario(const std::string& file,
                                         const std::vector<std::string>& sets,
                                         scenario::Source source);

}  // namespace eyrie::campaign
