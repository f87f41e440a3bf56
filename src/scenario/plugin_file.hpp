// SPDX-License-Identifier: MIT
#pragma once
/// \file  A plug-in as a recording names it, and the bytes of its file.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace eyrie::scenario {

struct PluginFile {
  std::string path;        ///< absolute
  std::uint64_t hash = 0;  ///< of the bytes of the file
  bool operator==(const PluginFile&) const = default;
};

/// No plug-in is larger, so that nobody reads a disk into memory.
inline constexpr std::size_t kLargestPlugin = std::size_t{512} << 20;

/// What is in a file, or in words why it is not read: `problem` is empty exactly if it was.
struct FileBytes {
  std::string bytes, problem;
};
/// Reads a regular file of at most kLargestPlugin bytes.
[[nodiscard]] FileBytes read_plugin_file(const std::string& path);

/// The hash that recordings keep.
[[nodiscard]] std::uint64_t hash_of(std::string_view bytes);
/// The same of a file, or nothing if it cannot be read.
[[nodiscard]] std::optional<std::uint64_t> hash_of_file(const std::string& path);

/// A path as it may be typed into a shell and shown on a terminal: quoted if it has to be.
[[nodiscard]] std::string shell_word(std::string_view path);

}  // namespace eyrie::scenario
