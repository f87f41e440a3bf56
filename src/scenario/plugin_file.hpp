// SPDX-License-Identifier: MIT
#pragma once
/// \file  A plug-in as a file: as a recording names it, its bytes, and which ones the user has
/// allowed files to name, by path and by content.
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// Asked before a plug-in is opened that nobody has typed but that a scenario or a run file names:
/// its canonical path and the SHA-256 of its bytes, which is empty before the file is read at all.
/// Gives why it may not be opened (or read), or "" if it may. The empty function allows nothing.
using PluginPermission =
    std::function<std::string(const std::string& path, const std::string& sha256)>;

/// Reads the file of a plug-in at its canonical path. With a permission not a byte is read before
/// its path is allowed; the problem is then "it was not opened: <why>; add '--plugin x.so', or
/// trust it with 'eyrie trust x.so'", with `shown` as x.so.
[[nodiscard]] disk::FileRead read_allowed(const std::string& path,
                                          const PluginPermission* permission,
                                          std::string_view shown);

/// The list of trusted plug-ins: a text file with a line each, as sha256sum writes and checks it.
///
///   <SHA-256 in 64 digits>  </absolute/path/of/libmine.so>
///
/// Whoever may write to it may run code as the user. So it is read only if it belongs to him (or,
/// where he may read it, to root) and nobody else may write to it, and it is never guessed at.
class TrustList {
 public:
  struct Entry {
    std::string sha256, path;
    bool operator==(const Entry&) const = default;
  };

  /// A list that is not there is empty. Throws ConfigError for one that is damaged, with its line,
  /// or that others may have written.
  [[nodiscard]] static TrustList read(const std::string& file);
  /// Replaces the file, with what leads to it, so that nobody ever sees half of it. Throws
  /// std::runtime_error.
  void write(const std::string& file) const;

  [[nodiscard]] std::span<const Entry> entries() const { return entries_; }
  /// As PluginPermission: without a hash whether the path stands in the list.
  [[nodiscard]] std::string why_not(const std::string& path, const std::string& sha256) const;
  /// Trusts a plug-in with these bytes, and no longer with others.
  void add(Entry entry);
  /// False if it is not in the list.
  bool remove(std::string_view path);

 private:
  std::vector<Entry> entries_;  ///< by path
};

/// SHA-256 (FIPS 180-4) of some bytes as 64 small hexadecimal digits: for what an adversary may
/// have made. Everything else is hashed by core/hash.hpp, which is faster.
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace eyrie::scenario
