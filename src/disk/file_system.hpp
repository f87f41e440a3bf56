// SPDX-License-Identifier: MIT
#pragma once
/// \file  The calls by which Eyrie reads, writes and moves files, in one table.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace eyrie::disk {

/// The operating system's own calls, with its own results: below 0 is a failure, and errno says
/// which. A test puts another table in its place, in which any call can fail or be the last one.
/// A name is relative to the open folder before it; AT_FDCWD is the current one.
class FileSystem {
 public:
  virtual ~FileSystem() = default;

  virtual int open(int folder, const char* name, int flags, mode_t mode) {
    return ::openat(folder, name, flags | O_CLOEXEC, mode);
  }
  virtual ssize_t read(int file, void* to, std::size_t size) { return ::read(file, to, size); }
  virtual ssize_t write(int file, const void* from, std::size_t size) {
    return ::write(file, from, size);
  }
  /// Takes back what stands behind the first `size` bytes; the next write() goes there.
  virtual int cut(int file, off_t size) {
    return ::ftruncate(file, size) == 0 && ::lseek(file, size, SEEK_SET) == size ? 0 : -1;
  }
  /// Until what was written is on the disk.
  virtual int sync(int file) { return ::fsync(file); }
  virtual int close(int file) { return ::close(file); }
  /// Of an open file, or of a name: of the symbolic link itself with AT_SYMLINK_NOFOLLOW.
  virtual int status(int file, struct stat& into) { return ::fstat(file, &into); }
  virtual int status(int folder, const char* name, struct stat& into, int flags) {
    return ::fstatat(folder, name, &into, flags);
  }
  virtual int set_mode(int file, mode_t mode) { return ::fchmod(file, mode); }
  virtual int make_folder(int folder, const char* name, mode_t mode) {
    return ::mkdirat(folder, name, mode);
  }
  /// A file; with AT_REMOVEDIR an empty folder.
  virtual int remove(int folder, const char* name, int flags) {
    return ::unlinkat(folder, name, flags);
  }
  /// As renameat2: RENAME_NOREPLACE fails if `to` is there, RENAME_EXCHANGE swaps the two.
  virtual int rename(int from_folder, const char* from, int to_folder, const char* to,
                     unsigned flags) {
    return ::renameat2(from_folder, from, to_folder, to, flags);
  }
  /// A symbolic link.
  virtual int link(const char* to, int folder, const char* name) {
    return ::symlinkat(to, folder, name);
  }
  /// The names in an open folder, without "." and "..".
  virtual int list(int folder, std::vector<std::string>& names);
  /// Whether another disk, or another part of one, begins at an open folder.
  virtual bool mount_point(int folder);
  /// Takes the lock of an open file or folder for as long as it is open; fails if another open
  /// file holds it.
  virtual int lock(int file) { return ::flock(file, LOCK_EX | LOCK_NB); }
};

/// The table in use: the operating system's, unless a test has put in another one.
[[nodiscard]] FileSystem& files();

/// Puts another table in its place, or with null the operating system's; gives what was there.
FileSystem* use_files(FileSystem* other);

/// "a file", "a folder", "a symbolic link", "a pipe" ...
[[nodiscard]] const char* kind_text(mode_t mode);

/// What errno means, in words: "No space left on device".
[[nodiscard]] std::string words_of(int error);

/// An open file or folder that is closed when nobody needs it any more.
class Handle {
 public:
  Handle() = default;
  explicit Handle(int file) : file_(file) {}
  ~Handle() {
    if (file_ >= 0)
      files().close(file_);
  }
  Handle(Handle&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }

  [[nodiscard]] int get() const { return file_; }
  explicit operator bool() const { return file_ >= 0; }

 private:
  int file_ = -1;
};

/// The machine's failure: a full disk, a folder that may not be written to.
struct Failed : std::runtime_error {
  using std::runtime_error::runtime_error;
  template <class... T>
  requires(sizeof...(T) > 0) explicit Failed(fmt::format_string<T...> words, T&&... values)
      : Failed(fmt::format(words, std::forward<T>(values)...)) {}
};
/// The user's mistake: a place that is taken, that is none, or that may not be replaced.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
  Refused(int code, const std::string& words) : std::runtime_error(words), error(code) {}
  template <class... T>
  requires(sizeof...(T) > 0) explicit Refused(fmt::format_string<T...> words, T&&... values)
      : Refused(fmt::format(words, std::forward<T>(values)...)) {}
  int error = 0;  ///< of errno; 0: of none, as where something is there
};

/// Throws that `path` cannot be made because of `error` of errno: Refused if there cannot be
/// anything of that name, or the user may not make it; Failed otherwise.
[[noreturn]] void cannot_make(const std::string& path, int error);

}  // namespace eyrie::disk
