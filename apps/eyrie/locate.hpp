// SPDX-License-Identifier: MIT
#pragma once
/// \file  From what the user typed to a loaded scenario.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scenario/scenario.hpp"

namespace eyrie::app {

/// The page that runs are put into: EYRIE_VIEWER, or the one beside the program; "" if there is
/// none.
[[nodiscard]] std::string viewer_file();

/// The launch zones of the shipped missiles need not be flown if they lie beside the program.
void take_launch_zones();

/// The file that a name means: itself if it is one, or scenarios/<name>.yaml.
[[nodiscard]] std::string scenario_file(const std::string& name);

/// Loads it, or prints every mistake on stderr and gives null.
[[nodiscard]] std::shared_ptr<const scenario::Scenario> load_or_complain(
    const std::string& name, const std::vector<std::string>& sets,
    const std::vector<std::string>& plugins, const std::vector<std::string>& includes);

/// The folder with data/ and scenarios/: EYRIE_HOME, or where this program is installed, or the one
/// it was built from. Nothing after saying that it is not there.
[[nodiscard]] std::optional<std::string> home_or_complain();

}  // namespace eyrie::app
