// SPDX-License-Identifier: MIT
#include "scenario/node_files.hpp"

#include <fmt/format.h>

namespace eyrie::scenario {

std::optional<std::string> NodeFiles::read(const Value& name, Diagnostics& diagnostics) {
  const std::string asker(name.where.file.text());
  const bool typed = asker.starts_with("--");
  const std::string path = typed ? name.text : relative_to(asker, name.text);
  auto bytes = source_.read_bytes(path);
  if (bytes && bytes->size() <= Source::kLargestBytes)
    return bytes;
  diagnostics.error(
      name.where,
      bytes ? fmt::format("{} is larger than {} MB", quote_path(path), Source::kLargestBytes >> 20)
      : source_.is_outside(path)
          ? fmt::format("{} is outside the folder of the scenario and the installation; "
                        "--allow-include DIR allows it",
                        quote_path(path))
          : "cannot read " + quote_path(path) + source_.nearest(path, asker));
  return std::nullopt;
}

}  // namespace eyrie::scenario
