// SPDX-License-Identifier: MIT
#pragma once
/// \file  From what the user typed to a loaded scenario.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "disk/read_file.hpp"
#include "scenario/scenario.hpp"

namespace eyrie::app {

/// The page that runs are put into: EYRIE_VIEWER, or the one beside the program; "" if there is
/// none.
[[nodiscard]] std::string viewer_file();
/// The page of the playground, which lies beside that one.
[[nodiscard]] std::string playground_file();
/// One of them without its parts, or why there is none: `problem` is `unbuilt` if it is not there.
[[nodiscard]] disk::FileRead read_page(const std::string& file, std::string_view unbuilt);

/// The launch zones of the shipped missiles if they lie beside the program, else "".
[[nodiscard]] std::string launch_zones();

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
