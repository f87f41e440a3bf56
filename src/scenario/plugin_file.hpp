// SPDX-License-Identifier: MIT
#pragma once
/// \file  A plug-in as a recording names it.
#include <cstdint>
#include <optional>
#include <string>

namespace eyrie::scenario {

struct PluginFile {
  std::string path;        ///< absolute
  std::uint64_t hash = 0;  ///< of the bytes of the file
  bool operator==(const PluginFile&) const = default;
};

/// The hash of a file's bytes, or nothing if it cannot be read.
[[nodiscard]] std::optional<std::uint64_t> hash_of_file(const std::string& path);

}  // namespace eyrie::scenario
