// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "commands.hpp"
#include "locate.hpp"
#include "record/json_schema.hpp"
#include "say.hpp"
#include "scenario/catalog.hpp"
#include "scenario/plugins.hpp"

namespace eyrie::app {

int catalog(CatalogFormat format, const std::vector<std::string>& files) {
  const auto there = home_or_complain();
  if (!there)
    return 2;
  scenario::Source source = scenario::Source::disk(*there);
  scenario::Plugins plugins;
  Diagnostics diagnostics;
  scenario::load_plugins(files, plugins, source, diagnostics);
  if (!diagnostics.ok()) {
    complain("{}\n", lines(diagnostics.text()));
    return 2;
  }
  const scenario::Catalog all = scenario::make_catalog(source, plugins);
  say("{}", lines(format == CatalogFormat::json_schema ? record::catalog_json_schema(all)
                  : format == CatalogFormat::markdown  ? scenario::catalog_markdown(all)
                                                       : scenario::catalog_text(all)));
  return 0;
}

}  // namespace eyrie::app
