// SPDX-License-Identifier: MIT
#pragma once
/// \file  Files written and read: one that remembers whether everything was written, and a whole
/// one of a stranger.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace eyrie::disk {

/// Buffered output to one file. After the first failure nothing more is written and error() says
/// why; so a full disk is noticed, whoever wrote last.
class Sink {
 public:
  /// A new file, or an old one that is emptied.
  explicit Sink(const std::string& path);
  /// A file that must not exist yet, `name` in the open folder; mistakes call it `shown`.
  Sink(int folder, const std::string& name, std::string shown);
  /// A file that is open already and stays open.
  Sink(int file, std::string shown);
  ~Sink();
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;

  void write(std::string_view bytes);
  /// Nothing waits any more. False if anything was lost.
  bool flush();
  /// Takes back everything behind the first `size` bytes, and with it the failure, so that a
  /// shorter end may find room. False if not even those were written.
  bool cut(std::uint64_t size);
  /// Until everything is on the disk; then closes. False if anything was lost.
  bool close();

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Bytes given to write() so far.
  [[nodiscard]] std::uint64_t size() const { return size_; }
  /// "cannot write 'x': No space left on device", or "".
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  void open(int folder, const std::string& name, int flags);
  [[nodiscard]] bool good() const { return file_ >= 0 && error_.empty(); }
  bool release();
  void fail();

  std::string path_, error_, waiting_;
  std::uint64_t size_ = 0, written_ = 0;
  int file_ = -1;
  bool borrowed_ = false;
};

/// The bytes, or why there are none: `problem` is "" exactly if they are there.
struct FileRead {
  std::string bytes{}, problem{};
  bool missing = false;               ///< there is nothing of that name
  std::uint32_t owner = 0, mode = 0;  ///< st_uid and st_mode of what was read
};

/// Nothing is read that is no regular file (a device, a pipe, a folder) or larger than `limit`
/// bytes; nothing is waited for. The problem is words to stand behind "file: ", such as "is a
/// folder, not a file".
[[nodiscard]] FileRead read_file(const std::string& path, std::size_t limit);

/// "; did you mean 'x'?" for the file nearest to one that is not there, or "": of those that stand
/// as many folders below the last folder of its path that exists; x is named from there, or from
/// the folder `from` with `before` before it, and is not `asker`. First the one that has that name
/// and the ending .yaml.
[[nodiscard]] std::string nearest_file(const std::filesystem::path& missing,
                                       const std::filesystem::path& asker = {},
                                       const std::filesystem::path& from = {},
                                       std::string_view before = "");

}  // namespace eyrie::disk
