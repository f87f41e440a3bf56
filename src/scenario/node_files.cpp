// SPDX-License-Identifier: MIT
#include "scenario/node_files.hpp"

namespace eyrie::scenario {

std::string file_named(const Value& name) {
  const std::string_view asker = name.where.file.text();
  return asker.starts_with("--") ? name.text : relative_to(asker, name.text);
}

std::optional<std::string> NodeFiles::read(const Value& name, Diagnostics& diagnostics) {
  const std::string asker(name.where.file.text()), path = file_named(name);
  auto bytes = source_.read_bytes(path);
  if (bytes && bytes->size() <= Source::kLargestBytes)
    return bytes;
  return diagnostics.error(
      name.where,
      bytes ? fmt::format("{} is larger than {} MB", quote_path(path), Source::kLargestBytes >> 20)
            : source_.why_unread(path, asker));
}

}  // namespace eyrie::scenario
