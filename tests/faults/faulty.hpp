// SPDX-License-Identifier: MIT
#pragma once
/// \file  A table of file calls in which one call fails, or is the moment of a signal, or the disk
/// is full after so many bytes.
#include <signal.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "disk/file_system.hpp"

namespace eyrie::test {

class Faulty final : public disk::FileSystem {
 public:
  std::uint64_t at = 0;           ///< the call, from 1 on; 0: none
  int error = 0;                  ///< of errno: what it fails with
  int signal = 0;                 ///< comes before it is made
  std::int64_t room = INT64_MAX;  ///< bytes that the disk still takes
  int times = 1;                  ///< how often the signal comes
  useconds_t apart = 0;           ///< us between two of them
  /// Before the first file or folder is put in its place.
  std::function<void()> before_first_move{};
  std::uint64_t calls = 0;

  int open(int folder, const char* name, int flags, mode_t mode) override {
    return fails() ? -1 : FileSystem::open(folder, name, flags, mode);
  }
  ssize_t read(int file, void* to, std::size_t size) override {
    return fails() ? -1 : FileSystem::read(file, to, size);
  }
  ssize_t write(int file, const void* from, std::size_t size) override {
    if (fails())
      return -1;
    const auto taken = std::min<std::size_t>(size, static_cast<std::size_t>(room));
    room -= static_cast<std::int64_t>(taken);
    if (taken == 0 && size != 0) {
      errno = ENOSPC;
      return -1;
    }
    return FileSystem::write(file, from, taken);
  }
  int cut(int file, off_t size) override {
    struct stat before {};
    if (fails() || ::fstat(file, &before) != 0)
      return -1;
    room += before.st_size - size;
    return FileSystem::cut(file, size);
  }
  int sync(int file) override { return fails() ? -1 : FileSystem::sync(file); }
  int close(int file) override {
    const int closed = FileSystem::close(file);
    return fails() ? -1 : closed;
  }
  int status(int file, struct stat& into) override {
    return fails() ? -1 : FileSystem::status(file, into);
  }
  int status(int folder, const char* name, struct stat& into, int flags) override {
    return fails() ? -1 : FileSystem::status(folder, name, into, flags);
  }
  int set_mode(int file, mode_t mode) override {
    return fails() ? -1 : FileSystem::set_mode(file, mode);
  }
  int make_folder(int folder, const char* name, mode_t mode) override {
    return fails() ? -1 : FileSystem::make_folder(folder, name, mode);
  }
  int remove(int folder, const char* name, int flags) override {
    return fails() ? -1 : FileSystem::remove(folder, name, flags);
  }
  int rename(int from_folder, const char* from, int to_folder, const char* to,
             unsigned flags) override {
    if (before_first_move)
      std::exchange(before_first_move, {})();
    return fails() ? -1 : FileSystem::rename(from_folder, from, to_folder, to, flags);
  }
  int link(const char* to, int folder, const char* name) override {
    return fails() ? -1 : FileSystem::link(to, folder, name);
  }
  int list(int folder, std::vector<std::string>& names) override {
    return fails() ? -1 : FileSystem::list(folder, names);
  }
  int lock(int file) override { return fails() ? -1 : FileSystem::lock(file); }

 private:
  bool fails() {
    if (++calls != at)
      return false;
    for (int i = 0; signal && i < times; ++i) {
      if (i > 0)
        ::usleep(apart);
      ::raise(signal);
    }
    errno = error;
    return error != 0;
  }
};

}  // namespace eyrie::test
