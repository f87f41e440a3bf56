// SPDX-License-Identifier: MIT
#pragma once
/// \file  The plug-ins of a scenario, and the nodes that there are with them.
#include "core/diagnostics.hpp"
#include "core/value.hpp"
#include "scenario/plugin.hpp"
#include "scenario/plugin_file.hpp"
#include "scenario/scenario.hpp"
#include "scenario/source.hpp"

namespace eyrie::scenario {

/// Eyrie's own nodes and those of the plug-ins that were loaded. A shared library stays loaded
/// until the program ends, because trees hold its code.
class Plugins {
 public:
  Plugins();

  /// Loads a shared library: its nodes are then in registries(), its models in `source`. Gives
  /// every reason why it is refused; nothing of it is taken then. A file that is loaded already is
  /// not loaded again. Its code runs then: `permission` is null if the user has typed its path,
  /// otherwise it decides whether the file is opened.
  [[nodiscard]] std::vector<std::string> load(const std::string& path, Source& source,
                                              const PluginPermission* permission = nullptr);

  /// Takes the nodes of a program. Gives every reason why they are refused.
  [[nodiscard]] std::vector<std::string> add(const AddNodes& nodes);

  [[nodiscard]] const Registries& registries() const { return *registries_; }
  /// Says in a scenario whose nodes its trees may hold.
  void tell(Scenario& scenario) const;
  /// In the order in which they were loaded.
  [[nodiscard]] std::span<const PluginFile> files() const { return files_; }

 private:
  std::shared_ptr<const Registries> registries_;  ///< shared until a plug-in is loaded
  std::vector<PluginFile> files_;
  bool added_ = false;  ///< nodes of a program
};

/// Words that mean something else in YAML or in a tree than a node.
inline constexpr auto kReservedWords = std::to_array<std::string_view>(
    {"not", "and", "or", "null", "yes", "no", "on", "true", "false", "off", "any", "name", "tree",
     "parameters", "child", "children"});
/// What is wrong with the names of the nodes that `origin` has registered, and of their parameters:
/// what no tree could say, or what means something else there already.
[[nodiscard]] std::vector<std::string> name_problems(const Registries& registries,
                                                     std::string_view origin);

/// Loads and adds what a request names, as the command line does.
void load_plugins(const LoadRequest& request, Plugins& plugins, Source& source,
                  Diagnostics& diagnostics);
/// Loads what `plugins:` of a document names: one file or a list, relative to the file that says
/// so, as far as that is permitted. Out of a bundle nothing is loaded: whoever replays has done
/// that.
void load_plugins(const Value& key, const PluginPermission& permission, Plugins& plugins,
                  Source& source, Diagnostics& diagnostics);

}  // namespace eyrie::scenario
