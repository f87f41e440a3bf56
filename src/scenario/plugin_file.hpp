// SPDX-License-Identifier: MIT
#pragma once
/// \file  A plug-in as a recording names it, and the bytes of its file.
#include "disk/sink.hpp"

namespace eyrie::scenario {

struct PluginFile {
  std::string path;        ///< absolute
  std::uint64_t hash = 0;  ///< of the bytes of the file
  bool operator==(const PluginFile&) const = default;
};

/// No plug-in is larger, so that nobody reads a disk into memory.
inline constexpr std::size_t kLargestPlugin = std::size_t{512} << 20;

/// Reads a regular file of at most that size.
[[nodiscard]] disk::FileRead read_plugin_file(const std::string& path);
/// The hash that recordings keep.
[[nodiscard]] std::uint64_t hash_of(std::string_view bytes);

/// A path as it may be typed into a shell and shown on a terminal: quoted if it has to be.
[[nodiscard]] std::string shell_word(std::string_view path);

/// Why a file is no whole plug-in (a shared library in ELF, for this machine), in words; empty if
/// it is one. The dynamic linker believes what stands in a file and is killed by what is cut short.
/// Checked is what it believes: every segment, every section and every table of the dynamic segment
/// lies inside the file. System V ABI (gABI 4.1), chapters 4 and 5.
[[nodiscard]] std::string shared_object_problem(std::string_view file);

}  // namespace eyrie::scenario
