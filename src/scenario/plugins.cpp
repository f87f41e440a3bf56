// SPDX-License-Identifier: MIT
#include "scenario/plugins.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "driver/catalog.hpp"
#include "pilot/catalog.hpp"

namespace eyrie::scenario {

Plugins::Plugins() {
  static const auto own = std::make_shared<const Registries>(
      Registries{.pilots = pilot::make_registry(), .drivers = driver::make_registry()});
  registries_ = own;
}

void load_plugins(std::span<const std::string> paths, Plugins& plugins, Source& source,
                  Diagnostics& diagnostics) {
  for (const std::string& path : paths)
    for (std::string& problem : plugins.load(path, source))
      diagnostics.error({"--plugin " + path, 0, 0}, std::move(problem));
}

void load_plugins(const Value& key, const PluginPermission& permission, Plugins& plugins,
                  Source& source, Diagnostics& diagnostics) {
  const auto load = [&](const Value& item) {
    if (!item.is_scalar())
      return diagnostics.error(item.where, "plugins: expected a file, got " + item.shown());
    if (source.is_bundle())
      return;
    // what --set names is meant as it was typed
    const bool typed = item.where.file.text().starts_with("--set ");
    const std::string path = typed ? item.text : relative_to(item.where.file.text(), item.text);
    for (const std::string& problem : plugins.load(path, source, &permission))
      diagnostics.error(item.where, fmt::format("plug-in {}: {}", quote(item.text), problem));
  };
  if (key.is_list())
    std::for_each(key.items.begin(), key.items.end(), load);
  else if (key.is_scalar())
    load(key);
  else if (!key.is_null())
    diagnostics.error(key.where, "plugins: expected a file or a list of files, got " + key.shown());
}

}  // namespace eyrie::scenario
