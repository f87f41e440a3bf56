// SPDX-License-Identifier: MIT
#include "disk/file_system.hpp"

#include <dirent.h>

#include <atomic>
#include <cerrno>
#include <new>
#include <system_error>

#include "core/diagnostics.hpp"

namespace eyrie::disk {
namespace {

FileSystem operating_system;
std::atomic<FileSystem*> in_use = nullptr;

}  // namespace

int FileSystem::list(int folder, std::vector<std::string>& names) {
  const int again =
      ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);  // a place of its own
  DIR* stream = again < 0 ? nullptr : ::fdopendir(again);
  if (!stream) {
    if (again >= 0)
      ::close(again);
    return -1;
  }
  int error = 0;
  try {
    errno = 0;
    while (const dirent* entry = ::readdir(stream)) {
      const std::string_view name = entry->d_name;
      if (name != "." && name != "..")
        names.emplace_back(name);
      errno = 0;
    }
    error = errno;
  } catch (const std::bad_alloc&) {
    error = ENOMEM;
  }
  ::closedir(stream);
  errno = error;
  return error ? -1 : 0;
}

bool FileSystem::mount_point(int folder) {
  struct statx found {};
  return ::statx(folder, "", AT_EMPTY_PATH, 0, &found) == 0 &&
         (found.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
}

FileSystem& files() {
  FileSystem* const other = in_use;
  return other ? *other : operating_system;
}

FileSystem* use_files(FileSystem* other) {
  return in_use.exchange(other);
}

const char* kind_text(mode_t mode) {
  return S_ISREG(mode)    ? "a file"
         : S_ISDIR(mode)  ? "a folder"
         : S_ISLNK(mode)  ? "a symbolic link"
         : S_ISFIFO(mode) ? "a pipe"
         : S_ISSOCK(mode) ? "a socket"
                          : "a device";
}

std::string words_of(int error) {
  return std::generic_category().message(error);
}

void cannot_make(const std::string& path, int error) {
  const std::string words = fmt::format("cannot make {}: {}", quote_path(path), words_of(error));
  if (error == ENOENT || error == ENOTDIR || error == ENAMETOOLONG || error == ELOOP ||
      error == EINVAL || error == EACCES || error == EPERM || error == EROFS)
    throw Refused(error, words);
  throw Failed(words);
}

}  // namespace eyrie::disk
