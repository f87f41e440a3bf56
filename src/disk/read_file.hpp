// SPDX-License-Identifier: MIT
#pragma once
/// \file  A whole file of a stranger, read only if it is one and no larger than allowed.
#include <cstddef>
#include <string>

namespace eyrie::disk {

/// The bytes, or why there are none: `problem` is "" exactly if they are there.
struct FileRead {
  std::string bytes{}, problem{};
  bool missing = false;  ///< there is nothing of that name
};

/// Nothing is read that is no regular file (a device, a pipe, a folder) or larger than `limit`
/// bytes; nothing is waited for. The problem is words to stand behind "file: ", such as "is a
/// folder, not a file".
[[nodiscard]] FileRead read_file(const std::string& path, std::size_t limit);

}  // namespace eyrie::disk
