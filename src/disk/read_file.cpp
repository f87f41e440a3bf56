// SPDX-License-Identifier: MIT
#include "disk/read_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>

#include "disk/file_system.hpp"

namespace eyrie::disk {
namespace {

std::string size_text(std::size_t bytes) {
  constexpr std::size_t kKilo = 1024, kMega = kKilo * kKilo;
  return bytes % kMega == 0   ? fmt::format("{} MB", bytes / kMega)
         : bytes % kKilo == 0 ? fmt::format("{} kB", bytes / kKilo)
                              : fmt::format("{} bytes", bytes);
}

FileRead refused(int error) {
  if (error == ENOENT || error == ENOTDIR)
    return {.problem = "there is no such file", .missing = true};
  // a socket, or a device that is not there, cannot even be opened
  return {.problem = error == ENXIO ? "is no regular file"
                                    : fmt::format("cannot be read: {}", words_of(error))};
}

FileRead read_open(int file, std::size_t limit) {
  struct stat status {};
  if (files().status(file, status) != 0)
    return refused(errno);
  if (!S_ISREG(status.st_mode))
    return {.problem = fmt::format("is {}, not a file", kind_text(status.st_mode))};
  const std::string too_large =
      fmt::format("is larger than {}, the most that is read", size_text(limit));
  const auto size = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
  if (size > limit)
    return {.problem = too_large};
  // a byte more than it says: it may have grown since, and a file of /proc says 0
  constexpr std::size_t kMore = 1 << 16;
  FileRead read;
  std::size_t used = 0;
  for (;;) {
    if (used == read.bytes.size())
      read.bytes.resize(used == 0 ? size + 1 : used + kMore);
    const ssize_t got = files().read(file, read.bytes.data() + used, read.bytes.size() - used);
    if (got < 0 && errno == EINTR)
      continue;
    if (got < 0)
      return refused(errno);
    used += static_cast<std::size_t>(got);
    if (used > limit)
      return {.problem = too_large};
    if (got == 0)
      break;
  }
  read.bytes.resize(used);
  return read;
}

}  // namespace

FileRead read_file(const std::string& path, std::size_t limit) {
  if (path.find('\0') != path.npos)
    return refused(ENOENT);
  const int file = files().open(AT_FDCWD, path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY, 0);
  if (file < 0)
    return refused(errno);
  FileRead read = read_open(file, limit);
  files().close(file);
  return read;
}

}  // namespace eyrie::disk
