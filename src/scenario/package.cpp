// SPDX-License-Identifier: MIT
#include "scenario/data.hpp"
#include "scenario/plugins.hpp"
#include "scenario/scenario.hpp"
#include "scenario/trees.hpp"

namespace eyrie::scenario {

std::optional<std::size_t> check_package(const LoadRequest& request, Source source) {
  Diagnostics diagnostics;
  Plugins plugins;
  load_plugins(request.plugins, plugins, source, diagnostics);
  const Value document = load_document(request.file, source, diagnostics);
  diagnostics.throw_if_any();
  if (!is_package(document))
    return std::nullopt;
  if (const Value* v = document.find("plugins"))
    load_plugins(*v, request.may_open, plugins, source, diagnostics);
  diagnostics.throw_if_any();
  static_cast<void>(
      TreeBook::read(document, {}, {}, plugins.registries(), {}, diagnostics, &source));
  model::Library library;
  static_cast<void>(DataLoader(library, document.find("data"), source, diagnostics));
  diagnostics.throw_if_any();
  const Value* const trees = document.find("trees");
  return trees ? trees->entries.size() : 0;
}

}  // namespace eyrie::scenario
