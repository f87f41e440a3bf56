// SPDX-License-Identifier: MIT
#include "disk/failure.hpp"

#include <fmt/format.h>

#include <cerrno>

#include "core/diagnostics.hpp"
#include "disk/file_system.hpp"

namespace eyrie::disk {

std::string quoted(const std::string& path) {
  return quote_path(path);
}

void cannot_make(const std::string& path, int error) {
  const std::string words = fmt::format("cannot make {}: {}", quoted(path), words_of(error));
  if (error == ENOENT || error == ENOTDIR || error == ENAMETOOLONG || error == ELOOP ||
      error == EINVAL)
    throw Refused(words);
  throw Failed(words);
}

}  // namespace eyrie::disk
