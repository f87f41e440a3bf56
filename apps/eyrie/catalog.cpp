// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "commands.hpp"
#include "pilot/catalog.hpp"

namespace eyrie::app {

int catalog(CatalogFormat) {
  for (const auto& info : pilot::make_registry().catalog())
    fmt::print("{:<24} {}\n", info.name, info.help);
  return 0;
}

}  // namespace eyrie::app
