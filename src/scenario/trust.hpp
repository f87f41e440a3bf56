// SPDX-License-Identifier: MIT
#pragma once
/// \file  Which plug-ins the user has allowed files to name: by path and by content.
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "disk/sink.hpp"

namespace eyrie::scenario {

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
