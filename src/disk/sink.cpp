// SPDX-License-Identifier: MIT
#include "disk/sink.hpp"

#include <fcntl.h>

#include <algorithm>
#include <cerrno>

#include "core/diagnostics.hpp"
#include "disk/file_system.hpp"

namespace eyrie::disk {
namespace fs = std::filesystem;
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

namespace {

std::string limit_text(std::size_t bytes) {
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
      fmt::format("is larger than {}, the most that is read", limit_text(limit));
  const auto size = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0));
  if (size > limit)
    return {.problem = too_large};
  // a byte more than it says: it may have grown since, and a file of /proc says 0
  constexpr std::size_t kMore = 1 << 16;
  FileRead read{.owner = status.st_uid, .mode = status.st_mode};
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
  if (file < 0) {
    FileRead none = refused(errno);
    if (none.missing)
      none.problem += nearest_file(path);
    return none;
  }
  FileRead read = read_open(file, limit);
  files().close(file);
  return read;
}

std::string nearest_file(const fs::path& missing, const fs::path& asker, const fs::path& from,
                         std::string_view before) {
  constexpr std::size_t kMost = 10'000;
  std::error_code failed;
  const fs::path path = fs::absolute(missing, failed).lexically_normal();
  const fs::path other = fs::absolute(asker, failed).lexically_normal();
  fs::path folder = path.parent_path();
  int deep = 0;  // folders between the one that exists and the file
  for (; !fs::is_directory(folder, failed) && folder.has_relative_path(); ++deep)
    folder = folder.parent_path();
  std::vector<std::string> names;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied,
                                      failed);
  for (std::size_t seen = 0; !failed && at != end(at) && seen < kMost; ++seen) {
    if (at.depth() == deep) {
      at.disable_recursion_pending();
      if (at->path() != other && at->is_regular_file(failed))
        names.push_back(at->path().lexically_relative(folder).generic_string());
    }
    at.increment(failed);
  }
  std::ranges::sort(names);
  std::string wanted = path.lexically_relative(folder).generic_string();
  if (std::ranges::binary_search(names, wanted + ".yaml"))
    wanted += ".yaml";
  std::string meant = did_you_mean(wanted, names);
  if (!meant.empty() && !from.empty()) {
    const fs::path way = folder.lexically_relative(fs::absolute(from, failed).lexically_normal());
    const std::string written = way == "." || way.empty() ? "" : way.generic_string() + "/";
    meant.insert(meant.find('\'') + 1, std::string(before) + written);
  }
  return meant;
}

}  // namespace eyrie::disk
