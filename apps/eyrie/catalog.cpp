// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "commands.hpp"
#include "record/json_schema.hpp"
#include "scenario/catalog.hpp"

namespace eyrie::app {

int catalog(CatalogFormat format) {
  const scenario::Catalog all = scenario::make_catalog(scenario::Source::disk(home()));
  fmt::print("{}", format == CatalogFormat::json_schema ? record::catalog_json_schema(all)
                   : format == CatalogFormat::markdown  ? scenario::catalog_markdown(all)
                                                        : scenario::catalog_text(all));
  return 0;
}

}  // namespace eyrie::app
