// SPDX-License-Identifier: MIT
#include "disk/sink.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <utility>

#include "disk/file_system.hpp"

namespace eyrie::disk {
namespace {
constexpr std::size_t kBuffer = 1 << 16;
}

Sink::Sink(const std::string& path) : path_(path) {
  open(AT_FDCWD, path, O_TRUNC);
}

Sink::Sink(int folder, const std::string& name, std::string shown) : path_(std::move(shown)) {
  open(folder, name, O_EXCL | O_NOFOLLOW);
}

Sink::Sink(int file, std::string shown) : path_(std::move(shown)), file_(file), borrowed_(true) {
  waiting_.reserve(kBuffer);
}

Sink::~Sink() {
  release();
}

bool Sink::release() {
  const int file = std::exchange(file_, -1);
  return file < 0 || borrowed_ || files().close(file) == 0;
}

void Sink::open(int folder, const std::string& name, int flags) {
  waiting_.reserve(kBuffer);
  file_ = files().open(folder, name.c_str(), O_WRONLY | O_CREAT | flags, 0666);
  if (file_ < 0)
    fail();
}

void Sink::write(std::string_view bytes) {
  size_ += bytes.size();
  while (good() && !bytes.empty()) {
    const std::string_view part = bytes.substr(0, kBuffer - waiting_.size());
    waiting_ += part;
    bytes.remove_prefix(part.size());
    if (waiting_.size() == kBuffer)
      flush();
  }
}

bool Sink::flush() {
  std::string_view left = waiting_;
  while (good() && !left.empty()) {
    const ssize_t written = files().write(file_, left.data(), left.size());
    if (written > 0) {
      left.remove_prefix(static_cast<std::size_t>(written));
      written_ += static_cast<std::uint64_t>(written);
    } else if (written == 0 || errno != EINTR) {
      fail();
    }
  }
  waiting_.clear();
  return error_.empty();
}

bool Sink::cut(std::uint64_t size) {
  flush();
  if (file_ < 0 || size > written_ || files().cut(file_, static_cast<off_t>(size)) != 0)
    return false;
  size_ = written_ = size;
  error_.clear();
  return true;
}

bool Sink::close() {
  flush();
  // EINVAL: what is written to is no file of a disk
  if (good() && files().sync(file_) != 0 && errno != EINVAL)
    fail();
  if (!release())
    fail();
  return error_.empty();
}

void Sink::fail() {
  if (error_.empty())
    error_ = fmt::format("cannot write '{}': {}", path_, words_of(errno));
}

}  // namespace eyrie::disk
