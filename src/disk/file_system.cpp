// SPDX-License-Identifier: MIT
#include "disk/file_system.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <new>
#include <string_view>
#include <system_error>

#include "core/diagnostics.hpp"

namespace eyrie::disk {
namespace {

FileSystem& operating_system() {
  static FileSystem calls;
  return calls;
}

std::atomic<FileSystem*> in_use = nullptr;

}  // namespace

int FileSystem::open(int folder, const char* name, int flags, mode_t mode) {
  return ::openat(folder, name, flags | O_CLOEXEC, mode);
}
ssize_t FileSystem::read(int file, void* to, std::size_t size) {
  return ::read(file, to, size);
}
ssize_t FileSystem::write(int file, const void* from, std::size_t size) {
  return ::write(file, from, size);
}
int FileSystem::cut(int file, off_t size) {
  return ::ftruncate(file, size) == 0 && ::lseek(file, size, SEEK_SET) == size ? 0 : -1;
}
int FileSystem::sync(int file) {
  return ::fsync(file);
}
int FileSystem::close(int file) {
  return ::close(file);
}
int FileSystem::status(int file, struct stat& into) {
  return ::fstat(file, &into);
}
int FileSystem::status(int folder, const char* name, struct stat& into, int flags) {
  return ::fstatat(folder, name, &into, flags);
}
int FileSystem::set_mode(int file, mode_t mode) {
  return ::fchmod(file, mode);
}
int FileSystem::make_folder(int folder, const char* name, mode_t mode) {
  return ::mkdirat(folder, name, mode);
}
int FileSystem::remove(int folder, const char* name, int flags) {
  return ::unlinkat(folder, name, flags);
}
int FileSystem::rename(int from_folder, const char* from, int to_folder, const char* to,
                       unsigned flags) {
  return ::renameat2(from_folder, from, to_folder, to, flags);
}

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

int FileSystem::lock(int file) {
  return ::flock(file, LOCK_EX | LOCK_NB);
}

FileSystem& files() {
  FileSystem* const other = in_use;
  return other ? *other : operating_system();
}

Instead::Instead(FileSystem& other) : before_(in_use.exchange(&other)) {}
Instead::~Instead() {
  in_use = before_;
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
